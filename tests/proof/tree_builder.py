#!/usr/bin/env python3
"""Writes the log of a proof (docs/proof.md) for the task of a design.json, by branching with the checker's own rules.

A test's tool: slow and plain. It guesses in doubles (weights, openings, points); the checker's rules decide whether a guess
refutes a node. That the trees close shows that the rules are enough.

usage: tree_builder.py design.json certificate.jsonl [bound]
"""
import json
import math
import pathlib
import sys

CHECKER = pathlib.Path(__file__).resolve().parents[2] / "proof" / "kempe_check.py"
MOST_NODES = 20_000


sys.path.insert(0, str(CHECKER.parent))
import kempe_check as check  # noqa: E402


def header_of(design, bound=None, none=False):
    """The header of a log about a design's task."""
    copy, mechanism = design["copy"], design["mechanism"]
    task = {"copy": {k: copy.get("wanted_" + k, copy[k]) for k in ("scale", "rotation_deg")}}
    task |= {k: design.get(k) for k in ("region", "pole", "links", "limits", "obstacles", "objective", "tolerance", "cutting")}
    task |= {k: mechanism[k] for k in ("link_width_mm", "pin_diameter_mm")}
    task["plate"] = mechanism["links"][2]["shape"]
    return {"format": "kempe-certificate/1", "claim": "none" if none else "bound", "objective": design["search"]["objective"],
            "bound": None if none else (design["quality"]["lower_bound"] if bound is None else bound), "task": task}


class TooLarge(Exception):
    pass


