"""docs/capabilities.md: every file and every test that it names is there."""
import pathlib
import re
import sys

source = pathlib.Path(sys.argv[2])
tests = {str(f.relative_to(source / "tests"))[: -len("_test.cpp")]: f.read_text()
         for f in (source / "tests").glob("*/**/*_test.cpp")}
problems, ticked = [], 0


def find_test(name):
    """Tests by `file`, of any room, or `room/file`; a script of program/ by its name."""
    if (source / "tests" / name).exists():
        return "script"
    found = [text for path, text in tests.items() if path == name or path.split("/", 1)[1] == name]
    return "\n".join(found) or ("room" if (source / "tests" / name).is_dir() else None)


def has_test(text, case):
    """Suite.Case, or one of the two alone, by the line that begins the test."""
    return any(case in (suite, name, f"{suite}.{name}")
               for suite, name in re.findall(r"\bTEST(?:_F|_P)?\((\w+),\s*(\w+)\)", text))


def check_tests(cell, line):
    for part in cell.split(";"):
        if part.strip() in ("-", ""):
            continue
        name, _, cases = re.sub(r"\(.*?\)", "", part).partition(":")
        text = find_test(name.strip())
        if text is None:
            problems.append(f"no test file {name.strip()}: {line}")
            continue
        for case in re.findall(r"[A-Z]\w+(?:\.\w+)?", cases):
            if not has_test(text, case):
                problems.append(f"no test {case} in {name.strip()}: {line}")


for line in (source / "docs" / "capabilities.md").read_text().splitlines():
    for path in re.findall(r"`((?:geometry|modules|planar|spherical|apps|tests)/[\w./]*)`", line):
        if not (source / path).exists():
            problems.append(f"no {path}: {line}")
    cells = [c.strip() for c in line.strip("|").split("|")]
    if len(cells) != 5 or cells[0] in ("capability", "---"):
        continue
    check_tests(cells[2].replace(" has the numbers", "").replace(" and others", ""), line)
    if not re.fullmatch(r"yes|in work|not yet|part(: .*)?", cells[4]):
        problems.append(f"neither yes nor no: {line}")
    if cells[4] == "yes":
        ticked += 1
        if "`" not in cells[1] or cells[2] == "-":
            problems.append(f"ticked without code or test: {line}")

for p in problems:
    print(p)
sys.exit(bool(problems) or ticked == 0)
