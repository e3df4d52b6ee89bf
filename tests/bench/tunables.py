#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each number that steers a search does: a CSV row for each number, halved and doubled.

    python3 tests/bench/tunables.py [PUZZLES] [--only TEXT] [-j 2]

PUZZLES are JSON Lines for `bankshot batch`; without them some 450 are made, of seeds for which nobody tuned. The
program is built in build/tunables from copies of the planners' settings.hpp in which every number is read at the start:
it is multiplied by what the variable BANKSHOT_TUNE says. The answers are then compared, puzzle by puzzle, with those of
the program as it is. A number of which the compiler needs the value stays as it is, and is named on standard error.
"""
import argparse
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import random
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build/tunables"
# `learn` does not search.
ROOMS = sorted(str(file.parent.relative_to(ROOT / "planners")) for file in ROOT.glob("planners/**/settings.hpp")
               if file.parent.name != "learn")
DIFFERS = 0.005  # value
FACTORS = (0.5, 2)
COLUMNS = ["number", "value", "factor", "answers", "better", "worse", "net", "net_interval", "simulations_ratio"]

READER = """#pragma once
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
namespace bankshot::planning {
inline double tuned(const char* name, double value) {
  if (std::getenv("BANKSHOT_TUNABLES") != nullptr) std::fprintf(stderr, "%s=%.17g\\n", name, value);
  const char* const say = std::getenv("BANKSHOT_TUNE");
  const char* const factor = say != nullptr ? std::strchr(say, '=') : nullptr;
  if (factor == nullptr) return value;
  const auto length = static_cast<std::size_t>(factor - say);
  if (std::strncmp(say, name, length) != 0 || name[length] != 0) return value;
  return value * std::atof(factor + 1);
}
template <class Int>
Int tuned_int(const char* name, Int value) {
  return static_cast<Int>(std::llround(tuned(name, static_cast<double>(value))));
}
}  // namespace bankshot::planning
"""


# Wishes for `bankshot generate`.
WISHES = [
    "--target pocket --cushions 0-3",
    "--target pocket --cushions 3-5",
    "--target stop --cushions 1-4",
    "--target pass --cushions 1-4",
    "--target kick --cushions 1-3",
    "--target pot --cushions 0",
    "--target pot --cushions 0 --then 1-2",
    "--target pot --cushions 1 --then 0",
    "--target carom --table carom-10ft --cushions 1-4 --balls 2",
    "--target pot --cushions 0 --balls 8",
    "--physics rolling --target pocket --cushions 1-4",
    "--physics rolling --target pot --cushions 0-1",
    "--target pocket --cushions 1-3 --difficulty hard",
    "--target kick --cushions 1-3 --difficulty hard",
    "--target pot --cushions 0-1 --balls 4 --difficulty hard",
    "--table snooker-12ft --target pot --cushions 0 --balls 5",
]
LENGTH, WIDTH, RADIUS = 2.54, 1.27, 0.028575
# Searches longer than this are left out, so that a row takes seconds.
MOST_SIMULATIONS = 12000


def question(kind, balls):
    """Returns what a player asks of a layout."""
    if kind == 0:
        return {"target": {"ball": "any", "then": {"pocket": "any", "cushions": {"max": 2}}}, "cushions": 0}
    if kind == 1:
        return {"target": {"ball": "1", "pocket": "any"}}
    if kind == 2:
        return {"target": {"ball": "1", "then": {"pocket": "any", "cushions": 1}}, "cushions": 0}
    if kind == 3:
        return {"target": {"ball": "1"}, "cushions": {"min": 1, "max": 3}}
    if kind == 4:
        return {"target": {"pocket": "any"}, "cushions": {"max": 2}}
    if kind == 5:
        return {"target": {"game": "rotation"}}
    if balls == 1:
        return {"target": {"point": [1.9, 0.6]}, "cushions": {"max": 3}}
    return {"target": {"ball": "1", "then": {"ball": "2", "then": {"pocket": "any"}}}}


def layouts(seed, count):
    """Returns random layouts with a question each."""
    draw = random.Random(seed)
    out = []
    for k in range(count):
        balls, places = draw.choice([1, 2, 3, 5, 7]), []
        while len(places) <= balls:
            at = [round(draw.uniform(0.04, side - 0.04), 4) for side in (LENGTH, WIDTH)]
            in_corner = min(at[0], LENGTH - at[0]) + min(at[1], WIDTH - at[1]) < 0.12
            if not in_corner and all(math.dist(at, other) > 2.1 * RADIUS for other in places):
                places.append(at)
        ball = {"at": places[0]}
        kind = k % 7
        if kind == 4:
            ball["spin"] = {"top": [-1, 1], "side": [-0.7, 0.7]}
        others = [{"id": str(i), "at": at} for i, at in enumerate(places) if i > 0]
        out.append({"table": "pool-9ft", "ball": ball, "others": others, **question(kind, balls)})
    return [json.dumps(puzzle) for puzzle in out]


def make():
    """Writes the puzzles into a file, and returns its name."""
    lines = layouts(990017, 140)
    for i, wish in enumerate(WISHES, 1):
        command = [str(BUILD / "bankshot"), "generate", "--count", "24", "--seed", str(88100 + i), *wish.split()]
        lines += subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    path = BUILD / "puzzles.jsonl"
    path.write_text("\n".join(lines) + "\n")
    short = [line for line, (_, simulations) in zip(lines, answers(str(path))) if simulations < MOST_SIMULATIONS]
    path.write_text("\n".join(short) + "\n")
    return str(path)


def split(text):
    """Returns the parts of a list, cut at the commas outside brackets."""
    parts, depth, start = [], 0, 0
    for i, c in enumerate(text):
        depth += (c in "({[") - (c in ")}]")
        if c == "," and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    return [part.strip() for part in parts + [text[start:]]]


def read(kind, name, value):
    if kind == "double":
        return f'tuned("{name}", {value})'
    return f'tuned_int<{kind}>("{name}", {value})'


def declaration(kind, text, room, fixed):
    """Returns a declaration of numbers, each read at the start unless it is fixed."""
    out = []
    for one in split(text):
        name, _, value = one.partition("=")
        name = name.strip()
        if f"{room}{name}" in fixed or not value:
            return None
        out.append(f'inline const {kind} {name} = {read(kind, room + name, value.strip())};')
    return "\n".join(out)


def spacing(name, text, room, fixed):
    if f"{room}{name}" in fixed:
        return None
    out = []
    for i, one in enumerate(split(text)):
        field, equals, value = one.rpartition("=")
        number = value.strip() not in ("true", "false")
        out.append(f"{field}{equals} " + (read("double", f"{room}{name}[{i}]", value.strip()) if number else value.strip()))
    return f"inline const Spacing {name}{{{', '.join(out)}}};"


def overlay(fixed):
    folder = BUILD / "overlay/planners"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "tuned.hpp").write_text(READER)
    for room in ROOMS:
        source = (ROOT / "planners" / room / "settings.hpp").read_text()
        space = ""

        def replace(match):
            nonlocal space
            if match["space"]:
                space = "" if match["space"] == "bankshot::planning::settings" else match["space"] + "::"
                return match[0]
            if match["spacing"]:
                return spacing(match["spacing"], match["fields"], space, fixed) or match[0]
            return declaration(match["kind"], match["numbers"], space, fixed) or match[0]

        pattern = (
            r"^namespace (?P<space>[\w:]+) \{"
            r"|^inline constexpr (?P<kind>double|int|long|std::size_t) (?P<numbers>[^;{]*);"
            r"|^inline constexpr Spacing (?P<spacing>\w+)\{(?P<fields>[^;]*)\};"
        )
        text = re.sub(pattern, replace, source, flags=re.M)
        text = text.replace("#pragma once\n", '#pragma once\n\n#include "planners/tuned.hpp"\n', 1)
        target = folder / room / "settings.hpp"
        target.parent.mkdir(exist_ok=True)
        if not target.exists() or target.read_text() != text:
            target.write_text(text)


def build():
    """Builds the program; returns the numbers whose values the compiler needs."""
    fixed = set()
    flags = f"-iquote {BUILD / 'overlay'}"
    configure = ["cmake", "--preset", "release", "-B", str(BUILD), "-DBANKSHOT_TESTS=OFF", "-DBANKSHOT_BENCH=OFF"]
    subprocess.run([*configure, "-DBANKSHOT_EXAMPLES=OFF", f"-DCMAKE_CXX_FLAGS={flags}"], cwd=ROOT, check=True, stdout=sys.stderr)
    while True:
        overlay(fixed)
        made = subprocess.run(["ninja", "-k", "0", "-C", str(BUILD), "bankshot"], capture_output=True, text=True, check=False)
        if made.returncode == 0:
            return fixed
        said = made.stdout + made.stderr
        names = set(re.findall(r"settings::((?:\w+::)?\w+)[’'] (?:is not usable|was not)", said))
        if not names - fixed:
            sys.exit(said[-4000:])
        fixed |= names


def answers(puzzles, tune=None):
    env = dict(os.environ, **({"BANKSHOT_TUNE": tune} if tune else {}))
    command = [str(BUILD / "bankshot"), "batch", puzzles, "-j", "1", "--quiet", "--no-timing"]
    made = subprocess.run(command, capture_output=True, text=True, env=env, check=False)
    out = []
    for line in made.stdout.splitlines():
        answer = json.loads(line)
        shots = answer.get("shots") or [{}]
        out.append((shots[0].get("value", -1), answer.get("simulations", 0)))
    return out


def compare(name, value, factor, before, after):
    better = sum(b[0] > a[0] + DIFFERS for a, b in zip(before, after))
    worse = sum(b[0] < a[0] - DIFFERS for a, b in zip(before, after))
    ratio = sum(b[1] for b in after) / max(1, sum(a[1] for a in before))
    interval = 1.96 * math.sqrt(better + worse)
    return [name, value, factor, len(after), better, worse, better - worse, f"{interval:.1f}", f"{ratio:.3f}"]


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("puzzles", nargs="?")
    options.add_argument("--only", default="")
    options.add_argument("-j", type=int, default=2)
    asked = options.parse_args()
    for name in sorted(build()):
        print(f"stays as it is: {name}", file=sys.stderr)
    asked.puzzles = asked.puzzles or make()
    env = dict(os.environ, BANKSHOT_TUNABLES="1")
    said = subprocess.run([str(BUILD / "bankshot"), "--version"], capture_output=True, text=True, env=env, check=False).stderr
    numbers = dict(line.split("=") for line in said.splitlines() if asked.only in line)
    before = answers(asked.puzzles)
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(COLUMNS)
    jobs = [(name, value, factor) for name, value in sorted(numbers.items()) for factor in FACTORS]
    with concurrent.futures.ThreadPoolExecutor(asked.j) as pool:
        after = pool.map(lambda job: answers(asked.puzzles, f"{job[0]}={job[2]}"), jobs)
        for job, found in zip(jobs, after):
            out.writerow(compare(*job, before, found))
            sys.stdout.flush()


if __name__ == "__main__":
    main()
