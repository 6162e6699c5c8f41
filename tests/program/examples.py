"""The example files: they follow the schemas and give the published dyads."""
import glob
import os
import sys
import tempfile

import jsonschema

sys.path.insert(0, os.path.join(sys.argv[2], "tests", "support"))
from program import EXAMPLES, ProgramTest, example, load, main, run, schema, strict_json  # noqa: E402

# Per example: (fixed pivot, moving pivot, length) of the RR dyads, and how closely to compare. 15-digit values from
# 60-digit arithmetic on the poses of the file; condition numbers of 1e3 to 1e5 set the tolerance.
DYADS = {
    "mech576_five_poses": (1e-9, [
        ((-66.18369509230067, -40.02952306564768), (-62.385886690543586, -36.60306159044855), 5.115074476239864),
        ((-0.2561943547362886, -9.131068814745392), (5.388532201695383, -7.044804581520475), 6.0179262497739625),
        ((-14.03958511012513, -9.1318225998561), (-8.927616965458261, -1.7473235877431834), 8.98126071172558),
        ((-6.360698551944286, -91.69846503534978), (0.9223795681332575, -151.41107513545083), 60.15512473488723)]),
    "mech576_designed_fourbar": (1e-9, [
        ((-66.26641278105728, -40.10594946222406), (-62.47381678669954, -36.66996327245876), 5.117595673035949),
        ((-0.106, -9.176), (5.535015529100302, -7.13175348833629), 6.0),
        ((-14.106, -9.176), (-9.004855016411495, -1.7612633319577802), 9.0),
        ((-6.288743180368108, -91.98337506417803), (0.995615694048961, -151.78891166698543), 60.247523538823025)]),
    "hayes_2002_five_positions": (1e-9, [
        ((-7.99710759896726, 0.0009535399325885758), (-3.5794261131828633, -0.43562013682505724), 7.998517050532),
        ((7.983138825270547, 0.027859538428453012), (2.9320700846036436, -8.023883717922446), 13.971709218684346)]),
    "hayes_2002_five_positions_exact": (1e-12, [
        ((-8, 0), (-3.579352554007827, -0.4338609156373123), 8),
        ((8, 0), (2.928561180551858, -8.026426939290278), 14)]),
    "hayes_2004_rrrp": (1e-4, [
        ((8.30109568446976, 5.083745144629524), (3.770492382217225, -2.0318669592375915), 1.1504826897749914),
        ((1.5000002754896864, 1.999999657385456), (-2.0000001850152858, -1.2300605119812605e-07), 2.4999997505588305),
        ((15.604109351170091, -3.436168222358842), (0.22810540012536212, -0.7845436863750664), 12.16266289150423)]),
    "hayes_2004_rrrp_exact": (1e-9, [
        ((8.301095774171904, 5.083745103143986), (3.7704923622913546, -2.031867092504621), 1.1504826543331845),
        ((1.5, 2.0), (-2.0, 0.0), 2.5),
        ((15.604091215825617, -3.436157059492897), (0.22810560587606094, -0.7845456115302727), 12.16263977354195)]),
    "mech576_three_poses": (1e-12, [
        ((16, 0), (7.076702762857621, -14.02358240987242), 15.73827233465615),
        ((0, 0), (7.352058590438461, -5.780259849944223), 23.62332646967654)]),
}


FOUR_POSES = "four_positions"


