#!/usr/bin/env python3
"""Loads in the plane against two structural programs by other people: anaStruct (frames in the plane) and PyNite (frames in space), which are
installed from the Python package index into a folder of their own when this starts.

Twenty designs, of all groundings, straight and bent, of several materials and sections. From each design.json alone: joints, who holds what,
section, modulus; each program solves the frame at openings all over those that the region uses. Compared are the most and the least that the
pen gives way and the hand's force, with PyNite also the largest force in a pin. They must agree to 0.1 %.

usage: frames.py KEMPE [FOLDER]      FOLDER: where the programs are installed (build/frames-venv if left out); exit 1 if a figure is off
"""
import cmath
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import warnings

ALLOWED = 1e-3
PLACES = 25  # openings looked at, the ends among them
JOINTS = "VABCXY"
FLEXURE = 2e-6  # length of a flexure as a share of its beam
# scale, rotation_deg, grounding, [width, thickness], material, pen_N, the region's [x, y, width, height]
TASKS = [
    (1.4, 90, "tracer", (6, 2), "steel", 10, (60, -5, 10, 10)),
    (1.4, 90, "pole", (6, 2), "steel", 10, (60, -5, 10, 10)),
    (1.4, 90, "pen", (6, 2), "steel", 10, (60, -5, 10, 10)),
    (0.4, 0, "tracer", (15, 5), "steel", 50, (150, -60, 120, 120)),
    (0.4, 0, "pole", (15, 5), "aluminium", 10, (150, -60, 120, 120)),
    (0.4, 0, "pen", (15, 5), "PLA", 10, (150, -60, 120, 120)),
    (2, 0, "tracer", (20, 6), "birch plywood", 15, (100, -40, 80, 80)),
    (2, 0, "pole", (20, 6), "birch plywood", 15, (100, -40, 80, 80)),
    (2, 0, "pen", (20, 6), "acrylic", 15, (100, -40, 80, 80)),
    (1, 180, "tracer", (12, 4), "aluminium", 5, (80, -30, 60, 60)),
    (0.5, 180, "pole", (12, 4), "brass", 5, (80, -30, 60, 60)),
    (3, 180, "pen", (12, 4), "steel", 5, (40, -15, 30, 30)),
    (0.7, 45, "tracer", (12, 4), "PLA", 2, (120, 20, 60, 40)),
    (0.7, 45, "pole", (12, 4), "PLA", 2, (120, 20, 60, 40)),
    (0.7, 45, "pen", (12, 4), "PLA", 2, (120, 20, 60, 40)),
    (5, 10, "tracer", (15, 3), "steel", 8, (30, 10, 20, 10)),
    (0.2, -120, "pole", (10, 3), "brass", 20, (150, -80, 100, 60)),
    (0.05, 0, "tracer", (10, 3), "steel", 1, (200, -40, 80, 80)),
    (1.2, -30, "pen", (25, 8), "birch plywood", 30, (200, -60, 120, 120)),
    (1, 90, "pole", (15, 5), "aluminium", 10, (100, 50, 80, 60)),
]


def enter_environment(folder):
    """Runs this again by the Python of the folder, with the two programs in it."""
    python = folder / "bin" / "python"
    if not python.exists():
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", "anastruct==1.7.0", "PyNiteFEA==3.2.0"], check=True)
    os.execv(python, [str(python), __file__, *sys.argv[1:], "--inside"])


def spec_of(task):
    scale, rotation, grounding, section, material, force, (x, y, width, height) = task
    return f"""
[copy]
scale = {scale}
rotation_deg = {rotation}
[region]
rectangle_mm = {{ at = [{x}, {y}], size = [{width}, {height}] }}
[pole]
at_mm = [0, 0]
[links]
width_mm = {section[0]}
thickness_mm = {section[1]}
pin_diameter_mm = 3
[objective]
groundings = ["{grounding}"]
[material]
name = "{material}"
[load]
pen_N = {force}
"""


def distances(ring):
    """Of the nearest and the farthest point of a convex region without the pole in it, which stands at the origin."""
    nearest = math.inf
    for a, b in zip(ring, ring[1:]):
        along = b - a
        share = min(1, max(0, -(a * along.conjugate()).real / abs(along) ** 2)) if along else 0
        nearest = min(nearest, abs(a + share * along))
    return nearest, max(map(abs, ring))


