#!/usr/bin/env python3
"""Random single changes of designs and logs, and a judge of the truth that shares nothing with the checker: angles instead of
complex square roots, sampled places instead of intervals. What the checker accepts must be true of every sampled place.

usage: mutations.py SOURCE_DIR COUNT [SEED]      prints how many were refused, accepted and wrong
"""
import cmath
import contextlib
import copy
import io
import json
import math
import pathlib
import random
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
FILES = HERE / "files"
LOOKED_AT = ("format", "copy", "region", "mechanism", "limits", "obstacles", "pole", "links", "objective", "cutting")


def numbers(value, path=()):
    """The paths of all numbers in a JSON value."""
    if isinstance(value, dict):
        for key, entry in value.items():
            yield from numbers(entry, (*path, key))
    elif isinstance(value, list):
        for i, entry in enumerate(value):
            yield from numbers(entry, (*path, i))
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path


def mutate(value, path, chance):
    """A copy with one number changed a little, much, or to another whole number."""
    out = copy.deepcopy(value)
    at = out
    for key in path[:-1]:
        at = at[key]
    old = at[path[-1]]
    ways = [old * 1.001, old * 0.999, old * 1.1, old * 0.9, -old, old + 1, old - 1, 0]
    at[path[-1]] = chance.choice(ways) if isinstance(old, float) else int(chance.choice([old + 1, old - 1, old + 2, 0]))
    return out


def accepted(module, texts):
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
        names = []
        for name, text in texts:
            names.append(str(pathlib.Path(folder) / name))
            pathlib.Path(names[-1]).write_text(text, encoding="utf-8")
        try:
            return module.main(names)
        except module.Unreadable:
            return False


# The judge


def near(p, a, b):
    length = abs(b - a) ** 2
    t = min(1.0, max(0.0, ((p - a) * (b - a).conjugate()).real / length)) if length else 0.0
    return abs(p - a - t * (b - a))


def between(a, b, c, d):
    """Distance of two segments."""
    def turn(p, q, r):
        return ((q - p).conjugate() * (r - p)).imag
    if turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0:
        return 0.0
    return min(near(a, c, d), near(b, c, d), near(c, a, b), near(d, a, b))


def inside(z, ring):
    found = False
    for p, q in zip(ring, ring[1:]):
        if (p.imag > z.imag) != (q.imag > z.imag) and z.real < p.real + (z.imag - p.imag) / (q.imag - p.imag) * (q.real - p.real):
            found = not found
    return found


def rings_of(shape):
    return [[[complex(*c) for c in ring] for ring in polygon] for polygon in shape["coordinates"]]


def places(region):
    for polygon in region:
        for ring in polygon:
            for p, q in zip(ring, ring[1:]):
                yield from (p + (q - p) * i / 8 for i in range(8))


def parts_of(m):
    """(name, joints of each stroke, layers, half width) of links, pins and posts."""
    layer = {l["name"]: l["layer"] for l in m["links"]}
    wide, thin = m["link_width_mm"] / 2, m["pin_diameter_mm"] / 2
    for link in m["links"]:
        n = link["name"]
        strokes = [n] if len(n) == 2 else [n[0] + n[1], n[0] + n[2]] + ([n[1] + n[2]] if link["shape"] == "triangle" else [])
        yield n, strokes, {layer[n]}, wide, set(n)
    for joint, one, other in (("A", "VA", "ACX"), ("B", "VB", "BCY"), ("C", "ACX", "BCY"), ("V", "VA", "VB")):
        low, high = sorted((layer[one], layer[other]))
        yield "pin " + joint, [joint * 2], set(range(low + 1, high)), thin, {joint}
    for joint, lowest in (("V", min(layer["VA"], layer["VB"])), ("X", layer["ACX"]), ("Y", layer["BCY"])):
        yield "post " + joint, [joint * 2], set(range(1, lowest)), thin, {joint}


