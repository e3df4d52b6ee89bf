# SPDX-License-Identifier: MIT
#
# Sourced by examples/run.sh and tests/run.sh: installs what is missing and builds. On Debian and
# Ubuntu with apt, with sudo when not root; elsewhere it names the packages and goes on, and CMake
# says what it does not find.
#   need PACKAGE...     install the Debian packages that are not there yet
#   build PRESET [ARG...] [-- TARGET...]   configure and build a preset under build/, or only these targets

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

# The C++ files of the repository, a line each; also where there is no git.
cpp_files() {
  git ls-files '*.cpp' '*.hpp' 2>/dev/null | grep . || find bindings examples include planners src tests -name '*.[ch]pp'
}

toolchain="g++ cmake ninja-build ccache nlohmann-json3-dev libfmt-dev libcli11-dev libeigen3-dev libceres-dev libnlopt-dev libboost-dev libtbb-dev zlib1g-dev libcpp-httplib-dev pkg-config"
# The Python module, pip with all that it must not ask a registry for, and what the module's tests look at.
python="python3-dev python3-numpy pybind11-dev python3-pybind11 python3-pip python3-venv python3-setuptools python3-wheel python3-matplotlib python3-tqdm mypy"

# Compiled once, found again from a clone in any other folder.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros

# configure PRESET [ARG...]
configure() {
  preset=$1
  shift
  launcher=""
  command -v ccache >/dev/null 2>&1 && launcher="-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"
  cmake --preset "$preset" $launcher "$@" >/dev/null
}

build() {
  preset=$1
  shift
  options="" targets=""
  while [ $# -gt 0 ] && [ "$1" != -- ]; do
    options="$options $1"
    shift
  done
  [ $# -gt 1 ] && shift && targets="--target $*"
  log=build/$preset.log
  mkdir -p build
  # shellcheck disable=SC2086  # several words each
  if ! { configure "$preset" $options && cmake --build --preset "$preset" $targets; } >"$log" 2>&1; then
    tail -n 40 "$log" >&2
    echo "The build failed; the whole log is $log" >&2
    return 1
  fi
}
