# SPDX-License-Identifier: MIT
"""The module's answers are the program's, to the byte: all puzzles of the repository, and 200 generated ones."""
import json
import pathlib
import pickle
import tempfile
import unittest

import bankshot
import program


class Answers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.puzzles = program.examples() + program.made()
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "puzzles.jsonl"
            file.write_text("".join(json.dumps(json.loads(p)) + "\n" for p in cls.puzzles))
            cls.answers = program.run("batch", file, "--no-timing", "--quiet").splitlines()
            cls.from_file = [a.json for a in bankshot.solve_batch(file, no_timing=True)]
        assert len(cls.answers) == len(cls.puzzles) >= 350, len(cls.puzzles)

    def test_solve(self):
        for i, puzzle in enumerate(self.puzzles):
            with self.subTest(i, puzzle=puzzle):
                self.assertEqual(bankshot.solve(puzzle, no_timing=True).json, self.answers[i])

    def test_solve_as_the_command_prints_it(self):
        for puzzle in self.puzzles[::20]:
            with self.subTest(puzzle=puzzle):
                for flags, words in (({}, []), ({"all": True}, ["--all"]), ({"path": True}, ["--path"])):
                    told = program.run("solve", "--json", "--no-timing", *words, text=puzzle, exit=(0, 1))
                    self.assertEqual(bankshot.solve(puzzle, no_timing=True, **flags).json + "\n", told)

    def test_batch(self):
        self.assertEqual(self.from_file, self.answers)
        dicts = [json.loads(p) for p in self.puzzles[::5]]
        for threads in (1, 3):
            answers = bankshot.solve_batch(dicts, threads=threads, no_timing=True)
            self.assertEqual([a.json for a in answers], self.answers[::5])

    def test_every_way_to_write_a_puzzle(self):
        for puzzle, answer in zip(self.puzzles[::15], self.answers[::15]):
            as_dict = json.loads(puzzle)
            for document in (as_dict, bankshot.Puzzle.from_dict(as_dict), puzzle.encode()):
                with self.subTest(puzzle=puzzle):
                    self.assertEqual(bankshot.solve(document, no_timing=True).json, answer)

    def test_words_and_pictures(self):
        """Also of an answer that was pickled, which is solved again for them."""
        files = sorted(program.puzzles.glob("*.json"))
        for file in files:
            with self.subTest(file=file.name):
                answer = bankshot.solve(file.read_text())
                words = program.run("solve", file, exit=(0, 1)).splitlines()
                words = [line for line in words if not line.startswith("  safer ")]
                self.assertEqual(str(answer).splitlines(), words)
                picture = program.repository / "examples" / "figures" / f"{file.stem}.svg"
                drawn = answer.svg(animate=file.stem == "three-cushion-carom")
                self.assertEqual(drawn, picture.read_text())
                again = pickle.loads(pickle.dumps(answer))
                self.assertEqual(again, answer)
                self.assertEqual((str(again), again.svg()), (str(answer), answer.svg()))
        self.assertGreaterEqual(len(files), 11)

    def test_verify(self):
        held = 0
        for puzzle in self.puzzles[::40]:
            answer = bankshot.solve(puzzle)
            report = bankshot.verify(puzzle, answer)
            self.assertTrue(report["holds"], report)
            held += report["checked"]
            if not answer.shots:
                continue
            false = answer.to_dict()
            false["shots"][0]["arrival"]["speed"] += 0.001
            report = bankshot.verify(puzzle, false)
            self.assertFalse(report["holds"])
            self.assertIn("arrival speed", {claim["claim"] for claim in report["failed"]})
        self.assertGreater(held, 80)

    def test_generate(self):
        for seed, words in program.seeds[:3]:
            wishes = dict(zip([word.strip("-") for word in words[::2]], words[1::2]))
            told = program.run("generate", "--count", 10, "--seed", seed, *words).splitlines()
            made = bankshot.generate(10, seed, **wishes)
            self.assertEqual([puzzle.to_dict() for puzzle in made], [json.loads(line) for line in told])
        banks = bankshot.generate(2, 4, target="pot", cushions=0, then=(1, 1))
        self.assertEqual({puzzle.target["then"]["cushions"] for puzzle in banks}, {1})

    def test_fit(self):
        shot = {"table": "pool-9ft", "ball": {"at": [0.6, 0.4]}, "physics": {"model": "spin", "cushion": {"model": "han2005", "restitution": 0.8}}}
        recordings = []
        for i in range(1, 5):
            text = json.dumps({**shot, "shot": {"speed": i + 0.5, "angle": 30 * i + 7}})
            recordings.append(program.run("simulate", "-", "--record", 60, "--noise", 1, "--seed", i, text=text))
        told = program.run("fit", "-", "--free", "cushion.restitution", "-j", 1, "--quiet", text="".join(recordings))
        found = bankshot.fit(recordings, free=["cushion.restitution"], threads=1)
        self.assertEqual(found, json.loads(told))
        self.assertAlmostEqual(found["physics"]["cushion"]["restitution"], 0.8, delta=0.001)
        learnt = {**json.loads(self.puzzles[0]), "physics": found["physics"]}
        self.assertIn(bankshot.solve(learnt).status, ("solved", "no-shot"))
        with self.assertRaises(bankshot.InvalidInput):
            bankshot.fit([])
        with self.assertRaises(bankshot.InvalidInput):
            bankshot.fit(["{}"])
        with self.assertRaisesRegex(ValueError, "none of"):
            bankshot.fit(recordings, rolling="square")

    def test_map(self):
        puzzle = (program.puzzles / "two-cushion-bank.json").read_text()
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "map.csv"
            program.run("map", "-", "--grid", 8, 4, "-o", file, text=puzzle)
            header, *rows = (line.split(",") for line in program.lines_of(file))
        found = bankshot.map(puzzle, 8, 4)
        self.assertEqual((found.shape, list(found.dtype.names)), ((4, 8), header))
        for cell, row in zip(found.ravel(), rows):
            for value, text in zip(cell, row):
                if isinstance(value, str):
                    self.assertEqual(value, text)
                else:
                    self.assertEqual(repr(float(value)), repr(float(text or "nan")))
        self.assertGreater(sum(found["status"].ravel() == "solved"), 10)

    def test_map_of_values(self):
        puzzle = json.loads((program.puzzles / "first-shot.json").read_text())
        found = bankshot.map(puzzle, 8, 4, value=True)
        self.assertEqual(found.dtype.names, ("x_m", "y_m", "status", "value", "ball", "pocket"))
        legal = found[found["status"] == "legal"]
        best = legal[legal["value"].argmax()]
        self.assertEqual((best["status"], best["ball"], best["pocket"]), ("legal", "8", "top-right"))
        self.assertGreater(best["value"], 0.9)


