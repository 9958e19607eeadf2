# Sourced by regress.sh: the gate's exact layer, counts of instructions. Needs its variables and setup.sh.

counts_verdict=SKIPPED  # PASS or FAIL where something was compared

bin_of() { printf '%s/build/release/bin' "$1"; }

counts_file() { "$(bin_of "$root")/thinbench_regress" counts-file --baselines "$baselines"; }

# count ROOT FILE OPTION...: counts of a build, into a file that is there only if all went well.
count() {
  "$(bin_of "$1")/thinbench" instructions --filter "$filter" "${pictures[@]:0:2}" --out "$2" \
    "${binarise[@]}" "${@:3}" >"$work/compared" 2>"$work/said"
}

why_not_counted() { tail -n 1 "$work/said" | sed 's/^thinbench: //'; }

skip_counts() { printf 'SKIPPED: instructions are not compared: %s\n' "$1"; }

# Why nothing could be compared, out of what was said instead.
why_not_compared() {
  head -n 1 "$work/compared" | sed -e 's/^.*not compared: //' -e 's/^nothing compared: //' \
    -e 's/^0 rows compared.*/no row was counted before/'
}

# compare_counts FILE: this build's counts with those in the file. A file of another version, or a
# filter without rows on one thread, is nothing to compare; a build that cannot count went wrong.
compare_counts() {
  local status=0 why
  count "$root" "$work/counts.json" --against "$1" || status=$?
  if [ ! -e "$work/counts.json" ]; then
    why=$(why_not_counted)
    case "$status $why" in "2 "* | "1 '$1' "*) skip_counts "$why"; return 0 ;; esac
    fail 2 "regress: instructions cannot be counted: $why"
  fi
  case $status in
    0) counts_verdict=PASS ;;
    1) counts_verdict=FAIL ;;
    4) skip_counts "$(why_not_compared)"; return 0 ;;
    *) fail 2 "regress: instructions cannot be compared: $(why_not_counted)" ;;
  esac
  cat "$work/compared"
  printf '%s\n' "$counts_verdict"
}

compare_with_baseline() {
  local file
  file=$(counts_file) || exit 2
  if [ -e "$file" ]; then
    compare_counts "$file"
  else
    skip_counts "there is no '$file'; ./study regress --update writes it"
  fi
}

# The other build counts first. What it cannot do is no fault of this one.
compare_with_build() {
  if [ ! -x "$(bin_of "$work/old")/thinbench" ]; then
    skip_counts "commit $against has no program that counts"
  elif count "$work/old" "$work/old-counts.json"; then
    compare_counts "$work/old-counts.json"
  else
    skip_counts "commit $against: $(why_not_counted)"
  fi
}

# Before anything is measured, so that a baseline never lacks its counts.
count_for_baseline() {
  count "$root" "$work/counts.json" ||
    fail 2 "regress: instructions cannot be counted: $(why_not_counted); --no-instructions leaves them out"
}

# Beside the baseline, where there is one now.
store_counts() {
  local file
  file=$(counts_file) || exit 2
  if ! { cp "$work/counts.json" "$file.part" && mv -T "$file.part" "$file"; } 2>/dev/null; then
    rm -f "$file.part"
    fail 2 "regress: the counts of instructions cannot be written to '$file'"
  fi
  printf 'counts of instructions: %s\n' "${file##*/}"
}

# conclude STATUS: the gate's last line and exit status, from the counts and the status of times.
conclude() {
  local times=("PASS" "FAIL" "" "INCONCLUSIVE" "SKIPPED") status=$1
  [ -n "${times[status]-}" ] || exit 2
  printf 'instructions %s, times %s\n' "$counts_verdict" "${times[status]}"
  [ "$counts_verdict" != FAIL ] || status=1
  exit $status
}
