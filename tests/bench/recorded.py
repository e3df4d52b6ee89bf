#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Which law of the cushions explains tracked shots: a CSV row for each.

    python3 tests/bench/recorded.py build/release/bankshot shots.jsonl [MODEL:RESTITUTION:ROLLING[:HOLDOUT] ...]

RESTITUTION and ROLLING are words of `fit --restitution` and `--rolling`; HOLDOUT 0 predicts nothing, for a law whose
fits take long.
"""
import json
import statistics
import subprocess
import sys
import time

USUAL = [
    "han2005:constant:constant",
    "stronge:constant:constant",
    "mathavan2010:constant:constant:0",
    "han2005:constant:linear",
    "han2005:linear:constant",
    "han2005:linear:linear",
    "stronge:linear:linear",
    "han2005:square:linear",
]
MANY = 3


def median_mm(rms):
    return f"{1000 * statistics.median(rms):.1f}" if rms else ""


def main():
    program, recordings, *laws = sys.argv[1:]
    print("model,restitution,rolling,shots,rms_median_mm,rms_many_mm,predictions,predicted_median_mm,seconds")
    for law in laws or USUAL:
        model, restitution, rolling, holdout = (law + ":5").split(":")[:4]
        command = [program, "fit", recordings, "--quiet", "--model", model, "--restitution", restitution]
        begin = time.monotonic()
        out = subprocess.run(
            command + ["--rolling", rolling, "--holdout", holdout], check=True, capture_output=True, text=True
        ).stdout
        seconds = time.monotonic() - begin
        fit = json.loads(out)
        shots = [s for s in fit["shots"] if s["samples"]]
        many = [s["rms"] for s in shots if s["cushions"] >= MANY]
        predicted = [s["rms"] for s in (fit["holdout"] or {"shots": []})["shots"] if s["samples"]]
        numbers = [median_mm([s["rms"] for s in shots]), median_mm(many), len(predicted), median_mm(predicted)]
        print(model, restitution, rolling, len(shots), *numbers, f"{seconds:.0f}", sep=",", flush=True)


main()
