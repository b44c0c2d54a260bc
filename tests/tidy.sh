#!/bin/sh
# Runs clang-tidy with the checks of .clang-tidy on all sources of the program.
#
#   tidy.sh [analyze]
#
# With `analyze` clang's static analyzer runs too. It looks only at functions of the file that is
# compiled, so every source is then compiled by itself, which takes ten times as long.
set -eu
cd "$(dirname "$0")/.."

if [ "${1:-}" = analyze ]; then
    unity=OFF
    checks=
else
    unity=ON
    checks='-clang-analyzer-*'
fi
cmake --preset tidy "-DCMAKE_UNITY_BUILD=$unity" >/dev/null
cmake --build build/tidy --target cambrian_glad >/dev/null
run-clang-tidy -p build/tidy -quiet -j "$(nproc)" "-checks=$checks" '/src/'
