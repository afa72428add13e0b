#!/usr/bin/env python3
"""Loads against two structural programs by other people: anaStruct (frames in the plane) and PyNite (frames in space). scripts/bootstrap tests
installs what structural_programs.txt names from the Python package index into build/structural-programs; its Python runs this.

Twenty designs, of all groundings, straight and bent, of several materials and sections. From each design.json alone: joints, who holds what,
section, modulus; each program solves the frame at openings all over those that the region uses. Compared are the most and the least that the
pen gives way and the hand's force, with PyNite also the largest force in a pin, and out of the plane the sag, by weight and by play. They
must agree to 0.1 %.

usage: structural_programs_test.py KEMPE      exit 1 if a figure is off
"""
import cmath
import json
import math
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


def carried(number):
    """What the task's instrument carries and stands on, out of the plane: all kinds in turn."""
    return {
        "rests": [[], ["tracer"], ["pen"], ["tracer", "pen"]][number % 4],
        "pen_mass_kg": [0.2, 0, 1.5][number % 3],
        "tracer_mass_kg": [0, 0.1][number % 2],
        "tilt_deg": [0, 0, 30, 0, 60][number % 5],
        "grip_mm": [10, 25, 40][number % 3],
        "play_mm": [0.02, 0, 0.05, 0.1][(number + number // 4) % 4],
    }


def spec_of(task, number):
    load = carried(number)
    rests = f"rests = {json.dumps(load['rests'])}" if load["rests"] else ""
    play = f"[tolerance]\nplay_mm = {load['play_mm']}" if load["play_mm"] else ""
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
{rests}
pen_mass_kg = {load["pen_mass_kg"]}
tracer_mass_kg = {load["tracer_mass_kg"]}
tilt_deg = {load["tilt_deg"]}
grip_mm = {load["grip_mm"]}
{play}
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
        self.G = 1000 * design["material"]["G_GPa"] if "G_GPa" in design["material"] else self.E / 2.6
        self.density = 1e-9 * design["material"]["density_kg_m3"]
        load = design["load"]
        self.force, self.rests = load["pen_N"], load["rests"]
        # On a tilted table what the pen carries pulls along the plane too, at most in the force's direction.
        self.pull = self.force + 9.80665 * math.sin(math.radians(load.get("tilt_deg", 0))) * load.get("pen_mass_kg", 0)
        self.masses = {self.pen: load.get("pen_mass_kg", 0), self.tracer: load.get("tracer_mass_kg", 0)}
        self.down = 9.80665 * math.cos(math.radians(load.get("tilt_deg", 0)))
        self.is_level = load.get("tilt_deg", 0) == 0
        self.tilt = ((design["tolerance"] or {}).get("play_mm") or 0) / load["grip_mm"]
        self.layers = {link["name"]: link["layer"] for link in mechanism["links"]}
        self.pin = mechanism["pin_diameter_mm"]
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
    piece so short that it passes forces and so soft that it passes no moment; that spoils the result in
    proportion to the piece's length, at the length taken by 0.035 % at most on the twenty designs."""
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
    frame.add_material("material", design.E, design.G, 0.3, 0)
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


class Grillage:
    """The links lying in their layers, in PyNite: arms bend and twist, pins are upright pieces of steel that pass height and bending, and
    turn freely. Nothing moves in the plane."""

    def __init__(self, design, at):
        from Pynite import FEModel3D

        self.design, self.at, self.beams = design, at, design.beams(at)
        self.frame, self.pins, self.goes_on = FEModel3D(), [], {}
        thickness, width, E = design.thickness, design.width, design.E
        thin, wide = sorted((thickness, width))
        torsion = wide * thin**3 * (1 / 3 - 0.21 * thin / wide * (1 - (thin / wide) ** 4 / 12))  # Roark, table 10.1
        self.frame.add_material("link", E, design.G, 0.3, 0)
        self.frame.add_material("steel", 200000, 200000 / 2.6, 0.3, 0)
        self.frame.add_section("arm", design.area(), width * thickness**3 / 12, design.second_moment(), torsion)
        round_ = math.pi * design.pin**4 / 64
        self.frame.add_section("pin", 100, round_, round_, 2 * round_)
        for link in ("VA", "VB", "ACX", "BCY"):
            for joint in link:
                self.frame.add_node(f"{link}.{joint}", at[joint].real, at[joint].imag, self.height(link))
                self.frame.def_support(f"{link}.{joint}", True, True, False, False, False, True)
        for number, (link, start, end) in enumerate(self.beams):
            self.frame.add_member(f"arm {number}", f"{link}.{start}", f"{link}.{end}", "link", "arm")
            self.frame.add_member_dist_load(f"arm {number}", "FZ", *2 * [-design.down * design.density * design.area()], case="weight")
        self.add_pins()
        self.add_weights()
        self.frame.add_load_combo("weight", {"weight": 1})
        for joint in (design.tracer, design.pen):
            self.frame.add_node_load(self.node(joint), "FZ", -1, case=joint)
            self.frame.add_load_combo(joint, {joint: 1})

    def height(self, link):
        return self.design.thickness * (self.design.layers[link] - 0.5)

    def node(self, joint):
        """Of the link that carries the tool there."""
        return {"V": "VA.V", "X": "ACX.X", "Y": "BCY.Y"}[joint]

    def add_pins(self):
        if self.design.pole == "V":
            low, high = sorted(("VA", "VB"), key=self.height)
            post = self.add_post(f"{low}.V")
            self.goes_on[post] = self.add_pin(f"{low}.V", f"{high}.V")
        else:
            self.add_post("ACX.X"), self.add_pin("VA.V", "VB.V")
        for one, other in (("VA.A", "ACX.A"), ("VB.B", "BCY.B"), ("ACX.C", "BCY.C")):
            self.add_pin(one, other)

    def add_post(self, node):
        """Clamped in the table."""
        foot = f"foot of {node}"
        place = self.frame.nodes[node]
        self.frame.add_node(foot, place.X, place.Y, 0)
        self.frame.def_support(foot, True, True, True, True, True, True)
        return self.add_pin(foot, node)

    def add_pin(self, one, other):
        name = f"pin {one} {other}"
        self.frame.add_member(name, one, other, "steel", "pin")
        self.frame.def_releases(name, Dyj=True, Dzj=True, Rxj=True)
        self.pins.append(name)
        return name

    def borne(self, pin, case):
        """The moment between a pin and its link. Where a post goes on to another link, the lower one takes what the two parts differ by."""
        ends = self.frame.members[pin].f(case).flatten()
        moments = ends[4], ends[5]
        if pin in self.goes_on:
            on = self.frame.members[self.goes_on[pin]].f(case).flatten()
            moments = ends[4] - on[4], ends[5] - on[5]
        return math.hypot(*moments)

    def add_weights(self):
        """Half a disc at both ends of each link, and what pen and tracer carry."""
        design = self.design
        disc = math.pi * design.width**2 / 8 * design.thickness * design.density
        for link in ("VA", "VB", "ACX", "BCY"):
            ends = [joint for name, *pair in self.beams if name == link for joint in pair]
            for joint in (joint for joint in ends if ends.count(joint) == 1):
                self.frame.add_node_load(f"{link}.{joint}", "FZ", -design.down * disc, case="weight")
        for joint, mass in design.masses.items():
            self.frame.add_node_load(self.node(joint), "FZ", -design.down * mass, case="weight")

    def sag(self):
        """Of tracer or pen, what sinks more. A point that rests is pushed by the table, and never pulled."""
        design = self.design
        resting = [getattr(design, name) for name in design.rests]
        for chosen in sorted((set(resting[:i] + resting[j:]) for i in range(3) for j in range(i, 3)), key=len, reverse=True):
            for joint in resting:
                self.frame.def_support(self.node(joint), True, True, joint in chosen, False, False, True)
            self.frame.analyze_linear(check_stability=False)
            nodes = {joint: self.frame.nodes[self.node(joint)] for joint in resting}
            bears = all(nodes[joint].RxnFZ["weight"] >= -1e-9 for joint in chosen)
            if bears and all(node.DZ["weight"] >= -1e-9 for node in nodes.values()):
                break
        drops = []
        for joint in (design.tracer, design.pen):
            by_play = design.tilt * sum(self.borne(pin, joint) for pin in self.pins)
            drops.append(by_play - self.frame.nodes[self.node(joint)].DZ["weight"])
        return max(0, *drops)


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
    if pin and design.is_level:  # on a tilted table that has the links' own weight too, which these frames are not given
        result["pin_force_max_N"] = pin
    return {name: (design.force if name == "hand_force_max_N" else design.pull) * value for name, value in result.items()}


def design_of(kempe, number, folder):
    task = TASKS[number]
    spec = folder / "spec.toml"
    spec.write_text(spec_of(task, number))
    run = subprocess.run([kempe, "synthesize", spec, "-o", folder / "out", "--quiet"], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{task}: {run.stderr.strip()}")
    return Design(json.loads((folder / "out" / "design.json").read_text()))


def main():
    kempe = pathlib.Path(sys.argv[1]).resolve()
    warnings.filterwarnings("ignore")
    largest = {}

    def compare(task, program, name, value, ours):
        off = abs(value - ours) / max(abs(ours), 1e-6)
        largest[program] = max(largest.get(program, 0), off)
        if off > ALLOWED:
            print(f"{task}: {name} {ours:.6g}, {program} {value:.6g}: {100 * off:.2f} % off")

    for number, task in enumerate(TASKS):
        with tempfile.TemporaryDirectory() as folder:
            design = design_of(kempe, number, pathlib.Path(folder))
        for program, answer in (("anaStruct", anastruct_answer), ("PyNite", pynite_answer)):
            for name, value in figures(design, answer).items():
                compare(task, program, name, value, design.quality[name])
        sag = max(Grillage(design, design.joints(opening)).sag() for opening in design.used_openings())
        compare(task, "PyNite, out of the plane", "sag_max_mm", sag, design.quality["sag_max_mm"])
        print(f"scale {task[0]}, {task[1]} degrees, {task[2]} at V: gives way by {design.quality['load_error_max_mm']:.4g} mm, "
              f"sags by {design.quality['sag_max_mm']:.4g} mm")
    for program, off in largest.items():
        print(f"{program}: {len(TASKS)} designs, largest difference {100 * off:.4f} %")
    sys.exit(any(off > ALLOWED for off in largest.values()))


if __name__ == "__main__":
    main()
