#!/usr/bin/env bash
# Installs the build into a scratch folder and builds a program that knows only find_package(kempe).
set -euo pipefail
source="$1" build="$2"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
cmake --install "$build" --prefix "$scratch/prefix" >/dev/null
cmake -S "$source/tests/app/client" -B "$scratch/build" -G Ninja -DCMAKE_PREFIX_PATH="$scratch/prefix" \
  -DCMAKE_CXX_FLAGS="$(sed -n 's/^CMAKE_CXX_FLAGS:STRING=//p' "$build/CMakeCache.txt")" \
  -DCMAKE_CXX_COMPILER="$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")" >/dev/null
cmake --build "$scratch/build" >/dev/null
"$scratch/build/client"

# The installed program finds the module that writes STEP; without it the summary says so, and nothing else changes.
design() { "$scratch/prefix/bin/kempe" synthesize "$source/specs/examples/plagiograph.toml" -o "$scratch/$1" --quiet; }
design with >"$scratch/with.txt"
rm -rf "$scratch"/prefix/lib*/kempe/kempe-step-* "$scratch"/prefix/lib*/*/kempe/kempe-step-*
design without >"$scratch/without.txt"
grep -q "no parts/assembly.step: .*scripts/bootstrap step" "$scratch/without.txt"
[ ! -e "$scratch/without/parts/assembly.step" ]
cmp "$scratch/with/design.json" "$scratch/without/design.json"
if ls "$build"/modules/kempe-step-* >/dev/null 2>&1; then
  [ -s "$scratch/with/parts/assembly.step" ]
  ! grep -q assembly.step "$scratch/with.txt"
fi
