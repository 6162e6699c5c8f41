"""report.html in a browser: it sets itself up without an error and has a card for each linkage."""
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
