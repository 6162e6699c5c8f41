"""Batch: one line out for each line in, in order, the same on any number of threads, flushed as they finish."""
import json
import os
import random
import subprocess
import sys

sys.path.insert(0, os.path.join(sys.argv[2], "tests", "support"))
from program import FIVE_POSES, PROGRAM, ProgramTest, main, run, strict_json  # noqa: E402


def tasks(count):
    stream = random.Random("batch")
    return [dict(FIVE_POSES, name=f"task {i}", poses=[[stream.uniform(-9, 9), stream.uniform(-9, 9),
                                                       stream.uniform(-90, 90)]
                                                      for _ in range(5)]) for i in range(count)]


def lines_of(problems):
    return "".join((p if isinstance(p, str) else json.dumps(p)) + "\n" for p in problems)


class Batch(ProgramTest):
    def test_order_and_threads(self):
        problems = tasks(300)
        text = lines_of(problems)
        first = self.good("batch", "-j", "1", text=text).stdout
        for threads in ("2", "7", "64", "0"):
            self.assertEqual(self.good("batch", "-j", threads, text=text).stdout, first)
        self.assertEqual(self.good("batch", text=text).stdout, first)
        answers = [strict_json(line) for line in first.decode().splitlines()]
        self.assertEqual([a["name"] for a in answers], [p["name"] for p in problems])

    def test_lines_are_those_of_synthesize_without_curves(self):
        for problem in tasks(5):
            line = strict_json(self.good("batch", text=lines_of([problem])).stdout)
            full = strict_json(self.good("synthesize", "-", "--json", text=json.dumps(problem)).stdout)
            self.assertNotIn("curves", line)
            del full["curves"]
            self.assertEqual(line, full)

    def test_bad_lines_keep_their_place(self):
        good = FIVE_POSES
        problems = [good, "nonsense", good, "", "{\"geometry\": \"planar\"}", "x,y,angle_deg", good, "[" * 5000, "  "]
        answer = run("batch", text=lines_of(problems)[:-1])  # no newline at the end
        self.assertEqual(answer.returncode, 2)
        answers = [strict_json(line) for line in answer.stdout.decode().splitlines()]
        self.assertEqual(len(answers), len(problems))
        for number, (problem, reply) in enumerate(zip(problems, answers), 1):
            if problem is good:
                self.assertEqual(reply["status"], "exact")
            else:
                self.assertEqual(reply["status"], "error")
                self.assertEqual(reply["line"], number)
                self.assertTrue(reply["message"].startswith(f"line {number}"), reply)
                self.assertIn("expected", reply["message"])
        self.assertEqual(answers[1]["message"], "line 2, column 1: expected a value, got nonsense")
        self.assertEqual(answer.stderr.count(b"\n"), 1)

    def test_lines_that_this_version_cannot_answer(self):
        unknown = {"geometry": "planar", "poses": [[i * i, i, 10 * i] for i in range(6)]}
        answer = run("batch", text=lines_of([FIVE_POSES, unknown]))
        self.assertEqual(answer.returncode, 4)
        self.assertIn("not available yet: ", strict_json(answer.stdout.decode().splitlines()[1])["message"])
        self.assertEqual(run("batch", text=lines_of([unknown, "x"])).returncode, 2)

    def test_geometry_for_lines_without_one(self):
        problem = {"poses": FIVE_POSES["poses"]}
        self.assertEqual(run("batch", text=lines_of([problem])).returncode, 2)
        self.assertEqual(strict_json(self.good("batch", "--geometry", "planar",
                                               text=lines_of([problem])).stdout)["geometry"], "planar")

    def test_no_lines(self):
        self.assertEqual(self.good("batch", text="").stdout, b"")

    def test_lines_come_while_the_input_is_open(self):
        with subprocess.Popen([PROGRAM, "batch", "-j", "2"], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
            for problem in tasks(20):
                process.stdin.write(lines_of([problem]).encode())
                process.stdin.flush()
                self.assertEqual(strict_json(process.stdout.readline())["name"], problem["name"])
            process.stdin.close()
            self.assertEqual(process.wait(60), 0)


main()
