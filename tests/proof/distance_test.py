"""The distances of the checker, computed in doubles, are off by less than the slack it grants them: against exact fractions.

usage: distance_test.py SOURCE_DIR
"""
import math
import random
import sys
from fractions import Fraction


def exact_square(p, a, b):
    """The squared distance of p from the segment a-b, as a fraction."""
    (px, py), (ax, ay), (bx, by) = ([Fraction(c) for c in point] for point in (p, a, b))
    dx, dy = bx - ax, by - ay
    t = max(Fraction(0), min(Fraction(1), ((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy)))
    return (ax + t * dx - px) ** 2 + (ay + t * dy - py) ** 2


def point_and_edge(draw, length):
    """A point some millimetres beside a long edge."""
    turn, off, share = draw.uniform(0, 2 * math.pi), draw.uniform(0, 6), draw.uniform(0.1, 0.9)
    c, s = math.cos(turn), math.sin(turn)
    p = draw.uniform(-100, 100), draw.uniform(-100, 100)
    foot = p[0] - s * off, p[1] + c * off
    ends = (-share * length, (1 - share) * length)
    return p, *((foot[0] + t * c, foot[1] + t * s) for t in ends)


def main(source):
    sys.dont_write_bytecode = True
    sys.path.insert(0, source + "/proof")
    from kempe_check import apart
    draw, worst = random.Random(1), 0.0
    for case in range(3500):
        p, a, b = point_and_edge(draw, 10.0 ** (1 + case % 7))
        found = math.hypot(*apart([p], [a, b]))
        slack = 1e-14 * max(abs(c) for point in (p, a, b) for c in point)
        square = exact_square(p, a, b)
        for bound, holds in ((found - slack, lambda d: d <= 0 or Fraction(d) ** 2 <= square),
                             (found + slack, lambda d: Fraction(d) ** 2 >= square)):
            if not holds(bound):
                sys.exit(f"case {case}: {found!r} is off by more than {slack:.3g} mm from the exact distance of {p} from {a}, {b}")
        worst = max(worst, abs(found - math.sqrt(square)) / slack)
    print(f"3500 distances; the worst is off by {worst:.2g} of the slack")


if __name__ == "__main__":
    main(sys.argv[1])
