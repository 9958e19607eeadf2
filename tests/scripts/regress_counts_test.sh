#!/usr/bin/env bash
# The exact layer of ./study regress: what it says of counts that were doctored, on two short rows.
# Usage: regress_counts_test.sh ROOT BIN
set -euo pipefail
scripts=$(cd "$1" && pwd)/bench/scripts
bin=$(cd "$2" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
work="$scratch/work" baselines="$scratch/baselines" root="$scratch/root" against=0123456789
filter='^euler_number/bitpacked/baseline/1/' pictures=() binarise=()
mkdir -p "$work" "$baselines" "$root/build/release" "$work/old/build/release/bin"
ln -s "$bin" "$root/build/release/bin"
. "$scripts/setup.sh"
. "$scripts/regress_counts.sh"

# doctor EXPRESSION: changes the stored document `d`.
doctor() {
  /usr/bin/python3 -c "
import json, sys
d = json.load(open(sys.argv[1]))
$1
json.dump(d, open(sys.argv[2], 'w'))" "$scratch/stored.json" "$file"
}

# expect STATUS TEXT COMMAND...: the exit status of a command in a shell of its own, and what it says.
expect() {
  local found=0
  rm -f "$work/counts.json"
  ("${@:3}") >"$scratch/out" 2>&1 || found=$?
  if [ "$found" -ne "$1" ] || ! grep -qF -- "$2" "$scratch/out"; then
    printf '%s\n  status %s instead of %s; wanted: %s\n' "${*:3}" "$found" "$1" "$2"
    cat "$scratch/out"
    exit 1
  fi
}

gate() { compare_with_baseline && conclude "$1"; }
gate_of_builds() { compare_with_build && conclude "$1"; }
skipped='SKIPPED: instructions are not compared:'

file=$(counts_file)
expect 0 "$skipped there is no '$file'; ./study regress --update writes it" gate 0
expect 4 'instructions SKIPPED, times SKIPPED' gate 4

count_for_baseline
store_counts >"$scratch/out"
grep -qx "counts of instructions: ${file##*/}" "$scratch/out"
[ "$(ls -A "$baselines")" = "${file##*/}" ]
cp "$file" "$scratch/stored.json"

# Equal counts: what times say.
expect 0 'instructions PASS, times PASS' gate 0
expect 1 'instructions PASS, times FAIL' gate 1
expect 3 'instructions PASS, times INCONCLUSIVE' gate 3
expect 4 'instructions PASS, times SKIPPED' gate 4
expect 2 '2 rows compared: 0 take more instructions' gate 2

# Less than 2 % more than were stored.
doctor "for row in d['rows']: row['instructions'] = int(row['instructions'] / 1.02)"
for status in 0 3 4; do expect 1 'instructions FAIL, times' gate $status; done
expect 1 '(+2.' gate 0
expect 2 '2 take more instructions' gate 2

# Nothing to compare with does not hide what times say.
doctor "d['build']['compiler']['version'] = '1'"
expect 0 "$skipped they are of another compiler" gate 0
expect 1 'instructions SKIPPED, times FAIL' gate 1
doctor "for row in d['rows']: row['method'] = 'abacus'; d['valgrind'] = '3'"
expect 0 "$skipped they were counted by another method or valgrind" gate 0
doctor "d['rows'] = []"
expect 0 "$skipped no row was counted before" gate 0
doctor "d['schema'] = 99"
expect 0 "$skipped '$file' holds no counts that this version knows" gate 0
cp "$scratch/stored.json" "$file"
filter='no such row' expect 0 "$skipped no row to time" gate 0

# What cannot be written leaves nothing behind.
mv "$file" "$scratch/kept.json"
mkdir "$file"
store() { cp "$scratch/stored.json" "$work/counts.json" && store_counts; }
expect 2 "the counts of instructions cannot be written to '$file'" store
[ "$(ls -A "$baselines")" = "${file##*/}" ]
rmdir "$file"
mv "$scratch/kept.json" "$file"

# Another build: none that counts, one that cannot, one with counts of another version, one as good.
old="$work/old/build/release/bin/thinbench"
expect 0 "$skipped commit $against has no program that counts" gate_of_builds 0
printf '#!/bin/sh\necho "thinbench: no such command" >&2\nexit 2\n' >"$old"
chmod +x "$old"
expect 0 "$skipped commit $against: no such command" gate_of_builds 0
# It is called with: instructions --filter REGEX --out FILE.
doctor "d['schema'] = 99"
printf '#!/bin/sh\ncp "%s" "$5"\n' "$file" >"$old"
expect 0 'holds no counts that this version knows' gate_of_builds 0
cp "$scratch/stored.json" "$file"
expect 0 'instructions PASS, times PASS' gate_of_builds 0
doctor "for row in d['rows']: row['instructions'] = int(row['instructions'] / 1.02)"
expect 1 'instructions FAIL, times PASS' gate_of_builds 0

# A build that cannot count is no verdict.
rm "$root/build/release/bin"
mkdir "$root/build/release/bin"
printf '#!/bin/sh\necho "thinbench: it ended with signal 11" >&2\nexit 1\n' >"$root/build/release/bin/thinbench"
chmod +x "$root/build/release/bin/thinbench"
expect 2 'instructions cannot be counted: it ended with signal 11' compare_counts "$file"
expect 2 '--no-instructions leaves them out' count_for_baseline
echo "all as it should be"