class Judge:
    """What a design's file says, at sampled places. `broken` names what does not hold by more than twice the checker's eps."""

    def __init__(self, design):
        self.design, self.m = design, design["mechanism"]
        c, self.vertex = design["copy"], self.m["vertex"]
        self.k = cmath.rect(c["scale"], math.radians(c["rotation_deg"] % 360))
        if c["rotation_deg"] % 180 == 0:
            self.k = complex(self.k.real, 0.0)
        self.s = {"pole": self.k, "tracer": 1 - self.k, "pen": 1 - 1 / self.k}[self.vertex]
        self.a, self.b = self.m["lengths_mm"]["VA"], self.m["lengths_mm"]["VB"] / abs(self.s)
        self.pole, self.region = complex(*self.m["pole_position_mm"]), rings_of(design["region"])

    def interval(self):
        dead = cmath.phase(self.s) % math.pi
        ends = [-math.pi, 0.0, math.pi] if self.s.imag == 0 else [-math.pi, dead - math.pi, 0.0, dead, math.pi]
        return ends[self.m["assembly"]], ends[self.m["assembly"] + 1]

    def pose(self, T):
        """Joints, and the transmission angle in degrees, by angles; None out of reach."""
        w = (T - self.pole) * {"pole": 1, "tracer": -1, "pen": -self.k}[self.vertex]
        cosine = (abs(w) ** 2 - self.a ** 2 - self.b ** 2) / (2 * self.a * self.b)
        if abs(cosine) > 1:
            return None
        low, high = self.interval()
        for psi in (math.acos(cosine), -math.acos(cosine)):
            d = (psi + cmath.phase(self.s) - low) % (2 * math.pi) + low
            if low < d < high:
                p = w / (1 + self.b / self.a * cmath.exp(1j * psi))
                q = self.s * (w - p)
                V = self.pole if self.vertex == "pole" else self.pole - w
                joints = {"V": V, "A": V + p, "B": V + q, "C": V + p + q, "X": V + w, "Y": V + self.s * w}
                return joints, math.degrees(min(d - low, high - d))
        return None

    def broken(self):
        d, m, eps = self.design, self.m, 2e-6
        s, a, b, L = abs(self.s), self.a, self.b, m["lengths_mm"]
        one = abs(1 - self.s)
        right = {"VA": a, "VB": s * b, "AC": s * b, "BC": a, "AX": b, "CX": one * b, "BY": s * a, "CY": one * a}
        links, pole = d["links"], d["pole"]
        least = max(links["shortest_mm"], m["pin_diameter_mm"] + max(0, d["cutting"]["hole_fit_mm"]) + links["wall_mm"])
        for name, length in L.items():
            if abs(length - right[name]) > eps or not least - eps <= length <= links["longest_mm"] + eps:
                return name
        if max(l["layer"] for l in m["links"]) > links["layers"] or self.vertex not in d["objective"]["groundings"]:
            return "layers"
        if "at_mm" in pole and abs(complex(*pole["at_mm"]) - self.pole) > eps:
            return "pole"
        if "within_mm" in pole:
            area = rings_of(pole["within_mm"])
            off = min(near(self.pole, p, q) for polygon in area for ring in polygon for p, q in zip(ring, ring[1:]))
            if off > eps and not any(inside(self.pole, polygon[0]) for polygon in area):
                return "pole"
        return self.gaps(eps)

    def gaps(self, eps):
        parts, limits = list(parts_of(self.m)), self.design["limits"]
        pairs = [(p, q) for i, p in enumerate(parts) for q in parts[:i]
                 if not p[4] & q[4] and (p[2] & q[2] or p[0].startswith("post") and q[0].startswith("post"))]
        if any(p[4] & q[4] and p[2] & q[2] for i, p in enumerate(parts[:4]) for q in parts[:i]):
            return "layers"
        for T in places(self.region):
            found = self.pose(T)
            if not found or found[1] < limits["transmission_deg"] - eps:
                return "transmission"
            J = found[0]
            for p, q in pairs:
                gap = min(between(J[u[0]], J[u[1]], J[v[0]], J[v[1]]) for u in p[1] for v in q[1]) - p[3] - q[3]
                if gap < limits["clearance_mm"] - eps:
                    return f"{p[0]}, {q[0]}"
            for o in self.design["obstacles"]:
                for p in parts:
                    if any(o["layers"][0] <= n <= o["layers"][1] for n in p[2]):
                        for ring in rings_of(o["shape"])[0][:1]:
                            gap = min(between(J[u[0]], J[u[1]], v, w) for u in p[1] for v, w in zip(ring, ring[1:])) - p[3]
                            if gap < limits["clearance_mm"] - eps or inside(J[p[1][0][0]], ring):
                                return f"{p[0]}, {o['name']}"
        if limits["sheets_gap_mm"] is not None:
            copied = [self.pole + self.k * (T - self.pole) for T in places(self.region)]
            edges = [(p, q) for polygon in self.region for ring in polygon for p, q in zip(ring, ring[1:])]
            if min(near(z, p, q) for z in copied for p, q in edges) < limits["sheets_gap_mm"] - eps:
                return "sheets"
        return None


