#!/usr/bin/env bash
# What ./study and ./check say before they build: help, wrong options, missing rights.
# Usage: scripts_test.sh ROOT
set -euo pipefail
root=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# expect STATUS TEXT COMMAND...: the exit status, and TEXT in the last line of standard error (anywhere
# in standard output where the status is 0).
expect() {
  local status=$1 text=$2 found=0
  shift 2
  "$@" >out 2>err </dev/null || found=$?
  local said=out
  [ "$status" -eq 0 ] || { tail -n 1 err >last; said=last; }
  if [ "$found" -ne "$status" ] || ! grep -qF -- "$text" "$said"; then
    printf '%s\n  status %s instead of %s; wanted: %s\n' "$*" "$found" "$status" "$text"
    cat out err
    exit 1
  fi
}

study() { "$root/study" --no-install "$@"; }
expect 0 '--quality-image FILE' "$root/study" --help
for command in sweeps many-images compare; do expect 0 "usage: ./study $command" "$root/study" $command --help; done
expect 0 'Usage: ./check' "$root/check" -h
expect 2 '--quik' study --quik
expect 2 "cannot read the image 'absent.png'" study --image absent.png
expect 2 "--foreground: invalid choice: 'black'" study --foreground black
for threshold in 256 -1 1.5 ottsu; do
  expect 2 "expected an integer in [0, 255] or 'otsu', got '$threshold'" study --threshold=$threshold
done
expect 2 "expected integers in [2, 1024], got '1,4'" study --threads 1,4
expect 2 "expected integers with commas between them, got 'two'" study --threads two
expect 2 '--foreground needs --image' study --foreground dark
expect 2 "--filter: '(' is no regular expression" study --filter '('
expect 2 "--only: invalid choice: 'sizes'" study sweeps --only sizes
expect 2 '--compiler measures the sweep isa; leave out --only' study sweeps --compiler clang --only size
expect 2 "expected an integer from 1 to 999999, got 'many'" study sweeps --seconds many
expect 1 'absent/run.json: cannot be read' study compare absent absent
expect 2 'expected two runs or more' study compare absent
expect 0 'usage: ./check fuzz' "$root/check" --no-install fuzz --help
expect 0 'usage: ./check coverage' "$root/check" --no-install coverage --help
expect 0 'usage: python3 tests/mutation/run.py' "$root/check" --no-install mutants --help
expect 2 "--seconds: expected a number above 0, got 'long'" "$root/check" --no-install fuzz --seconds long
expect 2 "check: 'fast' is neither an option nor something to check; see ./check --help" "$root/check" fast

# Files of the caller's directory are not imported.
echo 'raise SystemExit(9)' >report.py
cp report.py numpy.py
expect 2 '--quik' study --quik
rm report.py numpy.py

# A user who may not install: no package is there, and sudo asks in vain.
mkdir bin
printf '#!/bin/sh\nexit 1\n' >bin/dpkg-query
cp bin/dpkg-query bin/sudo
printf '#!/bin/sh\necho 1000\n' >bin/id
chmod +x bin/*
for script in study check; do
  PATH="$work/bin:$PATH" expect 1 "$script: packages are missing and this user may not install them; \
run: sudo apt-get update && sudo apt-get install -y --no-install-recommends g++ cmake" "$root/$script"
done
echo "all as it should be"
