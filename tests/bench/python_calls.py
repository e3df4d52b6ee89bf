# SPDX-License-Identifier: MIT
"""What a call from Python costs beyond the call in C++, and what a loop of Python costs beside simulate_many; CSV.

    PYTHONPATH=build/release/bindings/python python3 tests/bench/python_calls.py build/release/tests/bench/one_call
"""
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import bankshot

puzzles = {
    "the softest by an order given": {"table": {"length": 2.54, "width": 1.27}, "ball": {"at": [0.635, 0.40]},
                        "target": {"point": [1.9, 0.9]}, "cushions": ["top", "right"], "prefer": "soft"},
    "of the README": {"table": "pool-9ft", "ball": {"at": [0.635, 0.40]}, "target": {"pocket": "bottom-middle"},
                 "cushions": ["top", "right"]},
}
shot = {"table": "pool-9ft", "ball": {"at": [0.635, 0.40]}, "shot": {"speed": 2.5, "angle": 37.44}}


def us(call, count):
    """Of CPU; the median of nine rounds."""
    rounds = []
    for _ in range(9):
        begin = time.process_time()
        for _ in range(count):
            call()
        rounds.append((time.process_time() - begin) / count * 1e6)
    return statistics.median(rounds)


def row(what, way, count, each):
    print(f"{what},{way},{count},{each:.3f}", flush=True)


def in_cpp(what, document, count):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        file.write(json.dumps(document))
        file.flush()
        told = subprocess.run([sys.argv[1], what, file.name, str(count)], capture_output=True, text=True, check=True)
    return map(float, told.stdout.split())


def calls(what, name, document, count, call, look):
    alone, from_text_to_text, in_c = in_cpp(what, document, count)
    row(name, "C++", count, alone)
    row(name, "C++ from text to text", count, from_text_to_text)
    row(name, "C from text to text", count, in_c)
    text = json.dumps(document)
    row(name, "Python from text to text", count, us(lambda: call(text).json, count))
    row(name, "Python from a dict to a number", count, us(lambda: look(call(document)), count))


def many(launches):
    random = np.random.default_rng(1)
    speeds, angles = random.uniform(1, 6, launches), random.uniform(0, 360, launches)
    scene = {key: value for key, value in shot.items() if key != "shot"}
    few = 5000

    def loop():
        for speed, angle in zip(speeds[:few].tolist(), angles[:few].tolist()):
            bankshot.simulate({**scene, "shot": {"speed": speed, "angle": angle}}).end

    row("many launches", "a loop of Python", few, us(loop, 1) / few)
    row("many launches", "simulate_many with one thread", launches,
        us(lambda: bankshot.simulate_many(scene, speeds, angles, threads=1), 1) / launches)


if __name__ == "__main__":
    print("what,way,count,us_each")
    for name, puzzle in puzzles.items():
        calls("solve", f"solve {name}", puzzle, 200, bankshot.solve, lambda answer: answer.best.angle)
    calls("simulate", "simulate", shot, 2000, bankshot.simulate, lambda path: path.end["time"])
    row("simulate", "Python from a dict to arrays", 2000, us(lambda: bankshot.simulate(shot).x, 2000))
    many(1000000)
