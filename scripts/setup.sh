# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by ./run and ./test: installs system packages, the virtual environment and the package.
# Steps that are up to date are skipped.

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

# samcontact_setup EXTRAS: EXTRAS is "" or e.g. "[dev]". With extras, compiler warnings are errors.
samcontact_setup() {
  samcontact_prepare "$1"
  samcontact_install "$1"
}

# Installs system packages and creates a virtual environment that contains only build tools.
samcontact_prepare() {
  local packages=(g++ libeigen3-dev libfftw3-dev)
  # Tests of reports use the browser; clang provides sanitizers and fuzzer; ccache stores compiled
  # objects for all builds.
  [ "$1" = "" ] ||
    packages+=(doctest-dev valgrind clang libomp-dev ccache $(samcontact_browser_packages))
  # A Python that is not from the distribution may contain venv and headers.
  python3 -c 'import ensurepip' 2> /dev/null || packages+=(python3-venv)
  python3 -c 'import os, sysconfig as s, sys
sys.exit(not os.path.exists(s.get_path("include") + "/Python.h"))' || packages+=(python3-dev)
  samcontact_system_packages "${packages[@]}"
  # Tests start hundreds of processes, each of which would compile its imports to bytecode.
  [ "$1" = "" ] || unset PYTHONDONTWRITEBYTECODE
  if [ "$1" != "" ] && command -v ccache > /dev/null; then
    # Compiled objects are shared between checkouts.
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=true
    export CCACHE_SLOPPINESS=time_macros CCACHE_EXTRAFILES=$PWD/cmake/elsewhere.txt
    export CXX=${CXX:-g++}  # always one name: ccache regards c++ as another compiler
  fi
  [ -x .venv/bin/python ] || python3 -m venv .venv
  # An isolated build has its headers in a new folder each time, so ccache would not find its objects.
  [ "$1" = "" ] || [ -x .venv/bin/ninja ] || .venv/bin/python -m pip install --quiet \
    --disable-pip-version-check cmake ninja "scikit-build-core>=0.10" "pybind11>=2.12"
  mkdir -p build
}

# Installs the packages that the development environment requires, but not the package itself.
samcontact_requirements() {
  grep -qxF -e "[dev]" .venv/samcontact-extras 2> /dev/null ||
    .venv/bin/python scripts/requirements.py dev |
    .venv/bin/python -m pip install --quiet --disable-pip-version-check --no-compile -r /dev/stdin
}

samcontact_install() {
  local strict=OFF state
  [ "$1" = "" ] || strict=ON
  state=$(samcontact_fingerprint)
  if [ "$(cat .venv/samcontact-state 2> /dev/null)" != "$state" ] ||
    { [ -n "$1" ] && ! grep -qxF -e "$1" .venv/samcontact-extras 2> /dev/null; }; then
    echo "Building and installing samcontact (a minute the first time) ..."
    .venv/bin/python -m pip install --quiet --disable-pip-version-check \
      ${1:+--no-compile --no-build-isolation} --config-settings="cmake.define.SAMCONTACT_WERROR=$strict" ".$1"
    echo "$state" > .venv/samcontact-state
    echo "$1" >> .venv/samcontact-extras
  fi
}
