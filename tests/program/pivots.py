"""Two and three poses, and given pivots: families, dyads and best fits, in JSON and CSV."""
import json
import math
import os
import sys
import tempfile
import xml.etree.ElementTree

import jsonschema

sys.path.insert(0, os.path.join(sys.argv[2], "tests", "support"))
from program import ProgramTest, example, main, schema, strict_json  # noqa: E402

POSES = [[0, 0, 0], [2, 1, 30], [3, -1, 75], [1, 4, -20], [5, 5, 5], [-3, 2, 44]]
SPHERICAL = [{"axis": [0, 0, 1], "angle": 0}, {"axis": [0, 1, 1], "angle": 40},
             {"longitude": 20, "latitude": 30, "roll": 10},
             {"quaternion_wxyz": [1, 0.5, 0, 0.2]}]


def problem(poses, geometry="planar", **members):
    return json.dumps(dict({"geometry": geometry, "poses": poses}, **members))


def place(pose, p):
    x, y, angle = pose
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return (x + c * p[0] - s * p[1], y + s * p[0] + c * p[1])


class Pivots(ProgramTest):
    def answer(self, text, *options):
        document = strict_json(self.good("synthesize", "-", "--json", *options, text=text).stdout)
        jsonschema.validate(document, schema("result"))
        return document

    def shape(self, document, status, dimension, dyads):
        self.assertEqual((document["status"], document["solutions"]["dimension"], len(document["dyads"])),
                         (status, dimension, dyads), document["message"])

    def test_two_poses(self):
        document = self.answer(problem(POSES[:2]))
        self.shape(document, "family", 3, 0)
        self.assertIn("a rotation by 30 deg about the pole", document["message"])
        pole = document["poles"][0]
        self.assertEqual((pole["poses"], round(pole["angle"], 9)), ([1, 2], 30))
        for pose in POSES[:2]:
            for got, wanted in zip(place(pose, pole["moving"]), pole["fixed"]):
                self.assertAlmostEqual(got, wanted, delta=1e-12)
        self.assertGreater(len(document["samples"]), 50)
        self.assertEqual([d["type"] for d in document["dyads"]], [])
        shifted = self.answer(problem([[0, 0, 10], [3, 0, 10]]))
        self.assertIn("a translation, its pole at infinity in the direction of 90 deg", shifted["message"])
        self.assertEqual(shifted["poles"][0]["line"], {"point": [1.5, 0], "angle": 90})

    def test_parallel_poses_have_a_double_slider(self):
        parallel = [[0, 0, 10], [1, 0, 10], [0, 2, 10], [3, 3, 10]]
        for count in (2, 3, 4):
            for types in ({}, {"types": ["PP"]}):
                document = self.answer(problem(parallel[:count], **types))
                double_sliders = [d for d in document["dyads"] if d["type"] == "PP"]
                self.assertEqual([round(d["angle"], 12) for d in double_sliders], [10])
                self.assertTrue(double_sliders[0]["certificate"]["certified"])
                self.assertLess(double_sliders[0]["residual"], 1e-15)
                self.assertIn("a PP dyad", document["message"])
            turned = self.answer(problem(parallel[:count - 1] + [[5, 1, 10.000001]]))
            self.assertNotIn("PP", [d["type"] for d in turned["dyads"]])

    def test_one_dyad_near_two_points(self):
        document = self.answer(problem(POSES[:4], near=[[1, 1], [1, 1], [4, -2]]))
        self.assertEqual(sum(d["type"] == "RR" for d in document["dyads"]), 2)
        self.assertIn("two of the given points lead to the same RR dyad: listed once", document["warnings"])

    def test_batch_lines_keep_poles_and_partners(self):
        line = problem(POSES[:2], moving=[[1, 1]])
        document, full = strict_json(self.good("batch", text=line + "\n").stdout), self.answer(line)
        self.assertNotIn("samples", document)
        self.assertEqual((document["poles"], document["partners"]), (full["poles"], full["partners"]))

    def test_two_poses_and_a_pivot(self):
        document = self.answer(problem(POSES[:2], moving=[[1, 1]]))
        self.shape(document, "family", 1, 0)
        line = document["partners"][0]["line"]
        a, b = (place(pose, (1, 1)) for pose in POSES[:2])
        t = math.radians(line["angle"])
        self.assertAlmostEqual(math.cos(t) * (a[0] - b[0]) + math.sin(t) * (a[1] - b[1]), 0, delta=1e-12)
        self.assertEqual({d["type"] for d in document["samples"]}, {"RR", "PR"})

    def test_three_poses(self):
        document = self.answer(problem(POSES[:3]))
        self.shape(document, "family", 2, 0)
        self.assertEqual([p["poses"] for p in document["poles"]], [[1, 2], [1, 3], [2, 3]])
        for dyad in document["samples"]:
            self.assertLess(dyad["residual"], 1e-9)

    def test_three_poses_and_pivots(self):
        document = self.answer(problem(POSES[:3], fixed=[[5, 0], [5, 0], [-1, 2]], moving=[[1, 1]]))
        self.shape(document, "exact", 0, 3)
        self.assertEqual({k: document["solutions"][k] for k in ("complex", "real", "certified")},
                         {"complex": 3, "real": 3, "certified": True})
        self.assertEqual(document["warnings"], ["fixed[1] is fixed[0] again: listed once"])
        self.assertEqual(len(document["linkages"]), 3)
        for dyad in document["dyads"]:
            for pose in POSES[:3]:
                self.assertAlmostEqual(math.dist(place(pose, dyad["moving"]), dyad["fixed"]), dyad["length"],
                                       delta=1e-12)
            self.assertLess(dyad["certificate"]["radius"], 1e-13)
        self.assertEqual(self.answer(problem(POSES[:3], fixed=[[5, 0]], types=["PR"]))["dyads"], [])
        bare = self.answer(problem(POSES[:3], fixed=[[5, 0]]), "--no-certify")
        self.assertFalse(bare["solutions"]["certified"] or bare["dyads"][0]["certificate"]["certified"])

    def test_a_pole_is_named(self):
        document = self.answer(problem([[0, 0, 0], [2, 4, 180], [-2, 6, 180]], fixed=[[1, 2], [7, 7]]))
        self.shape(document, "degenerate", 1, 1)
        self.assertIn("fixed[0]: it is the pole of poses 1 and 2, its partners fill a line", document["message"])

    def test_more_poses_are_fitted(self):
        document = self.answer(problem(POSES, fixed=[[5, 0]], moving=[[0, 0]]))
        self.assertEqual(document["status"], "approximate")
        self.assertEqual(sorted(d["type"] for d in document["dyads"]), ["PR", "RP", "RR", "RR"])
        by_id = {d["id"]: d for d in document["dyads"]}
        self.assertEqual(len(document["linkages"]), 4)
        for one, other in ([by_id[k] for k in linkage["dyads"]] for linkage in document["linkages"]):
            self.assertFalse(any(body in one and one[body] == other.get(body) for body in ("fixed", "moving")))
        alone = self.answer(problem(POSES, fixed=[[5, 0]]))
        self.assertEqual(alone["linkages"], [])
        self.assertIn("all these dyads share the given fixed pivot: no two of them make a linkage", alone["message"])
        circle = [[3 * math.cos(t) + 1, 3 * math.sin(t), a] for t, a in ((0, 5), (1, 30), (2, 80), (2.5, 10), (4, 0))]
        met = self.answer(problem(circle, moving=[[0, 0]]))
        self.shape(met, "exact", 0, 1)
        self.assertAlmostEqual(met["dyads"][0]["length"], 3, delta=1e-12)

    def test_near_a_point_of_the_curve(self):
        near = [[1, 1], [4, -2]]
        document = self.answer(problem(POSES[:4], near=near))
        self.assertEqual((document["status"], document["solutions"]["dimension"]), ("family", 1))
        pivots = [c for curve in document["curves"] for c in curve["fixed"]]
        found = [d for d in document["dyads"] if d["type"] == "RR"]
        self.assertEqual(len(found), 2)
        for point in near:
            dyad = min(found, key=lambda d: math.dist(d["fixed"], point))
            self.assertLessEqual(math.dist(dyad["fixed"], point), min(math.dist(c, point) for c in pivots) + 1e-12)
            for pose in POSES[:4]:
                self.assertAlmostEqual(math.dist(place(pose, dyad["moving"]), dyad["fixed"]), dyad["length"],
                                       delta=1e-10)
            self.assertTrue(dyad["certificate"]["certified"])
        self.assertTrue(any(l["type"] == "RRRR" for l in document["linkages"]))
        self.assertEqual(self.answer(problem(POSES[:3], near=near))["warnings"],
                         ["near: only four poses without given pivots leave a choice; ignored"])

    def test_near_a_direction_of_the_cone(self):
        near = [[1, 1, 2], [-6, 8, 0], [3, -4, 0], [1e300, 0, -1e300]]
        document = self.answer(problem(SPHERICAL, "spherical", near=near))
        found = [d for d in document["dyads"] if d["type"] == "RR"]
        self.assertEqual(len(found), 3)
        self.assertEqual(document["warnings"], ["two of the given directions lead to the same RR dyad: listed once"])

        def nearness(axis, direction):  # cosine of the angle between axes without direction
            return abs(sum(a * b for a, b in zip(axis, direction))) / math.hypot(*direction)
        axes = [c for curve in document["curves"] for c in curve["fixed"]]
        for direction in near:
            best = max(found, key=lambda d: nearness(d["fixed"], direction))
            self.assertGreaterEqual(nearness(best["fixed"], direction),
                                    max(nearness(c, direction) for c in axes) - 1e-14)
        for dyad in found:
            self.assertLess(dyad["residual"], 1e-14)
            self.assertLess(dyad["certificate"]["radius"], 1e-12)
        self.assertEqual(self.answer(problem(SPHERICAL[:3], "spherical", near=near))["warnings"],
                         ["near: only four poses without given axes leave a choice; ignored"])

    def test_small_turns_are_seen_from_far(self):
        text = problem([[0, 0, 0], [3, 1, 2], [5, -1, 3.5], [4, -4, 5]])
        document = self.answer(text)
        self.assertIn("the poles are far: listed within 256 of pose 1's origin, 45.3 task sizes", document["message"])
        self.assertEqual([d["type"] for d in document["dyads"]], ["PR", "RP"])
        self.assertGreater(max(abs(x) for curve in document["curves"] for c in curve["fixed"] for x in c), 200)
        links = [c["links"] for c in document["candidates"]]
        self.assertEqual(len(links), 6)
        self.assertEqual(len({(l["input"], l["output"]) for l in links}), 6)
        with tempfile.TemporaryDirectory() as folder:
            self.good("synthesize", "-", "-o", folder, text=text)
            self.assertLessEqual({"curves.svg", "curves_near.svg", "vector_diagram.svg"}, set(os.listdir(folder)))

    def test_linkages_as_asked_for(self):
        asked = {"fixed_in": [[9, 8], [-3, -6]], "moving_in": [[-8, -8], [8, 8]],
                 "classes": ["crank-rocker", "double-crank"],
                 "largest_ratio": 8, "most": 3}
        self.assertIsNone(jsonschema.validate(json.loads(problem(POSES[:4], linkages=asked)), schema("problem")))
        document = self.answer(problem(POSES[:4], linkages=asked))
        self.assertEqual((len(document["candidates"]), document["warnings"]), (3, []))
        for candidate in document["candidates"]:
            self.assertIn(candidate["class"], asked["classes"])
            self.assertLessEqual(candidate["link_ratio"], 8)
            for dyad in candidate["dyads"]:
                (x, y), (u, v) = dyad["fixed"], dyad["moving"]
                self.assertTrue(-3 <= x <= 9 and -6 <= y <= 8 and max(abs(u), abs(v)) <= 8, dyad)
        nowhere = self.answer(problem(POSES[:4], linkages={"fixed_in": [[1000, 1000], [1001, 1001]]}))
        self.assertEqual((nowhere["candidates"], nowhere["warnings"]),
                         ([], ["linkages: no two dyads of the curves as listed are as asked for"]))
        self.assertEqual(self.answer(problem(POSES[:3], linkages=asked))["warnings"],
                         ["linkages: only four poses without given pivots leave a choice; ignored"])
        self.assertEqual(self.answer(problem(POSES[:4], linkages=asked, types=["PR"]))["warnings"],
                         ["linkages: RR dyads are not asked for; ignored"])
        self.assertEqual(self.answer(problem(POSES[:4], linkages={"mots": 3}))["warnings"],
                         ["linkages.mots: unknown key, ignored"])
        sphere = json.dumps({"geometry": "spherical", "poses": [{"axis": [1, 2, k], "angle": 20 * k} for k in range(4)],
                             "linkages": {"most": 3}})
        self.assertEqual(self.answer(sphere)["warnings"][0],
                         "linkages: the spherical module ranks no linkages; ignored")

    def test_constructions_are_drawn(self):
        names = {f"construction_{k}_{how}.svg" for k in (1, 2) for how in ("inversion", "poles", "steps")}
        with tempfile.TemporaryDirectory() as folder:
            self.good("synthesize", example("mech576_three_poses"), "-o", folder)
            self.assertLessEqual(names, set(os.listdir(folder)))
            with open(os.path.join(folder, "report.html"), encoding="utf-8") as file:
                page = file.read()
            self.assertEqual(page.count("by inversion") >= 2 and page.count("<figcaption>"), 6)
            for name in names:
                text = "".join(xml.etree.ElementTree.parse(os.path.join(folder, name)).getroot().itertext())
                for label in ("M2", "M3", "A1"):
                    self.assertIn(label, text)

    def test_csv(self):
        csv = "x,y,angle_deg\n" + "".join("%r,%r,%r\n" % tuple(pose) for pose in POSES[:3])
        self.assertEqual(strict_json(self.good("synthesize", "-", "--json", text=csv).stdout),
                         self.answer(problem(POSES[:3])))

    def test_text(self):
        text = self.good("synthesize", "-", text=problem(POSES[:2], moving=[[1, 1]])).stdout.decode()
        for words in ("Poles", "Partners", "Samples"):
            self.assertIn("\n" + words, text)
        self.assertLessEqual(max(map(len, text.split("\n"))), 170)

    def test_spherical(self):
        two, three = SPHERICAL[:2], SPHERICAL[:3]
        self.shape(self.answer(problem(two, "spherical")), "family", 3, 0)
        line = self.answer(problem(two, "spherical", fixed=[[1, 2, 3]]))
        self.shape(line, "family", 1, 0)
        self.assertAlmostEqual(math.hypot(*line["partners"][0]["normal"]), 1, delta=1e-15)
        text = self.good("synthesize", "-", text=problem(two, "spherical", fixed=[[1, 2, 3]])).stdout.decode()
        self.assertIn("\nPartners fill a great circle\n", text)
        self.assertRegex(text, r"\n  fixed axis +perpendicular to\n")
        cone = self.good("synthesize", "-", text=problem(SPHERICAL, "spherical")).stdout.decode()
        self.assertIn("\nCurves of axes: ", cone)
        for words in ("fill a line", "pivot"):
            self.assertNotIn(words, text + cone)
        self.shape(self.answer(problem(three, "spherical")), "family", 2, 0)
        document = self.answer(problem(three, "spherical", fixed=[[1, 2, 3]], moving=[[0, 1, 0]]))
        self.shape(document, "exact", 0, 2)
        self.assertTrue(document["solutions"]["certified"])
        self.assertEqual(self.answer(problem(SPHERICAL, "spherical", fixed=[[1, 2, 3]]))["status"], "approximate")
        csv = "qw,qx,qy,qz\n1,0,0,0\n1,0.5,0,0.2\n"
        self.assertEqual(strict_json(self.good("synthesize", "-", "--json", text=csv).stdout)["solutions"]["dimension"],
                         3)

    def test_refused(self):
        for text, place_of_error in ((problem(POSES[:1], fixed=[[0, 0]]), "poses: expected two or more poses"),
                                     (problem(POSES[:3], fixed=[0, 0]), "fixed[0]"),
                                     (problem(POSES[:3], moving=[[0, 0, 0]]), "moving[0]"),
                                     (problem(POSES[:3], moving=[[0, "x"]]), "moving[0][1]"),
                                     (problem(SPHERICAL[:3], "spherical", fixed=[[0, 0]]), "fixed[0]"),
                                     (problem(SPHERICAL[:3], "spherical", moving=[[0, 0, 0]]),
                                      "moving[0]: expected an axis that is not zero"),
                                     (problem(SPHERICAL, "spherical", near=[[0, 0, 1], [0, 0, 0]]),
                                      "near[1]: expected an axis that is not zero"),
                                     (problem(SPHERICAL, "spherical", near=[[0, 1]]), "near[0]"),
                                     (problem(POSES[:4], near=[[0, 1e101]]),
                                      "near[0]: expected coordinates of magnitude")):
            with self.subTest(text=text):
                self.assertIn(place_of_error, self.refused("synthesize", "-", text=text))

    def test_unusable_near_is_refused_for_any_number_of_poses(self):
        for count in range(2, 7):
            for more in ({}, {"fixed": [[1, 2]]}):
                text = problem(POSES[:count], near=[[0, 1], [0, 1e101]], **more)
                self.assertIn("near[1]: expected coordinates of magnitude", self.refused("synthesize", "-", text=text))
            for more in ({}, {"moving": [[1, 2, 3]]}):
                poses = [{"axis": [1, k, 2 * k * k], "angle": 10 * k} for k in range(count)]
                text = problem(poses, "spherical", near=[[0, 0, 0]], **more)
                self.assertIn("near[0]: expected an axis that is not zero", self.refused("synthesize", "-", text=text))


main()