class Shots(unittest.TestCase):
    def test_keys_are_those_of_the_schema(self):
        """A key of the format that a class does not have would be refused: it has them all."""
        answer = bankshot.schema("answer")
        keys = set(answer["$defs"]["answer_shot"]["properties"])
        self.assertEqual(keys, set(bankshot.Shot.__dataclass_fields__))
        puzzle = set(bankshot.schema("puzzle")["properties"])
        self.assertEqual(puzzle, set(bankshot.Puzzle.__dataclass_fields__))
        scene = {"table", "ball", "shot", "physics", "others", "settle", "unit", "until", "id"}
        self.assertEqual(scene, set(bankshot.Scene.__dataclass_fields__))

    def test_what_a_user_sees(self):
        answer = bankshot.solve_all(json.loads((program.puzzles / "bank-shot.json").read_text()))
        told = json.loads(answer.json)
        self.assertEqual(answer.to_dict(), told)
        self.assertEqual((answer.status, answer.solved), ("solved", True))
        self.assertEqual([shot.to_dict() for shot in answer.shots], told["shots"])
        self.assertEqual(answer.best.angle, told["shots"][0]["angle"])
        self.assertIn(f"{answer.best.speed:.2f} m/s", repr(answer))
        self.assertGreater(answer.time_us, 0)
        miss = bankshot.solve((program.puzzles / "too-soft.json").read_text())
        self.assertEqual((miss.status, miss.best, miss.shots), ("no-shot", None, []))
        self.assertIn("no-shot", repr(miss))
        self.assertEqual(miss.nearest.why, json.loads(miss.json)["nearest"]["why"])


if __name__ == "__main__":
    unittest.main()
