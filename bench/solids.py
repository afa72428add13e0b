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

With --shares the differences are taken apart, one thing changed after another:
  in the plane       bricks without holes and pins (at a joint the links' discs have one mean movement); with holes, and pins a thousand times as
                     stiff, all links in one layer; with pins of steel; the links in their layers
  sag                kempe's beams; their weight without the holes'; what two crossing plates of bricks give way at their pin in place of what the
                     pin's bending is; beside the bricks, also with pins that weigh as much as the holes' material or as steel

usage: solids.py [--shares] KEMPE [FOLDER]      FOLDER: where CalculiX's files stay (a temporary one if left out)
"""
import cmath
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy

AROUND = 24  # nodes round a hole
RINGS = 2  # elements between hole and edge
GRAVITY = 9.80665
STEEL = (200e3, 200e3 / (2 * 77e3) - 1)  # E (MPa) and Poisson's ratio of pins
PINS, NEAR_RIGID = (*STEEL, 1e-20), (1000 * STEEL[0], STEEL[1], 1e-20)  # and without weight
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


def add_pin(mesh, name, centre, diameter, levels, material="pin"):
    core = diameter / 4
    for a, b in zip(STEPS, STEPS[1:]):
        for c, d in zip(STEPS, STEPS[1:]):
            quad = [centre + core * complex(x, y) for x, y in ((a, c), (b, c), (b, d), (a, d))]
            mesh.column(name, material, quad, levels)
    for i in range(AROUND):
        angles = [2 * math.pi * j / AROUND for j in (i, i + 1)]
        inner = [centre + on_square(angle, core) for angle in angles]
        edge = [centre + cmath.rect(diameter / 2, angle) for angle in angles]
        mesh.column(name, material, [inner[0], edge[0], edge[1], inner[1]], levels)


def push(forces):
    """CalculiX's lines of forces: node, direction, N."""
    return ["*CLOAD, OP=NEW"] + [f"{number}, {dof}, {force:.12g}" for number, dof, force in forces if force]


class Solids:
    def __init__(self, beams, layers, pin, filled=False):
        """`filled`: no holes and no pins."""
        self.beams, self.layers, self.pin, self.filled, self.at, self.mesh = beams, layers, pin, filled, beams.at, Mesh()
        self.equations, self.on_hole, self.held = [], set(), []
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
            if filled:
                self.fill(joint, links)
                continue
            lowest = 0 if joint == post else min(layers[link] for link in links) - 1
            highest = max(layers[link] for link in links)
            add_pin(self.mesh, "pin " + joint, beams.at[joint], pin, [t / 2 * i for i in range(2 * lowest, 2 * highest + 1)])
            for link in links:
                self.join(link, joint, link == fast)
        if not filled:
            self.clamp("pin " + post)

    def clamp(self, pin):
        self.held += [(number, dof) for (part, _, _, z), number in self.mesh.number.items() if part == pin and abs(z) < 1e-6 for dof in (1, 2, 3)]

    def fill(self, joint, links):
        """Discs of the links' material in their holes, whose mean movements are one, at the pole none."""
        t, discs = self.beams.thickness, []
        for link in links:
            low = t * (self.layers[link] - 1)
            add_pin(self.mesh, f"pin {joint} {link}", self.at[joint], self.pin, [low, low + t / 2, low + t], "link")
            self.join(link, f"{joint} {link}", True)
            discs.append(self.middle_of(joint, link))
            self.held += [(number, 3) for number in discs[-1]]
        first = [] if joint == self.beams.pole else discs.pop(0)
        self.equations += [[(number, dof, 1) for number in disc] + [(number, dof, -1) for number in first] for disc in discs for dof in (1, 2)]

    def join(self, link, joint, fast):
        centre = self.at[joint[0]]
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

    def middle_of(self, joint, link):
        """Nodes in the middle of a link there: of its disc, or of the pin's core."""
        z, centre = self.beams.thickness * (self.layers[link] - 0.5), self.at[joint]
        pin, reach = (f"pin {joint} {link}", 1) if self.filled else ("pin " + joint, 0.36)
        return [number for (part, x, y, height), number in self.mesh.number.items()
                if part == pin and abs(height - z) < 1e-6 and abs(complex(x, y) - centre) < reach * self.pin]

    def solve(self, folder, name, links, pins, in_plane, steps):
        """Mean movement of pen and tracer for each step: a force on the pen, or None for weight."""
        pen, tracer = (self.middle_of(joint, self.carrier(joint)) for joint in (self.beams.pen, self.beams.tracer))
        held = [(number, 3) for (part, _, _, z), number in self.mesh.number.items() if in_plane and part in self.layers
                and number not in self.on_hole and abs(z - self.beams.thickness * (self.layers[part] - 0.5)) < 1e-6]
        weigh = ["*DLOAD"] + [f"E{material}, GRAV, {1000 * GRAVITY}, 0, 0, -1" for material in self.mesh.elements]
        loads = [weigh if force is None else
                 push((number, dof, part / len(pen)) for number in pen for dof, part in ((1, force.real), (2, force.imag))) for force in steps]
        blocks = self.calculix(folder, name, links, pins, [[(number, dof, 1) for number in tracer] for dof in (1, 2)], held,
                               {"PEN": pen, "TRACER": tracer}, loads)
        means = [[sum(row[i] for row in rows) / len(rows) for i in (1, 2, 3)] for rows in blocks]
        return list(zip(means[::2], means[1::2]))

    def calculix(self, folder, name, links, pins, equations, held, shown, loads):
        """Rows of node and movement, for each load (its lines) in turn those of each set of nodes in `shown`."""
        mesh = self.mesh
        lines = ["*NODE, NSET=NALL"]
        lines += [f"{i + 1}, {place.real:.9g}, {place.imag:.9g}, {z:.9g}" for i, (place, z) in enumerate(mesh.places)]
        element = 0
        for material, elements in mesh.elements.items():
            lines.append(f"*ELEMENT, TYPE=C3D20R, ELSET=E{material}")
            for nodes in elements:
                element += 1
                lines += [f"{element}, " + ", ".join(map(str, nodes[:10])) + ",", ", ".join(map(str, nodes[10:]))]
        for material in mesh.elements:
            modulus, poisson, mass = {"link": links, "pin": pins}[material]
            lines += [f"*MATERIAL, NAME={material}", "*ELASTIC", f"{modulus:.9g}, {poisson:.9g}", "*DENSITY", f"{mass:.9g}",
                      f"*SOLID SECTION, ELSET=E{material}, MATERIAL={material}"]
        for terms in self.equations + equations:
            lines += ["*EQUATION", str(len(terms))]
            for i in range(0, len(terms), 4):
                lines.append(", ".join(f"{number}, {dof}, {value:.12g}" for number, dof, value in terms[i:i + 4]))
        lines += ["*BOUNDARY"] + [f"{number}, {dof}, {dof}" for number, dof in self.held + held]
        for set_name, nodes in shown.items():
            lines += [f"*NSET, NSET={set_name}"] + [f"{number}," for number in nodes]
        for load in loads:
            lines += ["*STEP", "*STATIC"] + load
            lines += [line for set_name in shown for line in (f"*NODE PRINT, NSET={set_name}", "U")] + ["*END STEP"]
        (folder / f"{name}.inp").write_text("\n".join(lines) + "\n")
        run = subprocess.run(["ccx", "-i", name], cwd=folder, capture_output=True, text=True)
        answer = folder / f"{name}.dat"
        if run.returncode != 0 or not answer.exists():
            sys.exit(f"solids.py: ccx failed on {folder / name}.inp:\n{run.stdout[-2000:]}")
        blocks = re.split(r"displacements.*", answer.read_text())[1:]
        return [[[float(value) for value in line.split()] for line in block.splitlines() if line.strip()] for block in blocks]


class Crossing(Solids):
    """Two plates that cross at a pin: the lower one ends there and is fast on it, the upper one goes on both ways. Or the lower one `alone`,
    turning on a pin that is clamped under it, as a post."""

    def __init__(self, width, t, pin, alone):
        self.pin, self.mesh, self.at, self.equations, self.on_hole = pin, Mesh(), {"C": 0j}, [], set()
        self.sections = [4.5 * width, 3.5 * width, 2.5 * width]  # from the pin: a couple is on the first
        add_link(self.mesh, "low", [complex(-5 * width), 0j], width, pin, [0, t / 2, t])
        add_pin(self.mesh, "pin C", 0j, pin, [t / 2 * i for i in range(3 if alone else 5)])
        self.join("low", "C", not alone)
        self.held, self.middles, end = [], {"low": t / 2, "high": 1.5 * t}, self.sections[0]
        low, high, back = ("low", -1 + 0j), ("high", 1j), ("high", -1j)
        if alone:
            self.clamp("pin C")
            held = {("low", -end, 0, t / 2): (2,)}
            self.cases = [(way, [(1, low)]) for way in (1 + 0j, 1j)]
        else:
            add_link(self.mesh, "high", [-5j * width, 0j, 5j * width], width, pin, [t, 1.5 * t, 2 * t])
            self.join("high", "C", False)
            held = {("low", -end, 0, t / 2): (1, 2, 3), ("low", -end, width / 2, t / 2): (1, 3), ("low", -end, 0, 0): (1,),
                    ("high", 0, end, 1.5 * t): (1,)}
            self.cases = [(way, [(1, high), (-1, before)]) for way, before in ((1 + 0j, low), (1j, low), (1j, back), (1 + 0j, back))]
        self.held += [(self.mesh.number[key], dof) for key, dofs in held.items() for dof in dofs]

    def tilt(self, link, along, section, way):
        """How the nodes of a section move where it tilts and rises along a way, over the sum of the squares of this."""
        moves = numpy.zeros((len(self.mesh.places), 3))
        for (part, x, y, z), number in self.mesh.number.items():
            place = complex(x, y) - along * self.sections[section]
            if part == link and abs((place * along.conjugate()).real) < 1e-4:
                low = z - self.middles[link]
                moves[number - 1] = -low * way.real, -low * way.imag, (way.conjugate() * place).real
        return moves / (moves**2).sum()

    def gives(self, folder, links, pins):
        """Tilt for 1 N mm at the pin's axis, beyond what the plates' bending and twist is: of the upper plate on the lower one (of the one
        alone), rising along x and along y; and of the upper one's two sides, rising along it and across."""
        tilts = [[sum(sign * self.tilt(*arm, i, way) for sign, arm in arms) for i in range(3)] for way, arms in self.cases]
        loads = [push((int(node) + 1, int(axis) + 1, tilt[0][node, axis]) for node, axis in zip(*numpy.nonzero(tilt[0]))) for tilt in tilts]
        answers = self.calculix(folder, "crossing", links, pins, [], [], {"ALL": range(1, len(self.mesh.places) + 1)}, loads)
        (_, far, near), gives = self.sections, []
        for tilt, rows in zip(tilts, answers):
            at_far, at_near = ((tilt[i] * numpy.array(rows)[:, 1:]).sum() for i in (1, 2))
            gives.append(at_near - (at_far - at_near) * near / (far - near))
        return gives


def flat_bar(width, t, E, nu):
    """EI and GJ out of the plane, as kempe has them."""
    return E * width * t**3 / 12, E / (2 + 2 * nu) * width * t**3 * (1 / 3 - 0.21 * t / width * (1 - (t / width)**4 / 12))


def sag_of(beams, pins, links, hole, rigid, gives):
    """By kempe's grillage (docs/loads-out-of-plane.md). `hole`: of this diameter, without weight; `rigid`: mm of an arm, of bending and of twist,
    at its link's ends and at the joint between; `gives`: tilt for 1 N mm at each of `pins`, joints and their links, one alone on the table."""
    EI, GJ = flat_bar(beams.width, beams.thickness, *links[:2])
    area = 1000 * GRAVITY * links[2] * beams.thickness  # N/mm^2
    keys = list(JOINTS) + [(link, joint, axis) for link, row in beams.rows().items() for joint in row for axis in (0, 1)]
    unit = dict(zip(keys, numpy.eye(len(keys))))
    stiffness, forces = numpy.zeros((len(keys), len(keys))), numpy.zeros(len(keys))
    for link, row in beams.rows().items():
        for joint in row:
            forces -= area * math.pi / 8 * ((joint in row[0] + row[-1]) * beams.width**2 - 2 * hole**2) * unit[joint]
        for pair in zip(row, row[1:]):
            way = beams.at[pair[1]] - beams.at[pair[0]]
            length, way = abs(way), way / abs(way)
            ends = [rigid[joint not in row[0] + row[-1]] for joint in pair]
            slopes = [unit[link, joint, 0] * way.real + unit[link, joint, 1] * way.imag for joint in pair]
            twists = [unit[link, joint, 1] * way.real - unit[link, joint, 0] * way.imag for joint in pair]
            rises = [unit[joint] + sign * end[0] * slope for joint, sign, end, slope in zip(pair, (1, -1), ends, slopes)]
            free, untwisted = (length - ends[0][i] - ends[1][i] for i in (0, 1))
            bent = rises[1] - rises[0] - free / 2 * (slopes[0] + slopes[1])
            for each, change in ((EI / free, slopes[1] - slopes[0]), (12 * EI / free**3, bent), (GJ / untwisted, twists[1] - twists[0])):
                stiffness += each * numpy.outer(change, change)
            forces -= area * beams.width * free**2 / 12 * (slopes[0] - slopes[1])
            for joint, end, rise in zip(pair, ends, rises):
                forces -= area * beams.width / 2 * ((free + end[0]) * rise + end[0] * unit[joint])
    for joint, on in pins.items():
        for axis in (0, 1):
            lean = sum(sign * unit[link, beams.pole if joint == "post" else joint, axis] for link, sign in zip(on, (1, -1)))
            stiffness += numpy.outer(lean, lean) / gives[joint]
    free = [i for i, key in enumerate(keys) if key != beams.pole]
    moved = dict(zip([keys[i] for i in free], numpy.linalg.solve(stiffness[numpy.ix_(free, free)], forces[free])))
    return -min(moved[beams.pen], moved[beams.tracer])


def shares(beams, layers, links, pin, force, states, sag, bricks, folder):
    """Prints what each thing adds to load error and sag. `bricks`: both of bricks as they are, in the plane."""
    E, nu, density = links

    def plane(name, of_pins, *plates):
        (x, _), (y, _) = Solids(beams, *plates).solve(folder, name, links, of_pins, True, [1, 1j])
        return [force * value for value in worst_and_least([[x[0], y[0]], [x[1], y[1]]])]

    print(" load error in the plane, one change after another: worst, least direction")
    before, one_layer = states, dict.fromkeys(layers, 1)
    for what, now in (("shear", [force * value for value in worst_and_least(beams.compliance(E, E / (2 + 2 * nu)))]),
                      ("bricks without holes and pins", plane("filled", PINS, layers, pin, True)),
                      ("holes with near-rigid pins, in one layer", plane("rigid", NEAR_RIGID, one_layer, pin)),
                      ("pins of steel", plane("layer", PINS, one_layer, pin)), ("the links in their layers", bricks[0])):
        print(f"  {what:58} " + " ".join(f"{100 * (b - a) / s:+7.2f} %" for a, b, s in zip(before, now, states)))
        before = now

    def heavy(name, of_pins):
        (pen, tracer), = Solids(beams, layers, pin).solve(folder, name, links, of_pins, False, [None])
        return -min(pen[2], tracer[2])

    post = min(("VA", "VB"), key=layers.get) if beams.pole == "V" else "ACX"
    pins = {"post": (post,), "V": ("VA", "VB"), "A": ("VA", "ACX"), "B": ("VB", "BCY"), "C": ("ACX", "BCY")}
    heights = {joint: abs(layers[on[0]] - (layers[on[1]] if on[1:] else 0.5)) * beams.thickness for joint, on in pins.items()}
    bent = {joint: height * 64 / (STEEL[0] * math.pi * pin**4) for joint, height in heights.items()}
    slender, bars = ((0, 0), (0, 0)), flat_bar(beams.width, beams.thickness, E, nu)
    crossing, alone = (Crossing(beams.width, beams.thickness, pin, each) for each in (False, True))
    held = crossing.gives(folder, links, NEAR_RIGID)

    def with_joints(of_pins):
        gives, on_post = crossing.gives(folder, links, of_pins), alone.gives(folder, links, of_pins)
        rigid = [[-give * bar / 2 for give, bar in zip(each[2:], bars)] for each in (held, gives)]
        arms = [sum(mm / bar for mm, bar in zip(each, bars)) / 2 for each in rigid]
        leans = {joint: (gives[0] + gives[1]) / 2 + arms[0] + arms[joint in "AB"] for joint in pins}
        return sag_of(beams, pins, links, pin, rigid, leans | {"post": sum(on_post) / 2 + arms[0]})

    print(" sag, each against what kempe states")
    for what, value in (("kempe's beams", sag_of(beams, pins, links, 0, slender, bent)),
                        ("pins do not bend", sag_of(beams, pins, links, 0, slender, dict.fromkeys(pins, 1e-12))),
                        ("holes weigh nothing", sag_of(beams, pins, links, pin, slender, bent)),
                        ("and joints as two crossing plates give, near-rigid pins", with_joints(NEAR_RIGID)),
                        ("bricks, near-rigid pins", heavy("stiff", NEAR_RIGID)),
                        ("and joints as two crossing plates give, pins of steel", with_joints(PINS)),
                        ("bricks", bricks[1]), ("bricks, pins as heavy as the holes' material", heavy("heavy", (*STEEL, density))),
                        ("bricks, pins with the weight of steel", heavy("weighed", (*STEEL, 7.85e-9)))):
        print(f"  {what:58} {100 * (value / sag - 1):+7.2f} %")


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


def compare(kempe, task, folder, in_shares):
    beams = Beams(task)
    opening, pin, force = task[6], task[9], task[11]
    reach = abs(beams.at[beams.tracer] - beams.at[beams.pole])
    design, pins, layered = stated(kempe, task, reach, opening, folder)
    layers = {link["name"]: link["layer"] for link in design["mechanism"]["links"]}
    E = 1000 * design["material"]["E_GPa"]
    G = 1000 * design["material"].get("G_GPa", E / 2600)
    density = 1e-12 * design["material"]["density_kg_m3"]
    links, solids = (E, E / (2 * G) - 1, density), Solids(beams, layers, pin)
    print(f"{task[0]}: {len(solids.mesh.places)} nodes, {sum(map(len, solids.mesh.elements.values()))} elements; opening {opening} degrees")

    def solved(name, in_plane, steps):
        return solids.solve(folder, name, links, PINS, in_plane, steps)

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
    if in_shares:
        shares(beams, layers, links, pin, force, states, quality["sag_max_mm"], (plane, max(-pen[2], -tracer[2])), folder)


def main():
    in_shares = "--shares" in sys.argv
    arguments = [argument for argument in sys.argv[1:] if argument != "--shares"]
    kempe = str(pathlib.Path(arguments[0]).resolve())
    for number, task in enumerate(TASKS):
        if len(arguments) > 1:
            folder = pathlib.Path(arguments[1]).absolute() / str(number)
            folder.mkdir(parents=True, exist_ok=True)
            compare(kempe, task, folder, in_shares)
        else:
            with tempfile.TemporaryDirectory() as folder:
                compare(kempe, task, pathlib.Path(folder), in_shares)


if __name__ == "__main__":
    main()
