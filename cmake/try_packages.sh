#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs each file of build/packages on a bare Debian 12 and uses it there, after cmake/package.sh; as root. Prints the
# seconds that each took.
#   bash cmake/try_packages.sh [deb|wheel|npm|page|source ...]     all of them by default
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/packages.sh
need debootstrap
packages=$PWD/build/packages root=$(mktemp -d)
trap 'umount "$root/proc" 2>/dev/null || true; rm -rf "$root"' EXIT
debootstrap --variant=minbase bookworm "$root" >/dev/null
mount -t proc proc "$root/proc"
cp -r "$packages" "$root/packages"
cp examples/puzzles/two-cushion-bank.json "$root/bank.json"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive sh -ec "$1" >/dev/null; }
inside "apt-get update -qq"
[ $# -gt 0 ] || set -- deb wheel npm page source
for kind; do
  begin=$SECONDS
  case $kind in
    deb)
      inside "apt-get install -y -qq --no-install-recommends /packages/bankshot_*.deb && bankshot solve /bank.json"
      inside "apt-get remove -y -qq bankshot"
      ;;
    wheel)
      inside "apt-get install -y -qq --no-install-recommends python3-pip python3-numpy libceres3 libfmt9 libnlopt0 && pip install --quiet --break-system-packages --no-deps /packages/*.whl &&
        python3 -c 'import bankshot; assert bankshot.solve(open(\"/bank.json\").read()).shots'"
      ;;
    npm)
      inside "apt-get install -y -qq --no-install-recommends npm && mkdir -p /js && cd /js && npm install --silent /packages/*.tgz &&
        node --input-type=module -e 'import {load} from \"bankshot\"; import fs from \"fs\";
          const b = await load(); const a = b.solve(JSON.parse(fs.readFileSync(\"/bank.json\"))); if (!a.shots.length) process.exit(1)'"
      ;;
    page) inside "grep -q '</html>' /packages/bankshot.html" ;;
    source)
      inside "apt-get install -y -qq --no-install-recommends $toolchain && tar xf /packages/bankshot-*.tar.gz && cd bankshot-* &&
        cmake --preset release -DBANKSHOT_TESTS=OFF -DBANKSHOT_BENCH=OFF -DBANKSHOT_EXAMPLES=OFF && cmake --build --preset release && build/release/bankshot solve /bank.json"
      ;;
    *) echo "no package is called $kind" >&2 && exit 2 ;;
  esac
  echo "$kind: $((SECONDS - begin)) s" >&2
done
