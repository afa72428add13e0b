#!/usr/bin/env python3
"""What the shared library shows: of our own names only those that include/kempe marks, and every one of them."""
import re
import subprocess
import sys
from pathlib import Path

library, headers = sys.argv[1], Path(sys.argv[2])
declared = " ".join(path.read_text(encoding="utf-8") for path in headers.glob("*.hpp"))
types = set(re.findall(r"(?:class|struct) KEMPE_EXPORT (\w+)", declared))
functions = set(re.findall(r"^KEMPE_EXPORT [\w:<>, ]+? (\w+)\(", declared, re.MULTILINE))

listing = subprocess.run(["nm", "--dynamic", "--defined-only", library], check=True, capture_output=True, text=True)
mangled = [name for line in listing.stdout.splitlines() if re.match(r"_Z(?:TV|TI|TS|GV)?NK?5kempe", name := line.split(" ")[-1])]
plain = subprocess.run(["c++filt"], input="\n".join(mangled), check=True, capture_output=True, text=True).stdout.splitlines()
ours = {re.sub(r"^(?:vtable|typeinfo|typeinfo name|guard variable) for ", "", name) for name in plain}
names = {(match[1], match[2]) for name in ours if (match := re.match(r"kempe::(\w+)(?:\[abi:\w+\])?(::|\(|$)", name))}

faults = sorted(f"shown, but not marked: {name}" for name in ours
                if not any(re.match(rf"kempe::{word}\b", name) for word in types | functions))
faults += sorted(f"marked, but not shown: {word}" for word in functions if (word, "(") not in names)
faults += sorted(f"marked, but not shown: {word}" for word in types if (word, "::") not in names)
print("\n".join(faults) or f"{len(ours)} names of kempe:: are shown: of {len(types)} types and {len(functions)} functions")
sys.exit(bool(faults))
