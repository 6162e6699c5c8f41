"""Commands, options and exit codes; output folders; broken pipes."""
import json
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

sys.path.insert(0, os.path.join(sys.argv[2], "tests", "support"))
from program import FIVE_POSES, PROGRAM, ProgramTest, example, main, run, strict_json  # noqa: E402

COMMANDS = ["synthesize", "analyze", "platform", "export", "reproduce", "batch", "modules"]
PROBLEM = json.dumps(FIVE_POSES)


class Help(ProgramTest):
    def test_version_and_help(self):
        self.assertRegex(self.good("--version").stdout.decode(), r"^burmester \d+\.\d+\.\d+\n$")
        text = self.good("--help").stdout.decode()
        for command in COMMANDS:
            self.assertIn(command, text)
            mine = self.good(command, "--help").stdout.decode()
            self.assertIn("--plugin", mine)
            self.assertTrue(mine.endswith("\n"))

    def test_bad_usage(self):
        for arguments in ([], ["sing"], ["--sing"], ["synthesize"],
                          ["synthesize", example("mech576_five_poses"), "--sing"],
                          ["synthesize", "a", "b"], ["batch", "-j", "x"], ["batch", "-j", "-1"], ["batch", "-j"],
                          ["modules", "x"], ["batch", "--geometry", "flat"], [""], ["synthesize", "-o"]):
            with self.subTest(arguments=arguments):
                self.assertIn("expected", self.refused(*arguments, text=PROBLEM))

    def test_not_available(self):
        for arguments in (["analyze"], ["analyze", "x.json", "--linkage", "2", "-o", "d", "--json"],
                          ["platform", "x.json"],
                          ["export", "r.json", "--linkage", "1", "--format", "dxf"], ["reproduce"],
                          ["reproduce", "--list"],
                          ["modules", "--plugin", "x.so"], ["synthesize", "x.json", "--plugin", "x.so"]):
            with self.subTest(arguments=arguments):
                self.assertTrue(self.refused(*arguments, code=4).startswith("not available yet: "))

    def test_a_known_request_that_cannot_be_answered(self):
        line = self.refused("synthesize", "-", code=4, text=json.dumps(
            {"geometry": "planar", "poses": [[i, i * i, 10 * i] for i in range(9)]}))
        self.assertTrue(line.startswith("not available yet: "))

    def test_modules(self):
        modules = strict_json(self.good("modules", "--json").stdout)["modules"]
        self.assertEqual([m["name"] for m in modules], ["planar", "spherical"])
        self.assertEqual(modules[0]["dyad_types"], ["RR", "PR", "RP", "PP"])
        for module in modules:
            self.assertEqual(module["origin"], "built in")
            self.assertIsInstance(module["solvers"], list)
        self.assertIn(b"planar", self.good("modules").stdout)


class Synthesize(ProgramTest):
    def test_table(self):
        text = self.good("synthesize", example("hayes_2004_rrrp_exact")).stdout.decode()
        for words in ("Five poses of the generating RRRP", "Dyads", "Linkages", "PR", "RRRP", "at 60 deg", "12.16"):
            self.assertIn(words, text)
        self.assertLessEqual(max(map(len, text.split("\n"))), 100)

    def test_json_alone_on_standard_output(self):
        answer = self.good("synthesize", "-", "--json", text=PROBLEM)
        document = strict_json(answer.stdout)
        self.assertEqual(answer.stderr, b"")
        self.assertEqual(document["schema"], "burmester/result/1")
        self.assertEqual([d["id"] for d in document["dyads"]], [1, 2, 3, 4])
        self.assertEqual(document["pose_count"], 5)

    def test_csv(self):
        rows = "".join(f"{x}, {y},{a}\r\n" for x, y, a in FIVE_POSES["poses"])
        csv = strict_json(self.good("synthesize", "-", "--json", text="x,y,angle_deg\r\n" + rows).stdout)
        other = strict_json(self.good("synthesize", "-", "--json", text=PROBLEM).stdout)
        self.assertEqual(csv, other)

    def test_types_choose_dyads_and_leave_the_counts(self):
        full = strict_json(self.good("synthesize", example("hayes_2004_rrrp_exact"), "--json").stdout)
        for types in (["PR"], ["RR"], ["PR", "RR"], ["PP"], ["RP", "PP"]):
            some = strict_json(self.good("synthesize", example("hayes_2004_rrrp_exact"), "--json", "--types",
                                         ",".join(types)).stdout)
            self.assertEqual(some["solutions"], full["solutions"])
            self.assertEqual(some["dyads"], [d for d in full["dyads"] if d["type"] in types])
            left = {d["id"] for d in some["dyads"]}
            self.assertEqual(some["linkages"], [l for l in full["linkages"] if set(l["dyads"]) <= left])
        line = self.refused("synthesize", example("hayes_2004_rrrp_exact"), "--types", "RR,XX")
        self.assertIn("--types: expected RR, PR, RP or PP, got \"XX\"", line)

    def test_no_certify_is_taken(self):
        self.good("synthesize", "-", "--no-certify", text=PROBLEM)

    def test_warnings_go_to_both_places(self):
        problem = dict(FIVE_POSES, nmae="typo")
        answer = self.good("synthesize", "-", "--json", text=json.dumps(problem))
        self.assertEqual(answer.stderr.decode(), "standard input: warning: nmae: unknown key, ignored\n")
        self.assertEqual(strict_json(answer.stdout)["warnings"], ["nmae: unknown key, ignored"])

    def test_control_characters_do_not_reach_the_terminal(self):
        answer = self.good("synthesize", "-", text=json.dumps(dict(FIVE_POSES, name="a\x1b[2Jb\nc\x00")))
        self.assertNotIn(b"\x1b", answer.stdout + answer.stderr)
        self.assertNotIn(b"\x00", answer.stdout + answer.stderr)


