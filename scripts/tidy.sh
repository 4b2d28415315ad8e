#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# clang-tidy over core, bindings and tests, with the checks of .clang-tidy. Arguments are patterns of
# paths instead of all files, e.g. scripts/tidy.sh src/contact
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset tidy -DPython_EXECUTABLE="$(command -v python)" \
  -Dpybind11_DIR="$(python -m pybind11 --cmakedir)"
# The package clang-tidy has the headers of its own compiler but OpenMP's, which are clang++'s; they
# come last, so that nothing else is found there.
run-clang-tidy.py -quiet -p build/tidy -j "$(nproc)" \
  -extra-arg="-idirafter$(clang++ -print-resource-dir)/include" "$@"
