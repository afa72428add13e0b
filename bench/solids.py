#!/usr/bin/env python3
"""Loads against solid elements: two instruments as plates and pins of quadratic bricks (C3D20R), solved by CalculiX (Debian package
calculix-ccx, program ccx).

Every link is a plate in its own layer, cut round at its ends, with holes at its joints; every pin is a cylinder of steel that fills the holes
of its links. It is fast in one of them; in the other the surfaces keep their distance from the axis and their height and turn freely: a
true hinge, whose links lie above each other. (CalculiX's beam elements clamp where they meet, so none are used.) The table clamps the
pole's post.

For each instrument at one opening:
  in the plane       each plate's middle plane keeps its height, as for slender links that lie in one plane
  free               the plates may leave it: what the layers' offsets add
  sag                by the weight of the links
beside what kempe states (links alone, and with the pins of its budget) and the same beams with shear (Timoshenko's, coefficient 6/5).

usage: solids.py KEMPE [FOLDER]      FOLDER: where CalculiX's files stay (a temporary one if left out)
"""
import cmath
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

AROUND = 24  # nodes round a hole
RINGS = 2  # elements between hole and edge
GRAVITY = 9.80665
STEEL = (200e3, 200e3 / (2 * 77e3) - 1)  # E (MPa) and Poisson's ratio of pins
JOINTS = "VABCXY"
# name, scale, rotation_deg, vertex, VA, VB, opening_deg (a multiple of 15: holes and pins share their nodes), width, thickness, pin, material, pen_N
TASKS = [
    ("engraver's pantograph, steel", 0.4, 0, "pen", 91.784, 76.542, 90, 15, 5, 8, "steel", 10),
    ("half size and turned, PLA", 0.5, 180, "pole", 150, 110, 60, 20, 8, 8, "PLA", 10),
]


def spec_of(task, assembly, reach):
    _, scale, rotation, vertex, VA, VB, _, width, thickness, pin, material, force = task
    return f"""
[copy]
scale = {scale}
rotation_deg = {rotation}
[region]
rectangle_mm = {{ at = [{reach}, -0.0005], size = [0.001, 0.001] }}
[pole]
at_mm = [0, 0]
[links]
width_mm = {width}
thickness_mm = {thickness}
pin_diameter_mm = {pin}
[mechanism]
vertex = "{vertex}"
VA_mm = {VA}
VB_mm = {VB}
assembly = {assembly}
[material]
name = "{material}"
[load]
pen_N = {force}
"""


