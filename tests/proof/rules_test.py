#!/usr/bin/env python3
"""The independent checker is tested as the product: every rule has a file that only this rule refuses. Each case is a file with
something wrong and the rule that sees it. The checker must refuse the file; with that one rule taken out of its source it must
accept it, which shows that no other rule sees the fault and that the case tests the rule.

usage: rules_test.py SOURCE_DIR [unittest arguments]
"""
import cmath
import contextlib
import copy
import io
import json
import math
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock
from fractions import Fraction

import instruments
import mutations

SOURCE = pathlib.Path(sys.argv[1]).resolve()
TEXTS = {name: (SOURCE / "proof" / f"{name}.py").read_text(encoding="utf-8") for name in ("kempe_check", "limits_check", "tolerance_check", "bodies_check")}
FILES = SOURCE / "tests" / "proof" / "files"


def checker(old=None, new=None):
    """The checker, with a piece of its source replaced; the files beside it are `module.limits_check` and so on."""
    texts = dict(TEXTS)
    if old is not None:
        assert sum(text.count(old) for text in texts.values()) == 1, f"not once in the checker: {old}"
        texts = {name: text.replace(old, new) for name, text in texts.items()}
    modules = {name: types.ModuleType(name) for name in texts}
    with unittest.mock.patch.dict(sys.modules, modules):
        for name, module in modules.items():
            exec(compile(texts[name], name + ".py", "exec"), module.__dict__)
    for name in modules:
        setattr(modules["kempe_check"], name, modules[name])
    return modules["kempe_check"]


WHOLE = checker()


def files_beside(module):
    """In this context the checker finds the files beside it."""
    return unittest.mock.patch.dict(sys.modules, {name: getattr(module, name) for name in TEXTS})


def run(module, design, log=None):
    """The checker's exit code and what it printed."""
    with tempfile.TemporaryDirectory() as folder:
        names = []
        if design is not None:
            names.append(str(pathlib.Path(folder) / "design.json"))
            pathlib.Path(names[0]).write_text(json.dumps(design), encoding="utf-8")
        if log is not None:
            names.append(str(pathlib.Path(folder) / "certificate.jsonl"))
            pathlib.Path(names[-1]).write_text("".join(json.dumps(line) + "\n" for line in log), encoding="utf-8")
        out = io.StringIO()
        with contextlib.redirect_stdout(out), files_beside(module):
            try:
                return (0 if module.main(names) else 1), out.getvalue()
            except module.Unreadable as fault:
                return 2, str(fault)


def design(name):
    return json.loads((FILES / f"{name}.json").read_text(encoding="utf-8"))


def log(name):
    return [json.loads(line) for line in (FILES / f"{name}.jsonl").read_text(encoding="utf-8").splitlines()]


def changed(name, *path_and_value):
    """A stored design with one value replaced, or changed by a function of the old one."""
    out = design(name)
    *path, last, value = path_and_value
    at = out
    for key in path:
        at = at[key]
    at[last] = value(at[last]) if callable(value) else value
    return out


def rectangle(x0, y0, x1, y1):
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]


def obstacle(ring, layers):
    return {"name": "block", "shape": {"type": "MultiPolygon", "coordinates": [[ring]]}, "layers": layers}


def with_obstacle(name, ring, layers):
    return changed(name, "obstacles", [obstacle(ring, layers)])


def tolerant(name, copy_error, robust=False, clearance=None):
    """A stored design with a tolerance of 0.05 mm in lengths and play."""
    out = changed(name, "tolerance", {"length_mm": 0.05, "play_mm": 0.05, "robust": robust})
    out["limits"]["copy_error_mm"] = copy_error
    out["limits"]["clearance_mm"] = out["limits"]["clearance_mm"] if clearance is None else clearance
    return out


def walled_islands():
    """Two islands that the tracer reaches, and walls that the linkage cannot pass, whichever way round it goes."""
    out = changed("plagiograph", "region", "coordinates", [[rectangle(64, -1, 66, 1)], [rectangle(-66, -1, -64, 1)]])
    out["obstacles"] = [obstacle(rectangle(-60, 20, -20, 60), [1, 2]), obstacle(rectangle(20, -60, 60, -20), [1, 2])]
    return out


def with_holder(outline, *blocks):
    """A body in layer 2 at the pen that turns with BCY, and obstacles there."""
    out = changed("plagiograph", "obstacles", [obstacle(block, [2, 2]) for block in blocks])
    shape = {"type": "MultiPolygon", "coordinates": [[outline]]}
    out["bodies"] = [{"name": "holder", "at": "pen", "turns_with": "BCY", "shape": shape, "layers": [2, 2]}]
    return out


