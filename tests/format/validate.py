#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds `bankshot schema` against an independent validator (Debian's python3-jsonschema).

  validate.py PROGRAM REPOSITORY [--mutants N] [--seed S]

Every puzzle of the repository, every JSON block of docs/format.md, every answer to them and every shot made of both must
be valid; and of puzzles with one place changed, what the schema refuses the program must refuse. The other way round the
program knows more (geometry); what it alone refuses is counted by its reason, and reasons that a schema can tell fail.
"""
import argparse
import json
import pathlib
import random
import re
import subprocess
import sys

import jsonschema

parser = argparse.ArgumentParser()
parser.add_argument("program")
parser.add_argument("repository", type=pathlib.Path)
parser.add_argument("--mutants", type=int, default=3000)
parser.add_argument("--seed", type=int, default=1)
args = parser.parse_args()
failures = 0


def run(*command, text=""):
    return subprocess.run([args.program, *command], input=text, capture_output=True, text=True, check=False).stdout


def validator(document):
    schema = json.loads(run("schema", document))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def fail(what, document):
    global failures
    failures += 1
    print(f"FAILED: {what}\n{json.dumps(document)}")


def check(checker, documents, what):
    for document in documents:
        for error in checker.iter_errors(document):
            fail(f"{what}: /{'/'.join(map(str, error.absolute_path))}: {error.message}", document)
            break
    print(f"{len(documents)} {what}")


def jsonl(text):
    return [json.loads(line) for line in text.splitlines() if line.strip()]


def lines_of(documents):
    return "".join(json.dumps(d) + "\n" for d in documents)


puzzle, shot, answer = (validator(d) for d in ("puzzle", "shot", "answer"))

# Examples in the schemas themselves.
for checker in puzzle, shot, answer:
    for holder in [checker.schema, *checker.schema["$defs"].values()]:
        for key, member in holder["properties"].items():
            if member is True:  # a key that is not read
                continue
            own = jsonschema.Draft202012Validator({**member, "$defs": checker.schema["$defs"]})
            for example in [member[word] for word in ("default",) if word in member] + member["examples"]:
                for error in own.iter_errors(example):
                    fail(f"example of {key}: {error.message}", example)

# Documents of the repository.
folders = args.repository / "examples", args.repository / "tests"
documents = [json.loads(p.read_text()) for p in sorted(folders[0].rglob("*.json"))]
for path in sorted(p for folder in folders for p in folder.rglob("*.jsonl")):
    documents += jsonl(path.read_text())
text = (args.repository / "docs/format.md").read_text()
documents += [json.loads(block) for block in re.findall(r"```json\n(.*?)```", text, re.S)]
puzzles = [d for d in documents if "target" in d and "table" in d]
for physics in "ideal", "rolling", "spin":
    puzzles += jsonl(run("generate", "--count", "20", "--seed", "1", "--physics", physics))
shots = [d for d in documents if "shot" in d and "table" in d]
for document in shots:
    document.pop("expect", None)  # for the test alone
if len(puzzles) < 100 or not shots:
    fail("too few documents were found", [len(puzzles), len(shots)])
check(puzzle, puzzles, "puzzles")
check(shot, shots, "shots")
program_refuses = [a for a in jsonl(run("batch", "-", "--quiet", "--budget", "0", text=lines_of(puzzles))) if a["status"] == "invalid"]
for refused in program_refuses:
    fail("the program refuses a puzzle of the repository", refused)

# Answers to these puzzles.
quick = ["--quiet", "--budget", "3000"]
told = jsonl(run("batch", "-", *quick, "--all", "--path", text=lines_of(puzzles)))
check(answer, told, "answers with all shots and their paths")
check(answer, jsonl(run("batch", "-", *quick, "--no-timing", "--no-robustness", text=lines_of(puzzles))), "answers in short")
check(answer, jsonl(run("batch", "-", "--quiet", "--budget", "0", text=lines_of(puzzles))), "answers without a budget")
check(answer, jsonl(run("batch", "-", "--quiet", text='\n[1]\n{"id": 7, "about": 1}\n{"tabel": 1}\n')), "answers to bad lines")

# Puzzles with their shots.
played = [{**p, "shot": a["shots"][0]} for p, a in zip(puzzles, told) if a["shots"]]
check(shot, played, "puzzles with a shot of their answer")
for document in played:
    if "events" not in run("simulate", "--json", text=json.dumps(document)):
        fail("simulate refuses it", document)


# Puzzles with one place changed.
def places(value, path=()):
    yield path
    if isinstance(value, (dict, list)):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from places(value[key], path + (key,))


def changed(document, draw):
    document = json.loads(json.dumps(document))
    path = draw.choice([p for p in places(document) if p])
    holder = document
    for key in path[:-1]:
        holder = holder[key]
    what = draw.random()
    if what < 0.15:
        del holder[path[-1]]
    elif what < 0.3 and isinstance(holder, dict):
        holder[draw.choice(["speed", "point", "spin", "model", "colour", "jaws", "others", "max", "radius"])] = draw.choice([1, "x", [], {}])
    else:
        holder[path[-1]] = draw.choice(
            [-1, 0, 1, 1.5, 0.05, 1e9, True, False, None, "", "six", "any", "spin", [], [1], [0, 1], [1, 0], [-1, 1], {}, {"model": "spin"}, {"speed": 1}, {"min": 1}])
    return document


draw = random.Random(args.seed)
mutants = [changed(draw.choice(puzzles), draw) for _ in range(args.mutants)]
verdicts = jsonl(run("batch", "-", "--quiet", "--budget", "0", "--no-robustness", text=lines_of(mutants)))
if len(verdicts) != len(mutants):
    fail("an answer is missing", len(verdicts))
of_form = re.compile(r"must be (a|an|true|at least|greater than|between|\")|required|unknown|not supported|is no (?!cushion|pocket|ball)")
counts = {"both take it": 0, "both refuse it": 0, "the program alone refuses it": 0}
for mutant, verdict in zip(mutants, verdicts):
    errors, refused = list(puzzle.iter_errors(mutant)), verdict["status"] == "invalid"
    if errors and not refused:
        fail(f"only the schema refuses: {errors[0].message}", mutant)
    counts["both refuse it" if errors else "the program alone refuses it" if refused else "both take it"] += 1
    if refused and not errors:
        reason = verdict["error"]["reason"]
        known = ("friction · g", "lower end first", "span at most", "must lie between", "inside the table", "too fast", "per_speed is", "min", "pair", "cannot be reached")
        if of_form.search(reason) and not any(k in reason for k in known):
            print(f"the program alone: {verdict['error']['path']}: {reason}")
            if verdict["error"]["path"].split("/")[-1] not in ("max", "radius", "spin", "speed", "mass", "at_rest"):
                fail("the schema does not know this rule of form", mutant)
print(f"{len(mutants)} changed puzzles of seed {args.seed}: {counts}")
if min(counts.values()) < args.mutants // 100:
    fail("too few of one kind to mean anything", counts)
sys.exit(1 if failures else 0)
