#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests the launchers of docs/cluster.md that need neither Slurm nor other machines: GNU parallel (here instead of over
# ssh), MPI as a launcher where installed, Dask. The merged output of each must be the bytes of a batch in one run.
#   bash tests/cluster/launchers.sh          BANKSHOT=PATH names another program than build/release/bankshot
set -euo pipefail
cd "$(dirname "$0")/../.."
. cmake/packages.sh
need parallel openmpi-bin python3-distributed
root=$PWD program=$(readlink -f "${BANKSHOT:-build/release/bankshot}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir bin
ln -s "$program" bin/bankshot
export PATH=$folder/bin:$PATH
bankshot generate --count 600 --seed 1 --physics rolling >puzzles.jsonl
bankshot batch puzzles.jsonl -o whole.jsonl --no-timing --quiet
same() {
  cmp shots.jsonl whole.jsonl
  echo "$1: the bytes of a batch in one go"
  rm -f shots*
}

parallel -j2 bankshot batch puzzles.jsonl --part {}/8 -o shots-{}.jsonl --resume --quiet --no-timing ::: $(seq 0 7)
bankshot merge shots-*.jsonl -o shots.jsonl --quiet
same parallel

mpirun --oversubscribe --allow-run-as-root -n 4 sh -c \
  'bankshot batch puzzles.jsonl -o shots-$OMPI_COMM_WORLD_RANK.jsonl --resume --quiet --no-timing --part'
bankshot merge shots-*.jsonl -o shots.jsonl --quiet
same mpirun

/usr/bin/python3 "$root/examples/cluster/batch_dask.py" puzzles.jsonl shots.jsonl --parts 8
same dask