# name, the rule's source, what stands there without the rule, the file that only the rule refuses
DESIGN_RULES = [
    ("a length by 0.1 %", "need((self.exact[name] - length).size() <= EPS_MM", "need(True",
     lambda: changed("plagiograph", "mechanism", "lengths_mm", "CX", lambda v: 1.001 * v)),
    ("transmission", "max(0.0, task.transmission_deg - EPS_DEG)", "0.0",
     lambda: changed("plagiograph", "limits", "transmission_deg", lambda v: v + 0.001)),
    ("assembly mode", "shape.window(task.assembly,", "shape.window({0: 3, 3: 0, 1: 2, 2: 1}[task.assembly],", lambda: changed("plagiograph", "mechanism", "assembly", lambda v: {0: 3, 3: 0, 1: 2, 2: 1}[v])),
    ("parts of the linkage", "itself, self.pending_in", "[], self.pending_in",
     lambda: changed("plagiograph", "limits", "clearance_mm", design("plagiograph")["quality"]["clearance_min_mm"] + 0.002)),
    ("an obstacle moved into a link", "                left.append(pair)\n", "                pass\n",
     lambda: changed("two-layer", "obstacles", 0, "shape", "coordinates", 0, 0, lambda ring: [[x + 20, y] for x, y in ring])),
    ("an obstacle around everything", "where(at, pair.rings) > 0", "False",
     lambda: with_obstacle("plagiograph", rectangle(-900, -900, 900, 900), [1, 1])),
    ("islands behind a wall", "self.join(self.region[0][0], rings[0], blocked)", "pass", walled_islands),
    ("the axes of a body that turns", "one.ring = [(along * Z(*corner)).middle() for corner in one.ring]", "pass",
     lambda: with_holder(rectangle(5, -1, 79, 1))),
    ("a body that turns into an obstacle", 'turning(one, other.name, ["pole"], "table", wide, edges_of(block)) if one.link',
     "[] if one.link", lambda: with_holder(rectangle(5, -1, 60, 1), rectangle(-5, 71, -3, 73))),
    ("an obstacle within a body that turns", "refuse_overlaps(design, bodies, table)\n\n    def within",
     "None\n\n    def within", lambda: with_holder(rectangle(-12, -12, 40, 12), rectangle(-1, 91.5, 1, 93.5))),
    ("original and copy too near", "if task.sheets_gap_mm is not None:", "if False:",
     lambda: changed("free", "limits", "sheets_gap_mm", lambda v: v + 20)),
    ("a length over the limit", "off = [low - length, length - high]", "off = [0.0]",
     lambda: changed("plagiograph", "links", "longest_mm", 40)),
    ("a strip over the limit", "if strip is None else min(", "if True else min(",
     lambda: changed("plagiograph", "limits", "longest_strip_mm", 50)),
    ("a locked length", "if locked is None else (", "if True else (", lambda: changed("plagiograph", "links", "VA_mm", 100)),
    ("a grid", "if task.grid_mm else []", "if False else []", lambda: changed("plagiograph", "links", "grid_mm", 5)),
    ("a stock", "if task.stock_mm else []", "if False else []", lambda: changed("plagiograph", "links", "stock_mm", [30, 60])),
    ("a vertex not permitted", "vertex in task.groundings and", "", lambda: changed("plagiograph", "objective", "groundings", ["pole"])),
    ("a layer too high", "and max(design.layers.values()) <= task.layers", "", lambda: changed("plagiograph", "links", "layers", 1)),
    ("the pole elsewhere", "away <= EPS_MM or within(design.pole, task.pole)", "True",
     lambda: changed("plagiograph", "pole", "at_mm", [0.001, 0])),
    ("a copy error above its limit", "if sine.lo > 0 and not self.exceeding(slopes, (limit + EPS_MM) * sine.lo):", "if True:", lambda: tolerant("plagiograph", 0.8886)),
    ("a limit of the copy error without a tolerance", 'raise Open("limits.copy_error_mm without a tolerance")', "pass",
     lambda: changed("plagiograph", "limits", "copy_error_mm", 5)),
    ("no table of what was permitted", 'need(all(design.data.get(key) is not None for key in CHOICE), "not checked: pole, links, objective (not stated)")',
     "if design.data.get(\"links\") is None: return",
     lambda: changed("plagiograph", "links", None)),
    ("parts that a wrong instrument brings too near", "loss = self.losses(z)", "loss = lambda *which: 0.0",
     lambda: tolerant("free", None, True, 4.3)),
    ("the format", '{"kempe-design/1"}', '{"kempe-design/1", "kempe-design/2"}', lambda: changed("plagiograph", "format", "kempe-design/2")),
    ("a hole outside its polygon", "all(within(c, [rings[:1]]) for rings in found for c in sum(rings[1:], []))", "True",
     lambda: changed("plagiograph", "region", "coordinates", 0, lambda p: p + [rectangle(69, 0, 70.1, 1)])),
]


