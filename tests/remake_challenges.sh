#!/usr/bin/env bash
# Freezes the challenges of assets/challenges again, scores their own entries again and writes their boards:
#   tests/remake_challenges.sh build/release/bin/cambrian
# To be run when the version of a simulator was raised. Scores of assets/creatures must be of this version.
set -euo pipefail
cambrian=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../assets"
shopt -s nullglob

for entry in challenges/*.creature.json; do
  "$cambrian" rescore "$entry"
done

make_challenge() { # FILE SETTINGS NAME CREATURE...
  local file=challenges/$1
  "$cambrian" challenge new "settings/$2.toml" --seed 7 --budget 20000 --name "$3" -o "$file.challenge.toml"
  "$cambrian" challenge enter "$file.challenge.toml" "${@:4}" -o "$file.board.md"
}
creatures() { printf 'creatures/%s.creature.json\n' "$@"; }

make_challenge walk walking walk $(creatures biped bounder crawler galloper pacer rower trotter walker worm)
make_challenge swim swimming swim $(creatures dart finned_swimmer lobster medusa scissors squid)
make_challenge jump jumping jump $(creatures frog hopper leaper)
make_challenge seek seeking seek $(creatures cuttlefish manta minnow shrimp)
make_challenge walk-in-space walking-3d 'walk in space' challenges/*.creature.json
