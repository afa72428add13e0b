"""What the sections of the table share: running a command under a meter, fitting growth, rows."""
import dataclasses
import json
import math
import os
import pathlib
import subprocess
import tempfile

HOME = pathlib.Path(__file__).resolve().parent
ROOT = HOME.parent
EXAMPLES = ROOT / "specs" / "examples"
SYSTEM_PYTHON = "/usr/bin/python3"  # the distribution's, which has its packages


@dataclasses.dataclass
class Row:
    """One line of the table. `reached`: True, False, or None where no target is set."""
    what: str
    on: str
    kempe: str
    peer: str = ""
    ratio: str = ""
    target: str = ""
    reached: bool | None = None

    def line(self):
        verdict = {True: "yes", False: "**no**", None: ""}[self.reached]
        return f"| {self.what} | {self.on} | {self.kempe} | {self.peer} | {self.ratio} | {self.target} | {verdict} |"


HEAD = "| what | on | Kempe | peer | ratio | target | reached |\n|---|---|---|---|---|---|---|"


@dataclasses.dataclass
class Context:
    build: pathlib.Path
    quick: bool

    @property
    def kempe(self):
        return self.build / "app" / "kempe"

    def program(self, name):
        return self.build / "bench" / f"kempe_{name}_bench"


@dataclasses.dataclass
class Metered:
    code: int
    stdout: str
    stderr: str
    cpu_s: float
    wall_s: float
    memory_mb: float


def metered(command, **options):
    """Runs a command to its end: its output, CPU seconds and largest resident memory (of it and what it waited for).

    The memory is what time(1) sees: a child of this process begins with the memory of this process.
    """
    import time
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err, tempfile.NamedTemporaryFile("r") as memory:
        begin = time.monotonic()
        process = subprocess.Popen(["/usr/bin/time", "--quiet", "-f", "%M", "-o", memory.name, *[str(c) for c in command]],
                                   stdout=out, stderr=err, **options)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        wall = time.monotonic() - begin
        texts = []
        for file in (out, err):
            file.seek(0)
            texts.append(file.read().decode())
        largest = int(memory.read().split()[-1]) / 1024
    return Metered(process.returncode, *texts, usage.ru_utime + usage.ru_stime, wall, largest)


def json_of(*command):
    run = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if run.returncode != 0:
        raise RuntimeError(f"{command[0]} ended with {run.returncode}: {run.stderr.strip()}")
    return json.loads(run.stdout)


def google_benchmarks(program, pattern, seconds=0.5, rounds=3):
    """Results by name: the least CPU time of some rounds, in seconds."""
    report = json_of(program, f"--benchmark_filter={pattern}", "--benchmark_format=json",
                     f"--benchmark_min_time={seconds}", f"--benchmark_repetitions={rounds}")
    unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}
    least = {}
    for one in report["benchmarks"]:
        if one.get("run_type") == "iteration":
            name, time = one["run_name"], one["cpu_time"] * unit[one["time_unit"]]
            least[name] = min(least.get(name, math.inf), time)
    return least


def exponent(sizes, times):
    """Slope of log time over log size by least squares."""
    x, y = [math.log(s) for s in sizes], [math.log(t) for t in times]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def n_log_n_exponent(sizes):
    """What `exponent` gives for n log n itself over these sizes."""
    return exponent(sizes, [n * math.log(n + 1) for n in sizes])


def shown(seconds):
    for unit, size in (("s", 1), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"
