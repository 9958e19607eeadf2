#!/usr/bin/env bash
# A compiler launcher that copies objects of another build instead of compiling the same again.
#
# Compiling the kernels takes minutes, so tests that build the library inside another project set
# CMAKE_CXX_COMPILER_LAUNCHER to this file and THINBENCH_OBJECTS to a list of lines "source isa object",
# separated by tabs (conftest.py makes it). A source is the same if its path below kernels/ and its ISA
# are. Headers to precompile are left empty. Anything else is compiled.
isa= source= output= dependencies=
previous=
for argument in "$@"; do
  case "$previous" in
    -c) source=${argument##*kernels/} ;;
    -o) output=$argument ;;
    -MF) dependencies=$argument ;;
  esac
  case "$argument" in -DTHINBENCH_ISA=*) isa=${argument#*=} ;; esac
  previous=$argument
done
case "$output" in
  *cmake_pch.hxx.gch) : >"$output"; exit ;;
esac
object=$(grep -m 1 -F "$source"$'\t'"$isa"$'\t' "$THINBENCH_OBJECTS" | cut -f 3)
[ -n "$object" ] || exec "$@"
[ -z "$dependencies" ] || : >"$dependencies"
cp "$object" "$output"
