# SPDX-License-Identifier: MIT
"""What the tests share: the program to compare with, the puzzles of the repository, and puzzles that it makes."""
import os
import pathlib
import subprocess

bankshot = os.environ["BANKSHOT_PROGRAM"]
repository = pathlib.Path(__file__).resolve().parents[2]
puzzles = repository / "examples" / "puzzles"


def run(*arguments, text="", exit=0):
    """Standard output of the program, which must end with this code, or one of these."""
    done = subprocess.run([bankshot, *map(str, arguments)], input=text, capture_output=True, text=True)
    allowed = (exit,) if isinstance(exit, int) else exit
    assert done.returncode in allowed, f"{arguments} ended with {done.returncode}: {done.stderr}"
    return done.stdout


def lines_of(path):
    return path.read_text().splitlines()


def examples():
    """All puzzles of examples/puzzles, the books' too."""
    found = [path.read_text() for path in sorted(puzzles.glob("*.json"))]
    for book in sorted(puzzles.glob("*.jsonl")):
        found += lines_of(book)
    return found


seeds = ((1, ()), (2, ("--physics", "rolling")), (3, ("--target", "kick")), (4, ("--target", "pot", "--cushions", "0-1")))


def made(each=50):
    """Generated ones, of four kinds."""
    out = []
    for seed, more in seeds:
        out += run("generate", "--count", each, "--seed", seed, *more).splitlines()
    assert len(out) == each * len(seeds)
    return out
