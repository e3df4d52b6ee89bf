# SPDX-License-Identifier: MIT
"""The environment of examples/pool_environment.py keeps what Gymnasium asks of one; with or without Gymnasium."""
import importlib.util
import unittest

import numpy as np

import program

file = program.repository / "examples" / "pool_environment.py"
specification = importlib.util.spec_from_file_location("pool_environment", file)
example = importlib.util.module_from_spec(specification)
specification.loader.exec_module(example)


class Environment(unittest.TestCase):
    def test_reset(self):
        environment = example.PoolEnvironment(balls=4)
        first, info = environment.reset(seed=3)
        self.assertEqual((first.shape, info), ((5, 2), {}))
        again, _ = environment.reset(seed=3)
        np.testing.assert_array_equal(first, again)
        other, _ = environment.reset(seed=4)
        self.assertTrue((first != other).all())
        self.assertIsNone(environment.render())

    def test_steps(self):
        """Random strokes: balls that are down stay down, points are what fell, and every rack ends."""
        random = np.random.default_rng(5)
        fell = scratched = late = 0
        for seed in range(100):
            environment = example.PoolEnvironment(most_strokes=8)
            before, _ = environment.reset(seed=seed)
            terminated = truncated = False
            while not (terminated or truncated):
                after, reward, terminated, truncated, info = environment.step([random.uniform(1, 8), random.uniform(0, 360)])
                down = (after[1:, 0] < 0).sum() - (before[1:, 0] < 0).sum()
                scratch = "cue" in info["fell"]
                self.assertEqual(reward, down - scratch)
                self.assertTrue((after[before < 0] == -1).all())
                self.assertEqual(terminated, scratch or (after[1:, 0] < 0).all())
                fell, scratched, before = fell + down, scratched + scratch, after
            late += truncated
            self.assertTrue(environment.render().startswith("<svg"))
        self.assertGreater(fell, 10)
        self.assertGreater(scratched, 5)
        self.assertGreater(late, 2)

    def test_a_hint_pots(self):
        environment = example.PoolEnvironment()
        environment.reset(seed=1)
        _, reward, *_ = environment.step(environment.hint())
        self.assertEqual(reward, 1)


if __name__ == "__main__":
    unittest.main()
