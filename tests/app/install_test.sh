#!/usr/bin/env bash
# Installs the build into a scratch folder, looks at what is there, and builds and runs the examples outside the tree, which know
# only find_package(kempe). Every public header is compiled alone.
set -euo pipefail
source="$1" build="$2"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

cmake --install "$build" --prefix "$scratch/prefix" >/dev/null
diff <(cd "$source/include" && find . -type f | sort) <(cd "$scratch/prefix/include" && find . -type f | sort)

# The summary names the checker where it is installed; the command that it says is run as it stands.
kempe="$scratch/prefix/bin/kempe"
(cd "$scratch" && "$kempe" synthesize "$source/specs/examples/plagiograph.toml" -o plate --quiet >summary.txt)
check="$(sed -n 's/^proof  *check it with: //p' "$scratch/summary.txt")"
grep -qF "python3 $scratch/prefix/share/kempe/proof/kempe_check.py plate/design.json plate/certificate.jsonl" <<<"$check"
(cd "$scratch" && bash -c "$check" >checked.txt)
(cd "$scratch" && "$kempe" verify plate/design.json | grep -qF "$scratch/prefix/share/kempe/proof/kempe_check.py")

cp -r "$source/examples" "$scratch/examples"
for header in "$scratch"/prefix/include/kempe/*.hpp; do
  name="$(basename "$header" .hpp)"
  printf '#include <kempe/%s.hpp>\n#include <kempe/%s.hpp>\n' "$name" "$name" >"$scratch/examples/alone_$name.cpp"
done
cat >>"$scratch/examples/CMakeLists.txt" <<'CMAKE'
file(GLOB alone alone_*.cpp)
add_library(alone OBJECT ${alone})
target_link_libraries(alone PRIVATE kempe::kempe)
CMAKE
cmake -S "$scratch/examples" -B "$scratch/build" -G Ninja -DCMAKE_PREFIX_PATH="$scratch/prefix" \
  -DCMAKE_CXX_FLAGS="$(cached CMAKE_CXX_FLAGS)" -DCMAKE_EXE_LINKER_FLAGS="$(cached CMAKE_EXE_LINKER_FLAGS)" \
  -DCMAKE_CXX_COMPILER="$(cached CMAKE_CXX_COMPILER)" >/dev/null
cmake --build "$scratch/build" >/dev/null

"$scratch/build/design_and_write" "$scratch/design"
test -s "$scratch/design/report.html"
"$scratch/build/map_past_obstacles" | grep -q '^lost .*vice'
"$scratch/build/many_specs" 4 | grep -q 'designs for 4 tasks'