class Designs(unittest.TestCase):
    def test_a_body_that_turns_clear_of_all_is_proven(self):
        for outline in (rectangle(5, -1, 60, 1), rectangle(5, -1, 74, 1)):
            code, said = run(WHOLE, with_holder(outline, rectangle(200, 200, 210, 210)))
            self.assertEqual(code, 0, said)

    def test_a_corner_given_twice_is_proven(self):
        doubled = changed("plagiograph", "region", "coordinates", 0, 0, lambda ring: ring[:2] + ring[1:])
        self.assertEqual(run(WHOLE, doubled)[0], 0)

    def test_stored_designs_are_proven(self):
        for name in ("plagiograph", "two-layer", "free"):
            with self.subTest(name):
                self.assertEqual(run(WHOLE, design(name))[0], 0)

    def test_every_rule_has_a_file_that_only_it_refuses(self):
        for name, old, new, file in DESIGN_RULES:
            with self.subTest(name):
                code, said = run(WHOLE, file())
                self.assertNotEqual(code, 0, said)
                code, said = run(checker(old, new), file())
                self.assertEqual(code, 0, said)

    def test_what_cannot_be_read_is_told_with_its_key(self):
        for key, value, allowed in (("mechanism", 3, "a number"), ("obstacles", [{"shape": 1}], "MultiPolygon"), ("limits", {}, "a number"),
                                    ("pole", {"at_mm": [0, "x"]}, "a number"), ("pole", {}, "a table of at_mm or within_mm"),
                                    ("region", {"type": "MultiPolygon", "coordinates": [[[[1, 2], [3, 4], [5, 6], [7, 8]]]]}, "closed rings"),
                                    ("region", {"type": "MultiPolygon", "coordinates": []}, "polygons of closed rings")):
            with self.subTest(key):
                code, said = run(WHOLE, changed("plagiograph", key, value))
                self.assertEqual(code, 2, said)
                self.assertRegex(said, r"design.json: .*found .*allowed: .*" + allowed)

    def test_a_limit_that_no_rule_speaks_of_is_not_proven(self):
        for key in ("load_error_mm", "sag_mm"):
            code, said = run(WHOLE, changed("plagiograph", "limits", {**design("plagiograph")["limits"], key: 1e-9}))
            self.assertEqual(code, 1, said)
            self.assertIn(f"limits of the file: not proven: not checked: limits.{key}", said)

    def test_tolerances_without_their_file_are_not_proven(self):
        beside = {"tolerance_check": None}  # to import it fails
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.dict(sys.modules, beside):
            name, out = pathlib.Path(folder) / "design.json", io.StringIO()
            name.write_text(json.dumps(tolerant("plagiograph", None, True)), encoding="utf-8")
            with contextlib.redirect_stdout(out):
                self.assertFalse(WHOLE.main([str(name)]))
            self.assertRegex(out.getvalue(), "5 every instrument .*: not proven: .*tolerance_check")

    def test_one_file_proves_claims_1_to_4_alone(self):
        """Without the files beside it, it proves what has no body and no tolerance; of all else it says which file it needs."""
        router = {"name": "router", "at": "pen", "circle_mm": {"centre": [0.0, 0.0], "radius": 1.0}, "layers": [1, 1]}
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(SOURCE / "proof" / "kempe_check.py", folder)

            def said_of(value):
                (pathlib.Path(folder) / "design.json").write_text(json.dumps(value), encoding="utf-8")
                ran = subprocess.run([sys.executable, "kempe_check.py", "design.json"], cwd=folder, capture_output=True, text=True)
                return ran.returncode, ran.stdout

            its_log = [sys.executable, "kempe_check.py", FILES / "plagiograph.jsonl"]
            self.assertEqual(subprocess.run(its_log, cwd=folder, capture_output=True).returncode, 0)
            code, said = said_of(design("plagiograph"))
            self.assertEqual((code, re.findall("^([12]).*: proven", said, re.MULTILINE)), (1, ["1", "2"]), said)
            self.assertIn("limits of the file: not proven: needs limits_check.py", said)
            shutil.copy(SOURCE / "proof" / "limits_check.py", folder)
            self.assertEqual(said_of(design("plagiograph"))[0], 0)
            for wrong, needs in ((changed("plagiograph", "bodies", [router]), "bodies_check"),
                                 (tolerant("plagiograph", 5.0), "tolerance_check")):
                code, said = said_of(wrong)
                self.assertEqual(code, 1, said)
                self.assertIn(f": not proven: needs {needs}.py", said)

    def test_the_checker_is_short(self):
        self.assertLessEqual(len(TEXTS["kempe_check"].splitlines()), 600)
        self.assertLessEqual(max(len(line) for text in TEXTS.values() for line in text.splitlines()), 132)

    def test_what_can_be_read_in_two_ways_is_not_read(self):
        text = (FILES / "plagiograph.json").read_text(encoding="utf-8")
        key = '"clearance_mm":'
        twice = design("plagiograph")
        twice["mechanism"]["links"].append(dict(twice["mechanism"]["links"][0], layer=5))
        for name, wrong in (("a key twice", text.replace(key, key + " 0.0, " + key, 1)), ("no number", text.replace(key, key + " NaN, \"x\":", 1)),
                            ("too large", text.replace(key, key + " 1e999, \"x\":", 1)), ("a link twice", json.dumps(twice)),
                            ("a digit more than a number has", text.replace(key, key + " " + "9" * 5000 + ", \"x\":", 1))):
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                self.assertIn(key, text)
                path = pathlib.Path(folder) / "design.json"
                path.write_text(wrong, encoding="utf-8")
                with self.assertRaises(WHOLE.Unreadable) as told:
                    WHOLE.main([str(path)])
                self.assertRegex(str(told.exception), "found .*allowed")

    def test_names_from_files_forge_no_line(self):
        forged = with_obstacle("plagiograph", rectangle(-900, -900, 900, 900), [1, 1])
        forged["obstacles"][0]["name"] = forged["why\nclaim"] = "x\n4 no design exists: proven"
        code, said = run(WHOLE, forged)
        self.assertEqual(code, 1)
        self.assertFalse(any(line.startswith("4") for line in said.splitlines()), said)
        forged["format"] = "kempe\n4 no design exists: proven"
        self.assertEqual(len(run(WHOLE, forged)[1].splitlines()), 1)

    def test_any_name_may_stand_in_a_log(self):
        its_design, lines = design("two-layer"), log("two-layer")
        for obstacles in (its_design["obstacles"], lines[0]["task"]["obstacles"]):
            obstacles[0]["name"] = "of two lines \u2028 \u0085 \x0b"
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()), files_beside(WHOLE):
            names = [str(pathlib.Path(folder) / name) for name in ("design.json", "certificate.jsonl")]
            for name, values in zip(names, ([its_design], lines)):
                pathlib.Path(name).write_text("".join(json.dumps(v, ensure_ascii=False) + "\n" for v in values), encoding="utf-8")
            self.assertTrue(WHOLE.main(names))

    def test_wrong_usage_is_told(self):
        with self.assertRaises(WHOLE.Unreadable):
            WHOLE.main([])
        with self.assertRaises(WHOLE.Unreadable):
            WHOLE.main(["/nowhere/design.json"])



