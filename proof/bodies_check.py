"""The part of kempe_check.py that bodies and the table's edge need, in claims 2 to 4. It is imported for a design or a log that has
one of the two. The theorems stand in docs/proof.md.

A body that keeps its direction is at rest seen from the joint that carries it, and parts keep away from it there as they keep
away from obstacles in the table's frame. Two polygons that do not overlap come within a distance of each other exactly if the
origin comes as near to an edge of one less a corner of the other, or to a corner less an edge.

A body that turns with a link is at rest in that link's frame, where the opening alone moves the others. Its corners are points
of the link's plate: constants alpha and beta are known for them as for joints, so that its edges keep away from all else as parts
do. Outlines that never meet lie one in the other always or never: one place of each polygon of the region decides.
"""
from types import SimpleNamespace

from kempe_check import (AT_REST, JOINTS, LINKS, POINT, UNIT, WIDTH, Pair, Refuted, Z, edges_of, fits, half, must, occupied,
                         pieces, polygons, where)

ALONG_P = ("VA", "BCY")
EQUALLY_NEAR = 1 + 1e-9
CARRIERS = {"pole": {"tracer": "X", "pen": "Y"}, "tracer": {"tracer": "V", "pen": "Y"}, "pen": {"tracer": "Y", "pen": "V"}}


def ring_of(value, path):
    found = polygons(value, path)
    must(len(found) == 1 == len(found[0]), path, value, "an outline without holes")
    return found[0][0]


def body(value, path):
    """Its corners, closed to a ring unless it is a disc about one corner; how far it reaches beyond them."""
    found = fits(value, {"layers": [(1, 64)] * 2, "at": {"tracer", "pen"}, "turns_with": {*LINKS, None}}, path)
    if "circle_mm" in value:
        disc = fits(value, {"circle_mm": {"centre": POINT, "radius": WIDTH}}, path)
        ring, beyond = [disc.centre], disc.radius
    else:
        ring, beyond = ring_of(value.get("shape"), path), 0.0
    return SimpleNamespace(name=value.get("name") or "a body", at=found.at, link=found.turns_with, ring=ring, beyond=beyond,
                           layers=range(found.layers[0], found.layers[1] + 1))


def bodies_of(data, path):
    return fits(data.get("bodies") or [], [body], path + "bodies.")


def blocks_of(log, vertex):
    """What a log names by numbers that follow the obstacles': bodies that keep their direction, seen from the joints that carry
    them; the table's edge, with an empty ring more, so that it can be met by its edges alone. Bodies that turn rule nothing out."""
    task, table = log.data["task"], log.data["task"].get("table")
    found = [SimpleNamespace(rings=[one.ring * 2 if len(one.ring) == 1 else one.ring], layers=one.layers, beyond=one.beyond,
                             joint=CARRIERS[vertex][one.at], rest=0.0) for one in bodies_of(task, "task.") if not one.link]
    return found + ([SimpleNamespace(rings=[ring_of(table, "task.table"), []], layers=range(1, 65), **AT_REST)] if table else [])


def less(p, q):
    return p[0] - q[0], p[1] - q[1]


def edges(ring):
    return edges_of([ring]) if len(ring) > 1 else [(ring[0], ring[0])]


def difference(rings, taken):
    """Edges among which are all of the difference's outline."""
    return ([(less(p, c), less(q, c)) for ring in rings for p, q in edges(ring) for c in taken]
            + [(less(c, p), less(c, q)) for ring in rings for c in ring for p, q in edges(taken) if len(taken) > 1])


def overlap(rings, taken, at):
    """Whether a ring at a place lies in a polygon, or the other way round; asked of two whose outlines do not meet."""
    moved = [(c[0] + at[0], c[1] + at[1]) for c in taken]
    return len(rings[0]) > 1 and where(moved[0], rings) > 0 or len(taken) > 1 and where(rings[0][0], [moved]) > 0


def axis(shape, link):
    """From the link's end to its nearest other joint, as a multiple of the direction of p or q, of size 1."""
    if link in ("VA", "VB"):
        return UNIT
    u = shape.s if link == "BCY" else UNIT / shape.s
    ways = -u, UNIT - u
    near = ways[0 if ways[0].square().middle() <= EQUALLY_NEAR ** 2 * ways[1].square().middle() else 1]
    return near / near.square().sqrt()


def fix_to_link(design, one, number):
    """Names the body's corners as joints, and turns its outline into the frame in which it is at rest."""
    shape, along = design.shape, axis(design.shape, one.link)
    one.frame, one.joints = "VA" if one.link in ALONG_P else "ACX", []
    alpha, beta = shape.seen[one.joint]
    for i, corner in enumerate(one.ring):
        beside = along * Z(*corner)
        name = f"corner {i} of body {number}"
        if one.frame == "VA":  # alpha p + beta q/s
            shape.seen[name] = alpha + beside / design.a, beta
        else:
            shape.seen[name] = alpha, beta + beside * shape.s / (shape.abs_s * design.b)
        one.joints.append(name)
    one.ring = [(along * Z(*corner)).middle() for corner in one.ring]


