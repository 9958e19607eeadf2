#!/bin/bash
# golden_experiment.sh PROGRAM EXPERIMENT DIRECTORY: computes an experiment again and compares it with
# DIRECTORY/EXPERIMENT.json. To record another one: PROGRAM experiment EXPERIMENT --out that file.
set -eu
out=$(mktemp)
trap 'rm -f "$out"' EXIT
"$1" experiment "$2" --out "$out" >/dev/null
diff "$3/$2.json" "$out"
