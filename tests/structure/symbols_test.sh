#!/usr/bin/env bash
# An object file compiled for an ISA may export a symbol only if the name of the symbol carries the ISA: any
# other symbol could be linked into code that runs on processors without the ISA. And the libraries that users link
# define nothing of what the study compares them with.
# Usage: symbols_test.sh BUILD_DIR
set -euo pipefail
isas=(baseline sse42 avx2 avx512 avx512icl)  # in the order of enum Isa
sources=
for i in "${!isas[@]}"; do
  isa=${isas[i]}
  checked=0
  while IFS= read -r -d '' object; do
    checked=$((checked + 1))
    leaked=$(nm --defined-only --extern-only "$object" | awk '{print $3}' |
      grep -vE "IsaE${i}E|6detail${#isa}${isa}[0-9]|^DW\.ref\.|^__odr_asan|^$" || true)
    if [ -n "$leaked" ]; then
      printf '%s leaks:\n%s\n' "$object" "$leaked"
      exit 1
    fi
  done < <(find "$1/kernels/CMakeFiles/thinbench_$isa.dir" \
    "$1/kernels/techniques/CMakeFiles/thinbench_techniques_$isa.dir" -name '*.o' -print0)
  [ "$checked" -ge 15 ] || { echo "only $checked object files of $isa found"; exit 1; }
  [ "${sources:-$checked}" = "$checked" ] || { echo "$isa has $checked object files, not $sources"; exit 1; }
  sources=$checked
done
echo "$sources object files of each of ${#isas[@]} ISAs define no symbol that could leak"

# defined FILE: its functions and data, but for those that several files may define.
defined() { nm --defined-only "$1" | awk '$2 ~ /^[TtDdRrBb]$/ && $3 ~ /9thinbench/ {print $3}' | LC_ALL=C sort -u; }
techniques=$(nm --defined-only --extern-only "$1/kernels/techniques/libthinbench_techniques.a" |
  awk '$2 ~ /^[TDRB]$/ {print $3}' | LC_ALL=C sort -u)
for library in "$1"/kernels/libthinbench.{a,so}; do
  shared=$(LC_ALL=C comm -12 <(defined "$library") <(printf '%s\n' "$techniques"))
  [ -z "$shared" ] || { printf '%s has symbols of techniques:\n%s\n' "$library" "$shared"; exit 1; }
done
echo "the libraries have none of $(printf '%s\n' "$techniques" | wc -l) symbols of techniques"