class Examples(ProgramTest):
    def test_four_poses_give_paired_curves(self):
        document = self.answer(FOUR_POSES)
        self.assertEqual((document["status"], document["solutions"]["dimension"]), ("family", 1))
        self.assertEqual([d["type"] for d in document["dyads"]], ["PR", "RP"])
        self.assertEqual({c["component"] for c in document["curves"]}, {1, 2})
        for curve in document["curves"]:
            self.assertEqual(len(curve["moving"]), len(curve["fixed"]))
            self.assertLess(curve["max_error"], 1e-3)
        self.assertIn("Curves of pivots:", self.good("synthesize", example(FOUR_POSES)).stdout.decode())

    def test_four_poses_give_ranked_linkages_and_figures(self):
        document = self.answer(FOUR_POSES)
        candidates = document["candidates"]
        self.assertEqual([c["rank"] for c in candidates], list(range(1, 7)))
        order = [(not c["one_branch"], c["link_ratio"]) for c in candidates]
        self.assertEqual(order, sorted(order))
        with tempfile.TemporaryDirectory() as folder:
            text = self.good("synthesize", example(FOUR_POSES), "-o", folder).stdout.decode()
            written = set(os.listdir(folder))
        self.assertIn("Linkages from pairs of points of the curves, best first", text)
        self.assertLess({"curves.svg", "dyad_form.svg", "compatibility_linkage.svg"}, written)
        only_sliders = strict_json(self.good("synthesize", example(FOUR_POSES), "--json", "--types", "PR").stdout)
        self.assertNotIn("candidates", only_sliders)

    def answer(self, name):
        document = strict_json(self.good("synthesize", example(name), "--json").stdout)
        jsonschema.validate(document, schema("result"))
        return document

    def near(self, found, expected, tolerance):
        for a, b in zip(found, expected):
            self.assertAlmostEqual(a, b, delta=tolerance * max(1, *map(abs, expected)))

    def test_schemas_and_files(self):
        for name in ("problem", "result"):
            jsonschema.Draft202012Validator.check_schema(schema(name))
        files = sorted(glob.glob(os.path.join(EXAMPLES, "*.json")))
        self.assertGreaterEqual({os.path.basename(f)[:-5] for f in files}, set(DYADS))
        with open(os.path.join(EXAMPLES, "README.md")) as file:
            readme = file.read()
        for path in files:
            jsonschema.validate(load(path), schema("problem"))
            self.assertIn(os.path.basename(path), readme)
            answer = run("synthesize", path, "--json")
            self.assertEqual((answer.returncode, answer.stderr), (0, b""))

    def test_published_dyads(self):
        for name, (tolerance, dyads) in DYADS.items():
            with self.subTest(example=name):
                document = self.answer(name)
                found = [d for d in document["dyads"] if d["type"] == "RR"]
                self.assertGreaterEqual(len(found), len(dyads))
                for dyad, (fixed, moving, length) in zip(found, dyads):
                    self.near(dyad["fixed"] + dyad["moving"] + [dyad["length"]], fixed + moving + (length,), tolerance)
                    self.assertLess(dyad["residual"], 1e-11)

    def test_counts(self):
        for name, real in (("mech576_five_poses", 4), ("hayes_2002_five_positions", 2), ("hayes_2004_rrrp_exact", 4)):
            document = self.answer(name)
            self.assertEqual(document["status"], "exact")
            self.assertEqual({k: document["solutions"][k] for k in ("dimension", "complex", "real")},
                             {"dimension": 0, "complex": 4, "real": real})
            self.assertEqual(len(document["dyads"]), real)
            self.assertEqual(len(document["linkages"]), real * (real - 1) // 2)

    def test_published_linkages(self):
        links = {tuple(l["dyads"]): l for l in self.answer("mech576_designed_fourbar")["linkages"]}
        self.near([links[2, 3]["links"][k] for k in ("ground", "input", "coupler", "output")], (14, 6, 15.5, 9), 1e-9)
        links = {tuple(l["dyads"]): l for l in self.answer("mech576_five_poses")["linkages"]}
        self.near([links[2, 3]["links"]["coupler"]], (15.26484300134219,), 1e-9)
        links = self.answer("mech576_three_poses")["linkages"][0]["links"]
        self.near([links[k] for k in ("ground", "input", "coupler", "output")],
                  (16, 15.73827233465615, 8.247920202014804, 23.62332646967654), 1e-12)
        links = self.answer("hayes_2002_five_positions")["linkages"][0]["links"]
        self.near([links["ground"], links["coupler"]], (15.980, 9.9991), 1e-4)
        self.assertEqual(len(self.answer("hayes_2004_rrrp")["linkages"]), 6)

    def test_the_slider_of_the_rrrp(self):
        slider = self.answer("hayes_2004_rrrp_exact")["dyads"][3]
        self.assertEqual(slider["type"], "PR")
        self.near(slider["moving"], (0, 0), 1e-12)
        self.assertAlmostEqual(slider["line"]["angle"], 60, delta=1e-11)
        # -sin 60 X + cos 60 Y + 2 * 2.3547660358 / 2 = 0, as the reference writes it: K1 X + K2 Y + K3 / 2 = 0
        x, y = slider["line"]["point"]
        self.assertAlmostEqual(-0.4330127018922193 * x + 0.25 * y + 2.3547660358 / 2, 0, delta=1e-12)
        nearly = self.answer("hayes_2004_rrrp")["dyads"][3]  # rounding of the poses decides where the pivot is
        self.assertGreater(nearly["length"], 1e6)
        self.near(nearly["moving"], (0, 0), 1e-5)
        self.assertAlmostEqual(nearly["fixed"][0] / nearly["fixed"][1], -3 ** 0.5, delta=1e-5)

    def test_radians(self):
        document = self.answer("hayes_2004_rrrp_exact")
        degrees = load(example("hayes_2004_rrrp_exact"))
        rows = "".join(f"{p['x']!r},{p['y']!r},{p['angle'] * 3.141592653589793 / 180!r}\n" for p in degrees["poses"])
        radians = strict_json(self.good("synthesize", "-", "--json", text="x,y,angle_rad\n" + rows).stdout)
        jsonschema.validate(radians, schema("result"))
        self.assertEqual(radians["units"]["angle"], "rad")
        self.assertAlmostEqual(radians["dyads"][3]["line"]["angle"], 1.0471975511965976, delta=1e-12)
        self.assertAlmostEqual(radians["poses"][2]["angle"], document["poses"][2]["angle"] * 3.141592653589793 / 180,
                               delta=1e-12)


main()
