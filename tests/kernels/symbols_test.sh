#!/usr/bin/env bash
# No object file of an instruction-set level may define a symbol that other files could link to, except
# those whose name carries the level: such a symbol would run the level's instructions anywhere.
# Usage: symbols_test.sh BUILD_DIR
set -euo pipefail
levels=(kBaseline kSse42 kAvx2 kAvx512 kAvx512Icl)
checked=0
for i in "${!levels[@]}"; do
  while IFS= read -r -d '' object; do
    checked=$((checked + 1))
    leaked=$(nm --defined-only --extern-only "$object" | awk '{print $3}' |
      grep -vE "IsaE${i}E|thinbench${#levels[i]}${levels[i]}[0-9]|^DW\.ref\.|^__odr_asan|^$" || true)
    if [ -n "$leaked" ]; then
      printf '%s leaks:\n%s\n' "$object" "$leaked"
      exit 1
    fi
  done < <(find "$1/kernels/CMakeFiles/thinbench_${levels[i]}.dir" -name '*.o' -print0)
done
[ "$checked" -ge 15 ] || { echo "only $checked object files found"; exit 1; }
echo "$checked object files define no symbol that could leak"