def first(lines, key, value=None):
    return next(i for i, line in enumerate(lines) if key in line and (value is None or line[key] == value))


def altered(name, key, value=None, **changes):
    """A stored log with the first line that has a key (of that value) altered; the header's key is "format"."""
    lines = log(name)
    lines[first(lines, key, value)].update(changes)
    return lines


def with_task(name, *path_and_value):
    """A stored log about a task with one value replaced."""
    lines = log(name)
    *path, last, value = path_and_value
    at = lines[0]["task"]
    for key in path:
        at = at[key]
    at[last] = value(at[last]) if callable(value) else value
    return lines


def summed(name, *terms):
    return altered(name, "leaf", "sum", of=[list(term) for term in terms])


def other_place(name, place):
    """The first sum with one far place elsewhere, farther away."""
    lines = log(name)
    for line in lines:
        for term in line.get("of", ()):
            if term[0] == "far":
                term[1] = place
                return lines
    raise AssertionError


def instead(name, leaf, **fields):
    """Stored logs, each with one sum replaced by another leaf: what it says is false of that box."""
    for i, line in enumerate(log(name)):
        if line.get("leaf") == "sum":
            yield log(name)[:i] + [{"leaf": leaf, **fields}] + log(name)[i + 1:]


def split_of_a_point(name):
    """The pole stands at one place; a split there gives the same box twice."""
    lines = log(name)
    i = first(lines, "leaf", "sum")
    return lines[:i] + [{"split": "x", "at": 0.0}, lines[i]] + lines[i:]


def closed_by(line, *path_and_value, claim="none", objective="size", bound=None):
    """A log about the plagiograph's task with one value replaced, in which one line closes every root."""
    header = with_task("plagiograph", *path_and_value)[0]
    header.update(claim=claim, objective=objective, bound=bound)
    return [header] + [line] * 12


def too_wrong(limit, cosines):
    """A log by which all openings but those between two cosines exceed the limit on the copy error."""
    lines = closed_by({"copy_error": cosines}, "tolerance", {"length_mm": 0.05, "play_mm": 0.05})
    lines[0]["task"]["limits"]["copy_error_mm"] = limit
    return lines


def met(point, radius=500.0, **things):
    """A log by which, with the tracer at a place, a point is in what the pen carries, or in what `things` says."""
    lines = closed_by({"leaf": "obstacle", "obstacle": 0, "edge": None, "place": [66.0, 0.0], "point": point}, "links", "VA_mm", 60.0)
    lines[0]["task"]["links"]["VB_mm"] = 60.0
    router = {"name": "router", "at": "pen", "circle_mm": {"centre": [0.0, 0.0], "radius": radius}, "layers": [1, 8]}
    lines[0]["task"].update(things or {"bodies": [router]})
    return lines


def all_around(point):
    """A log by which a point of any design stands in an obstacle on which all of the task lies."""
    return closed_by({"leaf": "obstacle", "obstacle": 0, "edge": None, "place": [66.0, 0.0], "point": point},
                     "obstacles", [obstacle(rectangle(-900, -900, 900, 900), [1, 8])])


def deep_inside(ring, point):
    """A log by which a point that b moves by some ten millimetres stands in an obstacle."""
    lines = closed_by({"leaf": "obstacle", "obstacle": 0, "edge": None, "place": [66.0, 0.0], "point": point},
                      "obstacles", [obstacle(ring, [1, 8])])[:5]
    task = lines[0]["task"]
    task["links"].update(VA_mm=60.0, shortest_mm=40.0, longest_mm=86.0)
    task["objective"]["groundings"] = ["pole"]
    return lines


OUT_OF_REACH = {"leaf": "sum", "of": [["far", [0, 0, 1, 0.0], 1.0]]}


def dented(ring):
    """A ring with a dent of a hundredth of a millimetre in its last edge."""
    (x0, y0), (x1, y1) = ring[-2], ring[-1]
    return ring[:-1] + [[(x0 + x1) / 2 + 0.01, (y0 + y1) / 2], ring[-1]]