class Folder(ProgramTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_files(self):
        out = os.path.join(self.folder, "a", "b")
        for _ in range(2):
            answer = self.good("synthesize", example("mech576_five_poses"), "-o", out, "--json")
        self.assertIn(b"report.html", answer.stderr)
        self.assertEqual(sorted(os.listdir(out)), sorted(
            ["report.html", "result.json", "poses.svg"] + [f"{figure}_{k}.svg" for k in range(1, 7)
                                                           for figure in ("linkage", "surfaces")]))
        with open(os.path.join(out, "result.json"), "rb") as file:
            self.assertEqual(file.read(), answer.stdout)
        for name in os.listdir(out):
            if name.endswith(".svg"):
                tree = xml.etree.ElementTree.parse(os.path.join(out, name))
                self.assertIn("Five poses", tree.find("{http://www.w3.org/2000/svg}title").text)

    def test_a_name_cannot_break_the_files(self):
        name = "</script><script>alert(1)</script> <!-- & \" ]]>"
        self.good("synthesize", "-", "-o", self.folder, text=json.dumps(dict(FIVE_POSES, name=name)))
        with open(os.path.join(self.folder, "report.html")) as file:
            self.assertNotIn("<script>alert", file.read())
        tree = xml.etree.ElementTree.parse(os.path.join(self.folder, "poses.svg"))
        self.assertIn("alert(1)", tree.find("{http://www.w3.org/2000/svg}title").text)

    def test_fewer_linkages_leave_no_old_figures(self):
        self.good("synthesize", example("mech576_five_poses"), "-o", self.folder)
        self.good("synthesize", example("hayes_2002_five_positions"), "-o", self.folder)
        self.assertEqual([n for n in sorted(os.listdir(self.folder)) if n.startswith("linkage")], ["linkage_1.svg"])

    def test_no_place_to_write(self):
        file = os.path.join(self.folder, "file")
        open(file, "w").close()
        for out in (file, os.path.join(file, "below"), "/proc/nothing/here"):
            self.assertIn("expected a folder to write to", self.refused("synthesize", "-", "-o", out, text=PROBLEM))
        os.mkdir(os.path.join(self.folder, "result.json"))
        self.assertIn("expected a file to write to", self.refused("synthesize", "-", "-o", self.folder, text=PROBLEM))
        self.assertFalse([n for n in os.listdir(self.folder) if n.startswith(".")])

    def test_a_bad_problem_leaves_no_folder(self):
        out = os.path.join(self.folder, "new")
        self.refused("synthesize", "-", "-o", out, text="{}")
        self.assertFalse(os.path.exists(out))


class Streams(ProgramTest):
    def test_closed_streams(self):
        closed = run("modules", stdout=None, preexec_fn=lambda: os.close(1))
        self.assertEqual(closed.returncode, 3)
        self.assertIn(b"internal failure: standard output cannot be written", closed.stderr)
        no_input = run("synthesize", "-", stdin=None, preexec_fn=lambda: os.close(0))
        self.assertEqual((no_input.returncode, no_input.stdout), (2, b""))

    def test_full_disk(self):
        with open("/dev/full", "wb") as full:
            answer = run("modules", stdout=full)
        self.assertEqual(answer.returncode, 3)
        self.assertEqual(answer.stderr.count(b"\n"), 1)

    def test_a_reader_that_leaves(self):
        lines = (PROBLEM + "\n") * 2000
        for arguments in (["batch"], ["modules"]):
            with subprocess.Popen([PROGRAM, *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE) as process:
                process.stdout.close()
                try:
                    process.stdin.write(lines.encode())
                    process.stdin.close()
                except BrokenPipeError:
                    pass
                self.assertEqual(process.stderr.read(), b"")
                process.stderr.close()
                self.assertEqual(process.wait(60), 0)


main()