class Builder:
    def __init__(self, header):
        self.log = check.Certificate("built", [header])
        self.header, self.lines, self.lately = header, [], []
        task = self.log.task
        self.edges = [((i, j, n), p, q) for i, polygon in enumerate(task.region) for j, ring in enumerate(polygon)
                      for n, (p, q) in enumerate(zip(ring, ring[1:]))]
        self.corners = [(key, p) for key, p, _ in self.edges]

    def build(self):
        log = self.log
        for vertex in check.VERTICES:
            if vertex in log.task.groundings:
                log.shape = check.Shape(log.task, vertex)
                for mode in range(log.shape.modes):
                    log.sign = log.shape.signs(mode)[0]
                    todo = [(log.root(mode), 0)]
                    while todo:
                        node, depth = todo.pop()
                        line, children = self.step(node, depth)
                        self.lines.append(line)
                        todo += [(child, depth + 1) for child in reversed(children)]
                        if len(self.lines) > MOST_NODES:
                            raise TooLarge
        return [self.header] + self.lines

    def refutes(self, node, line):
        try:
            return not self.log.step(node, line)
        except check.Open:
            return False

    def step(self, node, depth):
        """A node's line and its children."""
        for line in ({"leaf": "lengths"}, {"leaf": "layers"}):
            if self.refutes(node, line):
                return line, []
        line = self.by_sum(node) or self.by_pole(node) or self.by_sheets(node)
        if line:
            return line, []
        found = self.as_lately(node)
        if not found and self.smallness(node) < 0.3:
            found = self.by_contact(node) or self.by_obstacle(node)
            if found and "share" not in found[0]:
                self.lately = [found[0]] + self.lately[:7]
        return found or self.by_split(node)

    def as_lately(self, node):
        """What refuted other nodes often refutes their neighbours."""
        for line in self.lately:
            if "leaf" in line and self.refutes(node, line):
                return line, []
            if "contact" in line:
                try:
                    children = self.log.contact(node, line)
                except check.Open:
                    continue
                if all(self.by_sum(child) for child in children):
                    return line, children
        return None

    # The middle design, in doubles

    def middle(self, node):
        return [node.box[v].middle() for v in "abxy"]

    def smallness(self, node):
        return max((node.box[v].hi - node.box[v].lo) / max(1e-9, node.box[v].hi) for v in "ab")

    def nearest(self, P):
        best = min(self.edges, key=lambda e: math.hypot(*check.to_segment(P, e[1], e[2])))
        (key, p, q) = best
        v = check.to_segment(P, p, q)
        length = math.dist(p, q)
        t = min(1.0, max(0.0, math.dist(p, (P[0] + v[0], P[1] + v[1])) / length)) if length else 0.0
        return [*key, t], (P[0] + v[0], P[1] + v[1])

    def farthest(self, P, count=4):
        ranked = sorted(self.corners, key=lambda c: -math.dist(c[1], P))[:count]
        return [([*key, 0.0], c) for key, c in ranked]

    # Sums

    def requirements(self, node):
        """(entry of the log, scale, coefficients) of what may be summed: value, slopes, squares of ab and of xy, product."""
        a, b, x, y = self.middle(node)
        shape, log, g2 = self.log.shape, self.log, self.log.shape.abs_g.middle() ** 2
        out = []
        poles = [(x, y)]
        if node.box["x"].hi > node.box["x"].lo:
            poles += [(cx, cy) for cx in (node.box["x"].lo, node.box["x"].hi) for cy in (node.box["y"].lo, node.box["y"].hi)]
        fars = {tuple(k): c for P in poles for k, c in self.farthest(P, 2 if len(poles) > 1 else 1)}
        nears = {tuple(k): c for P in poles for k, c in [self.nearest(P)]}
        for name, places, sign, window in (("far", fars, -1, node.window[0].middle()), ("near", nears, 1, node.window[1].middle())):
            for key, c in places.items():
                dx, dy = c[0] - x, c[1] - y
                unit = 1 / max(1.0, 2 * math.hypot(dx, dy) * math.sqrt(g2))
                p, l = sign * g2 * unit, -sign * unit
                out.append(([name, list(key), unit], [p * (dx * dx + dy * dy) + l * (a * a + b * b + 2 * a * b * window),
                            2 * l * (a + b * window), 2 * l * (b + a * window), -2 * p * dx, -2 * p * dy, l, p, 2 * l * window]))
        if log.by == "size":
            A, B = (f.middle() for f in shape.size)
            out.append((["bound", 1 / (A + B)], [(log.task.bound - A * a - B * b) / (A + B), -A / (A + B), -B / (A + B), 0, 0, 0, 0, 0]))
        smallest = min(1.0, shape.abs_s.middle(), shape.abs_1s.middle()) * shape.abs_g.middle()
        h = (log.task.pin_diameter_mm + log.task.clearance_mm) / smallest
        key, c = self.nearest((x, y))
        dx, dy = c[0] - x, c[1] - y
        out.append((["posts", key, 1 / h], [(dx * dx + dy * dy - h * h) / h, 0, 0, -2 * dx / h, -2 * dy / h, 0, 1 / h, 0]))
        return out

    def by_sum(self, node):
        requirements = self.requirements(node)
        half = [0.5 * (node.box[v].hi - node.box[v].lo) for v in "abxy"]

        def most(weights):
            c = [sum(w * r[1][i] for w, r in zip(weights, requirements)) for i in range(8)]
            total = c[0] + abs(c[7]) * half[0] * half[1]
            for i, h in enumerate(half):
                g, q = abs(c[1 + i]), c[5 + i // 2]
                total += g * g / (-4 * q) if q < 0 and g < -2 * q * h else g * h + q * h * h
            return total
        n = len(requirements)
        best, value = None, math.inf
        for i in range(n):
            unit = [1.0 if j == i else 0.0 for j in range(n)]
            if most(unit) < value:
                best, value = unit, most(unit)
        for _ in range(4):
            before = value
            for i in range(n):
                for j in range(n):
                    if value >= 0 and i != j and best[i] > 0:
                        best, value = self.shift(best, i, j, most)
            if value < -1e-9 or before - value < 1e-3 * abs(value):
                break
        if value >= 0:
            return None
        line = {"leaf": "sum", "of": [[*e[:-1], e[-1] * w] for (e, _), w in zip(requirements, best) if w > 0]}
        return line if self.refutes(node, line) else None

    @staticmethod
    def shift(weights, i, j, most):
        """The best share of weight i to move to j: `most` is convex in it."""
        def moved(t):
            out = list(weights)
            out[i], out[j] = weights[i] * (1 - t), weights[j] + weights[i] * t
            return out
        lo, hi = 0.0, 1.0
        for _ in range(22):
            t, u = lo + 0.382 * (hi - lo), lo + 0.618 * (hi - lo)
            lo, hi = (lo, u) if most(moved(t)) < most(moved(u)) else (t, hi)
        found = min((0.0, 0.5 * (lo + hi), 1.0), key=lambda t: most(moved(t)))
        return moved(found), most(moved(found))

    # Poles, sheets

    def by_pole(self, node):
        line = {"leaf": "pole"}
        return line if self.refutes(node, line) else None

    def by_sheets(self, node):
        gap = self.log.task.sheets_gap_mm
        if gap is None:
            return None
        P, k = self.middle(node)[2:], self.log.shape.k.middle()
        corners = self.corners[:: 1 + len(self.corners) // 30]
        pairs = []
        for key, c in corners:
            z = complex(*k) * complex(c[0] - P[0], c[1] - P[1]) + complex(*P)
            place, at = self.nearest((z.real, z.imag))
            inside = any(check.where((z.real, z.imag), p) >= 0 for p in self.log.task.region)
            pairs.append((0.0 if inside else math.dist(at, (z.real, z.imag)), [*key, 0.0], [z.real, z.imag] if inside else place))
            z = complex(c[0] - P[0], c[1] - P[1]) / complex(*k) + complex(*P)
            place, at = self.nearest((z.real, z.imag))
            inside = any(check.where((z.real, z.imag), p) >= 0 for p in self.log.task.region)
            pairs.append((0.0 if inside else abs(complex(*k)) * math.dist(at, (z.real, z.imag)),
                          [z.real, z.imag] if inside else place, [*key, 0.0]))
        distance, one, other = min(pairs, key=lambda p: p[0])
        line = {"leaf": "sheets", "places": [one, other]}
        return line if distance < gap and self.refutes(node, line) else None

    # Contact

    def passed(self, node):
        """Cosines of |psi| at the farthest and the nearest place, at the middle design."""
        a, b, x, y = self.middle(node)
        g2 = self.log.shape.abs_g.middle() ** 2
        far, near = self.farthest((x, y), 1)[0][1], self.nearest((x, y))[1]
        cosines = [(g2 * math.dist(c, (x, y)) ** 2 - a * a - b * b) / (2 * a * b) for c in (far, near)]
        return [min(0.999999, max(-0.999999, c)) for c in cosines]

    def by_contact(self, node):
        a, b = self.middle(node)[:2]
        far, near = (math.acos(c) for c in self.passed(node))
        low, high = max(far, math.acos(min(1, node.window[0].middle()))), min(near, math.acos(max(-1, node.window[1].middle())))
        if low >= high:
            return None
        assignment, found = node.assignments[0], []
        for part_way in (0.002, 0.006, 0.02, 0.06, 0.15, 0.3, 0.5, 0.7, 0.85, 0.94, 0.98, 0.994, 0.998):
            psi = low + (high - low) * part_way
            margin = 0.5 * min(a, b) * min(psi - low, high - psi)  # about a length
            joints = self.in_frame(a, b, psi)
            for one, other, need in self.pairs(assignment):
                touch = self.deepest(one, other, joints, need)
                if touch:
                    found.append((-min(touch[0], margin), psi, touch[1], touch[2]))
        for _, psi, one, other in sorted(found, key=lambda f: f[0])[:4]:
            if not all(check.share(one[0], other[0], l, ()) for l in node.assignments):
                line = {"share": [one[0], other[0]]}
                return line, self.log.share(node, line)
            line = {"contact": [one, other], "u": math.tan(psi / 2)}
            try:
                children = self.log.contact(node, line)
            except check.Open:
                continue
            if sum(1 for child in children if self.by_sum(child)) >= 1:
                return line, children
        return None

    def in_frame(self, a, b, psi):
        e = complex(math.cos(psi), self.log.sign * math.sin(psi))
        out = {}
        for j in "VABCXY":
            alpha, beta = (complex(*c.middle()) for c in self.log.shape.seen[j])
            out[j] = alpha * a + beta * b * e
        return out

    def pairs(self, assignment):
        task = self.log.task
        return [(one, other, check.half(task, one) + check.half(task, other) + task.clearance_mm) for i, one in enumerate(check.JOINTS)
                for other in list(check.JOINTS)[:i] if check.may_meet(one, other) and check.share(one, other, assignment, ())]

    def deepest(self, one, other, joints, need):
        """The nearest two points of two parts as material points; None if they keep apart."""
        best = None
        for A in self.spans(one):
            for B in self.spans(other):
                distance, t, u = nearest_on_segments(joints[A[0]], joints[A[1]], joints[B[0]], joints[B[1]])
                if distance < need and (best is None or distance < best[0]):
                    best = (distance, material(one, A, t), material(other, B, u))
        return (need - best[0], best[1], best[2]) if best else None

    def spans(self, part):
        out = []
        for piece in check.pieces(self.log.task, part):
            ends = [(piece[i], piece[j]) for i in range(len(piece)) for j in range(i)] if len(piece) > 1 else [(piece[0], piece[0])]
            out += ends
        return out

    # Obstacles

    def by_obstacle(self, node):
        task = self.log.task
        if not task.obstacles:
            return None
        a, b, x, y = self.middle(node)
        steps = 1 if len(self.edges) > 40 else 12
        places = [([*key, i / steps], (p[0] + (q[0] - p[0]) * i / steps, p[1] + (q[1] - p[1]) * i / steps))
                  for key, p, q in self.edges[:: 1 + len(self.edges) // 40] for i in range(steps)]
        found = []
        for place, T in places:
            joints = self.placed(a, b, (x, y), T)
            for i, obstacle in enumerate(task.obstacles) if joints else ():
                for part in check.JOINTS:
                    if any(check.share(part, i, l, task.obstacles) for l in node.assignments):
                        found += self.hits(part, joints, obstacle.rings[0], i, place)
        for depth, line in sorted(found, key=lambda f: -f[0])[:6]:
            part = line["point"][0]
            if not all(check.share(part, line["obstacle"], l, task.obstacles) for l in node.assignments):
                if self.smallness(node) < 0.02:
                    inner = {"share": [part, line["obstacle"]]}
                    return inner, self.log.share(node, inner)
                continue
            if self.refutes(node, line):
                return line, []
        return None

    def placed(self, a, b, P, T):
        """The joints with the tracer at T, by angles; None out of reach."""
        shape, P, T = self.log.shape, complex(*P), complex(*T)
        s, g = (complex(*z.middle()) for z in (shape.s, shape.g))
        w = g * (T - P)
        cosine = (abs(w) ** 2 - a * a - b * b) / (2 * a * b)
        if abs(cosine) > 1:
            return None
        p = w / (1 + b / a * complex(cosine, self.log.sign * math.sqrt(1 - cosine * cosine)))
        q, V = s * (w - p), P if shape.vertex == "pole" else P - w
        return {"V": V, "A": V + p, "B": V + q, "C": V + p + q, "X": V + w, "Y": V + s * w}

    def hits(self, part, joints, ring, i, place):
        task, out = self.log.task, []
        need = check.half(task, part) + task.clearance_mm
        convex = check.convex(ring)
        for A in self.spans(part):
            along = {i / 4 for i in range(5)} if A[0] != A[1] else {0.0}
            corners = [complex(*c) for c in ring]
            along.add(min(nearest_on_segments(joints[A[0]], joints[A[1]], u, v) for u, v in zip(corners, corners[1:]))[1])
            for t in along:
                z = joints[A[0]] + t * (joints[A[1]] - joints[A[0]])
                point = (z.real, z.imag)
                inside = check.where(point, [ring]) >= 0
                edge = min(range(len(ring) - 1), key=lambda e: math.hypot(*check.to_segment(point, ring[e], ring[e + 1])))
                away = math.hypot(*check.to_segment(point, ring[edge], ring[edge + 1]))
                depth = need + away if inside and convex else need - away
                if depth > 0:
                    out.append((depth, {"leaf": "obstacle", "obstacle": i, "edge": None if convex else edge, "place": place,
                                        "point": material(part, A, t)}))
        return out

    # Splits

    def by_split(self, node):
        widths = {v: node.box[v].hi - node.box[v].lo for v in "abxy"}
        scale = {"a": 1.0, "b": 1.0, "x": self.log.shape.abs_g.middle(), "y": self.log.shape.abs_g.middle()}
        name = max(widths, key=lambda v: widths[v] * scale[v])
        line = {"split": name, "at": node.box[name].middle()}
        return line, self.log.split(node, line)


def material(part, span, t):
    """The point at t along a span between two joints of a part, as the log names it."""
    if part not in check.LINKS:
        return [part]
    at = {j: 0.0 for j in part}
    at[span[0]] += 1 - t
    at[span[1]] += t
    return [part, at[part[1]]] if len(part) == 2 else [part, at[part[1]], at[part[2]]]


def nearest_on_segments(a, b, c, d):
    """Distance of two segments and where on each the nearest points are."""
    def on(p, u, v):
        length = abs(v - u) ** 2
        return min(1.0, max(0.0, ((p - u) * (v - u).conjugate()).real / length)) if length else 0.0
    options = [(abs(a - (c + on(a, c, d) * (d - c))), 0.0, on(a, c, d)), (abs(b - (c + on(b, c, d) * (d - c))), 1.0, on(b, c, d)),
               (abs(c - (a + on(c, a, b) * (b - a))), on(c, a, b), 0.0), (abs(d - (a + on(d, a, b) * (b - a))), on(d, a, b), 1.0)]
    cross = ((b - a).conjugate() * (d - c)).imag
    if cross:
        t, u = ((c - a).conjugate() * (d - c)).imag / cross, ((c - a).conjugate() * (b - a)).imag / cross
        if 0 <= t <= 1 and 0 <= u <= 1:
            options.append((0.0, t, u))
    return min(options)


def write(lines, path):
    pathlib.Path(path).write_text("".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines), encoding="utf-8")


if __name__ == "__main__":
    design = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    write(Builder(header_of(design, float(sys.argv[3]) if len(sys.argv) > 3 else None)).build(), sys.argv[2])
