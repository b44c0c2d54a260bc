#!/bin/sh
# Runs clang-tidy with the checks of .clang-tidy on all sources of the program.
#
#   tidy.sh [analyze]
#
# Most of the time goes into what the sources include, so they are joined into few large units
# (tidy_units.py), in which names of constants and helpers must differ. Reserved names are found by the
# compiler's own warnings, in no time. With `analyze` clang's static analyzer runs too. It looks only at
# functions of the file that is compiled, so every source is then compiled by itself, which takes very
# long.
set -eu
cd "$(dirname "$0")/.."

if [ "${1:-}" = analyze ]; then
    unity=OFF
    commands=build/tidy
    sources=/src/
    checks=
else
    unity=ON
    commands=build/tidy/units
    sources=/units/
    checks='-clang-analyzer-*'
fi
cmake --preset tidy "-DCMAKE_UNITY_BUILD=$unity" >/dev/null
cmake --build build/tidy --target cambrian_glad >/dev/null
[ "$unity" = OFF ] || python3 tests/tidy_units.py build/tidy 6
run-clang-tidy -p "$commands" -quiet -j "$(nproc)" "-checks=$checks" \
    -extra-arg=-Wreserved-identifier -extra-arg=-Wreserved-macro-identifier "$sources"