class Design:
    """What design.json says of the mechanism, as a frame."""

    def __init__(self, design):
        mechanism = design["mechanism"]
        self.VA, self.VB = (mechanism["lengths_mm"][name] for name in ("VA", "VB"))
        self.shape = complex(*mechanism["shape"])
        self.openings = [math.radians(angle) for angle in mechanism["opening_deg"]]
        self.pole, self.tracer, self.pen = (mechanism[name] for name in ("pole", "tracer", "pen"))
        self.width, self.thickness = mechanism["link_width_mm"], mechanism["thickness_mm"]
        self.straight = abs(math.sin(math.radians(design["copy"]["rotation_deg"]))) < 1e-12
        self.E = 1000 * design["material"]["E_GPa"]
        self.force = design["load"]["pen_N"]
        ring = design["region"]["coordinates"][0][0]
        self.reach = distances([complex(*point) - complex(*mechanism["pole_position_mm"]) for point in ring])
        self.quality = design["quality"]

    def area(self):
        return self.width * self.thickness

    def second_moment(self):
        return self.thickness * self.width**3 / 12

    def joints(self, opening):
        p, q = self.VA, cmath.rect(self.VB, opening)
        return dict(zip(JOINTS, (0j, p + 0j, q, p + q, p + q / self.shape, q + p * self.shape)))

    def used_openings(self):
        """Where the tracer stands at the region's nearest and farthest distance from the pole: it grows or falls all the way."""
        def distance(opening):
            at = self.joints(opening)
            return abs(at[self.tracer] - at[self.pole])

        def opening_at(wanted):
            low, high = self.openings
            falls = distance(low) > distance(high)
            for _ in range(200):
                middle = (low + high) / 2
                if (distance(middle) > wanted) == falls:
                    low = middle
                else:
                    high = middle
            return (low + high) / 2

        first, last = map(opening_at, self.reach)
        return [first + (last - first) * i / (PLACES - 1) for i in range(PLACES)]

    def beams(self, at):
        """(link, from, to): the bars, and each plate as two arms from its corner or as one beam through its joints in order."""
        beams = [("VA", "V", "A"), ("VB", "V", "B")]
        for link in ("ACX", "BCY"):
            corner, middle, end = link
            if not self.straight:
                beams += [(link, corner, middle), (link, corner, end)]
                continue
            way = max((at[b] - at[a] for a in link for b in link), key=abs)
            row = sorted(link, key=lambda joint: (at[joint] * way.conjugate()).real)
            beams += [(link, row[0], row[1]), (link, row[1], row[2])]
        return beams

    def owners(self, beams):
        """The link that goes through each joint stiffly; all others are hinged on it."""
        owners = {"V": "VA", "A": "ACX", "B": "BCY", "C": "ACX", "X": "ACX", "Y": "BCY"}
        for joint in "ABC":
            for link in ("ACX", "BCY"):
                if sum(joint in ends and name == link for name, *ends in beams) == 2:
                    owners[joint] = link
        return owners


def anastruct_answer(design, at, direction):
    """The pen's movement and the hand's force for 1 N at the pen.

    A beam hinged at one end keeps 4 EI / L at the other in anaStruct 1.7.0, where 3 EI / L is right. So no hinges are used: a pin is a flexure, a
    piece so short that it passes forces and so soft that it passes no moment; both spoil the result by less than 1e-4."""
    from anastruct import SystemElements

    frame = SystemElements()
    beams = design.beams(at)
    owners = design.owners(beams)
    EA, EI = design.E * design.area(), design.E * design.second_moment()

    def add(start, end, stiffness):
        frame.add_element(location=[[end_.real, end_.imag] for end_ in (start, end)], EA=EA, EI=stiffness)

    for link, start, end in beams:
        first, last = at[start], at[end]
        if link in ("VA", "VB"):
            frame.add_truss_element(location=[[first.real, first.imag], [last.real, last.imag]], EA=EA)
            continue
        short = FLEXURE * (last - first)
        if owners[start] != link:
            add(first, first + short, FLEXURE**2 * EI)
            first += short
        if owners[end] != link:
            add(last - short, last, FLEXURE**2 * EI)
            last -= short
        add(first, last, EI)
    node = {joint: frame.find_node_id([at[joint].real, at[joint].imag]) for joint in JOINTS}
    frame.add_support_hinged([node[design.pole], node[design.tracer]])
    frame.point_load(node[design.pen], Fx=direction.real, Fy=direction.imag)
    frame.solve()
    moved = frame.get_node_displacements(node[design.pen])
    held = frame.get_node_results_system(node[design.tracer])
    return complex(moved["ux"], moved["uy"]), complex(held["Fx"], held["Fy"]), None