def sides(one):
    return list(zip(one.joints, one.joints[1:])) if len(one.joints) > 1 else [one.joints]


def is_kept_from(one, part, joints):
    """Whether a part must keep away from a body: it is not mounted with it, nor a pin of the link that it turns with."""
    return one.joint not in joints and not (one.link and part not in LINKS and joints in one.link)


def never(at):
    """Whether outlines lie in each other is asked beforehand: refuse_overlaps()."""
    return False


def refuse_overlaps(design, bodies, table):
    """Of bodies that turn and all else: with the tracer at one place of each of the region's polygons."""
    task = design.task
    for rings in design.region:
        joints = {name: z.middle() for name, z in design.seen(Z(*rings[0][0])).items()}
        placed = [[joints[name] for name in one.joints] if one.link else
                  [(joints[one.joint][0] + c[0], joints[one.joint][1] + c[1]) for c in one.ring] for one in bodies]
        for i, (one, ring) in enumerate(zip(bodies, placed)):
            if not one.link:
                continue
            others = [(block, other.name) for block, other in zip(design.blocks, task.obstacles)
                      if set(one.layers) & set(other.layers)]
            others += [([placed[j]], other.name) for j, other in enumerate(bodies)
                       if other.joint != one.joint and set(one.layers) & set(other.layers)]
            others += [([[joints[piece[0]]]], part) for part, of in JOINTS.items() for piece in pieces(task, part)
                       if is_kept_from(one, part, of) and not occupied(part, design.layers).isdisjoint(one.layers)]
            for other, name in others:
                if overlap(other, ring, (0.0, 0.0)):
                    raise Refuted(f"{one.name} and {name} overlap")
            if any(where(ring[0], [edge]) < 0 for edge in table):
                raise Refuted(f"{one.name} is off the table")


def pairs_of(design):
    """What must keep apart, for Design.keep_out(). The design's slip grows to what these shapes need."""
    task, data, found = design.task, design.data, []
    bodies = bodies_of(data, design.name + ": ")
    table = [[less(c, design.pole) for c in ring_of(data["table"], design.name + ": table")]] if data.get("table") else []
    sizes = [abs(c) + b.beyond for b in bodies for corner in b.ring for c in corner] + [abs(c) for r in table for p in r for c in p]
    design.slip += 2.0 ** -42 * max(sizes, default=0.0)
    roles = CARRIERS[design.shape.vertex]
    for i, one in enumerate(bodies):
        one.joint, one.frame, one.joints = roles[one.at], "table", [roles[one.at]]
        if one.link:
            must(one.joint in one.link, f"{design.name}: bodies.turns_with", one.link, "a link that has the body's point")
            fix_to_link(design, one, i + 1)
    refuse_overlaps(design, bodies, table)

    def within(rings, taken=((0.0, 0.0),)):
        return lambda at: overlap(rings, taken, at)

    def turning(one, name, others, frame, wide, some):
        return [Pair(one.name, side, name, others, frame, wide, some, never) for side in sides(one)]

    for i, one in enumerate(bodies):
        joint, wide = one.joint, one.beyond + task.clearance_mm
        for part, joints in JOINTS.items():
            if is_kept_from(one, part, joints) and not occupied(part, design.layers).isdisjoint(one.layers):
                found += [Pair(part, piece, one.name, [joint], one.frame, half(task, part) + wide, edges(one.ring),
                               never if one.link else within([one.ring])) for piece in pieces(task, part)]
        for block, other in zip(design.blocks, task.obstacles):
            if not set(one.layers) & set(other.layers):
                continue
            found += turning(one, other.name, ["pole"], "table", wide, edges_of(block)) if one.link else [
                Pair(one.name, [joint], other.name, ["pole"], "table", wide, difference(block, one.ring),
                     within(block, one.ring))]
        for other in bodies[:i]:
            if other.at == one.at or not set(one.layers) & set(other.layers):
                continue
            moving, still = (one, other) if one.link else (other, one)
            both = wide + other.beyond
            found += turning(moving, still.name, [still.joint], still.frame, both, edges(still.ring)) if moving.link else [
                Pair(one.name, [joint], other.name, [other.joint], "table", both, difference([other.ring], one.ring),
                     within([other.ring], one.ring))]
    for edge in table:
        def off(at, taken=((0.0, 0.0),)):
            return where((taken[0][0] + at[0], taken[0][1] + at[1]), [edge]) < 0

        found += [Pair(part, piece, "what is off the table", ["pole"], "table", half(task, part) + task.clearance_mm,
                       edges(edge), off) for part in JOINTS for piece in pieces(task, part)]
        for one in bodies:
            wide = one.beyond + task.clearance_mm
            found += turning(one, "what is off the table", ["pole"], "table", wide, edges(edge)) if one.link else [
                Pair(one.name, [one.joint], "what is off the table", ["pole"], "table", wide, difference([edge], one.ring),
                     lambda at, ring=one.ring: off(at, ring))]
    return found
