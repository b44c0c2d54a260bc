#!/bin/sh
# Configures and builds every combination of the options STUDIO, TESTS and BENCH, and tries what each
# one built. All combinations share one build folder, so that only what differs is compiled again.
#   tests/build_combinations.sh [BUILD-FOLDER]      default: build/combinations
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/combinations}

fail() {
    printf '%s\n' "build_combinations: $*" >&2
    exit 1
}

# $1, $2, $3: ON or OFF for STUDIO, TESTS, BENCH.
configure_and_build() {
    cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCAMBRIAN_BUILD_STUDIO="$1" \
        -DCAMBRIAN_BUILD_TESTS="$2" -DCAMBRIAN_BUILD_BENCH="$3" >"$build.log" 2>&1 &&
        cmake --build "$build" --parallel "$(nproc)" >>"$build.log" 2>&1 || {
        tail -n 40 "$build.log" >&2
        fail "STUDIO=$1 TESTS=$2 BENCH=$3 does not build"
    }
}

try_program() {
    "$build/bin/cambrian" simulate assets/creatures/walker.creature.json >/dev/null ||
        fail "the program does not simulate a sample creature"
    # The program has no command to draw a picture when it is built without the studio.
    drawn=no
    "$build/bin/cambrian" render --help >/dev/null 2>&1 && drawn=yes
    [ "$drawn" = no ] && [ "$1" = ON ] && fail "the program with the studio cannot render"
    [ "$drawn" = yes ] && [ "$1" = OFF ] && fail "the program without the studio offers to render"
    return 0
}

try_tests() {
    ctest --test-dir "$build" -R '^(core|math|layers|genome):' --no-tests=error --parallel "$(nproc)" \
        >"$build.log" 2>&1 || {
        tail -n 40 "$build.log" >&2
        fail "tests fail"
    }
}

try_bench() {
    "$build/bin/cambrian_bench_robustness" -n 1 >/dev/null || fail "a benchmark does not run"
    "$build/bin/cambrian_bench_engines" --bodies 3 --seconds 0.1 >/dev/null ||
        fail "the comparison of engines does not run"
}

mkdir -p "$build"
for studio in ON OFF; do
    for tests in ON OFF; do
        for bench in ON OFF; do
            printf '%s\n' "STUDIO=$studio TESTS=$tests BENCH=$bench"
            # A target that this combination does not build must not be found from an earlier one.
            rm -rf "$build/bin" && find "$build" -name '*.a' -delete
            configure_and_build "$studio" "$tests" "$bench"
            try_program "$studio"
            [ "$tests" = OFF ] || try_tests
            [ "$bench" = OFF ] || try_bench
        done
    done
done
