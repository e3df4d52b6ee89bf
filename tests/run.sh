#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, builds, and runs all tests.
#   bash tests/run.sh [PRESET]     release (the default), debug, asan-ubsan ...
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/packages.sh
need $toolchain catch2 libbenchmark-dev gnuplot-nox chromium
preset=${1:-release}
build "$preset" -DBANKSHOT_TESTS=ON
ctest --test-dir "build/$preset" --output-on-failure -j "$(nproc)"