# name, the rule's source, what stands there without the rule, the log that only the rule refuses; its design, if it is needed
LOG_RULES = [
    ("a line too many", "self.at == len(self.lines) - 1,", "True,", lambda: log("plagiograph") + log("plagiograph")[-1:]),
    ("a split beside the box", "need(old.lo < at < old.hi,", "need(True,", lambda: split_of_a_point("plagiograph")),
    ("a sum that is not negative", "return most.hi < 0", "return True", lambda: summed("plagiograph", ["bound", 0.0])),
    ("a negative weight", "need(0 <= weight < 1e9,", "need(True,", lambda: summed("plagiograph", ["posts", [66, 0], -1.0])),
    ("a bound for another objective", 'need(name != "bound" or self.by == "size",', "need(True,",
     lambda: altered("plagiograph", "format", objective="transmission", bound=1.0)),
    ("a place outside the region", "need(within(fits([*value], POINT, \"place\"), self.task.region),", "need(True,",
     lambda: other_place("plagiograph", [9e5, 0.0])),
    ("a place beyond its edge", "and 0 <= t <= 1,", ",", lambda: other_place("plagiograph", [0, 0, 0, 1e5])),
    ("lengths that are permitted", "any(i.lo > i.hi for i in node.box.values())", "True",
     lambda: next(instead("plagiograph", "lengths"))),
    ("assignments that are left", 'return not node.assignments', 'return True', lambda: next(instead("plagiograph", "layers"))),
    ("sheets that are apart", "return max(way.square().hi for way in ways) < I(self.task.sheets_gap_mm).square().lo", "return True",
     lambda: altered("free", "leaf", "sheets", places=[[-40, 0], [40, 30]])),
    ("a contact that is none", 'need(met, "the points', 'need(True, "the points',
     lambda: altered("two-layer", "contact", contact=[["VA", 0.0], ["BCY", 0.0, 0.0]])),
    ("parts of different layers", "need(0 < u.lo < 1e9 and keep_apart,", "need(True,",
     lambda: altered("two-layer", "contact", contact=[["VA", 0.0], ["VB", 0.0]])),
    ("a contact of a part with itself", "may_meet(one[0], other[0]) and all(", "all(",
     lambda: altered("two-layer", "contact", contact=[["VA", 0.0], ["VA", 0.01]])),
    ("an obstacle in other layers", 'need(meets, "the part', 'need(True, "the part',
     lambda: with_task("block", "obstacles", 0, "layers", [7, 8])),
    ("an obstacle out of reach", "+ slack < allowed for p in points)", "> -1e9 for p in points)",
     lambda: altered("block", "leaf", "obstacle", point=["VA", 0.0])),
    ("a point beside an obstacle, not in it", "if where(p, [ring]) > 0", "if len(ring) > 3",
     lambda: deep_inside(rectangle(-900, -900, 900, 20), ["VB", 1.0])),
    ("a point not deep enough in an obstacle", "least = min(hypot", "least = max(hypot",
     lambda: deep_inside(rectangle(-900, -900, 900, 40.9), ["VB", 1.0])),
    ("a point that the lengths move", "at and joint in COPIED", "True", lambda: all_around(["VB", 0.5])),
    ("an obstacle that is not convex", "need(convex_piece,", "need(True,",
     lambda: with_task("block", "obstacles", 0, "shape", "coordinates", 0, 0, dented)),
    ("a link that carries the body", "block.joint not in JOINTS[part] and ", "", lambda: met(["BCY", 0.0, 0.0])),
    ("a body out of reach", "block.beyond) * (1 - 1e-15)", "1e9)", lambda: met(["ACX", 0.0, 0.0], 1.0)),
    ("a body seen from elsewhere", "start=at - o)", "start=NIL)", lambda: met(["ACX", 0.0, 0.0], 1.0)),
    ("a body in no layer of the part", 'need(meets, "the part', 'need(True, "the part', lambda: met(["pin A"])),
    ("a place on the table", "[ring_of(table, \"task.table\"), []]", "[ring_of(table, \"task.table\")]",
     lambda: met(["ACX", 0.0, 0.0], table={"type": "MultiPolygon", "coordinates": [[rectangle(-900, -900, 900, 900)]]})),
    ("a copy error within its limit", "tolerances.exceeded(low, high)", "pass",
     lambda: too_wrong(0.8, [0.0, 0.0])),
    ("a copy error within its limit, without a design left", "tolerances.exceeded(low, high)", "pass",
     lambda: too_wrong(0.8, [0.0, 0.5])),
    ("a copy error that is no number", "fits(line[\"copy_error\"], [(-1.0, 1.0)] * 2, \"copy_error\")", "line[\"copy_error\"]", lambda: too_wrong(0.8, [math.nan, math.nan])),
    ("another task", "need(log.data[\"task\"].get(key) == theirs[key],", "need(True,",
     lambda: with_task("plagiograph", "cutting", "gap_mm", 6), "plagiograph"),
    ("a weaker bound than the file's", "over * (stated.lower_bound - bound) <= EPS_MM", "True",
     lambda: altered("plagiograph", "format", bound=log("plagiograph")[0]["bound"] - 1), "plagiograph"),
]


