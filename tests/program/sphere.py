"""The sphere through the programs: examples of Angeles and Bai, mixed pose formats, figures, the semigraphical app."""
import json
import math
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

sys.path.insert(0, os.path.join(sys.argv[2], "tests", "support"))
import program  # noqa: E402
from program import ProgramTest, example, load, main, strict_json  # noqa: E402

RESEARCH = os.path.join(os.path.dirname(program.PROGRAM), "burmester-semigraphical")
SVG = "{http://www.w3.org/2000/svg}"

# (fixed, moving, arc in degrees), from 60-digit arithmetic on the attitudes of the file. Printed in "A robust solution
# of the spherical Burmester problem": the same truncated to four digits (example 2: with the columns exchanged).
DYADS = {
    "angeles_bai_1": [
        ((0.2640466294743534, -0.663651655704157, -0.6998898894428784),
         (0.7085790279115382, -0.6418147356202265, -0.29323984440160644), 35.08752256387994),
        ((0.11438567285118437, 0.7263033807215935, -0.6777900242691433),
         (0.03850018330177807, 0.31637010830067996, 0.9478542559167762), 114.0956785806511),
        ((0.5218800424400694, 0.8413857164607459, -0.14039692816649757),
         (0.1642313954817287, 0.6977365201145962, 0.6972745493967909), 54.90881132896959),
        ((0.9524952675521686, -0.2535884257361309, 0.16865845849939917),
         (0.8077994700250476, 0.14938415597112395, 0.5702143370453318), 34.135322118552374)],
    "angeles_bai_2": [
        ((0.28450823773206657, 0.3862803010036891, 0.8774067424627493),
         (0.12190198450452293, -0.7089233158009335, -0.6946708850151048), 148.06729498326277),
        ((0.7226320859010058, 0.5294531554128433, 0.44438972158426987),
         (0.23094208049695475, 0.45668275763799826, 0.8591313137884635), 37.7707868655929),
        ((0.9573525770021547, -0.24340177643607078, 0.1556650845086925),
         (0.8134046485629156, 0.16426577778846949, 0.558022967218903), 34.35092039052581),
        ((0.5211351438658721, 0.8446626880607322, -0.12232377212101878),
         (0.06524938063256407, 0.10123019861357492, 0.9927209906190777), 90.11025199884692)],
    "angeles_bai_2_exact": [
        ((0.2851174012296429, 0.38684470824486217, 0.8769602267030143),
         (0.12136108435658095, -0.7092551033834765, -0.6944268755803514), 148.07642424013696),
        ((0.7226597483646462, 0.5295437818420705, 0.44423672878989184),
         (0.2309171831869252, 0.45663397939865763, 0.8591639327669442), 37.78135573307057),
        ((0.9575295439763044, -0.2428768071313359, 0.15539636086542807),
         (0.8135569776919207, 0.16489074952364224, 0.5576164315820679), 34.34979116942731),
        ((0.5221393938323564, 0.8442635990986221, -0.12078670723809137),
         (0.06550500280810398, 0.10150775244309242, 0.9926758135469315), 90)]}


def off(u, v):
    """Angle between two axes, without signs."""
    cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    return math.atan2(math.hypot(*cross), abs(sum(a * b for a, b in zip(u, v))))


def apart(dyad, fixed, moving):
    return max(off(dyad["fixed"], fixed), off(dyad["moving"], moving))


def globe(longitude, latitude, roll):
    """Rz(longitude) Ry(-latitude) Rx(roll), degrees."""
    def product(a, b):
        return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    (cl, sl), (cb, sb), (cr, sr) = [(math.cos(math.radians(t)), math.sin(math.radians(t)))
                                    for t in (longitude, latitude, roll)]
    return product(product([[cl, -sl, 0], [sl, cl, 0], [0, 0, 1]], [[cb, 0, -sb], [0, 1, 0], [sb, 0, cb]]),
                   [[1, 0, 0], [0, cr, -sr], [0, sr, cr]])


