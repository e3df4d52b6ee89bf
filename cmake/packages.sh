# SPDX-License-Identifier: MIT
#
# Sourced by examples/run.sh and tests/run.sh: installs what is missing and builds. On Debian and
# Ubuntu with apt, with sudo when not root; elsewhere it names the packages and goes on, and CMake
# says what it does not find.
#   need PACKAGE...     install the Debian packages that are not there yet
#   build PRESET ARG... configure and build a preset under build/

need() {
  missing=""
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || missing="$missing $package"
  done
  [ -z "$missing" ] && return 0
  if ! command -v apt-get >/dev/null 2>&1; then
    echo "This is no Debian or Ubuntu; if the build fails, install what these packages hold:$missing" >&2
    return 0
  fi
  sudo=""
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null 2>&1 || { echo "As root: apt-get install$missing" >&2; return 1; }
    sudo="sudo"
  fi
  echo "Installing:$missing" >&2
  # shellcheck disable=SC2086  # one word a package
  $sudo env DEBIAN_FRONTEND=noninteractive sh -c 'apt-get update -qq && apt-get install -y -qq --no-install-recommends "$@" >/dev/null' sh $missing
}

toolchain="g++ cmake ninja-build ccache nlohmann-json3-dev libfmt-dev libcli11-dev libeigen3-dev libceres-dev libnlopt-dev libboost-dev libtbb-dev zlib1g-dev"

build() {
  preset=$1
  shift
  launcher=""
  command -v ccache >/dev/null 2>&1 && launcher="-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"
  log=build/$preset.log
  mkdir -p build
  if ! { cmake --preset "$preset" $launcher "$@" && cmake --build --preset "$preset"; } >"$log" 2>&1; then
    tail -n 40 "$log" >&2
    echo "The build failed; the whole log is $log" >&2
    return 1
  fi
}