class Logs(unittest.TestCase):
    def test_stored_logs_are_proven(self):
        for name in ("plagiograph", "two-layer", "free"):
            with self.subTest(name):
                self.assertEqual(run(WHOLE, design(name), log(name))[0], 0)
        self.assertIn("4 no design exists: proven", run(WHOLE, None, log("block"))[1])

    def test_every_rule_has_a_log_that_only_it_refuses(self):
        for name, old, new, file, *design_name in LOG_RULES:
            with self.subTest(name):
                its_design = design(design_name[0]) if design_name else None
                code, said = run(WHOLE, its_design, file())
                self.assertEqual(code, 1, said)
                code, said = run(checker(old, new), its_design, file())
                self.assertEqual(code, 0, said)

    def test_an_objective_without_rules_is_told(self):
        code, said = run(WHOLE, None, closed_by(OUT_OF_REACH, "links", "longest_mm", 20, claim="bound", objective="footprint", bound=1.0))
        self.assertEqual(code, 2, said)
        self.assertIn("objective: found footprint; allowed: size or transmission", said)

    def test_no_design_is_proven_by_one_line_a_root(self):
        for line, *change in (
                (OUT_OF_REACH, "links", "longest_mm", 20),
                ({"leaf": "lengths"}, "links", "shortest_mm", 399),
                ({"leaf": "layers"}, "links", "layers", 1),
                ({"leaf": "sum", "of": [["posts", [66, 0], 1.0]]}, "pole", {"at_mm": [66, 0]})):
            with self.subTest(change):
                code, said = run(WHOLE, None, closed_by(line, *change))
                self.assertEqual(code, 0, said)
                self.assertIn("4 no design exists: proven (12 nodes)", said)

    def test_an_obstacle_at_a_copied_joint_proves_that_there_is_no_design_whatever_the_lengths_are(self):
        for point in (["VA", 0.0], ["ACX", 0.0, 1.0], ["BCY", 0.0, 1.0]):
            with self.subTest(point):
                code, said = run(WHOLE, None, all_around(point))
                self.assertEqual(code, 0, said)
                self.assertIn("4 no design exists: proven (12 nodes)", said)
        for point in (["VA", 0.5], ["ACX", 0.0, 0.99], ["pin C"]):
            with self.subTest(point):
                self.assertEqual(run(WHOLE, None, all_around(point))[0], 1)

    def test_a_point_deep_in_an_obstacle_may_move_farther_than_it_reaches(self):
        """By 4.5 mm beyond what the corners say; half width and clearance are 3.5 mm."""
        code, said = run(WHOLE, None, deep_inside(rectangle(-900, -900, 900, 900), ["VB", 1.0]))
        self.assertEqual(code, 0, said)
        self.assertIn("4 no design exists: proven (4 nodes)", said)

    def test_a_body_that_is_met_proves_that_there_is_no_design(self):
        for lines in (met(["ACX", 0.0, 0.0]), met(["ACX", 1.0, 0.0])):
            code, said = run(WHOLE, None, lines)
            self.assertEqual(code, 0, said)
            self.assertIn("4 no design exists: proven (12 nodes)", said)

    def test_a_limit_that_no_opening_keeps_is_proven_to_be_one(self):
        """The least copy error of every mode is above 0.52 mm: one line closes every root."""
        for limit, code in ((0.01, 0), (0.5, 0), (0.8, 1)):
            with self.subTest(limit):
                self.assertEqual(run(WHOLE, None, too_wrong(limit, [0.0, 0.0]))[0], code)

    def test_a_window_that_is_not_cut_stays_as_it_is(self):
        """A cut from 1 to -1 claims nothing: the log is proven with it as without."""
        lines = log("plagiograph")
        certificate = WHOLE.Certificate("log", [lines[0]])
        certificate.shape, (certificate.sign, certificate.sign_d) = WHOLE.Shape(certificate.task, "pole"), (1, 1)
        root = certificate.root(1)
        with unittest.mock.patch.dict(sys.modules, {"tolerance_check": WHOLE.tolerance_check}):
            self.assertEqual(certificate.step(root, {"copy_error": [1.0, -1.0]}), [root])

    def test_a_line_left_out_or_exchanged_is_refused(self):
        lines = log("plagiograph")
        for i in random.Random(1).sample(range(1, len(lines)), 12):
            for wrong in (lines[:i] + lines[i + 1:], lines[:i] + [{"leaf": "layers"}] + lines[i + 1:]):
                self.assertEqual(run(WHOLE, None, wrong)[0], 1)

    def test_material_points_lie_on_their_parts(self):
        certificate = WHOLE.Certificate("log", log("plagiograph"))
        certificate.shape = WHOLE.Shape(certificate.task, "pole")
        for point in (["VA", 0.5], ["ACX", 0.0, 1.0], ["BCY", 1.0, 0.0], ["pin A"], ["post Y"]):
            certificate.material(point)
        for point in (["VA", 1.5], ["VA", -0.1], ["VA"], ["ACX", 0.5, 0.5], ["BCY", 0.0, 1.1], ["pin A", 0.5], ["ACX", 0.0, 1.0 + 2e-16], ["post A"], ["VX", 0.5]):
            with self.assertRaises((WHOLE.Open, KeyError)):
                certificate.material(point)


