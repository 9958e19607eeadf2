# Sourced by ./study for `./study sweeps`. Needs `root`, the project's root, and setup.sh.

sweeps_usage() {
  cat <<'TEXT'
Usage: ./study sweeps [--quick] [--only NAME]... [--rounds N] [--resume] [--out DIR] [--no-install]
       ./study sweeps --compiler clang [--rounds N] [--resume] [--out DIR] [--no-install]

Measures how times depend on the density and granularity of noise, the size of the image, threads, the
depth of strokes and the ISA; about four minutes. Every row is verified on every input first, which takes
2 GiB of memory for the largest. Ctrl-C leaves what was measured, with a report of it, and --resume goes on.

  --quick           smaller images and coarser steps: about half a minute
  --only NAME       this sweep, not all: density, size, threads, depth, enlarged or
                    isa; repeatable
  --rounds N        samples of every point; default 9
  --resume          go on with a run that was interrupted: the same command with this option
  --compiler clang  build with Clang, too, and measure the ISAs with both builds, interleaved round by round
  --out DIR         where results go; default results/<machine fingerprint>/<date>-<commit>, with
                    --resume the newest of this commit
  --no-install      do not look for packages
  -h, --help        this text

Written: sweeps.jsonl.xz, the journal, or for each compiler its own; sweeps.csv, sweeps.md, plots/, and a
section of the page where the folder holds a study.

Examples:
  ./study sweeps --quick --out /tmp/sweeps
  ./study sweeps --only density --only size
  ./study sweeps --compiler clang

Exit status: 0 done, 1 something is missing or failed, 2 wrong usage or a row was not equal to its
reference, 130 interrupted.
TEXT
}

chosen=() rounds=9 resume=no compiler='' out='' install=yes
need_value() { [ -n "${2-}" ] || fail 2 "sweeps: $1 needs a value; see ./study sweeps --help"; }
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help) sweeps_usage; exit 0 ;;
    --quick) chosen+=(--quick) ;;
    --only) need_value "$@"; chosen+=(--only "$2"); shift ;;
    --rounds) need_value "$@"; rounds=$2; shift ;;
    --resume) resume=yes ;;
    --compiler) need_value "$@"; compiler=$2; shift ;;
    --out) need_value "$@"; out=$(absolute "$2"); shift ;;
    --no-install) install=no ;;
    *) fail 2 "sweeps: '$1' is no option; see ./study sweeps --help" ;;
  esac
  shift
done
case $rounds in *[!0-9]* | 0*) fail 2 "sweeps: --rounds: expected an integer above 0, got '$rounds'" ;; esac
if [ -n "$compiler" ]; then
  [ "$compiler" = clang ] || fail 2 "sweeps: --compiler: '$compiler' is unknown; clang is compared with GCC"
  [ ${#chosen[@]} -eq 0 ] || fail 2 "sweeps: --compiler measures the levels and nothing else; leave out ${chosen[0]}"
  packages+=(clang)
fi

[ "$install" = no ] || install_packages
say "building"
build release thinbench_sweeps thinbench_program
[ -z "$compiler" ] || { say "building ($compiler)"; build "$compiler" thinbench_sweeps; }

commit=$(git -C "$root" rev-parse --short=10 HEAD 2>/dev/null) || commit=unknown
[ -z "$(git -C "$root" status --porcelain --untracked-files=no 2>/dev/null)" ] || commit="$commit-modified"
journals=(sweeps)
[ -z "$compiler" ] || journals=(sweeps-gnu "sweeps-$compiler")

# Folders start with the date, so that the last one is the newest.
newest_run() {
  local folder newest=''
  for folder in "$1"/*-"$commit"; do
    [ -z "$(ls "$folder/${journals[0]}.jsonl"* 2>/dev/null)" ] || newest=$folder
  done
  printf '%s' "$newest"
}

if [ -z "$out" ]; then
  runs="$root/results/$("$root/build/release/bin/thinbench" machine --fingerprint)"
  out="$runs/$(date -u +%F)-$commit"
  [ $resume = no ] || out=$(newest_run "$runs")
  [ -n "$out" ] || fail 1 "sweeps: no run of commit $commit was begun on this machine; leave out --resume"
fi
mkdir -p "$out" || fail 1 "sweeps: cannot make the folder '$out'"
for name in "${journals[@]}"; do
  journal="$out/$name.jsonl"
  if [ $resume = yes ]; then
    [ ! -e "$journal.xz" ] || xz -df "$journal.xz"
    [ -e "$journal" ] || [ "$name" != "${journals[0]}" ] ||
      fail 1 "sweeps: there is no '$journal' to go on with; leave out --resume"
  elif [ -e "$journal" ] || [ -e "$journal.xz" ]; then
    fail 1 "sweeps: '$out' holds $name.jsonl already: go on with it by --resume, or choose another --out"
  fi
done

# measure PRESET NAME OPTION...: begins the journal, or goes on with it.
measure() {
  local mode=--out
  [ ! -e "$out/$2.jsonl" ] || mode=--resume
  "$root/build/$1/bin/thinbench_sweeps" --commit "$commit" --rounds "$rounds" "${@:3}" $mode "$out/$2.jsonl"
}

# A round of each build, each time the other one first.
measure_by_turns() {
  local round builds=(release:sweeps-gnu "$compiler:sweeps-$compiler") build
  for ((round = 1; round <= rounds; ++round)); do
    printf 'round %s of %s\n' $round "$rounds"
    for build in "${builds[@]}"; do
      measure "${build%%:*}" "${build#*:}" --only isa --stop-after $round 2>"$work/said" || return $?
    done
    builds=("${builds[1]}" "${builds[0]}")
  done
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap : INT  # the program ends its sample first, and what was measured is reported
say "measuring"
status=0
if [ -n "$compiler" ]; then
  measure_by_turns || status=$?
  case $status in 0 | 130) ;; *) fail $status "sweeps: $(tail -n 1 "$work/said")" ;; esac
else
  measure release sweeps "${chosen[@]}" || status=$?
  case $status in 0 | 2 | 130) ;; *) fail 1 "sweeps: they could not be measured; see the line above" ;; esac
fi
ls "$out/${journals[0]}.jsonl" >/dev/null 2>&1 || exit $status

say "report"
cd "$root"
if [ $status -ne 130 ]; then
  for name in "${journals[@]}"; do xz -9ef "$out/$name.jsonl"; done
fi
command=sweeps
[ -z "$(ls "$out"/timings.json* 2>/dev/null)" ] || command=build
/usr/bin/python3 -m report $command "$out" || [ $status -eq 130 ] || exit 1
[ $status -ne 130 ] || fail 130 "sweeps: interrupted; go on by the same command with --resume"
exit $status
