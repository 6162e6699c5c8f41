"""Wrong problems: exit code 2, one line that says file, place and what was expected, nothing on standard output."""
import copy
import json
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(sys.argv[2], "tests", "support"))
from program import FIVE_POSES, ProgramTest, main  # noqa: E402

SPHERICAL = {"geometry": "spherical", "poses": [{"axis": [0, 0, 1], "angle": 10}, {"quaternion_wxyz": [1, 0, 0, 0]}]}


def changed(problem, **members):
    return json.dumps(dict(copy.deepcopy(problem), **members))


def with_pose(problem, pose):
    return changed(problem, poses=problem["poses"] + [pose])


class BadInput(ProgramTest):
    def says(self, text, *words):
        line = self.refused("synthesize", "-", text=text)
        self.assertTrue(line.startswith("standard input: "), line)
        for word in words + ("expected",):
            self.assertIn(word, line)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for path in (folder, os.path.join(folder, "missing.json"), os.path.join(folder, "missing.json", "x")):
                line = self.refused("synthesize", path)
                self.assertTrue(line.startswith(path + ": expected a "), line)
            path = os.path.join(folder, "bad\n.json")
            with open(path, "w") as file:
                file.write("{")
            self.assertIn("bad .json: line 1", self.refused("synthesize", path))

    def test_syntax(self):
        for text in ("", " \n ", "{", "}", "[", "null", "1", "nonsense", "{\"geometry\": \"planar\", \"poses\": [NaN]}",
                     "{} {}",
                     "{\"geometry\": \"planar\",}", "'x'", "\ufeff", "[" * 100000, "{\"a\":" * 10000, "\x00", "{}\x00"):
            with self.subTest(text=text[:50]):
                self.says(text)
        self.says(b"\xff\xfe{\x00}\x00")
        self.says(b'{"geometry": "planar\xff"}')
        self.says('{"geometry": "planar", "poses": [[0, 0, 0], [1, 1, 1e999]]}', "line 1, column 52 (poses[1][2])",
                  "finite")
        self.says('{"geometry": "planar", "geometry": "planar"}', "geometry: expected each key once")

    def test_shape(self):
        bad = {"geometry": ["planer", 1, None, {}],
               "units": ["mm", 1, {"angle": "degrees"}, {"angle": 1}, {"length": 1}],
               "poses": [[], [[0, 0, 0]], {}, "x", [[0, 0, 0], 1], [[0, 0, 0], [0, 0]], [[0, 0, 0], [0, 0, 0, 0]],
                         [[0, 0, 0], {"x": 1, "y": 2}], [[0, 0, 0], {"x": 1, "y": 2, "angle": "3"}],
                         [[0, 0, 0], [0, 0, None]]],
               "schema": [1, "burmester/problem/2", "burmester/linkage/1", "burmester/platform/1"],
               "types": ["RR", [], ["RX"], [1]], "fixed": [1, [1, 2], [[1]], [[1, 2, 3]], [["a", "b"]]],
               "moving": [{}, [[]]],
               "near": [[[1, None]], 3], "weights": [1, [1], ["exact"] * 4, [1, 1, 1, 1, -1], [1, 1, 1, 1, "x"],
                                                     [0] * 5],
               "linkages": [[], {"fixed_in": [[0, 0]]}, {"moving_in": [[0, 0], [1, 1, 1]]},
                            {"fixed_in": [[0, 0], [1, "2"]]},
                            {"classes": []}, {"classes": ["crank"]}, {"largest_ratio": 0.5}, {"most": 0}, {"most": 2.5},
                            {"most": 1e9}, {"most": "6"}],
               "name": [1, ["x"]], "source": [{}]}
        for key, values in bad.items():
            for value in values:
                with self.subTest(key=key, value=value):
                    self.says(changed(FIVE_POSES, **{key: value}), key)
        for key in ("geometry", "poses"):
            problem = dict(FIVE_POSES)
            del problem[key]
            self.says(json.dumps(problem), f"{key}: expected", "got nothing")

    def test_places(self):
        self.says(with_pose(FIVE_POSES, {"x": 1, "y": 2, "angle": "3"}), "poses[5].angle: expected a number, got \"3\"")
        self.says(with_pose(FIVE_POSES, [1, 2, True]), "poses[5][2]: expected a number, got true")

    def test_spherical(self):
        for pose in ({}, [1, 2, 3], {"axis": [0, 0, 0], "angle": 1}, {"axis": [0, 1], "angle": 1}, {"axis": [0, 0, 1]},
                     {"quaternion_wxyz": [0, 0, 0, 0]}, {"quaternion_wxyz": [1, 0, 0]},
                     {"matrix": [[1, 0, 0], [0, 1, 0]]},
                     {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]},
                     {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1.00001]]},
                     {"longitude": 1, "latitude": 2}, {"longitude": 1, "latitude": 2, "roll": "3"},
                     {"axis": [0, 0, 1], "angle": 1, "quaternion_wxyz": [1, 0, 0, 0]}):
            with self.subTest(pose=pose):
                self.says(with_pose(SPHERICAL, pose), "poses[2]")
        self.says(changed(SPHERICAL, fixed=[[1, 2]]), "fixed[0]")
        self.says(changed(SPHERICAL, types=["PP"]), "types[0]")

    def test_csv(self):
        for text, place in (("x,y\n1,2\n", "line 1"), ("x,y,angle_deg\n", "line 2"),
                            ("x,y,angle_deg\n1,2,3\n", "line 2"),
                            ("x,y,angle_deg\n1,2,3\n1,2\n", "line 3"), ("x,y,angle_deg\n1,2,3\n1,2,3,4\n", "line 3"),
                            ("x,y,angle_deg\n1,2,3\n1,2,inf\n", "line 3, column angle_deg"),
                            ("qw,qx,qy,qz\n1,0,0,0\n0,0,0,0\n", "line 3")):
            with self.subTest(text=text):
                self.says(text, place)

    def test_too_many_poses(self):
        self.says(changed(FIVE_POSES, poses=[[0, 0, 0]] * 100001), "at most 100000 poses")

    def test_endless_input_ends(self):
        self.assertIn("at most 256 MiB", self.refused("synthesize", "/dev/zero"))


main()