class Beams:
    """Joints, and the load error by slender beams (docs/loads.md), with or without shear."""

    def __init__(self, task):
        _, scale, rotation, vertex, VA, VB, opening, self.width, self.thickness, *_ = task
        k = scale * (-1 if rotation == 180 else 1)
        self.shape = {"pole": k, "tracer": 1 - k, "pen": 1 - 1 / k}[vertex]
        self.vertex = vertex
        self.pole, self.tracer, self.pen = {"pole": "VXY", "tracer": "XVY", "pen": "XYV"}[vertex]
        p, q = complex(VA), cmath.rect(VB, math.radians(opening))
        self.p, self.q = p, q
        self.at = dict(zip(JOINTS, (0j, p, q, p + q, p + q / self.shape, q + p * self.shape)))

    def rows(self):
        """Each link's joints in their order along it."""
        rows = {"VA": "VA", "VB": "VB"}
        for link in ("ACX", "BCY"):
            way = max((self.at[b] - self.at[a] for a in link for b in link), key=abs)
            rows[link] = "".join(sorted(link, key=lambda joint: (self.at[joint] * way.conjugate()).real))
        return rows

    def forces(self, F):
        """On the plates, by link and joint, and in the bars, for the force F at the pen."""
        s, p, q = self.shape, self.p, self.q
        F_Y = F / (s - 1) if self.vertex == "pen" else F
        F_X = -s * F_Y
        pull = -((q * (1 / s - 1)).conjugate() * F_X).imag / (p.conjugate() * q).imag * abs(p)
        f_C = -pull * p / abs(p) - F_X
        return {("ACX", "A"): pull * p / abs(p), ("ACX", "C"): f_C, ("ACX", "X"): F_X, ("BCY", "Y"): F_Y, ("BCY", "C"): -f_C,
                ("BCY", "B"): f_C - F_Y}, {"VA": pull, "VB": abs(f_C - F_Y)}

    def compliance(self, E, G):
        """The pen's, mm/N: [[xx, xy], [xy, yy]]; G None: without shear."""
        area, inertia = self.width * self.thickness, self.thickness * self.width**3 / 12
        (fx, bars_x), (fy, bars_y) = self.forces(1), self.forces(1j)
        total = [[0, 0], [0, 0]]

        def add(c, x, y):
            for i, a in enumerate((x, y)):
                for j, b in enumerate((x, y)):
                    total[i][j] += c * a * b

        for link, row in self.rows().items():
            if len(row) == 2:
                length = abs(self.at[row[1]] - self.at[row[0]])
                way = (self.at[row[1]] - self.at[row[0]]) / length
                pulls = [(fx, 1), (fy, 1)]
                if link == "VA":
                    add(length / (E * area), bars_x["VA"], bars_y["VA"])
                else:
                    on_B = [(-forces[("BCY", "B")] * way.conjugate()).real for forces in (fx, fy)]
                    add(length / (E * area), *on_B)
                continue
            for end in (row[0], row[2]):
                arm = self.at[end] - self.at[row[1]]
                length = abs(arm)
                x, y = (forces[(link, end)] * arm.conjugate() / length for forces in (fx, fy))
                add(length**3 / (3 * E * inertia) + (1.2 * length / (G * area) if G else 0), x.imag, y.imag)
                add(length / (E * area), x.real, y.real)
        return total


def worst_and_least(c):
    middle, apart = (c[0][0] + c[1][1]) / 2, math.hypot((c[0][0] - c[1][1]) / 2, (c[0][1] + c[1][0]) / 2)
    return middle + apart, middle - apart


class Mesh:
    def __init__(self):
        self.number, self.places, self.elements = {}, [], {}

    def node(self, part, place, z):
        key = (part, round(place.real, 6), round(place.imag, 6), round(z, 6))
        if key not in self.number:
            self.places.append((place, z))
            self.number[key] = len(self.places)
        return self.number[key]

    def brick(self, part, material, bottom, top):
        """Four corners (place, z) counter-clockwise below and above; a quadratic brick."""
        corners = bottom + top
        edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
        middles = [((corners[a][0] + corners[b][0]) / 2, (corners[a][1] + corners[b][1]) / 2) for a, b in edges]
        self.elements.setdefault(material, []).append([self.node(part, *corner) for corner in corners + middles])

    def column(self, part, material, quad, levels):
        area = sum((a.conjugate() * b).imag for a, b in zip(quad, quad[1:] + quad[:1]))
        quad = quad if area > 0 else quad[::-1]
        for low, high in zip(levels, levels[1:]):
            self.brick(part, material, [(c, low) for c in quad], [(c, high) for c in quad])


