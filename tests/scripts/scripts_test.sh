#!/usr/bin/env bash
# What ./study and ./check say before they build: help, wrong options, missing rights.
# Usage: scripts_test.sh ROOT
set -euo pipefail
root=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# expect STATUS TEXT COMMAND...: the exit status, and TEXT as a part of what is said on standard error
# in one line (of standard output where the status is 0).
expect() {
  local status=$1 text=$2 found=0
  shift 2
  "$@" >out 2>err </dev/null || found=$?
  local said=err
  [ "$status" -ne 0 ] || said=out
  if [ "$found" -ne "$status" ] || ! grep -qF -- "$text" "$said" ||
    { [ "$status" -ne 0 ] && [ "$(wc -l <err)" -ne 1 ]; }; then
    printf '%s\n  status %s instead of %s; wanted: %s\n' "$*" "$found" "$status" "$text"
    cat out err
    exit 1
  fi
}

expect 0 'Usage: ./study [--quick]' "$root/study" --help
expect 0 'Usage: ./check' "$root/check" -h
expect 2 "study: '--quik' is no option; see ./study --help" "$root/study" --quik
for option in --image --quality-image --foreground --threshold --filter --out; do
  expect 2 "study: $option needs a value; see ./study --help" "$root/study" "$option"
  expect 2 "study: $option needs a value; see ./study --help" "$root/study" "$option" ''
done
expect 1 "study: cannot read the image '$work/absent.png'" "$root/study" --image absent.png
expect 1 "study: cannot read the image '$work/absent.png'" "$root/study" --quality-image absent.png
for foreground in black '*' 'bright dark'; do
  expect 2 "study: --foreground: expected auto, bright or dark, got '$foreground'" \
    "$root/study" --foreground "$foreground"
done
for threshold in 256 -1 1.5 ottsu 007; do
  expect 2 "study: --threshold: expected an integer in [0, 255] or 'otsu', got '$threshold'" \
    "$root/study" --threshold "$threshold"
done
expect 2 'study: --foreground needs --image or --quality-image; see ./study --help' \
  "$root/study" --foreground dark
expect 2 'study: --threshold needs --image or --quality-image; see ./study --help' \
  "$root/study" --threshold 100
expect 2 "check: 'fast' is neither an option nor a preset; see ./check --help" "$root/check" fast

regress() { "$root/study" regress --no-install "$@"; }
expect 0 'Usage: ./study regress' "$root/study" regress --help
expect 2 "study: regress: '--agianst' is no option; see ./study regress --help" regress --agianst HEAD
expect 2 "study: regress: --against needs a value; see ./study regress --help" regress --against
expect 2 'study: regress: --update needs --reason "...", which the history keeps' regress --update
expect 2 'study: regress: --reason goes with --update' regress --reason why
expect 0 '--no-instructions only times' regress --help
expect 2 'study: --threshold: expected an integer' regress --image a.png --threshold high
expect 2 'study: regress: --foreground needs --image; see ./study regress --help' regress --foreground dark
expect 2 'study: regress: there is no commit' regress --against no_such_commit
oldest=$(git -C "$root" rev-list --max-parents=0 HEAD 2>/dev/null | tail -n 1) || oldest=
if [ -n "$oldest" ] && ! git -C "$root" cat-file -e "$oldest:bench/paired/main.cpp" 2>/dev/null; then
  expect 2 'study: regress: --update makes a baseline; it does not go with --against' \
    regress --update --reason why --against HEAD
  mkdir scratch
  TMPDIR="$work/scratch" expect 4 'has no program of paired speed-ups' regress --against "$oldest"
  [ -z "$(ls -A scratch)" ] && ! git -C "$root" worktree list | grep -qF "$work/scratch"
fi

sweeps() { "$root/study" sweeps --no-install "$@"; }
expect 0 'Usage: ./study sweeps' "$root/study" sweeps --help
expect 2 "study: sweeps: '--onyl' is no option; see ./study sweeps --help" sweeps --onyl size
expect 2 "study: sweeps: --out needs a value; see ./study sweeps --help" sweeps --out
expect 2 "study: sweeps: --rounds: expected an integer above 0, got 'many'" sweeps --rounds many
expect 2 "study: sweeps: --compiler: 'icc' is unknown; clang is compared with GCC" sweeps --compiler icc
expect 2 'sweeps: --compiler measures the levels and nothing else; leave out --quick' \
  sweeps --quick --compiler clang

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

# Paths are the caller's, wherever the script goes.
root="$root" bash -c '. "$root/bench/scripts/setup.sh"
  [ "$(absolute a/b)" = "$PWD/a/b" ] && [ "$(absolute /a)" = /a ]'
echo "all as it should be"