class Intervals(unittest.TestCase):
    """Every result of interval arithmetic holds the exact one, in fractions; every slope holds the difference quotient's limit."""

    def test_operations_hold_the_exact_result(self):
        chance, I = random.Random(3), WHOLE.I
        numbers = [0.0, 1.0, -1.0, 5e-324, 1e-200, -1e-170, 1e60, 1 / 3] + [chance.uniform(-9, 9) * 10 ** chance.randint(-9, 9) for _ in range(60)]
        for _ in range(4000):
            x, y = chance.choice(numbers), chance.choice(numbers)
            exact = {"+": Fraction(x) + Fraction(y), "-": Fraction(x) - Fraction(y), "*": Fraction(x) * Fraction(y)}
            found = {"+": I(x) + I(y), "-": I(x) - I(y), "*": I(x) * I(y)}
            if abs(y) > 1e-100:
                exact["/"], found["/"] = Fraction(x) / Fraction(y), I(x) / I(y)
            exact["square"], found["square"] = Fraction(x) ** 2, I(x).square()
            for name, interval in found.items():
                self.assertLessEqual(Fraction(interval.lo), exact[name], (name, x, y))
                self.assertGreaterEqual(Fraction(interval.hi), exact[name], (name, x, y))
            root = I(abs(x)).sqrt()
            self.assertLessEqual(Fraction(root.lo) ** 2, Fraction(abs(x)))
            self.assertGreaterEqual(Fraction(root.hi) ** 2, Fraction(abs(x)))

    def test_circle_holds_known_angles(self):
        for degrees, cosine_squared in ((0, 1), (30, Fraction(3, 4)), (45, Fraction(1, 2)), (60, Fraction(1, 4)), (90, 0), (240, Fraction(1, 4)),
                                        (-330, Fraction(3, 4))):
            turn = WHOLE.unit_circle(float(degrees))
            for found, exact in ((turn.x, cosine_squared), (turn.y, 1 - cosine_squared)):
                low, high = sorted((abs(Fraction(found.lo)), abs(Fraction(found.hi))))
                self.assertTrue(low ** 2 <= exact <= high ** 2, degrees)

    def test_windows_are_those_of_the_modes(self):
        """Opening less arg s, over a mode shortened at both ends, runs through the window and has the mode's sign."""
        chance = random.Random(5)
        for _ in range(200):
            d = design("plagiograph")
            d["copy"] = {"scale": chance.uniform(0.2, 3), "rotation_deg": chance.choice([0.0, 180.0, chance.uniform(-170, 170)])}
            d["mechanism"]["vertex"] = chance.choice(["pole", "tracer", "pen"])
            d["mechanism"]["assembly"] = mode = chance.randrange(2 if d["copy"]["rotation_deg"] % 180 == 0 else 4)
            judge, shape = mutations.Judge(d), WHOLE.Design("d", d).shape
            low, high = judge.interval()
            limit = chance.uniform(0, 0.4) * (high - low)
            most, least = shape.window(mode, math.degrees(limit))
            ends = sorted(math.cos(end - cmath.phase(judge.s)) for end in (low + limit, high - limit))
            self.assertAlmostEqual(ends[0], least.middle(), 11)
            self.assertAlmostEqual(ends[1], most.middle(), 11)
            middle = 0.5 * (low + high)
            signs = [math.copysign(1, math.sin(middle - cmath.phase(judge.s))), math.copysign(1, math.sin(middle))]
            self.assertEqual(list(shape.signs(mode)), signs)

    def test_cells_hold_all_of_a_region(self):
        """Every place of a region with holes and dents is in the hull of a cell, and no hull has a corner outside the region."""
        chance, outer, hole = random.Random(7), rectangle(0, 0, 8, 6), rectangle(3, 2, 5, 4)
        dented = [(0.3, 0.1), (7.9, 0.4), (4.1, 2.2), (7.7, 5.9), (4.3, 3.1), (0.2, 5.8), (0.3, 0.1)]
        for rings in ([outer], [outer, hole], [dented], [outer, [(x / 2 + 1, y / 2 + 1) for x, y in dented]], [[(1, 2), (7, 5), (1, 2)]]):
            rings, cells = [[tuple(map(float, corner)) for corner in ring] for ring in rings], []

            def halved(box, hull, pending):
                cells.append((box, hull, pending))
                return pending - 1 or None
            WHOLE.cover(rings, 7, halved)
            self.assertGreater(len(cells), 30)
            near = [min(math.hypot(*WHOLE.to_segment(corner, *edge)) for edge in WHOLE.edges_of(rings))
                    for _, hull, _ in cells for corner in hull if WHOLE.where(corner, rings) < 0]
            self.assertLess(max(near, default=0.0), 1e-14)
            places = [(chance.uniform(0, 8), chance.uniform(0, 6)) for _ in range(300)] + [corner for ring in rings for corner in ring]
            for place in (place for place in places if WHOLE.where(place, rings) >= 0):
                self.assertTrue(any(surrounds(hull, place) for _, hull, pending in cells if pending == 1), (rings, place))

    def test_joints_over_a_box_hold_the_joints_of_its_places(self):
        """The mean value form against the judge's angles, in every mode and vertex."""
        chance, seen = random.Random(4), 0
        for _ in range(60):
            judge, checked, z = any_linkage(chance)
            r = 1e-3 * abs(z)
            area = WHOLE.Z(*(WHOLE.I(x - r, x + r, {v: WHOLE.ONE}) for v, x in (("x", z.real), ("y", z.imag))))
            try:
                moving = checked.seen(area)
            except WHOLE.Open:  # too near to a dead point for so large a box
                continue
            seen += 1
            middle = judge.pose(judge.pole + z)[0]
            for _ in range(10):
                step = complex(chance.uniform(-r, r), chance.uniform(-r, r))
                joints = judge.pose(judge.pole + z + step)[0]
                for j in joints:
                    for c, now, then in ((moving[j].x, joints[j].real, middle[j].real), (moving[j].y, joints[j].imag, middle[j].imag)):
                        slopes = c.d or {}
                        change = slopes.get("x", WHOLE.ZERO) * step.real + slopes.get("y", WHOLE.ZERO) * step.imag
                        self.assertTrue(change.lo - 1e-9 <= now - then <= change.hi + 1e-9, (judge.k, j))
        self.assertGreater(seen, 40)


def surrounds(hull, place):
    """Whether a place is in the hull of points, which then leave no more than half a turn free around it."""
    turns = sorted(math.atan2(y - place[1], x - place[0]) for x, y in hull if (x, y) != place)
    gaps = [b - a for a, b in zip(turns, turns[1:])] + [turns[0] + 2 * math.pi - turns[-1]] if turns else [0.0]
    return place in hull or len(turns) > 1 and max(gaps) <= math.pi + 1e-9


def any_linkage(chance):
    """A linkage of any ratio, vertex and mode with the lengths of a stored one: its judge, the checker's view and a place from the pole."""
    d = design("plagiograph")
    d["copy"] = {"scale": chance.uniform(0.2, 3), "rotation_deg": chance.choice([0.0, 180.0, 2.0, chance.uniform(-170, 170)])}
    d["mechanism"]["vertex"] = chance.choice(["pole", "tracer", "pen"])
    d["mechanism"]["assembly"] = chance.randrange(2 if d["copy"]["rotation_deg"] % 180 == 0 else 4)
    d["mechanism"]["pole_position_mm"] = [0.0, 0.0]
    d["tolerance"] = {"length_mm": chance.choice([0.0, 0.01]), "play_mm": chance.choice([0.0, 0.01]), "robust": True}
    judge, checked = mutations.Judge(d), WHOLE.Design("d", d)
    low, high = judge.interval()
    opening = chance.uniform(0.7 * low + 0.3 * high, 0.3 * low + 0.7 * high)
    w = judge.a + judge.b * cmath.exp(1j * (opening - cmath.phase(judge.s)))
    return judge, checked, w * cmath.exp(1j * chance.uniform(0, 6)) / {"pole": 1, "tracer": -1, "pen": -judge.k}[judge.vertex]