def quaternion(m):
    w = math.sqrt(1 + m[0][0] + m[1][1] + m[2][2]) / 2
    return [w, (m[2][1] - m[1][2]) / (4 * w), (m[0][2] - m[2][0]) / (4 * w), (m[1][0] - m[0][1]) / (4 * w)]


class SphereTest(ProgramTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def check_dyads(self, document, name, tolerance):
        self.assertEqual(len(document["dyads"]), len(DYADS[name]))
        unit = 1 if document["units"]["angle"] == "deg" else 180 / math.pi
        for fixed, moving, arc in DYADS[name]:
            dyad = min(document["dyads"], key=lambda d: apart(d, fixed, moving))
            self.assertLess(apart(dyad, fixed, moving), tolerance)
            self.assertAlmostEqual(dyad["arc"] * unit, min(arc, 180 - arc), delta=60 * tolerance)

    def svg(self, name):
        return xml.etree.ElementTree.parse(os.path.join(self.folder, name)).getroot()


class Examples(SphereTest):
    def test_published_dyads(self):
        for name in DYADS:
            with self.subTest(example=name):
                document = strict_json(self.good("synthesize", example(name), "--json").stdout)
                self.assertEqual((document["status"], document["solutions"]["complex"], document["solutions"]["real"]),
                                 ("exact", 6, 4))
                self.check_dyads(document, name, 1e-10)
                self.assertEqual(sorted(d["type"] for d in document["dyads"]),
                                 (["PR"] if name.endswith("exact") else [])
                                 + ["RR"] * (3 if name.endswith("exact") else 4))

    def test_mixed_pose_formats(self):
        poses = load(example("angeles_bai_1"))["poses"]
        matrices = [globe(p["longitude"], p["latitude"], p["roll"]) for p in poses]
        q = [quaternion(m) for m in matrices]
        axis = q[3][1:]
        mixed = [{"matrix": matrices[0]}, {"quaternion_wxyz": [-5 * c for c in q[1]]}, poses[2],
                 {"axis": axis, "angle": math.degrees(2 * math.atan2(math.hypot(*axis), q[3][0]))},
                 {"matrix": matrices[4]}]
        document = strict_json(self.good("synthesize", "-", "--json",
                                         text=json.dumps({"geometry": "spherical", "poses": mixed})).stdout)
        self.check_dyads(document, "angeles_bai_1", 1e-9)
        rows = "qw,qx,qy,qz\n" + "".join(",".join(map(repr, c)) + "\n" for c in q)
        self.check_dyads(strict_json(self.good("synthesize", "-", "--json", text=rows).stdout), "angeles_bai_1", 1e-9)

    def test_bad_poses(self):
        good = {"quaternion_wxyz": [1, 0, 0, 0]}
        for pose in ({"quaternion_wxyz": [0, 0, 0, 0]}, {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]},
                     {"axis": [0, 0, 0], "angle": 1},
                     {"matrix": [[1, 0], [0, 1]]}, {"longitude": 1, "latitude": 2},
                     {"axis": [0, 0, 1], "angle": 1, "roll": 2}, [1, 0, 0, 0]):
            with self.subTest(pose=pose):
                self.assertIn("poses[4]", self.refused("synthesize", "-",
                                                       text=json.dumps({"geometry": "spherical",
                                                                        "poses": [good] * 4 + [pose]})))


class Figures(SphereTest):
    def test_the_task_and_every_linkage(self):
        for name in ("angeles_bai_1", "angeles_bai_2_exact"):
            self.good("synthesize", example(name), "-o", self.folder)
            self.assertEqual(sorted(os.listdir(self.folder)),
                             sorted(["poses.svg", "report.html", "result.json"]
                                    + [f"linkage_{k}.svg" for k in range(1, 7)]))
            for k in range(1, 7):
                figure = self.svg(f"linkage_{k}.svg")
                self.assertIn(f"Linkage {k} · Five attitudes", figure.find(SVG + "title").text)
                words = ["".join(t.itertext()) for t in figure.iter(SVG + "text")]
                self.assertEqual(sum(w.startswith(("along the mean", "from ")) for w in words), 4)
                for word in ("task attitude", "coupler and attitude", "far side"):
                    self.assertIn(word, words)
            self.assertNotIn("coupler and attitude", ["".join(t.itertext())
                                                      for t in self.svg("poses.svg").iter(SVG + "text")])


