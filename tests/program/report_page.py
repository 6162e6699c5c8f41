"""report.html in a browser: it sets itself up without an error and has a card for each linkage."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(sys.argv[2], "tests", "support"))
from program import ProgramTest, example, main, run, strict_json  # noqa: E402

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
if not BROWSER:
    print("no chromium here")
    sys.exit(77)
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", "--enable-logging=stderr",
         "--virtual-time-budget=5000", "--window-size=1300,1000"]


class ReportPage(ProgramTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def open(self, page):
        """The page's elements after its script ran, and what it said on the console."""
        profile = os.path.join(self.folder, "profile")
        answer = subprocess.run([BROWSER, *FLAGS, f"--user-data-dir={profile}", "--dump-dom", "file://" + page],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return answer.stdout.decode(), [l for l in answer.stderr.decode(errors="replace").splitlines()
                                        if ":CONSOLE" in l]

    def check(self, *arguments, **options):
        self.assertEqual(run("synthesize", *arguments, "-o", self.folder, **options).returncode, 0)
        page = os.path.join(self.folder, "report.html")
        elements, console = self.open(page)
        self.assertEqual(console, [])
        self.assertIn('data-ready="1"', elements[:300])
        with open(os.path.join(self.folder, "result.json")) as file:
            result = strict_json(file.read())
        self.assertEqual(len(re.findall(r'<button[^>]*class="card[" ]', elements)), len(result["linkages"]))
        self.assertEqual(len(re.findall(r"<tr[^>]*data-dyad=", elements)), len(result["dyads"]))
        return elements, result

    def test_examples(self):
        for name in ("mech576_five_poses", "hayes_2004_rrrp_exact", "hayes_2002_five_positions", "angeles_bai_1",
                     "angeles_bai_2_exact"):
            with self.subTest(example=name):
                elements, result = self.check(example(name))
                self.assertIn(f'<h1 id="name">{result["name"]}</h1>', elements)

    def test_the_sphere_turns(self):
        self.assertEqual(run("synthesize", example("angeles_bai_2_exact"), "-o", self.folder).returncode, 0)
        page = os.path.join(self.folder, "report.html")
        with open(page) as file:
            text = file.read()
        pictures = []
        for key in ("x", "ArrowLeft"):  # one that means nothing, one that turns
            press = ('<script>burmesterReport.select(6); document.getElementById("svg-linkage")'
                     f'.dispatchEvent(new KeyboardEvent("keydown", {{key: "{key}"}}));</script></body>')
            with open(page, "w") as file:
                file.write(text.replace("</body>", press))
            elements, console = self.open(page)
            self.assertEqual(console, [])
            pictures.append(re.search(r'<svg id="svg-linkage".*?</svg>', elements, re.S).group())
            for part in ("s-link", "s-guide", "s-block", "s-task", "s-body", "far"):
                self.assertIn(part, pictures[-1])
            self.assertNotIn("NaN", pictures[-1])
        self.assertNotEqual(*pictures)

    def check_poses(self, *poses, geometry="planar"):
        return self.check("-", text=json.dumps({"geometry": geometry, "poses": poses}))

    def test_families(self):
        """The tables of a family, row by row, and its best four-bar drawn in figure 1 among its curves."""
        def rows(elements, table):
            part = re.search(f'<div id="table-{table}"><h3>(.*?)</table>', elements, re.S)
            return len(re.findall("<tr[ >]", part.group(1))) - 1 if part else 0

        line = [{"x": i, "y": 0.5 * i, "angle": 10 * i * i} for i in range(4)]
        turns = [{"axis": axis, "angle": 25 * (i + 1)} for i, axis in enumerate([[0, 0, 1], [0, 3, 10], [5, 3, 9]])]
        for geometry, poses, poles in (("planar", line[:2], 1), ("planar", line[:3], 3), ("spherical", turns, 3)):
            with self.subTest(geometry=geometry, poses=len(poses)):
                elements, result = self.check_poses(*poses, geometry=geometry)
                self.assertGreater(len(result["samples"]), 12)
                self.assertIn("Give fixed or moving " + ("axes" if geometry == "spherical" else "pivots"), elements)
                self.assertEqual([rows(elements, t) for t in ("poles", "samples", "candidates")], [poles, 12, 0])
                self.assertIn(f'Samples: 12 of {len(result["samples"])} in all', elements)
        elements, result = self.check_poses(*line)
        self.assertGreater(len(result["candidates"]), 0)
        self.assertEqual([rows(elements, t) for t in ("poles", "samples", "candidates")],
                         [0, 0, len(result["candidates"])])
        table = re.search(r'<div id="table-candidates">.*?</table>', elements, re.S).group()
        for candidate in result["candidates"]:
            for length in (*candidate["links"].values(), candidate["link_ratio"]):
                self.assertIn(f'title="{length!r}"', table)
        self.assertNotIn('class="coupler"', re.search(r'<svg id="svg-poses".*?</svg>', elements, re.S).group())
        page = os.path.join(self.folder, "report.html")
        with open(page) as file:
            text = file.read()
        with open(page, "w") as file:
            file.write(text.replace("</body>", '<script>document.querySelector("#table-candidates button.id").click();'
                                               "</script></body>"))
        elements, console = self.open(page)
        self.assertEqual(console, [])
        figure = re.search(r'<svg id="svg-poses".*?</svg>', elements, re.S).group()
        for part in ("coupler", "dyad", "curve-fixed", "curve-moving"):
            self.assertIn(f'class="{part}"', figure)
        self.assertNotIn("NaN", figure)
        self.assertRegex(elements, r'<tr data-candidate="1" class="chosen">')

    def test_nothing_to_show(self):
        self.check(example("mech576_five_poses"), "--types", "PP")

    def test_the_page_loads_nothing(self):
        self.check(example("mech576_five_poses"))
        with open(os.path.join(self.folder, "report.html")) as file:
            page = file.read()
        self.assertNotIn("/*BURMESTER_", page)
        for address in re.findall(r"""(?:src|href)=["']([^"']*)["']""", page):
            self.assertTrue(address.startswith(("data:", "#")), address)
        self.assertEqual(set(re.findall(r"https?://[^\s\"'<>)]*", page)) - {"http://www.w3.org/2000/svg"}, set())

    def test_this_test_sees_errors(self):
        self.check(example("mech576_five_poses"))
        page = os.path.join(self.folder, "report.html")
        with open(page) as file:
            text = file.read().replace('"result":', '"result": {"dyads": 1}, "r":', 1)
        with open(page, "w") as file:
            file.write(text)
        elements, console = self.open(page)
        self.assertNotEqual(console, [])
        self.assertNotIn('data-ready="1"', elements[:300])


main()
