#!/bin/bash
# The sampler plans, measures and detects a wrong result; the program of Google Benchmark checks itself.
# Usage: programs_test.sh DIRECTORY_OF_PROGRAMS
set -u
programs=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  printf '%s\n' "$1" >&2
  exit 1
}

sampler=$programs/thinbench_sampler
"$sampler" plan --input square_64 --filter '^edges_sobel/autovec/baseline/1' >"$work/plan.json" ||
  fail 'plan failed'
"$sampler" measure --seed 1 <"$work/plan.json" >"$work/lines" || fail 'measure failed'
[ "$(grep -c '"chain_ns"' "$work/lines")" = 2 ] || fail 'expected the state of the machine twice'
[ "$(grep -c '"group":0' "$work/lines")" = 3 ] || fail 'expected a line for each layout'

# Times follow the clock of the plan.
sed 's/"cycle_ns":/"cycle_ns":1000/' "$work/plan.json" | "$sampler" measure --seed 1 >"$work/slow" ||
  fail 'measure failed at another clock'
/usr/bin/python3 - "$work/lines" "$work/slow" <<'PYTHON' || fail 'times do not follow the clock of the plan'
import json, sys
first, second = (min(time for line in map(json.loads, open(path)) if "group" in line
                     for time in line["entries"][0]) for path in sys.argv[1:])
assert second > 100 * first, (first, second)
PYTHON

sed -E 's/"hash":"[0-9a-f]{16}","name"/"hash":"0123456789abcdef","name"/g' \
  "$work/plan.json" >"$work/wrong.json"
"$sampler" measure <"$work/wrong.json" >/dev/null 2>"$work/err" && fail 'a wrong result was accepted'
grep -q 'gave another result' "$work/err" || fail "unexpected: $(cat "$work/err")"

"$sampler" plan --input square_64 --filter '^edges_sobel/autovec/baseline/1' --max-call 1e-9 >"$work/slow.json" ||
  fail 'a plan without rows failed'
grep -q '"reason":"a call takes more than 1e-09 s"' "$work/slow.json" || fail 'slow rows: other reason'

"$sampler" plan --filter no_such_row >/dev/null 2>"$work/err"
[ $? = 2 ] || fail 'expected exit status 2 where no row matches'
grep -q "no row matches the filter 'no_such_row'" "$work/err" || fail 'no row: other message'
"$sampler" plan --bogus >/dev/null 2>"$work/err"
[ $? = 2 ] || fail 'expected exit status 2 for an unknown option'
grep -q "there is no option '--bogus'" "$work/err" || fail 'unknown option: other message'

# Google Benchmark: one repetition of a millisecond, of all rows of one operation.
"$programs/thinbench_benchmarks" --input square_64 --filter '^edges_sobel/' \
  --benchmark_filter=autovec --benchmark_min_time=0.001 --benchmark_format=json >"$work/json" ||
  fail 'the benchmarks failed'
/usr/bin/python3 - "$work/json" <<'PYTHON' || fail 'unexpected benchmarks'
import json, sys
names = [row["name"] for row in json.load(open(sys.argv[1]))["benchmarks"]]
assert names and all("/autovec/" in name and name.startswith("edges_sobel/") for name in names), names
PYTHON
