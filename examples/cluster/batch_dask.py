#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs a batch in parts on a Dask cluster and merges them. Each worker needs the program and access to the same folder.

    python3 batch_dask.py puzzles.jsonl shots.jsonl --parts 64 --scheduler tcp://head:8786

Without --scheduler, the workers are two local processes. If a worker is lost, another continues its part where it
stopped.
"""
import argparse
import subprocess

from distributed import Client, LocalCluster, as_completed


def part(k, n, puzzles, shots):
    output = f"{shots}.{k}.jsonl"
    run = subprocess.run(["bankshot", "batch", puzzles, "--part", f"{k}/{n}", "-o", output, "-j", "1", "--resume",
                          "--quiet", "--no-timing"], stderr=subprocess.PIPE, text=True)
    if run.returncode != 0:
        raise RuntimeError(run.stderr)
    return output


if __name__ == "__main__":
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("puzzles")
    options.add_argument("shots")
    options.add_argument("--parts", type=int, default=8)
    options.add_argument("--scheduler", help="its address")
    o = options.parse_args()
    with Client(o.scheduler or LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)) as client:
        futures = client.map(part, range(o.parts), n=o.parts, puzzles=o.puzzles, shots=o.shots, retries=3)
        for done, future in enumerate(as_completed(futures), 1):
            print(f"{done} of {o.parts}: {future.result()}")
        subprocess.run(["bankshot", "merge", *client.gather(futures), "-o", o.shots], check=True)
