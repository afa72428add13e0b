"""The part of kempe_check.py that bodies and the table's edge need, in claims 2 to 4. It is imported for a design or a log that has
one of the two. The theorems stand in docs/proof.md.

A body keeps its direction, so it is at rest seen from the joint that carries it, and parts keep away from it there as they keep
away from obstacles in the table's frame. Two polygons that do not overlap come within a distance of each other exactly if the
origin comes as near to an edge of one less a corner of the other, or to a corner less an edge.
"""
from types import SimpleNamespace

from enclosures import AT_REST, Tree, edges_of, listed, must, number, point, polygons, tree_of, where, word

CARRIERS = {"pole": {"tracer": "X", "pen": "Y"}, "tracer": {"tracer": "V", "pen": "Y"}, "pen": {"tracer": "Y", "pen": "V"}}


def ring_of(value):
    (rings,) = polygons(value)
    return must(len(rings) == 1, value, "an outline without holes") and rings[0]


def body(value):
    """Its corners, closed to a ring unless it is a disc about one corner; how far it reaches beyond them."""
    low, high = listed(number(1, 64, [int]), 2)(value["layers"])
    name, at = value.get("name") or "a body", word("tracer", "pen")(value["at"])
    if "circle_mm" in value:
        ring, beyond = [point(value["circle_mm"]["centre"])], number(1e-9)(value["circle_mm"]["radius"])
    else:
        ring, beyond = ring_of(value["shape"]), 0.0
    return SimpleNamespace(name=name, at=at, ring=ring, beyond=beyond, layers=range(low, high + 1))


def blocks_of(log, vertex):
    """What a log names by numbers that follow the obstacles': bodies, seen from the joints that carry them; the table's edge, with
    an empty ring more, so that it can be met by its edges alone."""
    task, table = log.data["task"], log.data["task"].get("table")
    found = [SimpleNamespace(rings=[one.ring * 2 if len(one.ring) == 1 else one.ring], layers=one.layers, beyond=one.beyond,
                             joint=CARRIERS[vertex][one.at], rest=0.0) for one in listed(body)(task.get("bodies") or [])]
    return found + ([SimpleNamespace(rings=[ring_of(table), []], layers=range(1, 65), **AT_REST)] if table else [])


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


def tree(some):
    return Tree([some[0][0]], 0.0, ()) if len(some) == 1 and some[0][0] == some[0][1] else tree_of(some)


def pairs_of(design, parts, Pair, occupied, pieces, half):
    """What must keep apart, for Design.keep_out(). The design's slip grows to what these shapes need."""
    task, data, found = design.task, design.data, []
    bodies = listed(body)(data.get("bodies") or [])
    table = [[less(c, design.pole) for c in ring_of(data["table"])]] if data.get("table") else []
    sizes = [abs(c) + b.beyond for b in bodies for corner in b.ring for c in corner] + [abs(c) for r in table for p in r for c in p]
    design.slip += 2.0 ** -42 * max(sizes, default=0.0)
    roles = CARRIERS[design.shape.vertex]

    def within(rings, taken=((0.0, 0.0),)):
        return lambda at: overlap(rings, taken, at)

    for i, one in enumerate(bodies):
        joint, wide = roles[one.at], one.beyond + task.clearance
        for part, joints in parts.items():
            if joint not in joints and not occupied(part, design.layers).isdisjoint(one.layers):
                found += [Pair(part, piece, one.name, [joint], "table", half(task, part) + wide, tree(edges(one.ring)),
                               within([one.ring])) for piece in pieces(task, part)]
        for block, other in zip(design.blocks, task.obstacles):
            if set(one.layers) & set(other.layers):
                found.append(Pair(one.name, [joint], other.name, ["pole"], "table", wide, tree(difference(block, one.ring)),
                                  within(block, one.ring)))
        for other in bodies[:i]:
            if other.at != one.at and set(one.layers) & set(other.layers):
                found.append(Pair(one.name, [joint], other.name, [roles[other.at]], "table", wide + other.beyond,
                                  tree(difference([other.ring], one.ring)), within([other.ring], one.ring)))
    for edge in table:
        def off(at, taken=((0.0, 0.0),)):
            return where((taken[0][0] + at[0], taken[0][1] + at[1]), [edge]) < 0

        found += [Pair(part, piece, "what is off the table", ["pole"], "table", half(task, part) + task.clearance,
                       tree(edges(edge)), off) for part in parts for piece in pieces(task, part)]
        found += [Pair(one.name, [roles[one.at]], "what is off the table", ["pole"], "table", one.beyond + task.clearance,
                       tree(difference([edge], one.ring)), lambda at, ring=one.ring: off(at, ring)) for one in bodies]
    return found
