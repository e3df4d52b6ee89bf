#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes the files of a release into build/packages: source archive, Debian packages, wheel, npm package, one-file page.
#   bash cmake/package.sh [source|deb|wheel|npm|page ...]     all of them by default
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/packages.sh
version=$(sed -n 's/^project(bankshot VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
out=$PWD/build/packages
mkdir -p "$out"
[ $# -gt 0 ] || set -- source deb wheel npm page
for kind; do
  begin=$SECONDS
  case $kind in
    source) git archive --format=tar.gz --prefix="bankshot-$version/" -o "$out/bankshot-$version.tar.gz" HEAD ;;
    deb)
      need $toolchain dpkg-dev file librsvg2-dev
      configure release -B build/deb -DBANKSHOT_TESTS=OFF -DBANKSHOT_BENCH=OFF -DBANKSHOT_EXAMPLES=OFF
      cmake --build build/deb >build/deb.log
      cpack --config build/deb/CPackConfig.cmake -B "$out" >>build/deb.log
      rm -rf "$out/_CPack_Packages"
      ;;
    wheel)
      need $toolchain $python
      /usr/bin/python3 -m pip wheel --quiet --no-deps --no-build-isolation -w "$out" .
      ;;
    npm)
      command -v npm >/dev/null 2>&1 || need nodejs npm
      bash bindings/javascript/package.sh build/wasm/npm
      npm pack --silent --pack-destination "$out" ./build/wasm/npm >/dev/null
      ;;
    page) bash examples/page.sh "$out/bankshot.html" ;;
    *) echo "no package is called $kind" >&2 && exit 2 ;;
  esac
  echo "$kind: $((SECONDS - begin)) s" >&2
done
ls -l "$out" >&2
