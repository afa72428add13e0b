#!/usr/bin/env bash
# Tries installed packages: each thing that a person does first, from the installed files alone. scripts/package --test runs it in a
# bare Debian. Ends at the first that fails.
set -euo pipefail
fail() { echo "$*" >&2; exit 1; }
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
examples=/usr/share/doc/kempe/examples

echo "program: $(kempe --version)"
kempe init plagiograph -o first.toml >/dev/null
kempe synthesize first.toml -o design --seed 1 --quiet >design.txt
for file in report.html workshop.pdf drawing.dxf bom.csv design.json certificate.jsonl parts/assembly.step; do
  test -s "design/$file" || fail "no $file"
done
kempe verify design/design.json --quiet | head -n 1
kempe synthesize $examples/nameplate.toml -o nameplate --quiet | grep '^size'
kempe solve $examples/linkages/watt-six-bar.toml -o six-bar.csv --animate six-bar.html --quiet >/dev/null
test -s six-bar.html && [ "$(wc -l <six-bar.csv)" -gt 10 ]
if [ -f /usr/share/kempe/studio.html ]; then
  kempe studio $examples/plagiograph.toml -o studio.html --quiet >/dev/null && test -s studio.html
fi
check="$(sed -n 's/^proof  *check it with: //p' design.txt)"
[ "$check" = "python3 /usr/share/kempe/proof/kempe_check.py design/design.json design/certificate.jsonl" ] || fail "the checker: $check"
bash -c "$check" >claims.txt

echo "manual pages and completions"
for command in $(kempe help | sed -n '/^Subcommands/,$s/^  \([a-z]\+\)  .*/\1/p'); do
  test -s "/usr/share/man/man1/kempe-$command.1.gz" || fail "no manual page of kempe $command"
done
bash -c '. /usr/share/bash-completion/completions/kempe; complete -p kempe' >/dev/null
test -s /usr/share/fish/vendor_completions.d/kempe.fish && test -s /usr/share/zsh/vendor-completions/_kempe

echo "Python module"
python3 - <<'PY'
import kempe

design = kempe.synthesize(kempe.load("first.toml"))
design.save("by-python")
assert open("by-python/design.json", "rb").read() == open("design/design.json", "rb").read(), "another design than the program's"
print(design)
PY
for script in /usr/share/doc/python3-kempe/examples/python/*.py; do python3 "$script" >/dev/null; done

echo "client of the library"
cmake -S /usr/share/doc/libkempe-dev/examples -B client >/dev/null
cmake --build client >/dev/null
client/design_and_write written && test -s written/report.html

echo "without Ipopt"
for binary in /usr/bin/kempe /usr/lib/*/libkempe.so.* /usr/lib/*/kempe/*.so /usr/lib/python3/dist-packages/kempe/*.so; do
  ldd "$binary" >needs.txt
  if grep -q 'not found' needs.txt; then fail "$binary: $(grep 'not found' needs.txt)"; fi
  if grep -qi ipopt needs.txt; then fail "$binary is linked with Ipopt"; fi
done
if dpkg-query -W -f '${Package}\n' | grep -qi ipopt; then fail "Ipopt is installed"; fi
echo "tried: all in order"