def pynite_answer(design, at, direction):
    """The same, and the forces in the pins A, B, C and V."""
    from Pynite import FEModel3D

    frame = FEModel3D()
    frame.add_material("material", design.E, design.E / 2.6, 0.3, 0)
    frame.add_section("section", design.area(), 1, design.second_moment(), 1)
    for joint, place in at.items():
        frame.add_node(joint, place.real, place.imag, 0)
        held = joint in (design.pole, design.tracer)
        frame.def_support(joint, held, held, True, True, True, False)  # in the plane
    beams = design.beams(at)
    owners = design.owners(beams)
    for number, (link, start, end) in enumerate(beams):
        name = f"{link} {number}"
        frame.add_member(name, start, end, "material", "section")
        frame.def_releases(name, Rzi=owners[start] != link, Rzj=owners[end] != link)
    frame.add_node_load(design.pen, "FX", direction.real)
    frame.add_node_load(design.pen, "FY", direction.imag)
    frame.analyze_linear(check_stability=False)

    def force_on(link, joint):
        total = 0j
        for number, (name, start, end) in enumerate(beams):
            if name == link and joint in (start, end):
                ends = frame.members[f"{link} {number}"].F("Combo 1").flatten()
                first = 0 if joint == start else 6
                total += complex(ends[first], ends[first + 1])
        return total

    nodes = frame.nodes
    combo = "Combo 1"
    moved = complex(nodes[design.pen].DX[combo], nodes[design.pen].DY[combo])
    hand, pole = (complex(nodes[joint].RxnFX[combo], nodes[joint].RxnFY[combo]) for joint in (design.tracer, design.pole))
    return moved, hand, [force_on("VA", "A"), force_on("VB", "B"), force_on("BCY", "C"), force_on("VB", "V"), pole]


def stretches(x, y):
    """The largest and the smallest length of a x + b y over all a, b on the unit circle."""
    sum_of_squares, cross = abs(x) ** 2 + abs(y) ** 2, abs((x.conjugate() * y).imag)
    root = math.sqrt(max(0, sum_of_squares**2 - 4 * cross**2))
    return math.sqrt((sum_of_squares + root) / 2), math.sqrt(max(0, sum_of_squares - root) / 2)


def figures(design, answer):
    most, least, hand, pin = 0, math.inf, 0, 0
    for opening in design.used_openings():
        at = design.joints(opening)
        (x, hand_x, pins_x), (y, hand_y, pins_y) = (answer(design, at, direction) for direction in (1, 1j))
        worst, best = stretches(x, y)
        most, least = max(most, worst), min(least, best)
        hand = max(hand, stretches(hand_x, hand_y)[0])
        if pins_x:
            pin = max(pin, *(stretches(a, b)[0] for a, b in zip(pins_x, pins_y)))
    result = {"load_error_max_mm": most, "load_error_min_mm": least, "hand_force_max_N": hand}
    if pin:
        result["pin_force_max_N"] = pin
    return {name: design.force * value for name, value in result.items()}


def design_of(kempe, task, folder):
    spec = folder / "spec.toml"
    spec.write_text(spec_of(task))
    run = subprocess.run([kempe, "synthesize", spec, "-o", folder / "out", "--quiet"], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"frames.py: {task}: {run.stderr.strip()}")
    return Design(json.loads((folder / "out" / "design.json").read_text()))


def main():
    kempe = pathlib.Path(sys.argv[1]).resolve()
    if sys.argv[-1] != "--inside":
        enter_environment(pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "build/frames-venv").absolute())
    warnings.filterwarnings("ignore")
    largest = {}
    for task in TASKS:
        with tempfile.TemporaryDirectory() as folder:
            design = design_of(kempe, task, pathlib.Path(folder))
        for program, answer in (("anaStruct", anastruct_answer), ("PyNite", pynite_answer)):
            for name, value in figures(design, answer).items():
                ours = design.quality[name]
                off = abs(value - ours) / ours
                largest[program] = max(largest.get(program, 0), off)
                if off > ALLOWED:
                    print(f"{task}: {name} {ours:.6g}, {program} {value:.6g}: {100 * off:.2f} % off")
        print(f"scale {task[0]}, {task[1]} degrees, {task[2]} at V: gives way by {design.quality['load_error_max_mm']:.4g} mm")
    for program, off in largest.items():
        print(f"{program}: {len(TASKS)} designs, largest difference {100 * off:.4f} %")
    sys.exit(any(off > ALLOWED for off in largest.values()))


if __name__ == "__main__":
    main()
