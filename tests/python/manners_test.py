# SPDX-License-Identifier: MIT
"""How the module behaves: errors with their place, Ctrl-C, the GIL, progress, plots, types."""
import contextlib
import gzip
import io
import json
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import tomllib
import unittest

import numpy as np

import bankshot
import program

bank = json.loads((program.puzzles / "two-cushion-bank.json").read_text())
# The cushion impacts of this puzzle are integrated, so an answer takes minutes.
slow = {**bank, "physics": {"model": "spin", "cushion": {"model": "mathavan2010"}}, "cushions": {"max": 6},
        "budget": {"simulations": 100000000}}


class Errors(unittest.TestCase):
    def test_they_carry_the_path(self):
        cases = (
            ({**bank, "ball": {"at": ["a", 1]}}, "/ball/at/0"),
            ({**bank, "cushion": 1}, "/cushion"),
            ({**bank, "target": {"pocket": "nowhere"}}, "/target/pocket"),
            ({**bank, "ball": {"at": [9, 9]}}, "/ball/at"),
            ({**bank, "speed": [3, 1]}, "/speed"),
            ({}, "/table"),
            ("no JSON", ""),
            ("[]", ""),
        )
        for puzzle, path in cases:
            with self.subTest(puzzle=puzzle):
                with self.assertRaises(bankshot.InvalidInput) as caught:
                    bankshot.solve(puzzle)
                self.assertEqual(caught.exception.path, path)
                self.assertGreater(len(caught.exception.reason), 8)
                self.assertIn(caught.exception.reason, str(caught.exception))
                self.assertIsInstance(caught.exception, ValueError)
                again = pickle.loads(pickle.dumps(caught.exception))
                self.assertEqual((again.path, again.reason), (path, caught.exception.reason))
                told = program.run("solve", "--json", text=puzzle if isinstance(puzzle, str) else json.dumps(puzzle), exit=2)
                self.assertEqual(json.loads(told)["error"], {"path": path, "reason": caught.exception.reason})
        for call in (bankshot.simulate, lambda scene: bankshot.simulate_many(scene, 1, 1)):
            with self.assertRaises(bankshot.InvalidInput) as caught:
                call({"table": "pool-9ft", "ball": {"at": [0.5, 0.5, 0.5]}, "shot": {"speed": 1, "angle": 0}})
            self.assertEqual(caught.exception.path, "/ball/at")

    def test_what_is_no_flag(self):
        for flags in ({"planner": "oracle"}, {"all": True, "first": True}):
            for call in (bankshot.solve, lambda puzzle, **flags: bankshot.solve_batch([puzzle], **flags)):
                with self.assertRaises(bankshot.InvalidInput):
                    call(bank, **flags)
        with self.assertRaises(TypeError):
            bankshot.solve(bank, everything=True)
        with self.assertRaises(TypeError):
            bankshot.solve_batch(bank)
        with self.assertRaises(TypeError):
            bankshot.solve({**bank, "about": object()})
        with self.assertRaisesRegex(bankshot.InvalidInput, "cushions"):
            bankshot.generate(1, 1, cushions="nowhere")
        with self.assertRaisesRegex(LookupError, "puzzle 1 was not found"):
            bankshot.generate(1, 1, cushions=["top", "top"])
        with self.assertRaisesRegex(ValueError, "theme"):
            bankshot.solve(bank).svg("pink")
        with self.assertRaises(bankshot.InvalidInput):
            bankshot.schema("nothing")

    def test_a_batch_goes_on(self):
        answers = bankshot.solve_batch([bank, {**bank, "id": 7, "cushions": -1}, "no JSON", bank], no_timing=True)
        self.assertEqual([a.status for a in answers], ["solved", "invalid", "invalid", "solved"])
        self.assertEqual((answers[1].id, answers[1].error["path"]), (7, "/cushions"))
        self.assertEqual(answers[0].json, answers[3].json)
        self.assertEqual((answers[1].shots, answers[1].best, answers[1]._repr_svg_()), ([], None, None))
        self.assertIn("invalid", repr(answers[1]))
        self.assertEqual(str(answers[1]), answers[1].message)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "puzzles.jsonl.gz"
            with gzip.open(file, "wt") as packed:
                packed.write(json.dumps(bank) + "\n\n" + json.dumps(bank))
            answers = bankshot.solve_batch(str(file))
            self.assertEqual([a.status for a in answers], ["solved", "invalid", "solved"])
            with self.assertRaises(FileNotFoundError):
                bankshot.solve_batch(file.with_suffix(".none"))

    def test_numbers_of_numpy(self):
        puzzle = {**bank, "ball": {"at": np.array(bank["ball"]["at"])}, "budget": {"simulations": np.int64(5000)}}
        plain = {**bank, "budget": {"simulations": 5000}}
        self.assertEqual(bankshot.solve(puzzle, no_timing=True).json, bankshot.solve(plain, no_timing=True).json)


