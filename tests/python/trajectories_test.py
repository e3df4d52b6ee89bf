# SPDX-License-Identifier: MIT
"""Arrays of shots: against the program, against a closed form, and many launches against each one alone."""
import csv
import json
import math
import pickle
import unittest

import numpy as np

import bankshot
import program

scene = {"table": "pool-9ft", "ball": {"at": [0.635, 0.40]}, "shot": {"speed": 2.5, "angle": 37.44}}
rack = {**scene, "others": [{"id": "1", "at": [1.9, 0.635]}, {"id": "a, b", "at": [1.96, 0.66]}], "shot": {"speed": 6, "angle": 10.5}}


class Paths(unittest.TestCase):
    def test_rows_and_events_are_the_programs(self):
        for document in (scene, rack, {**scene, "physics": "rolling"}, {**scene, "until": {"cushions": 1}}):
            text = json.dumps(document)
            path = bankshot.simulate(document, rate=100)
            self.assertEqual(path.json + "\n", program.run("simulate", "--json", text=text))
            told = list(csv.reader(program.run("simulate", "--csv", "-", "--rate", 100, text=text).splitlines()))[1:]
            self.assertEqual(len(path.rows), len(told))
            self.assertGreater(len(told), 50)
            for row, words in zip(path.rows, told):
                self.assertEqual(path.balls[row["ball"]], words[1])
                self.assertEqual([row["t"], *list(row)[2:]], [float(words[0]), *map(float, words[2:])])
            self.assertEqual(path.svg(), bankshot.simulate(text, rate=100).svg())
            self.assertEqual(path.events, json.loads(path.json)["events"])

    def test_columns(self):
        path = bankshot.simulate(rack)
        own = path.of("cue")
        for name in ("t", "x", "y", "vx", "vy", "wx", "wy", "wz"):
            np.testing.assert_array_equal(getattr(path, name), own[name])
        self.assertEqual(path.balls, ["cue", "1", "a, b"])
        self.assertEqual(len(path.of("1")) + len(path.of("a, b")) + len(own), len(path.rows))
        with self.assertRaisesRegex(KeyError, "cue, 1"):
            path.of("9")
        self.assertEqual(pickle.loads(pickle.dumps(path)).json, path.json)
        self.assertIn("Trajectory rest after", repr(path))

    def test_a_ball_that_rolls_out(self):
        """Without cushions: v^2 / 2 mu g, and on the way v t - mu g t^2 / 2."""
        mu, g, v = 0.01, 9.81, 0.4
        path = bankshot.simulate(
            {"table": {"length": 10, "width": 10}, "ball": {"at": [1, 1]}, "physics": {"model": "rolling", "friction": mu},
             "shot": {"speed": v, "angle": 0}}
        )
        self.assertAlmostEqual(path.end["length"], v * v / (2 * mu * g), delta=1e-12)
        np.testing.assert_allclose(path.x, 1 + v * path.t - mu * g * path.t**2 / 2, atol=1e-12)
        self.assertGreater(len(path.t), 200)

    def test_an_answer_played(self):
        puzzle = json.loads((program.puzzles / "two-cushion-bank.json").read_text())
        answer = bankshot.solve(puzzle)
        whole, part = answer.trajectory(), answer.trajectory(to_target=True)
        self.assertEqual(whole.end["reason"], "pocketed")
        self.assertAlmostEqual(part.end["time"], answer.best.arrival["time"], delta=1e-9)


class Many(unittest.TestCase):
    seed, count = 5, 2000

    def check(self, document, random, with_spin):
        speeds, angles = random.uniform(0.2, 8, self.count), random.uniform(0, 360, self.count)
        spins = random.uniform(-0.5, 0.5, (self.count, 3)) if with_spin else None
        ends = bankshot.simulate_many(document, speeds, angles, spins)
        kinds = {"rest": bankshot.End.REST, "pocketed": bankshot.End.POCKETED, "until": bankshot.End.UNTIL}
        pockets = [pocket["name"] for pocket in bankshot.tables()[2]["pockets"]]
        self.assertEqual(bankshot.tables()[2]["name"], "pool-9ft")
        for i in range(0, self.count, 10):
            shot = {"speed": speeds[i], "angle": angles[i]}
            if with_spin:
                shot["spin"] = dict(zip(("top", "side", "masse"), spins[i]))
            path = bankshot.simulate({**document, "shot": shot})
            last = [e for e in path.events if e["ball"] == "cue"][-1]
            with self.subTest(seed=self.seed, draw=i):
                e = ends[i]
                self.assertEqual((e["time"], e["x"], e["y"]), (last["time"], *last["at"]))
                self.assertEqual((e["vx"], e["vy"], e["wx"], e["wy"], e["wz"]), (*last["velocity"], *last["spin"]))
                self.assertEqual((e["length"], e["cushions"]), (path.end["length"], path.end["cushions"]))
                self.assertEqual(e["kind"], kinds[path.end["reason"]])
                fell = [e["pocket"] for e in path.events if e["type"] == "pocket" and e["ball"] == "cue"]
                self.assertEqual([pockets[e["pocket"]]] if e["pocket"] >= 0 else [], fell)
        return ends

    def test_many_are_each_one(self):
        random = np.random.default_rng(self.seed)
        ends = self.check({k: v for k, v in scene.items() if k != "shot"}, random, True)
        self.assertGreater((ends["kind"] == bankshot.End.POCKETED).sum(), 50)
        self.check(rack, random, True)
        self.check({**scene, "physics": "rolling"}, random, False)
        ends = self.check({**scene, "until": {"length": 1.5}}, random, True)
        self.assertGreater((ends["kind"] == bankshot.End.UNTIL).sum(), 1000)
        self.check({**scene, "until": {"time": 1, "cushions": 2}}, random, True)

    def test_shapes(self):
        speeds, angles = np.linspace(1, 3, 4)[:, None], np.linspace(0, 90, 5)
        ends = bankshot.simulate_many(scene, speeds, angles)
        self.assertEqual(ends.shape, (4, 5))
        alone = bankshot.simulate_many(scene, speeds[2, 0], angles[3])
        self.assertEqual((alone.shape, alone[()]), ((), ends[2, 3]))
        spun = bankshot.simulate_many(scene, 2, 30, np.zeros((7, 3)))
        self.assertEqual(spun.shape, (7,))
        for threads in (1, 2, 5):
            np.testing.assert_array_equal(bankshot.simulate_many(scene, speeds, angles, threads=threads), ends)
        with self.assertRaises(ValueError):
            bankshot.simulate_many(scene, [1, 2], [1, 2, 3])
        with self.assertRaisesRegex(ValueError, "rows of top, side and masse"):
            bankshot.simulate_many(scene, 1, 2, [1, 2])
        self.assertEqual(bankshot.simulate_many(scene, [], []).shape, (0,))

    def test_no_launches(self):
        ends = bankshot.simulate_many(scene, [1, 0, -1, math.nan, math.inf, 1], [1, 1, 1, 1, 1, math.nan])
        invalid = bankshot.End.INVALID
        self.assertEqual(list(ends["kind"]), [bankshot.End.REST, *[invalid] * 5])
        # Only the physics "spin" has spin.
        ends = bankshot.simulate_many({**scene, "physics": "rolling"}, 1, 1, [[0, 0, 0], [0, 0.5, 0]])
        self.assertEqual(list(ends["kind"]), [bankshot.End.REST, invalid])


if __name__ == "__main__":
    unittest.main()
