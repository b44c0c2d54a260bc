#!/bin/sh
# All the set-up in one command: installs the missing packages, configures, builds, and starts.
#   sh third_party/bootstrap.sh run [ARGUMENT...]   the studio, or `cambrian ARGUMENT...`
#   sh third_party/bootstrap.sh test [ARGUMENT...]  the whole test suite, as `ctest ARGUMENT...`
#   sh third_party/bootstrap.sh engine              the engine that `cambrian page` puts into pages
#   sh third_party/bootstrap.sh packages [GROUP]    the packages only, with those of tests, emulation, engine or benchmarks
# Works from any folder; what was done before and is still good is not done again.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
build=$root/build/release
stamp=$build/.built_by_bootstrap

say() { printf '%s\n' "bootstrap: $*" >&2; }
die() {
    say "$*"
    exit 1
}

# The packages of packages.txt to build the program with, and those of the group $1.
packages_needed() {
    awk -v wanted="$1" '/^# -- /{ group = $3 } !/^#/ && NF && (group == "building" || group == "libraries" || group == wanted) { print $1 }' \
        "$root/third_party/packages.txt"
}

packages_missing() {
    # shellcheck disable=SC2046 # one word a package
    set -- $(packages_needed "$1")
    installed=$(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^ii  *//p')
    for package in "$@"; do
        printf '%s\n' "$installed" | grep -qxF "$package" || printf '%s ' "$package"
    done
}

install_packages() {
    if ! command -v dpkg-query >/dev/null; then
        say "not a Debian system; third_party/packages.txt says what must be installed"
        return
    fi
    missing=$(packages_missing "$1")
    [ -n "$missing" ] || return 0
    say "installing $missing"
    if [ "$(id -u)" -eq 0 ]; then
        as_root=
    elif command -v sudo >/dev/null; then
        as_root=sudo
    else
        die "these packages are missing and there is neither root nor sudo to install them: $missing"
    fi
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get update -qq || die "apt-get update failed"
    # shellcheck disable=SC2086 # one word a package
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing ||
        die "apt-get could not install $missing"
}

# Configures unless that was done; afresh if the tree was moved. $1: ON or OFF, the test suites.
configure() {
    cache=$build/CMakeCache.txt
    fresh=
    if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then fresh=--fresh; fi
    if [ -z "$fresh" ] && [ -f "$build/build.ninja" ]; then
        # Suites once built stay; ninja configures again by itself when a build file has changed.
        [ "$1" = OFF ] && return
        grep -qxF 'CAMBRIAN_BUILD_TESTS:BOOL=ON' "$cache" && return
    fi
    # shellcheck disable=SC2086 # an option or nothing
    (cd "$root" && cmake $fresh --preset release "-DCAMBRIAN_BUILD_TESTS=$1" >&2)
}

build() { cmake --build "$build" --parallel "$(nproc)" "$@" >&2; }

# Nothing the program is built from is newer than the last build.
program_is_current() {
    [ -x "$build/bin/cambrian" ] && [ -f "$stamp" ] || return 1
    changed=$(find "$root/src" "$root/third_party" "$root/CMakeLists.txt" "$root/CMakePresets.json" \
        -newer "$stamp" 2>/dev/null | head -n 1)
    [ -z "$changed" ] && [ "$(cat "$stamp")" = "$root" ]
}

build_program() {
    install_packages program
    configure OFF
    # Anything saved while it builds is newer than this.
    mkdir -p "$build"
    printf '%s\n' "$root" >"$stamp.new"
    build --target cambrian cambrian_documents
    mv "$stamp.new" "$stamp"
}

run_program() {
    program_is_current || build_program
    if [ $# -eq 0 ]; then set -- studio --if-no-display "$root/assets/settings/walking.toml"; fi
    exec "$build/bin/cambrian" "$@"
}

run_tests() {
    install_packages tests
    configure ON
    build
    cd "$root"
    exec ctest --preset release "$@"
}

build_engine() {
    install_packages engine
    configure OFF
    cmake -B "$build" -DCAMBRIAN_BUILD_ENGINE=ON >&2
    build --target engine
}

[ $# -gt 0 ] || set -- help
command=$1
shift
case $command in
run) run_program "$@" ;;
test) run_tests "$@" ;;
engine) build_engine ;;
packages)
    grep -q "^# -- ${1:-tests}\b" "$root/third_party/packages.txt" ||
        die "third_party/packages.txt has no group '$1'; it has tests, emulation, engine and benchmarks"
    install_packages "${1:-tests}"
    ;;
*)
    sed -n 's/^# \{0,1\}//; 2,7p' "$0" >&2
    exit 2
    ;;
esac
