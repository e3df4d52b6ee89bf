#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a batch in parts takes on N cores, from the times of many small parts measured here.

    cluster.py PROGRAM PUZZLES [--parts 400] [--order mixed|grouped] [--launch 1] [--seed 1] >table.csv

The model. A part takes the time to launch it (the scheduler's, --launch seconds, and the program's), to read what
stands before it in the file, which it counts and checks, and to solve its lines. In a file of mixed lines that is a sum
of times drawn with replacement from those of the small parts, so that it has their spread; in one where like stands
with like (--order grouped) the time of its share of this file. Cores are equal, and each takes the next part when it is
free. `efficiency` is what one core would take for the lines alone over cores times makespan; then one core merges.
"""
import argparse
import csv
import heapq
import os
import random
import subprocess
import sys
import tempfile

PUZZLES = (10**6, 10**8)
CORES = (1, 10, 100, 1000)
PARTS_A_CORE = (1, 2, 4, 8, 16, 32)
LONG = 300 * 10**6  # bytes of the file that measures the time of reading
MOST_DRAWS = 400  # draws per part; the mean of more draws is practically exact


def cpu(words):
    """Seconds of CPU that a command takes."""
    child = os.posix_spawn(words[0], words, os.environ)
    _, status, use = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{' '.join(words)} ended with status {status}")
    return use.ru_utime + use.ru_stime


class Measured:
    def __init__(self, program, puzzles, parts, folder):
        common = [program, "batch", puzzles, "-j", "1", "--no-timing", "--quiet"]
        self.bytes_each = 0
        self.seconds_each, names, lines = [], [], 0
        for k in range(parts):
            names.append(f"{folder}/{k}.jsonl")
            cost = f"{folder}/cost.csv"
            cpu([*common, "--part", f"{k}/{parts}", "-o", names[-1], "--cost", cost])
            row = next(csv.DictReader(open(cost)))
            lines += int(row["puzzles"])
            self.seconds_each.append(float(row["cpu_us_each"]) * 1e-6)
        merge = cpu([program, "merge", *names, "-o", f"{folder}/merged", "--quiet"])  # also reads them once before
        size = os.path.getsize(puzzles)
        self.lines, self.bytes_each, self.merge_each = lines, size / lines, merge / lines
        # The last of a million parts reads nearly all of a file and solves at most one line; the first reads nothing.
        again = 1 + LONG // size
        with open(f"{folder}/long", "w") as file:
            for _ in range(again):
                file.write(open(puzzles).read())
        common[2] = f"{folder}/long"
        ends = [sorted(cpu([*common, "--part", f"{k}/1000000", "-o", f"{folder}/end"]) for _ in range(5))[2]
                for k in (0, 999999)]
        self.start, self.read_each = ends[0], (ends[1] - ends[0]) / (lines * again)


    def share(self, begin, end):
        """Mean seconds of a puzzle between two shares of the file, from 0 to 1."""
        n = len(self.seconds_each)
        overlaps = [(min(end * n, i + 1) - max(begin * n, i), self.seconds_each[i])
                    for i in range(int(begin * n), min(n, int(end * n) + 1))]
        return sum(w * s for w, s in overlaps) / sum(w for w, _ in overlaps)


def makespan(m, o, puzzles, cores, parts):
    """Seconds until the last core is done."""
    draws = random.Random(o.seed)
    each = puzzles / parts
    steps = max(1, min(MOST_DRAWS, round(each * o.parts / m.lines)))
    free = [0.0] * cores
    for k in range(parts):
        if o.order == "grouped":
            solve = m.share(k / parts, (k + 1) / parts)
        else:
            solve = sum(draws.choices(m.seconds_each, k=steps)) / steps
        heapq.heapreplace(free, free[0] + o.launch + m.start + m.read_each * each * k + solve * each)
    return max(free)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("puzzles")
    options.add_argument("--parts", type=int, default=400)
    options.add_argument("--order", choices=("mixed", "grouped"), default="mixed")
    options.add_argument("--launch", type=float, default=1.0, help="s, of the scheduler for each part")
    options.add_argument("--seed", type=int, default=1)
    o = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        m = Measured(o.program, o.puzzles, o.parts, folder)
    mean = sum(m.seconds_each) / len(m.seconds_each)
    print(f"{m.lines} puzzles in {o.parts} parts: {mean * 1e6:.0f} us each, in a part from {min(m.seconds_each) * 1e6:.0f} "
          f"to {max(m.seconds_each) * 1e6:.0f}; start {m.start * 1e3:.0f} ms, reading {m.read_each / m.bytes_each * 1e9:.2f} "
          f"s/GB, merging {m.merge_each * 1e6:.1f} us each", file=sys.stderr)
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow("order puzzles cores parts_a_core launch_s part_s makespan_s efficiency merge_s".split())
    for puzzles in PUZZLES:
        for cores in CORES:
            for n in PARTS_A_CORE:
                span = makespan(m, o, puzzles, cores, cores * n)
                out.writerow([o.order, puzzles, cores, n, f"{o.launch:g}", f"{mean * puzzles / (cores * n):.3g}",
                              f"{span:.4g}", f"{mean * puzzles / (cores * span):.3f}", f"{m.merge_each * puzzles:.3g}"])


if __name__ == "__main__":
    main()
