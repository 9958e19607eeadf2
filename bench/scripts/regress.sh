# Sourced by ./study for `./study regress`. Needs `root`, the project's root, and setup.sh.

regress_usage() {
  cat <<'TEXT'
Usage: ./study regress [--against COMMIT] [--filter REGEX] [--image FILE]... [--foreground VALUE]
                       [--threshold VALUE] [--all] [--judge-threads] [--baselines DIR]
                       [--no-instructions] [--no-install]
       ./study regress --update --reason TEXT [--filter REGEX] [--image FILE]... [--foreground VALUE]
                       [--threshold VALUE] [--baselines DIR] [--no-instructions] [--no-install]

Says whether rows became slower, in two layers.

Instructions, exact on the busiest machine: the rows on one thread are counted on a small copy of the
scene or of the first picture. FAIL where a row takes over 1 % more of them, or another number of
iterations; SKIPPED, with the reason, where there is nothing to compare with: no counts, or counts of
another compiler, C library, valgrind or picture.

Times, measured in pairs by 9 fresh processes. What does not pass is measured once more by 9 others, and
is FAIL only if both runs say so.

Without --against the speed-ups over the references are compared with the baseline of this processor,
compiler and flags, and the counts with those beside it. A row may lose 10 % of its speed (20 % on
pictures that do not fit the cache of a core): less cannot be told on another day. With --against the
other commit is built in a scratch folder, processes of both builds take turns, and 5 % are enough.

  --against COMMIT  compare this working tree with a commit, not with the baseline
  --filter REGEX    results whose name case/technique/isa/threads/scope/input matches; default: fast
                    ones on one thread, about a minute (with --against some minutes and a build)
  --image FILE      measure on this image instead of the built-in scene; repeatable
  --foreground, --threshold
                    which pixels of these images are foreground, as for ./study
  --all             show rows that passed, too
  --judge-threads   judge rows with threads, too: only where no one else uses the cores
  --update          make this run the baseline, and its counts those beside it; needs --reason, which
                    the history keeps
  --baselines DIR   where baselines are; default results/baselines
  --no-instructions only times; with --update the counts stay as they are
  --no-install      do not look for packages
  -h, --help        this text

Examples:
  ./study regress
  ./study regress --against HEAD~1 --filter '^holes/simd'
  ./study regress --update --reason 'rows of holes are read in pairs'

Exit status: 1 FAIL where either layer fails, else what times say: 0 PASS, 3 INCONCLUSIVE (too noisy, or
a control failed), 4 no times were compared: no baseline for this machine, or every row skipped. Counts
that pass make no 0 of these, and the last line names both verdicts. 2 wrong usage, or something went
wrong.
TEXT
}

processes=9 seconds=0.05
filter='^(thin_naccache_shinghal|thin_zhang_suen|thin_guo_hall|skeleton_scan|edges_sobel|holes|'
filter+='localise_objects)/(bitpacked|bitpacked_runs|simd_bitpacked|simd_bitpacked_tiles|simd_bitpacked_row|'
filter+='simd_16bit|simd_runs)/[a-z0-9.]+/1/'
against='' update=no reason='' baselines="$root/results/baselines" install=yes
instructions=yes pictures=() binarise=() judging=()
. "$root/bench/scripts/regress_counts.sh"

need_value() { [ -n "${2-}" ] || fail 2 "regress: $1 needs a value; see ./study regress --help"; }
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help) regress_usage; exit 0 ;;
    --against) need_value "$@"; against=$2; shift ;;
    --filter) need_value "$@"; filter=$2; shift ;;
    --image) need_value "$@"; pictures+=(--image "$(absolute "$2")"); shift ;;
    --foreground) need_value "$@"; check_foreground "$2"; binarise+=("$1" "$2"); shift ;;
    --threshold) need_value "$@"; check_threshold "$2"; binarise+=("$1" "$2"); shift ;;
    --reason) need_value "$@"; reason=$2; shift ;;
    --baselines) need_value "$@"; baselines=$(absolute "$2"); shift ;;
    --all | --judge-threads) judging+=("$1") ;;
    --update) update=yes ;;
    --no-instructions) instructions=no ;;
    --no-install) install=no ;;
    *) fail 2 "regress: '$1' is no option; see ./study regress --help" ;;
  esac
  shift
done