class Tolerances(unittest.TestCase):
    """Claim 5 and the copy error's limit, against instruments that are closed by Newton's method."""

    def test_slopes_hold_what_instruments_do(self):
        """Every way between two holes of random instruments is within what the checker allows it, in many directions."""
        chance, seen = random.Random(6), 0
        for _ in range(150):
            judge, checked, z = any_linkage(chance)
            r = WHOLE.I(abs(z))
            try:
                tolerances = WHOLE.tolerance_check.Tolerances(checked)
                way, _ = tolerances.instrument(r, WHOLE.Z(r, 0.0))
                start = instruments.Instrument(judge, {}).closed(judge.pole + abs(z))
                wrong = instruments.Instrument(judge, instruments.random_off(chance, checked.task.length_mm, checked.task.play_mm)).closed(judge.pole + abs(z))
            except (WHOLE.Open, instruments.Broken):  # too near to a dead point, or too flat a plate
                continue
            seen += 1
            names = {(link, joint): WHOLE.tolerance_check.HOLES[link][link.index(joint)] for link, joint in start}
            for i, j in [chance.sample(sorted(names), 2) for _ in range(12)]:
                n = cmath.rect(1, chance.uniform(0, 6.3))
                moved = (wrong[j] - wrong[i]) - (start[j] - start[i])
                slopes = WHOLE.tolerance_check.slopes_of(way(names[i], names[j]))
                self.assertLessEqual((moved * n.conjugate()).real, tolerances.loss((n.real, n.imag), slopes) + 1e-9, (judge.k, judge.vertex, i, j))
        self.assertGreater(seen, 75)

    def test_no_instrument_of_a_proven_design_is_nearer(self):
        for name, clearance in (("free", 3.8), ("plagiograph", 10.3)):
            with self.subTest(name):
                robust = tolerant(name, None, True, clearance)
                self.assertIn("5 every instrument within the tolerances stays on one assembly mode and keeps the clearance: proven", run(WHOLE, robust)[1])
                self.assertGreater(instruments.smallest_gap(robust, 60, random.Random(2)), clearance)

    def test_what_some_instrument_breaks_is_not_proven(self):
        for name in ("free", "plagiograph", "two-layer"):
            with self.subTest(name):
                robust = tolerant(name, None, True)
                robust["limits"]["clearance_mm"] = 0.0
                robust["limits"]["clearance_mm"] = max(0.0, instruments.smallest_gap(robust, 60, random.Random(2))) + 0.01
                self.assertEqual(run(WHOLE, robust)[0], 1)
                self.assertIn("5 every instrument within the tolerances stays on one assembly mode and keeps the clearance: not proven", run(WHOLE, robust)[1])

    def test_copy_error_is_that_of_instruments(self):
        """The limit is proven a little above the largest copy error that instruments have, and refuted a little below it."""
        chance, seen = random.Random(8), 0
        for name in ("free", "plagiograph", "two-layer"):
            largest = instruments.largest_copy_error(tolerant(name, None))
            self.assertEqual(run(WHOLE, tolerant(name, largest * 1.0001))[0], 0, name)
            self.assertIn("limits of the file: refuted: copy error", run(WHOLE, tolerant(name, largest * 0.9999))[1])
        for _ in range(60):
            judge, checked, z = any_linkage(chance)
            p = judge.pose(judge.pole + z)[0]
            opening = cmath.phase((p["B"] - p["V"]) / (p["A"] - p["V"]))
            if abs(math.sin(opening)) < 0.05:  # differences are rough so near to a change point
                continue
            tolerances = WHOLE.tolerance_check.Tolerances(checked)
            tolerances.sign_d = math.copysign(1, math.sin(opening))
            tolerances.sign = math.copysign(1, math.sin(opening - cmath.phase(judge.s)))
            sine, slopes = tolerances.sources(WHOLE.I(math.cos(opening - cmath.phase(judge.s))))
            try:
                errors = instruments.slopes_of_pen(judge, judge.pole + z)
            except instruments.Broken:
                continue
            seen += 1
            for source, error in errors.items():
                x, y, _, _ = slopes.get(source, (0.0, 0.0, 0, 0))
                if not source.endswith(("x", "y")):
                    self.assertLess(abs(math.hypot(x, y) / sine.middle() - abs(error)), 2e-3 * (1 + abs(error)), (judge.k, judge.vertex, source))
        self.assertGreater(seen, 40)


class Mutations(unittest.TestCase):
    """Random single changes of designs and logs: one that is accepted must not have changed the truth."""

    def test_random_mutations_of_designs(self):
        with files_beside(WHOLE):
            found = mutations.designs(WHOLE, 200, 1)
        self.assertEqual(found["wrong"], [])
        self.assertGreater(min(found["refused"], found["true"]), 40)

    def test_random_mutations_of_logs(self):
        with files_beside(WHOLE):
            found = mutations.logs(WHOLE, 200, 2)
        self.assertEqual(found["wrong"], [])
        self.assertGreater(min(found["refused"], found["true"]), 40)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
