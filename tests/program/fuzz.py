"""Broken problems of every kind: never a crash, never a number that is none, an exit code of the contract."""
import glob
import json
import os
import random
import sys

import jsonschema

sys.path.insert(0, os.path.join(sys.argv[2], "tests", "support"))
from program import EXAMPLES, FIVE_POSES, ProgramTest, load, main, run, schema, strict_json  # noqa: E402

STREAM = random.Random("fuzz")
VALUES = [0, -0.0, 1, -1, 1e-320, 1e-160, 1e160, 1e308, -1.7976931348623157e308, 2 ** 53 + 1, 2 ** 64, 180, 360, 90,
          -180,
          None, True, "", "x", "deg", "rad", "exact", "planar", "spherical", [], {}, [[]], [0, 0], [1, 2, 3], {"x": 1}]
TOKENS = [b"NaN", b"Infinity", b"1e999", b"-", b"{", b"}", b"[", b"]", b",", b":", b'"', b"\\", b"\\u0000", b"\\ud800",
          b"\xff",
          b"\xc3", b"\x00", b"\xef\xbb\xbf", b"null", b"//", b"0x10", b"01", b".5", b"1e", b"9" * 400, b"[" * 200,
          b" " * 100]
SPHERICAL = [{"axis": [0, 0, 1], "angle": 0}, {"quaternion_wxyz": [0.9, 0.1, -0.2, 0.3]},
             {"longitude": 10, "latitude": 20, "roll": 30},
             {"matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}, {"axis": [1, 2, 3], "angle": 77}]
FOUR_POSES = dict(FIVE_POSES, poses=FIVE_POSES["poses"][:4])


def seeds():
    problems = [load(path) for path in sorted(glob.glob(os.path.join(EXAMPLES, "*.json")))]
    problems.append({"geometry": "spherical", "poses": SPHERICAL})
    problems += [dict(FOUR_POSES, near=[[3, 4], [0, 1]], weights=[1] * 4, types=["RR", "PR", "RP"],
                      linkages={"fixed_in": [[-50, -50], [50, 50]], "moving_in": [[-50, -50], [50, 50]],
                                "classes": ["crank-rocker", "double-rocker"], "largest_ratio": 4, "most": 2}),
                 {"geometry": "spherical", "poses": SPHERICAL[:4], "types": ["RR", "PR"],
                  "near": [[1, 2, 3], [0, 0, 1]]},
                 dict(FIVE_POSES, fixed=[[0, 0]], moving=[[1, 2]], weights=[1] * 5, types=["RR", "PR"])]
    return problems


def places(value, path=()):
    yield path
    if isinstance(value, (dict, list)):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from places(value[key], path + (key,))


def changed_value(problem):
    """Another value, a copy of a neighbour, or nothing at one place; or all poses the same, moved or scaled."""
    problem = json.loads(json.dumps(problem))
    for _ in range(STREAM.choice([1, 1, 1, 2, 5])):
        path = STREAM.choice([p for p in places(problem) if p] or [()])
        if not path:
            break
        parent = problem
        for key in path[:-1]:
            parent = parent[key]
        kind = STREAM.random()
        if kind < 0.6:
            parent[path[-1]] = json.loads(json.dumps(STREAM.choice(VALUES)))
        elif kind < 0.8:
            neighbour = STREAM.choice(list(parent if isinstance(parent, dict) else range(len(parent))))
            parent[path[-1]] = json.loads(json.dumps(parent[neighbour]))
        else:
            del parent[path[-1]]
    return problem


def changed_poses(problem):
    problem = json.loads(json.dumps(problem))
    poses, kind = problem["poses"], STREAM.randrange(6)
    if "x" not in poses[0]:
        return problem
    factor = STREAM.choice([0, 1e-100, 1e-12, 1e12, 1e100])
    for pose in poses:
        if kind == 0:
            pose.update(x=pose["x"] * factor, y=pose["y"] * factor)
        elif kind == 1:
            pose.update(angle=STREAM.choice([0, 90, 180, -180, 360, 1e-200]))
        elif kind == 2:
            pose.update(STREAM.choice(poses))
        elif kind == 3:
            pose.update(x=pose["x"] + factor)
        elif kind == 4:
            pose.update(x=STREAM.choice([0, 1, -1]), y=STREAM.choice([0, 1]), angle=STREAM.choice([0, 90, 180, 45]))
    if kind == 5:
        problem["poses"] = (poses * 3)[:STREAM.randrange(2, 14)]
    return problem


def changed_text(text):
    text = bytearray(text)
    for _ in range(STREAM.choice([1, 1, 2, 4])):
        at, end = STREAM.randrange(len(text) + 1), STREAM.randrange(len(text) + 1)
        kind = STREAM.randrange(5)
        if kind == 0:
            text[at:at] = STREAM.choice(TOKENS)
        elif kind == 1:
            del text[at:at + STREAM.randrange(1, 20)]
        elif kind == 2:
            text[at:at] = text[end:end + STREAM.randrange(1, 40)]
        elif kind == 3 and at < len(text):
            text[at] = STREAM.randrange(256)
        else:
            del text[max(at, 1):]
    return bytes(text)


def mutant(problem):
    kind = STREAM.random()
    if kind < 0.35:
        return json.dumps(changed_value(problem)).encode()
    if kind < 0.6:
        return json.dumps(changed_poses(problem)).encode()
    return changed_text(json.dumps(problem).encode())


def far_off(document):
    """Dyads called exact that are not met to 1e-7 of the largest number in sight."""
    if document["status"] != "exact":
        return []
    shown = [abs(p[k]) for p in document["poses"] for k in ("x", "y") if k in p]
    return [d for d in document["dyads"] if d["residual"] > 1e-7 * max(
        shown + [abs(v) for k in ("fixed", "moving") for v in d.get(k, [])] + [d.get("length", 0),
                                                                               document["task_size"]])]


class Fuzz(ProgramTest):
    def test_seeds_are_answered(self):
        for problem in seeds():
            answer = run("synthesize", "-", "--json", text=json.dumps(problem))
            self.assertEqual(answer.returncode, 0, (problem, answer.stderr))

    def test_batch(self):
        problems = seeds()
        lines = [mutant(STREAM.choice(problems)).replace(b"\n", b" ") for _ in range(6000)]
        answer = run("batch", "-j", "2", text=b"".join(line + b"\n" for line in lines))
        self.assertIn(answer.returncode, (0, 2, 4), answer.stderr[-500:])
        replies = answer.stdout.decode().splitlines()
        self.assertEqual(len(replies), len(lines))
        validator = jsonschema.Draft202012Validator(schema("result"))
        seen = {}
        for line, reply in zip(lines, replies):
            try:
                document = strict_json(reply)
                validator.validate(document)
                self.assertNotIn("internal failure", document["message"])
                self.assertEqual(far_off(document), [])
            except (ValueError, AssertionError, jsonschema.ValidationError) as error:
                self.fail(f"{line!r}\n{reply}\n{error}")
            seen[document["status"]] = seen.get(document["status"], 0) + 1
        self.assertGreater(seen["error"], 1000)
        self.assertGreater(seen["exact"], 300)

    def test_files(self):
        problems = seeds()
        csv = b"x,y,angle_deg\n" + b"".join(b"%d,%d,%d\n" % (i, i * i, 10 * i) for i in range(5))
        for i in range(300):
            text = changed_text(csv) if i % 3 == 0 else changed_text(json.dumps(STREAM.choice(problems),
                                                                                indent=1).encode())
            answer = run("synthesize", "-", "--json", text=text)
            with self.subTest(text=text, error=answer.stderr):
                self.assertIn(answer.returncode, (0, 2, 4))
                if answer.returncode == 0:
                    strict_json(answer.stdout)
                else:
                    self.assertEqual((answer.stdout, answer.stderr.count(b"\n")), (b"", 1))
                    answer.stderr.decode()


main()