class Interrupted(unittest.TestCase):
    """Each of these would go on for minutes: then the test runs out of time."""

    def interrupted(self, call):
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            call()
        timer.join()
        self.assertEqual(signal.getsignal(signal.SIGINT), signal.default_int_handler)
        self.assertEqual(bankshot.solve(bank).status, "solved")  # the module works as before

    def test_solve(self):
        self.interrupted(lambda: bankshot.solve(slow))

    def test_batch(self):
        self.interrupted(lambda: bankshot.solve_batch([bank] * 1000000))
        with contextlib.redirect_stderr(io.StringIO()):
            self.interrupted(lambda: bankshot.solve_batch([bank] * 1000000, progress=True))

    def test_many(self):
        scene = {"table": {"preset": "pool-9ft", "tilt": [0.002, 0]}, "ball": bank["ball"]}
        self.interrupted(lambda: bankshot.simulate_many(scene, np.full(1000000, 5.0), 33))

    def test_map(self):
        self.interrupted(lambda: bankshot.map(slow, 100, 100))

    def test_a_handler_that_raises_something_else(self):
        def handler(number, frame):
            raise RuntimeError("enough")

        before = signal.signal(signal.SIGINT, handler)
        try:
            threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
            with self.assertRaisesRegex(RuntimeError, "enough"):
                bankshot.solve(slow)
        finally:
            signal.signal(signal.SIGINT, before)


class Threads(unittest.TestCase):
    def test_the_gil_is_released(self):
        """Another thread counts while this one is in the engine; a thread that holds the GIL would stop it."""
        counted, stop = [0], threading.Event()

        def count():
            while not stop.is_set():
                counted[0] += 1

        thread = threading.Thread(target=count)
        thread.start()
        try:
            scene = {"table": "pool-9ft", "ball": bank["ball"]}
            speeds = np.full(200000, 5.0)
            for call in (
                lambda: bankshot.solve_batch([bank] * 50, threads=1),
                lambda: bankshot.simulate_many(scene, speeds, 33.0, threads=1),
            ):
                begin = counted[0]
                call()
                self.assertGreater(counted[0] - begin, 20000)
        finally:
            stop.set()
            thread.join()

    def test_answers_from_many_threads(self):
        from concurrent.futures import ThreadPoolExecutor

        expected = bankshot.solve(bank, no_timing=True).json
        with ThreadPoolExecutor(4) as pool:
            found = list(pool.map(lambda _: bankshot.solve(bank, no_timing=True).json, range(40)))
        self.assertEqual(found, [expected] * 40)


class Progress(unittest.TestCase):
    def told(self, **options):
        out = io.StringIO()
        with contextlib.redirect_stderr(out):
            bankshot.solve_batch([bank] * 20, **options)
        return out.getvalue()

    def test_bars(self):
        self.assertEqual(self.told(), "")  # no terminal
        self.assertEqual(self.told(progress=False), "")
        self.assertIn("20", self.told(progress=True))
        hidden = {name: sys.modules.pop(name) for name in list(sys.modules) if name.split(".")[0] == "tqdm"}
        sys.modules["tqdm"] = None  # as if it were not installed
        try:
            self.assertIn("20 of 20\n", self.told(progress=True))
        finally:
            del sys.modules["tqdm"]
            sys.modules.update(hidden)


class Pictures(unittest.TestCase):
    def test_notebooks_and_plots(self):
        import matplotlib

        matplotlib.use("svg")
        import matplotlib.pyplot as plt

        answer = bankshot.solve_all((program.puzzles / "bank-shot.json").read_text())
        self.assertTrue(answer._repr_svg_().startswith("<svg"))
        self.assertIn("<animate", answer.svg(animate=True))
        _, ax = plt.subplots()
        self.assertIs(answer.plot(ax), ax)
        own = [line for line in ax.lines if line.get_label().startswith(f"{answer.best.angle:.2f}")]
        x, y = own[0].get_data()
        self.assertEqual((x[0], y[0]), tuple(answer.puzzle.ball["at"]))
        self.assertGreater(len(ax.lines), len(answer.shots))
        with_range = {**bank, "ball": {**bank["ball"], "spin": {"side": [-0.5, 0.5]}}}
        self.assertIsNotNone(bankshot.solve(with_range).plot())
        path = answer.trajectory()
        self.assertTrue(path._repr_svg_().startswith("<svg"))
        self.assertIsNotNone(path.plot())


class Versions(unittest.TestCase):
    def test_the_package_is_of_the_program(self):
        with open(program.repository / "pyproject.toml", "rb") as file:
            project = tomllib.load(file)["project"]
        self.assertEqual(project["version"], bankshot.__version__)
        self.assertEqual(program.run("--version").split()[:2], ["bankshot", bankshot.__version__])


class Types(unittest.TestCase):
    def test_mypy(self):
        """The module itself, strictly, and a program that uses it."""
        package = pathlib.Path(bankshot.__file__).parent
        user = pathlib.Path(__file__).with_name("user.py")
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [sys.executable, "-m", "mypy", "--config-file", program.repository / "pyproject.toml", "--cache-dir", folder,
                 package, user], capture_output=True, text=True,
            )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("no issues found in 10 source files", done.stdout)
        wrong = user.read_text() + "\nspeed: str = bankshot.solve({}).shots[0].speed\n"
        done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "-c", wrong], capture_output=True, text=True)
        self.assertIn('expression has type "float"', done.stdout)


if __name__ == "__main__":
    unittest.main()
