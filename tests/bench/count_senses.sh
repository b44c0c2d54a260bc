#!/bin/sh
# Counts the machine instructions (valgrind's callgrind) of walkers' trials with all their senses,
# with those of 1994 and with none, in the same motion, and prints them as CSV, in thousands a tick,
# and in percent of the trials with those of 1994. Counts do not depend on how busy the machine is.
#
#   count_senses.sh PROGRAM [OUTPUT_FOLDER]
#
# PROGRAM is cambrian_bench_senses of a release build. Profiles are kept in OUTPUT_FOLDER, for
# callgrind_annotate. FOUNDERS, SECONDS_SIMULATED and EVOLVED (creature files with every sense) may
# be set from outside.
set -eu

program=${1:?usage: count_senses.sh PROGRAM [OUTPUT_FOLDER]}
folder=${2:-$(mktemp -d)}
founders=${FOUNDERS:-60}
seconds=${SECONDS_SIMULATED:-5}
evolved=${EVOLVED:-}
assets=$(CDPATH='' cd -- "$(dirname -- "$0")/../../assets" && pwd)
mkdir -p "$folder"

walkers=$(grep -l '"walking"' "$assets"/creatures/*.creature.json)

# Prints the instructions of the trials; the program's own line is left in the file `log`.
count() {
    name=$1
    shift
    valgrind --tool=callgrind --callgrind-out-file="$folder/$name.callgrind" \
        --toggle-collect='cambrian::bench::*count_trial*' "$program" "$@" \
        > "$folder/log" 2> "$folder/errors" || { cat "$folder/errors" >&2; exit 1; }
    awk '/^(summary|totals):/ { print $2; exit }' "$folder/$name.callgrind"
}

# compare NAME ARGUMENT...: one row.
compare() {
    name=$1
    shift
    base=$(count "$name-1994" --senses 1994 "$@")
    few=$(cat "$folder/log")
    none=$(count "$name-none" --senses none "$@")
    all=$(count "$name-all" --senses all "$@")
    awk -F, -v name="$name" -v few="$few" -v base="$base" -v none="$none" -v all="$all" '
        {
            split(few, old, ",")
            if ($5 != old[5]) { print "the motion differs" > "/dev/stderr"; exit 1 }
            printf "%s,%d,%.1f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f\n", name, $1, $2 / $1, old[3] / $1,
                $3 / $1, base / $4 / 1e3, all / $4 / 1e3, 100 * (base / none - 1),
                100 * (all / base - 1)
        }' "$folder/log"
}

columns="creatures,number,parts,sensors_1994,sensors_all,thousand_1994,thousand_all"
echo "$columns,percent_1994,percent_all"
settings=$assets/settings/walking.toml
compare founders --founders "$founders" --seconds "$seconds" "$settings"
compare founders-light --light --founders "$founders" --seconds "$seconds" "$settings"
# shellcheck disable=SC2086 # one word a file
{
    compare samples --every-channel --seconds "$seconds" "$settings" $walkers
    compare samples-light --every-channel --light --seconds "$seconds" "$settings" $walkers
    [ -z "$evolved" ] || compare evolved --seconds "$seconds" "$settings" $evolved
}
