# SPDX-License-Identifier: MIT
"""The module that pip installed solves a puzzle."""
import bankshot

assert "site-packages" in bankshot.__file__, bankshot.__file__
answer = bankshot.solve({"table": "pool-9ft", "ball": {"at": [0.6, 0.4]}, "target": {"pocket": "any"}})
assert answer.solved, answer
print(answer)