class Semigraphical(SphereTest):
    def app(self, *arguments, text=""):
        return subprocess.run([RESEARCH, *arguments], input=text.encode(), stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=120)

    def test_examples_side_by_side(self):
        for name in DYADS:
            with self.subTest(example=name):
                answer = self.app(example(name), "--json", "-o", self.folder)
                self.assertEqual(answer.returncode, 0, answer.stderr)
                document = strict_json(answer.stdout)
                self.check_dyads(document, name, 1e-10)
                to_degrees = 1 if document["units"]["angle"] == "deg" else 180 / math.pi
                self.assertEqual(sorted(d["algebraic"] for d in document["dyads"]), [1, 2, 3, 4])
                self.assertLess(max(d["apart"] for d in document["dyads"]), 1e-8)
                self.assertEqual(document["missed"], [])
                for plot in ("moving", "fixed"):
                    for d in document["dyads"]:
                        self.assertGreater(d["crossings"][plot], 0)
                        self.assertEqual(len(d["read_off"][plot]), d["crossings"][plot])
                        for longitude, latitude in d["read_off"][plot]:  # within two cells of a degree
                            raw = [row[0] for row in globe(longitude * to_degrees, latitude * to_degrees, 0)]
                            self.assertLess(off(raw, d[plot]), math.radians(2))
                    spurious = [c for c in document["spurious"] if c["plot"] == plot]
                    self.assertGreater(len(spurious), 0)
                    self.assertGreater(min(c["rank_ratio"] for c in spurious), 1e-6)
                    rings = [c for c in self.svg(f"{plot}_axes.svg").iter(SVG + "circle") if c.get("r") == "8"]
                    self.assertEqual(len(rings), 5)  # four dyads and the legend
                with open(os.path.join(self.folder, "semigraphical.json"), "rb") as file:
                    self.assertEqual(file.read(), answer.stdout)

    def test_table(self):
        text = self.app(example("angeles_bai_1")).stdout.decode()
        for words in ("4 axes of rank 2", "read off to", "spurious (rank 3)", "(-42.1696, -17.0520)", "35.08752",
                      "dyad 4"):
            self.assertIn(words, text)
        self.assertLessEqual(max(map(len, text.split("\n"))), 110)

    def test_degenerate_attitudes_are_an_answer(self):
        turns = {"geometry": "spherical", "poses": [{"axis": [0, 0, 1], "angle": 10 * i * i} for i in range(5)]}
        answer = self.app("-", text=json.dumps(turns))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn(b"vanishes all over the sphere", answer.stdout)

    def test_wrong_input_is_one_line(self):
        planar = json.dumps(program.FIVE_POSES)
        four = json.dumps({"geometry": "spherical", "poses": [{"quaternion_wxyz": [1, 0, 0, k]} for k in range(4)]})
        for arguments, text, words in ((["-"], planar, "geometry: expected spherical"),
                                       (["-"], four, "poses: expected 5 orientations, got 4"),
                                       (["-"], "{", "expected"), (["/nowhere.json"], "", "/nowhere.json: expected"),
                                       ([], "", "expected"),
                                       ([example("angeles_bai_1"), "--cells", "1"], "", "expected"),
                                       ([example("angeles_bai_1"), "--sing"], "", "expected")):
            with self.subTest(arguments=arguments, text=text[:30]):
                answer = self.app(*arguments, text=text)
                self.assertEqual((answer.returncode, answer.stdout), (2, b""))
                self.assertEqual(answer.stderr.count(b"\n"), 1, answer.stderr)
                self.assertIn(words, answer.stderr.decode())

    def test_help(self):
        self.assertIn(b"--cells", self.app("--help").stdout)
        self.assertRegex(self.app("--version").stdout.decode(), r"^burmester \d+\.\d+\.\d+\n$")


main()
