#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the module as docs/python.md says (its block of sh), in a home of its own, and solves with it.
set -euo pipefail
cd "$(dirname "$0")/../.."
# A home of its own, but for the compiler's cache.
export XDG_CACHE_HOME=${XDG_CACHE_HOME:-$HOME/.cache} XDG_CONFIG_HOME=${XDG_CONFIG_HOME:-$HOME/.config}
HOME=$(mktemp -d)
export HOME
unset PYTHONPATH
trap 'rm -rf "$HOME"' EXIT
block=$(awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' docs/python.md)
[ -n "$block" ]
bash -euc "$block"
cd "$HOME"
"$HOME/bankshot/bin/python" - <<'PYTHON'
import bankshot
assert "site-packages" in bankshot.__file__, bankshot.__file__
answer = bankshot.solve({"table": "pool-9ft", "ball": {"at": [0.6, 0.4]}, "target": {"pocket": "any"}})
assert answer.solved, answer
print(answer)
PYTHON
