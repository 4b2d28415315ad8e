# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by ./run and ./test: system packages, virtual environment, the package itself. Each part
# is skipped when it is up to date.

samcontact_missing_packages() {
  local package
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed ||
      echo "$package"
  done
}

samcontact_system_packages() {
  local missing sudo=""
  if ! command -v dpkg-query > /dev/null; then
    echo "Not a Debian-like system: install g++, Eigen 3, FFTW 3, doctest and Python's venv yourself." >&2
    return
  fi
  missing=$(samcontact_missing_packages "$@")
  [ -n "$missing" ] || return 0
  [ "$(id -u)" = 0 ] || sudo=sudo
  echo "Installing system packages:" $missing
  $sudo apt-get update -qq
  # shellcheck disable=SC2086
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq $missing > /dev/null
}

samcontact_browser_packages() {
  if grep -qxs 'ID=ubuntu' /etc/os-release; then
    echo chromium-browser chromium-chromedriver
  else
    echo chromium chromium-driver
  fi
}

# What the installed package depends on: sources, build files, and the interpreter.
samcontact_fingerprint() {
  { python3 --version; find CMakeLists.txt pyproject.toml cmake cpp python -type f \
      ! -name '*.pyc' ! -name '*.so' -print0 | sort -z | xargs -0 sha256sum; } | sha256sum
}

# samcontact_setup EXTRAS: EXTRAS is "" or e.g. "[dev]"; with extras warnings of the core are errors.
samcontact_setup() {
  samcontact_prepare "$1"
  samcontact_install "$1"
}

# System packages, and an environment with nothing in it yet but what builds.
samcontact_prepare() {
  local packages=(g++ libeigen3-dev libfftw3-dev)
  # The browser shows reports to their test; clang brings the sanitizers and the fuzzer; ccache
  # keeps what was compiled, for each of the builds.
  [ "$1" = "" ] ||
    packages+=(doctest-dev valgrind clang libomp-dev ccache $(samcontact_browser_packages))
  # A Python from elsewhere brings these two itself.
  python3 -c 'import ensurepip' 2> /dev/null || packages+=(python3-venv)
  python3 -c 'import os, sysconfig as s, sys
sys.exit(not os.path.exists(s.get_path("include") + "/Python.h"))' || packages+=(python3-dev)
  samcontact_system_packages "${packages[@]}"
  # Tests start hundreds of processes, each of which would compile what it imports.
  [ "$1" = "" ] || unset PYTHONDONTWRITEBYTECODE
  if [ "$1" != "" ] && command -v ccache > /dev/null; then
    # What one checkout has compiled serves the others.
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=true
    export CCACHE_SLOPPINESS=time_macros CCACHE_EXTRAFILES=$PWD/cmake/elsewhere.txt
    export CXX=${CXX:-g++}  # by one name: to ccache c++ is another compiler
  fi
  [ -x .venv/bin/python ] || python3 -m venv .venv
  # Headers of an isolated build are in another folder each time, where ccache does not know them.
  [ "$1" = "" ] || [ -x .venv/bin/ninja ] || .venv/bin/python -m pip install --quiet \
    --disable-pip-version-check cmake ninja "scikit-build-core>=0.10" "pybind11>=2.12"
  mkdir -p build
}

samcontact_install() {
  local strict=OFF own_headers=OFF state
  # Precompiled headers hold the folder they were made in, so that ccache would help no other one.
  [ "$1" = "" ] || strict=ON own_headers=ON
  state=$(samcontact_fingerprint)
  if [ "$(cat .venv/samcontact-state 2> /dev/null)" != "$state" ] ||
    { [ -n "$1" ] && ! grep -qxF -e "$1" .venv/samcontact-extras 2> /dev/null; }; then
    echo "Building and installing samcontact (a minute the first time) ..."
    .venv/bin/python -m pip install --quiet --disable-pip-version-check \
      ${1:+--no-compile --no-build-isolation} --config-settings="cmake.define.SAMCONTACT_WERROR=$strict" \
      --config-settings="cmake.define.CMAKE_DISABLE_PRECOMPILE_HEADERS=$own_headers" ".$1"
    echo "$state" > .venv/samcontact-state
    echo "$1" >> .venv/samcontact-extras
  fi
}