STEPS = [math.tan(math.radians(360 / AROUND * i)) for i in range(-AROUND // 8, AROUND // 8 + 1)]


def on_square(angle, half):
    return half * cmath.rect(1, angle) / max(abs(math.cos(angle)), abs(math.sin(angle)))


def add_link(mesh, link, joints, width, hole, levels):
    """A straight plate through joints (complex places in order) of this width."""
    way = (joints[-1] - joints[0]) / abs(joints[-1] - joints[0])
    half = width / 2
    for number, joint in enumerate(joints):
        open_ends = [number == len(joints) - 1, number == 0]  # to the right, to the left

        def outer(i):
            angle = 2 * math.pi * i / AROUND
            side = math.cos(angle)
            round_ = (side > 1e-9 and open_ends[0]) or (side < -1e-9 and open_ends[1])
            return cmath.rect(half, angle) if round_ else on_square(angle, half)

        def place(i, ring):
            inner = cmath.rect(hole / 2, 2 * math.pi * i / AROUND)
            return joint + way * (inner + (outer(i) - inner) * ring / RINGS)

        for i in range(AROUND):
            for ring in range(RINGS):
                quad = [place(i, ring), place(i, ring + 1), place(i + 1, ring + 1), place(i + 1, ring)]
                mesh.column(link, "link", quad, levels)
    for first, second in zip(joints, joints[1:]):
        start, end = half, abs(second - first) - half
        count = max(1, round((end - start) / width))
        for i in range(count):
            left, right = (start + (end - start) * j / count for j in (i, i + 1))
            for low, high in zip(STEPS, STEPS[1:]):
                corners = [(left, low), (right, low), (right, high), (left, high)]
                mesh.column(link, "link", [first + way * complex(x, half * y) for x, y in corners], levels)


def add_pin(mesh, name, centre, diameter, levels):
    core = diameter / 4
    for a, b in zip(STEPS, STEPS[1:]):
        for c, d in zip(STEPS, STEPS[1:]):
            quad = [centre + core * complex(x, y) for x, y in ((a, c), (b, c), (b, d), (a, d))]
            mesh.column(name, "pin", quad, levels)
    for i in range(AROUND):
        angles = [2 * math.pi * j / AROUND for j in (i, i + 1)]
        inner = [centre + on_square(angle, core) for angle in angles]
        edge = [centre + cmath.rect(diameter / 2, angle) for angle in angles]
        mesh.column(name, "pin", [inner[0], edge[0], edge[1], inner[1]], levels)


class Solids:
    def __init__(self, beams, layers, pin):
        self.beams, self.layers, self.pin, self.mesh = beams, layers, pin, Mesh()
        self.equations, self.on_hole = [], set()
        t = beams.thickness
        for link, row in beams.rows().items():
            low = t * (layers[link] - 1)
            add_link(self.mesh, link, [beams.at[joint] for joint in row], beams.width, pin, [low, low + t / 2, low + t])
        post = beams.pole
        hinges = {"A": ("VA", ["ACX"]), "B": ("VB", ["BCY"]), "C": ("ACX", ["BCY"])}
        if post == "V":
            hinges |= {"V": (None, ["VA", "VB"]), "X": ("ACX", []), "Y": ("BCY", [])}
        else:
            hinges |= {"X": (None, ["ACX"]), "V": ("VA", ["VB"]), "Y": ("BCY", [])}
        for joint, (fast, turning) in hinges.items():
            links = ([fast] if fast else []) + turning
            lowest = 0 if joint == post else min(layers[link] for link in links) - 1
            highest = max(layers[link] for link in links)
            add_pin(self.mesh, "pin " + joint, beams.at[joint], pin, [t / 2 * i for i in range(2 * lowest, 2 * highest + 1)])
            for link in links:
                self.join(link, joint, link == fast)

    def join(self, link, joint, fast):
        centre = self.beams.at[joint]
        for (part, x, y, z), number in list(self.mesh.number.items()):
            if part != link or abs(complex(x, y) - centre) > self.pin / 2 * (1 + 1e-5):
                continue
            on_pin = self.mesh.number[("pin " + joint, x, y, z)]
            self.on_hole.add(number)
            axes = [{1: 1}, {2: 1}, {3: 1}]
            if not fast:
                normal = (complex(x, y) - centre) / abs(complex(x, y) - centre)
                parts = sorted({1: normal.real, 2: normal.imag}.items(), key=lambda each: -abs(each[1]))
                axes = [dict(each for each in parts if abs(each[1]) > 1e-9), {3: 1}]
            for axis in axes:
                terms = [(number, dof, value) for dof, value in axis.items()] + [(on_pin, dof, -value) for dof, value in axis.items()]
                self.equations.append(terms)

    def carrier(self, joint):
        return {"V": "VA", "X": "ACX", "Y": "BCY"}[joint]

    def middle_of(self, joint):
        """Nodes of the pin's core in the middle of the link that carries the point there."""
        z, centre = self.beams.thickness * (self.layers[self.carrier(joint)] - 0.5), self.beams.at[joint]
        return [number for (part, x, y, height), number in self.mesh.number.items()
                if part == "pin " + joint and abs(height - z) < 1e-6 and abs(complex(x, y) - centre) < 0.36 * self.pin]

    def solve(self, folder, name, E, nu, density, in_plane, steps):
        """Mean movement of pen and tracer for each step: a force on the pen, or None for weight."""
        mesh = self.mesh
        pen, tracer = self.middle_of(self.beams.pen), self.middle_of(self.beams.tracer)
        lines = ["*NODE, NSET=NALL"]
        lines += [f"{i + 1}, {place.real:.9g}, {place.imag:.9g}, {z:.9g}" for i, (place, z) in enumerate(mesh.places)]
        element = 0
        for material, elements in mesh.elements.items():
            lines.append(f"*ELEMENT, TYPE=C3D20R, ELSET=E{material}")
            for nodes in elements:
                element += 1
                lines += [f"{element}, " + ", ".join(map(str, nodes[:10])) + ",", ", ".join(map(str, nodes[10:]))]
        for material, (modulus, poisson, mass) in {"link": (E, nu, density), "pin": (*STEEL, 1e-20)}.items():
            lines += [f"*MATERIAL, NAME={material}", "*ELASTIC", f"{modulus:.9g}, {poisson:.9g}", "*DENSITY", f"{mass:.9g}",
                      f"*SOLID SECTION, ELSET=E{material}, MATERIAL={material}"]
        equations = self.equations + [[(number, dof, 1) for number in tracer] for dof in (1, 2)]
        for terms in equations:
            lines += ["*EQUATION", str(len(terms))]
            for i in range(0, len(terms), 4):
                lines.append(", ".join(f"{number}, {dof}, {value:.12g}" for number, dof, value in terms[i:i + 4]))
        lines.append("*BOUNDARY")
        lines += [f"{number}, 1, 3" for (part, _, _, z), number in mesh.number.items() if part == "pin " + self.beams.pole and abs(z) < 1e-6]
        if in_plane:
            lines += [f"{number}, 3, 3" for (part, _, _, z), number in mesh.number.items()
                      if part in self.layers and number not in self.on_hole and abs(z - self.beams.thickness * (self.layers[part] - 0.5)) < 1e-6]
        for set_name, nodes in (("PEN", pen), ("TRACER", tracer)):
            lines += [f"*NSET, NSET={set_name}"] + [f"{number}," for number in nodes]
        for force in steps:
            lines += ["*STEP", "*STATIC"]
            if force is None:
                lines += ["*DLOAD", f"Elink, GRAV, {1000 * GRAVITY}, 0, 0, -1"]
            else:
                lines.append("*CLOAD, OP=NEW")
                lines += [f"{number}, {dof}, {part / len(pen):.12g}" for number in pen for dof, part in ((1, force.real), (2, force.imag)) if part]
            lines += ["*NODE PRINT, NSET=PEN", "U", "*NODE PRINT, NSET=TRACER", "U", "*END STEP"]
        (folder / f"{name}.inp").write_text("\n".join(lines) + "\n")
        run = subprocess.run(["ccx", "-i", name], cwd=folder, capture_output=True, text=True)
        answer = folder / f"{name}.dat"
        if run.returncode != 0 or not answer.exists():
            sys.exit(f"solids.py: ccx failed on {folder / name}.inp:\n{run.stdout[-2000:]}")
        blocks = re.split(r"displacements.*", answer.read_text())[1:]
        means = []
        for block in blocks:
            rows = [[float(value) for value in line.split()] for line in block.splitlines() if line.strip()]
            means.append([sum(row[i] for row in rows) / len(rows) for i in (1, 2, 3)])
        return list(zip(means[::2], means[1::2]))


def stated(kempe, task, reach, opening, folder):
    """What kempe states of this mechanism at this opening: design.json and its budget's parts for pins and for layers."""
    for assembly in (0, 1):
        spec = folder / "spec.toml"
        spec.write_text(spec_of(task, assembly, reach))
        out = folder / f"out{assembly}"
        run = subprocess.run([kempe, "workspace", spec, "-o", out], capture_output=True, text=True)
        if not (out / "design.json").exists():
            sys.exit(f"solids.py: {task[0]}: {run.stdout}{run.stderr}")
        design = json.loads((out / "design.json").read_text())
        if assembly == (1 if opening > 0 else 0):
            parts = [re.search(rf"budget .* {part} ([0-9.e+-]+)", run.stdout) for part in ("pins", "layers")]
            return design, *(float(part[1]) for part in parts)
    raise AssertionError


def compare(kempe, task, folder):
    beams = Beams(task)
    opening, pin, force = task[6], task[9], task[11]
    reach = abs(beams.at[beams.tracer] - beams.at[beams.pole])
    design, pins, layered = stated(kempe, task, reach, opening, folder)
    layers = {link["name"]: link["layer"] for link in design["mechanism"]["links"]}
    E = 1000 * design["material"]["E_GPa"]
    G = 1000 * design["material"].get("G_GPa", E / 2600)
    density = 1e-12 * design["material"]["density_kg_m3"]
    solids = Solids(beams, layers, pin)
    print(f"{task[0]}: {len(solids.mesh.places)} nodes, {sum(map(len, solids.mesh.elements.values()))} elements; opening {opening} degrees")

    def solved(name, in_plane, steps):
        return solids.solve(folder, name, E, E / (2 * G) - 1, density, in_plane, steps)

    def load_error(moved):
        (x, _), (y, _) = moved
        return [force * value for value in worst_and_least([[x[0], y[0]], [x[1], y[1]]])]

    plane = load_error(solved("plane", True, [1, 1j]))
    free = load_error(solved("free", False, [1, 1j]))
    (pen, tracer), = solved("sag", False, [None])
    quality = design["quality"]
    states = (quality["load_error_max_mm"], quality["load_error_min_mm"])
    slender, sheared = ([force * value for value in worst_and_least(beams.compliance(E, shear))] for shear in (None, G))

    def row(what, value, against):
        print(f"  {what:58} {value:10.5f} mm  {100 * (value / against - 1):+7.2f} %")

    for name, i in (("worst", 0), ("least", 1)):
        print(f" load error, {name} direction")
        row("kempe states, links alone", states[i], states[i])
        row("the same beams, computed here", slender[i], states[i])
        row("with shear", sheared[i], states[i])
        if i == 0:
            row("with shear and the pins of kempe's budget", sheared[i] + pins, states[i])
            row("with shear, and pins and layers of the budget", sheared[i] + pins + layered, states[i])
        row("CalculiX, in the plane", plane[i], states[i])
        row("CalculiX, plates free to leave their planes", free[i], states[i])
    print(" sag by the links' weight, of tracer or pen what sinks more")
    row("kempe states", quality["sag_max_mm"], quality["sag_max_mm"])
    row("CalculiX", max(-pen[2], -tracer[2]), quality["sag_max_mm"])


def main():
    kempe = str(pathlib.Path(sys.argv[1]).resolve())
    for number, task in enumerate(TASKS):
        if len(sys.argv) > 2:
            folder = pathlib.Path(sys.argv[2]).absolute() / str(number)
            folder.mkdir(parents=True, exist_ok=True)
            compare(kempe, task, folder)
        else:
            with tempfile.TemporaryDirectory() as folder:
                compare(kempe, task, pathlib.Path(folder))


if __name__ == "__main__":
    main()
