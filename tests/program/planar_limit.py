"""The research app burmester-planar-limit: its figure, its exponents, wrong input."""
import json
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

sys.path.insert(0, os.path.join(sys.argv[2], "tests", "support"))
import program  # noqa: E402
from program import ProgramTest, SOURCE, example, main  # noqa: E402

RESEARCH = os.path.join(os.path.dirname(program.PROGRAM), "burmester-planar-limit")
FIVE = os.path.join(SOURCE, "apps", "research", "planar_limit", "five_poses.json")
SVG = "{http://www.w3.org/2000/svg}"


class PlanarLimit(ProgramTest):
    def app(self, *arguments, text=""):
        return subprocess.run([RESEARCH, *arguments], input=text.encode(), stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=120)

    def figure(self, problem):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "new", "limit.svg")
            answer = self.app(problem, "-o", path)
            self.assertEqual((answer.returncode, answer.stderr), (0, b""))
            with open(path, encoding="utf-8") as file:
                return answer.stdout.decode(), file.read()

    def test_four_dyads_arrive_with_the_square(self):
        for problem in (FIVE, example("mech576_five_poses")):
            with self.subTest(problem=problem):
                text, figure = self.figure(problem)
                rows = re.findall(r"^ +(\d)  .*\)  (\S+)  (\S+)  (\S+)  (\S+)$", text, re.M)
                self.assertEqual([row[0] for row in rows], ["1", "2", "3", "4"])
                for _, *apart, exponent in rows:
                    self.assertGreater(float(apart[1]), 50 * float(apart[2]))
                    self.assertLess(abs(float(exponent) - 2), 0.01)
                self.assertIn("The other 2 dyads: complex for every e up to 0.5.", text)
                root = xml.etree.ElementTree.fromstring(figure)
                self.assertEqual(root.tag, SVG + "svg")
                self.assertFalse(re.search(r"\b(nan|inf)\b", figure, re.I))
                fixed = [c for c in root.iter(SVG + "circle") if c.get("r") == "4.5" and c.get("fill") != "#fff"]
                self.assertEqual(len(fixed), 4 + 1)  # four dyads and the legend

    def test_the_figure_of_the_documents_is_current(self):
        with open(os.path.join(SOURCE, "docs", "images", "planar_limit.svg"), encoding="utf-8") as file:
            kept = xml.etree.ElementTree.parse(file)
        texts = lambda root: ["".join(t.itertext()) for t in root.iter(SVG + "text")]  # noqa: E731
        self.assertEqual(texts(kept), texts(xml.etree.ElementTree.fromstring(self.figure(FIVE)[1])))

    def test_a_slider_runs_off_and_is_real(self):
        text, _ = self.figure(example("hayes_2004_rrrp_exact"))
        self.assertIn("real RR dyads: 3", text)
        self.assertIn("The other 3 dyads: 1 real already at e = 0.001.", text)

    def test_nothing_to_follow_is_an_answer(self):
        shifts = {"geometry": "planar", "poses": [[k, k * k, 0] for k in range(5)]}
        answer = self.app("-", text=json.dumps(shifts))
        self.assertEqual((answer.returncode, answer.stderr), (0, b""))
        self.assertTrue(answer.stdout.startswith(b"No RR dyad to follow: "), answer.stdout)

    def test_wrong_input_is_one_line(self):
        five = example("mech576_five_poses")
        for arguments, text, words in (([example("angeles_bai_1")], "", "geometry: expected planar"),
                                       ([example("mech576_three_poses")], "", "poses: expected 5 poses, got 3"),
                                       (["-"], "{", "expected"), (["/nowhere.json"], "", "/nowhere.json: expected"),
                                       ([], "", "expected"),
                                       ([five, "--sing"], "", "expected"),
                                       ([five, "-o", "/"], "", "-o: expected a file"),
                                       ([five, "-o", os.path.join(five, "x")], "", "expected a folder")):
            with self.subTest(arguments=arguments, text=text):
                answer = self.app(*arguments, text=text)
                self.assertEqual((answer.returncode, answer.stdout), (2, b""))
                self.assertEqual(answer.stderr.count(b"\n"), 1, answer.stderr)
                self.assertIn(words, answer.stderr.decode())

    def test_help(self):
        self.assertIn(b"-o FILE", self.app("--help").stdout)


main()
