#!/bin/sh
# Counts machine instructions (valgrind's callgrind) of every engine, workload and size and prints
# them as CSV, in millions: a simulated second (advancing only) and building one creature, with
# ratios to the first engine. Counts do not depend on how busy the machine is.
#
#   count_instructions.sh PROGRAM [OUTPUT_FOLDER]
#
# PROGRAM is cambrian_bench_engines of a release build. Profiles are kept in OUTPUT_FOLDER, for
# callgrind_annotate. ENGINES, WORKLOADS, BODIES, CREATURES and SECONDS_SIMULATED may be set from outside.
set -eu

program=${1:?usage: count_instructions.sh PROGRAM [OUTPUT_FOLDER]}
folder=${2:-$(mktemp -d)}
engines=${ENGINES:-cambrian box2d mujoco}
workloads=${WORKLOADS:-air swim walk}
bodies=${BODIES:-3 6 12 24}
creatures=${CREATURES:-6}
seconds=${SECONDS_SIMULATED:-3}
mkdir -p "$folder"

# Instructions below one of our functions, from a profile.
count_below() {
    callgrind_annotate --inclusive=yes --threshold=100 "$1" | grep "cambrian::bench::$2(" |
        head -1 | awk '{ gsub(",", "", $1); print $1 }'
}

echo "workload,bodies,engine,million_per_second,ratio,build_million"
for workload in $workloads; do
    for size in $bodies; do
        first=""
        for engine in $engines; do
            profile=$folder/$workload-$size-$engine.callgrind
            valgrind --tool=callgrind --callgrind-out-file="$profile" \
                --toggle-collect='cambrian::bench::advance_scene*' \
                --toggle-collect='cambrian::bench::build_scene*' \
                "$program" --advance-only --engine "$engine" --workload "$workload" \
                --bodies "$size" --creatures "$creatures" --seconds "$seconds" \
                > "$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 1; }
            advance=$(count_below "$profile" advance_scene)
            build=$(count_below "$profile" build_scene)
            : "${first:=$advance}"
            awk -v w="$workload" -v n="$size" -v e="$engine" -v a="$advance" -v b="$build" \
                -v f="$first" -v c="$creatures" -v s="$seconds" 'BEGIN {
                    printf "%s,%d,%s,%.3f,%.3f,%.3f\n", w, n, e, a / c / s / 1e6, a / f, b / c / 1e6
                }'
        done
    done
done
