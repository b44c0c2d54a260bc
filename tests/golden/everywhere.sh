#!/usr/bin/env bash
# The same bits everywhere, and how that is checked. cambrian_golden digests everything a result rests
# on: elementary functions, neurons, genomes, physics by every integrator, trials of every goal, an
# evolution on 1, 2 and 7 threads. digests.txt records the values. ctest compares them in every build;
# this script builds that one program for each platform and compares there:
#
#   release      gcc, optimised
#   debug        gcc, not optimised
#   clang        clang, optimised
#   clang-avx2   clang, free to use AVX2; multiply and add stay two roundings
#   old-cpu      the very program of `release` on an emulated Core 2 of 2006, which has no AVX: whatever
#                is chosen by processor is chosen differently there
#   aarch64      gcc for 64-bit ARM, less optimised, emulated: other instructions, another libm,
#                unsigned char
#   wasm         clang for WebAssembly, run by node: what pages for browsers have
#
#   everywhere.sh [PLATFORM...]     all of them, unless some are named
#
# Ends with status 1 if any platform differs; the first digests that do are named. A change meant to
# alter results records them again with
#
#   cmake --build build/release --target record_digests
#
# The tools are the groups `emulation` and `engine` of third_party/packages.txt. Builds are kept: `release` and
# `aarch64` in the folders of their presets, `wasm` in that of the engine, the others in build/everywhere.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

all=(release debug clang clang-avx2 old-cpu aarch64 wasm)

# build PRESET FOLDER [OPTION...]
build() {
  cmake --preset "$1" -B "$2" -DCAMBRIAN_BUILD_TESTS=ON "${@:3}" >/dev/null &&
    cmake --build "$2" --target cambrian_golden
}

# check FOLDER [EMULATOR...]
check() { "${@:2}" "$1/bin/cambrian_golden" --check tests/golden/digests.txt; }

# A processor that lacks what the program was compiled for must be emulated.
native_avx2() {
  if grep -qw avx2 /proc/cpuinfo; then "$@"; else qemu-x86_64 -cpu Haswell "$@"; fi
}

without_window=-DCAMBRIAN_BUILD_STUDIO=OFF

# Builds the program for a platform.
build_for() {
  local own=build/everywhere/$1
  case $1 in
    release | old-cpu) build release build/release ;;
    debug) build debug "$own" "$without_window" ;;
    clang) build clang "$own" "$without_window" ;;
    clang-avx2) build clang "$own" "$without_window" -DCMAKE_CXX_FLAGS=-march=x86-64-v3 ;;
    aarch64) build aarch64 build/aarch64 ;;
    wasm) build engine build/release/engine ;;
    *)
      echo "everywhere.sh: no platform '$1'; there are ${all[*]}" >&2
      return 1
      ;;
  esac
}

# Runs it there.
check_on() {
  local own=build/everywhere/$1
  case $1 in
    release) check build/release ;;
    debug | clang) check "$own" ;;
    clang-avx2) check "$own" native_avx2 ;;
    old-cpu) check build/release qemu-x86_64 -cpu core2duo ;;
    aarch64) check build/aarch64 qemu-aarch64 -L /usr/aarch64-linux-gnu ;;
    wasm)
      diff <(node --no-warnings third_party/run_wasi.mjs build/release/engine/bin/cambrian_golden.wasm) tests/golden/digests.txt &&
        echo 'the digests are as recorded'
      ;;
  esac
}

[ $# -gt 0 ] || set -- "${all[@]}"
failed=()
built=()
for name in "$@"; do
  printf -- '-- %s\n' "$name"
  if build_for "$name"; then built+=("$name"); else failed+=("$name"); fi
done

# Emulators use one core most of the time, so all platforms are checked at once.
reports=$(mktemp -d)
trap 'rm -rf "$reports"' EXIT
declare -A checks=()
for name in "${built[@]}"; do
  check_on "$name" >"$reports/$name" 2>&1 &
  checks[$name]=$!
done
for name in "${built[@]}"; do
  wait "${checks[$name]}" || failed+=("$name")
  printf -- '-- %s: ' "$name"
  cat "$reports/$name"
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "everywhere.sh: failed on ${failed[*]}" >&2
  exit 1
fi
echo "the same bits on $*"
