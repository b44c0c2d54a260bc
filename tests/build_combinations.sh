#!/bin/sh
# Configures and builds every combination of the options STUDIO, CLUSTER, TESTS and BENCH, and tries what
# each one built. All combinations share one build folder, so that only what differs is compiled again.
#   tests/build_combinations.sh [BUILD-FOLDER]      default: build/combinations
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/combinations}

fail() {
    printf '%s\n' "build_combinations: $*" >&2
    exit 1
}

# $1, $2, $3, $4: ON or OFF for STUDIO, CLUSTER, TESTS, BENCH.
configure_and_build() {
    cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCAMBRIAN_BUILD_STUDIO="$1" \
        -DCAMBRIAN_BUILD_CLUSTER="$2" -DCAMBRIAN_BUILD_TESTS="$3" -DCAMBRIAN_BUILD_BENCH="$4" \
        >"$build.log" 2>&1 &&
        cmake --build "$build" --parallel "$(nproc)" >>"$build.log" 2>&1 || {
        tail -n 40 "$build.log" >&2
        fail "STUDIO=$1 CLUSTER=$2 TESTS=$3 BENCH=$4 does not build"
    }
}

try_program() {
    "$build/bin/cambrian" simulate assets/creatures/walker.creature.json >/dev/null ||
        fail "the program does not simulate a sample creature"
    # Built without the studio, the program says so where it would draw a picture.
    drawn=no
    "$build/bin/cambrian" render --help | grep -q "built without" || drawn=yes
    [ "$drawn" = no ] && [ "$1" = ON ] && fail "the program with the studio cannot render"
    [ "$drawn" = yes ] && [ "$1" = OFF ] && fail "the program without the studio does not say that it cannot render"
    # Nothing listens at that port.
    joined=yes
    "$build/bin/cambrian" cluster nats://127.0.0.1:9 2>&1 | grep -q "built without libnats" && joined=no
    [ "$joined" = no ] && [ "$2" = ON ] && fail "the program with libnats cannot join a cluster"
    [ "$joined" = yes ] && [ "$2" = OFF ] && fail "the program without libnats does not say that it cannot join a cluster"
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
    for cluster in ON OFF; do
        for tests in ON OFF; do
            for bench in ON OFF; do
                printf '%s\n' "STUDIO=$studio CLUSTER=$cluster TESTS=$tests BENCH=$bench"
                # A target that this combination does not build must not be found from an earlier one.
                rm -rf "$build/bin" && find "$build" -name '*.a' -delete
                configure_and_build "$studio" "$cluster" "$tests" "$bench"
                try_program "$studio" "$cluster"
                [ "$tests" = OFF ] || try_tests
                [ "$bench" = OFF ] || try_bench
            done
        done
    done
done