def stored(names=("plagiograph", "two-layer", "free")):
    return [(json.loads((FILES / f"{n}.json").read_text(encoding="utf-8")),
             [json.loads(line) for line in (FILES / f"{n}.jsonl").read_text(encoding="utf-8").splitlines()]) for n in names]


def designs(module, count, seed):
    """Counts of random changes of the stored designs, and those that were accepted though something is broken."""
    chance, files, found = random.Random(seed), stored(), {"refused": 0, "not looked at": 0, "true": 0, "wrong": []}
    for _ in range(count):
        design = chance.choice(files)[0]
        path = chance.choice(list(numbers(design)))
        changed = mutate(design, path, chance)
        if not accepted(module, [("design.json", json.dumps(changed))]):
            found["refused"] += 1
        elif path[0] not in LOOKED_AT:
            found["not looked at"] += 1
        else:
            reason = Judge(changed).broken()
            found["true"] += not reason
            found["wrong"] += [(path, reason)] if reason else []
    return found


def beats(design, header):
    """True if the stored design keeps the log's task and is better than its bound: then the log's claim is false."""
    its = {**design, **{key: header["task"][key] for key in ("region", "pole", "links", "limits", "obstacles", "objective", "cutting", "copy")}}
    its["mechanism"] = {**design["mechanism"], **{key: header["task"][key] for key in ("link_width_mm", "pin_diameter_mm")}}
    size = design["quality"]["size_mm"]
    return size < header["bound"] - 1e-6 and Judge(its).broken() is None


def logs(module, count, seed):
    """Counts of random changes of the stored logs: a number changed, a line left out, doubled or exchanged with another."""
    chance, files, found = random.Random(seed), stored(), {"refused": 0, "true": 0, "wrong": []}
    for _ in range(count):
        design, log = chance.choice(files)
        i, way = chance.randrange(1, len(log)), chance.randrange(6)
        j = chance.randrange(1, len(log))
        if way == 0:
            log = log[:i] + log[i + 1:]
        elif way == 1:
            log = log[:i] + [log[j]] + log[i:]
        elif way == 2:
            log = log[:i] + [log[j]] + log[i + 1:]
        else:
            i = 0 if way == 3 else i
            paths = list(numbers(log[i]))
            log = log if not paths else log[:i] + [mutate(log[i], chance.choice(paths), chance)] + log[i + 1:]
        if not accepted(module, [("certificate.jsonl", "".join(json.dumps(line) + "\n" for line in log))]):
            found["refused"] += 1
        elif beats(design, log[0]):
            found["wrong"].append((way, i, log[0]["bound"]))
        else:
            found["true"] += 1
    return found


if __name__ == "__main__":
    sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "proof"))
    import kempe_check
    count, seed = int(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 1
    print("designs", designs(kempe_check, count // 2, seed))
    print("logs   ", logs(kempe_check, count - count // 2, seed + 1))
