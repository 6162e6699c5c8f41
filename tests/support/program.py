"""What the tests of the program share. They are called as: test.py <program> <source folder>."""
import json
import os
import subprocess
import sys
import unittest

PROGRAM, SOURCE = sys.argv[1:3]
EXAMPLES = os.path.join(SOURCE, "apps", "examples")
FIVE_POSES = {"geometry": "planar", "poses": [[0, 0, 0], [-1.979, 1.708, 4.82], [-7.045, 2.929, 9.58],
                                              [-10.128, 1.874, 10.04], [-11.373, 0.748, 8.83]]}


def run(*arguments, text="", **options):
    """Runs the program on bytes or text; the answer has returncode, stdout and stderr (bytes)."""
    data = text if isinstance(text, bytes) else text.encode()
    if "stdin" not in options:
        options["input"] = data
    options.setdefault("stdout", subprocess.PIPE)
    return subprocess.run([PROGRAM, *arguments], stderr=subprocess.PIPE, timeout=120, **options)


def strict_json(text):
    """JSON as the standard has it: no NaN, no Infinity, no key twice."""
    def refuse(word):
        raise ValueError(f"{word} in JSON")

    def once(pairs):
        assert len({key for key, _ in pairs}) == len(pairs), f"a key twice: {pairs}"
        return dict(pairs)
    return json.loads(text, parse_constant=refuse, object_pairs_hook=once)


def example(name):
    return os.path.join(EXAMPLES, name + ".json")


def load(path):
    with open(path, encoding="utf-8") as file:
        return strict_json(file.read())


def schema(name):
    return load(os.path.join(SOURCE, "apps", "schemas", name + ".schema.json"))


class ProgramTest(unittest.TestCase):
    maxDiff = None

    def good(self, *arguments, **options):
        answer = run(*arguments, **options)
        self.assertEqual(answer.returncode, 0, answer.stderr.decode(errors="replace"))
        return answer

    def refused(self, *arguments, code=2, **options):
        """Nothing on standard output, one line on standard error, which is returned."""
        answer = run(*arguments, **options)
        line = answer.stderr.decode()
        self.assertEqual(answer.returncode, code, line)
        self.assertEqual(answer.stdout, b"")
        self.assertTrue(line.endswith("\n") and line.count("\n") == 1, line)
        return line[:-1]


def main():
    unittest.main(argv=sys.argv[:1])
