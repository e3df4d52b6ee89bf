#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the commands that a page of docs/ tells a user to type in a checkout (its blocks of sh), in a temporary home.
# Then runs a command there that checks the result.
#   bash tests/checkout.sh docs/python.md '~/bankshot/bin/python .../installed.py'
set -euo pipefail
cd "$(dirname "$0")/.."
# A temporary home, except for the compiler's cache.
export XDG_CACHE_HOME=${XDG_CACHE_HOME:-$HOME/.cache} XDG_CONFIG_HOME=${XDG_CONFIG_HOME:-$HOME/.config}
HOME=$(mktemp -d)
export HOME
unset PYTHONPATH
trap 'rm -rf "$HOME"' EXIT
blocks=$(awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$1")
[ -n "$blocks" ] || { echo "$1 has nothing to type in a checkout" >&2; exit 1; }
bash -euc "$blocks"
cd "$HOME"
bash -euc "${2:-true}"
