#!/bin/sh
# Makes assets/gallery/creatures.html again: the twelve creatures of the first page, alive on one page.
# Needs a program that was built with the engine of pages. Usage: assets/gallery/remake.sh PROGRAM
set -eu
cd "$(dirname "$0")"
"$1" page $(for name in biped bounder galloper leaper frog dart medusa manta minnow dragonfly butterfly moth; do
    echo "../creatures/$name.creature.json"
done) -o creatures.html
