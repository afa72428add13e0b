#!/usr/bin/env python3
"""The program that scripts/run builds first: what it has, what it says of the commands it lacks, and that its designs are those of the
whole one. usage: design_program_test.py KEMPE_DESIGN KEMPE SOURCE"""
import pathlib
import subprocess
import sys
import tempfile

DESIGN, WHOLE, SOURCE = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])


def run(program, *words):
    return subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)


def commands(program):
    listed = run(program, "--help").stdout.split("Subcommands:\n")[1].split("\n\n")[0]
    return [line.split()[0] for line in listed.splitlines() if line.startswith("  ") and line[2] != " "]


own, all_commands = commands(DESIGN), commands(WHOLE)
assert own == ["init", "synthesize", "workspace", "report", "verify", "trace", "pareto", "studio", "help"], own
assert set(own) < set(all_commands), all_commands
assert "scripts/build" in run(DESIGN, "--help").stdout
assert "scripts/build" not in run(WHOLE, "--help").stdout
for command in sorted(set(all_commands) - set(own)):
    answer = run(DESIGN, command)
    assert answer.returncode == 2, (command, answer)
    assert "no such command" in answer.stderr and "scripts/build makes the one with all commands" in answer.stderr, answer.stderr
answer = run(DESIGN, "synthesise")
assert answer.returncode == 2 and "did you mean synthesize?" in answer.stderr, answer.stderr

with tempfile.TemporaryDirectory() as folder:
    spec = SOURCE / "specs/examples/plagiograph.toml"
    files = []
    for name, program in (("design", DESIGN), ("whole", WHOLE)):
        place = pathlib.Path(folder) / name
        answer = run(program, "synthesize", spec, "-o", place)
        assert answer.returncode == 0, answer.stderr
        files.append({file.relative_to(place): file.read_bytes() for file in place.rglob("*") if file.is_file()})
    assert files[0].keys() == files[1].keys()
    different = [str(name) for name in files[0] if files[0][name] != files[1][name]]
    assert not different, different
print(f"{len(own)} commands of {len(all_commands)}, {len(files[0])} files the same")
