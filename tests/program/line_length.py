"""No line of C++, Python, JavaScript or CMake is longer than 120 characters."""
import pathlib
import sys

LONGEST = 120
ROOMS = ("geometry", "modules", "planar", "spherical", "apps", "bench", "tests")
KINDS = {".cpp", ".hpp", ".py", ".js", ".cmake"}

source = pathlib.Path(sys.argv[2])
files = [source / "CMakeLists.txt"] + [f for room in ROOMS for f in sorted((source / room).rglob("*"))
                                       if f.suffix in KINDS or f.name == "CMakeLists.txt"]
assert len(files) > 300, files
too_long = [f"{file.relative_to(source)}:{number}: {len(line)} characters"
            for file in files for number, line in enumerate(file.read_text(encoding="utf-8").split("\n"), 1)
            if len(line) > LONGEST]
print("\n".join(too_long) or f"{len(files)} files")
sys.exit(1 if too_long else 0)