[ ${#binarise[@]} -eq 0 ] || [ ${#pictures[@]} -gt 0 ] ||
  fail 2 "regress: ${binarise[0]} needs --image; see ./study regress --help"
commit=$(git -C "$root" rev-parse --short=10 HEAD 2>/dev/null) || commit=unknown
if [ $update = yes ]; then
  [ -n "$reason" ] || fail 2 "regress: --update needs --reason \"...\", which the history keeps"
  [ -z "$against" ] || fail 2 "regress: --update makes a baseline; it does not go with --against"
  [ "$commit" != unknown ] || fail 2 "regress: --update needs a commit, and this is no clone"
  [ -z "$(git -C "$root" status --porcelain --untracked-files=no)" ] ||
    fail 2 "regress: --update needs a clean working tree: a baseline names the commit it was measured on"
elif [ -n "$reason" ]; then
  fail 2 "regress: --reason goes with --update"
fi
if [ -n "$against" ]; then
  against=$(git -C "$root" rev-parse --verify --quiet --short=10 "$against^{commit}") ||
    fail 2 "regress: there is no commit '$against'"
  seconds=0.08  # differences of two noisy sides, and only 5 % are allowed
fi

work=$(mktemp -d)
clean_up() {
  [ ! -e "$work/old" ] || git -C "$root" worktree remove --force "$work/old" || true
  rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 2' INT TERM

# The other commit, in a scratch folder of its own; what it lacks is said before anything is built.
check_out_other() {
  git -C "$root" worktree add --quiet --detach "$work/old" "$against" ||
    fail 2 "regress: cannot check out $against"
  [ -e "$work/old/bench/paired/main.cpp" ] ||
    fail 4 "regress: nothing was compared: commit $against has no program of paired speed-ups"
}

# A build that fails is no verdict.
build_both() {
  local counting=() old_counting=()
  [ $instructions = no ] || counting=(thinbench_program)
  [ ! -e "$work/old/bench/cli/instructions_command.cpp" ] || old_counting=("${counting[@]}")
  say "building"
  (build release thinbench_paired thinbench_regress "${counting[@]}") || exit 2
  new="$root/build/release/bin/thinbench_paired" old="$work/old/build/release/bin/thinbench_paired"
  [ -n "$against" ] || return 0
  say "building $against"
  (root="$work/old" && build release thinbench_paired "${old_counting[@]}") || exit 2
}

# measure PROGRAM SAMPLES FILTER OPTION...: whether its controls passed is judged later.
measure() {
  local status=0
  "$1" --quiet --no-peers --seconds-per-pair "$seconds" "${pictures[@]}" "${binarise[@]}" --samples-out "$2" --filter "$3" \
    "${@:4}" 2>"$work/said" || status=$?
  case $status in 0 | 3) ;; *) fail 2 "regress: $(tail -n 1 "$work/said")" ;; esac
}

# Processes of both builds by turns, each time the other one first. A build from before --first-seed
# gives every process the same layout, and then so does this one.
measure_by_turns() {
  local i seed=() builds=(new old)
  for ((i = 0; i < processes; ++i)); do
    ! "$old" --help | grep -q -e --first-seed || seed=(--first-seed $(($3 + i)))
    for build in "${builds[@]}"; do
      measure "${!build}" "$work/$build-$1-$i.jsonl" "$2" --processes 1 "${seed[@]}"
    done
    builds=("${builds[1]}" "${builds[0]}")
  done
}

# measure_all NAME FILTER SEED
measure_all() {
  if [ -n "$against" ]; then
    measure_by_turns "$@"
  else
    measure "$new" "$work/new-$1-0.jsonl" "$2" --processes $processes --first-seed "$3"
  fi
}

judge() {
  local options=(--baselines "$baselines")
  [ -z "$against" ] || options=(--old "$work"/old-first-*.jsonl)
  options+=(--run "$work"/new-first-*.jsonl)
  if [ -e "$work/new-again-0.jsonl" ]; then
    options+=(--again "$work"/new-again-*.jsonl)
    [ -z "$against" ] || options+=(--old-again "$work"/old-again-*.jsonl)
  fi
  "$root/build/release/bin/thinbench_regress" compare "${options[@]}" "${judging[@]}" "$@"
}

[ "$install" = no ] || (install_packages) || exit 2
[ -z "$against" ] || check_out_other
build_both

[ $instructions = no ] || {
  say "counting instructions"
  case "$update$against" in
    yes) count_for_baseline ;;
    no) compare_with_baseline ;;
    *) compare_with_build ;;
  esac
}

say "measuring ($processes processes${against:+ of each build})"
measure_all first "$filter" 0
if [ $update = yes ]; then
  mkdir -p "$baselines" || fail 2 "regress: cannot make the folder '$baselines'"
  status=0
  "$root/build/release/bin/thinbench_regress" update --baselines "$baselines" \
    --run "$work/new-first-0.jsonl" --commit "$commit" --reason "$reason" || status=$?
  [ $status -ne 0 ] || [ $instructions = no ] || store_counts
  exit $status
fi

judge --rerun-out "$work/rerun" >"$work/first" || true
[ -e "$work/rerun" ] || exit 2
doubtful=$(cat "$work/rerun")
if [ -n "$doubtful" ]; then
  say "measuring again: $doubtful"
  measure_all again "^(?=($doubtful)/)(?=.*(?:$filter))" $processes
fi
say "verdicts${against:+ against $against}"
status=0
judge || status=$?
conclude $status
