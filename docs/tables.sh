#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes the tables of docs/format.md anew, from the table of keys that the program reads by.
set -euo pipefail
cd "$(dirname "$0")"
bankshot=${BANKSHOT:-../build/release/bankshot}
awk -v program="$bankshot" '
  /^<!-- end -->/ { inside = 0 }
  !inside { print }
  /^<!-- bankshot schema/ { inside = 1; fflush(); system(program " schema " $4 " --markdown") }
' format.md >format.new
mv format.new format.md
