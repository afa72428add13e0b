// What the page calls things, what it makes of the engine's sentences, and how it names a task. Without a browser.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import vm from "node:vm";
import { root, template } from "./browser.mjs";

const sources = ["reports/web/kinematics.js", ...["toml", "words", "naming", "ways", "shapes"].map((name) => `studio/page/${name}.js`)];
const { kempe } = vm.runInNewContext(`${sources.map((name) => readFileSync(`${root}${name}`, "utf8")).join("\n")}; globalThis`, {});
const schema = JSON.parse(readFileSync(`${root}docs/spec.schema.json`, "utf8"));
const spec = `title = "Mine"\n\n[copy]\nscale = 0.5\n\n[region]\nrectangle_mm = [0, 0, 120, 80]\n\n[pole]\nat_mm = [-50, 0]\n\n[limits]\nlongest_strip_mm = 150\ntransmission_deg = 60\n
[links]\nhardware = "M8 bolt"\nwidth_mm = 12\nsections_mm = [[40, 10]]\n\n[material]\nname = "PLA"\n\n[tolerance]\nlength_mm = 0.1\nplay_mm = 0.05\nrobust = true\n
[load]\npen_N = 10\n
[[obstacles]]\nname = "vice"\ncircle_mm = [10, 200, 5]\n\n[[obstacles]]\nname = "vice 2"\ncircle_mm = [50, 200, 5]\n`;
const doc = new kempe.Doc(spec), task = { region: [[[0, 0], [120, 0], [120, 80], [0, 80]]], pole: { within: [[[0, 0], [10, 0], [10, 10], [0, 10]]] } };
const isKey = (path) => { const [table, name] = path.split("."); return Boolean(schema.properties[table] && schema.properties[table].properties[name]); };
const way = (key, sentence) => kempe.wayOut({ key, sentence }, { doc, task, isKey });
const plain = (text) => text.replaceAll("\u00a0", " ");

test("A way out speaks in the panel's words, with a figure that is also the one written", () => {
  for (const [key, sentence, words, path, value] of [
    ["limits.longest_strip_mm", "limits.longest_strip_mm = 150 is in the way; 205.101 would do", "Longest strip: 205.2 mm", "limits.longest_strip_mm", 205.2],
    ["limits.transmission_deg", "limits.transmission_deg = 60 is in the way; 27.4831 would do", "Transmission angle, least: 27.4°", "limits.transmission_deg", 27.4],
    ["links.longest_mm", "links.longest_mm = 100 is in the way; 1234.51 would do", "Joints apart, most: 1234.6 mm", "links.longest_mm", 1234.6],
    ["limits.load_error_mm", "limits.load_error_mm = 0.001 is in the way; 0.0123456 would do", "Pen gives way, most: 0.0124 mm", "limits.load_error_mm", 0.0124],
    ["limits.clearance_mm", "limits.clearance_mm = 5 is in the way; 0.43219 would do", "Clearance of parts: 0.432 mm", "limits.clearance_mm", 0.432],
    ["links.wall_mm", "links.wall_mm = 9 is in the way: two holes of 8.4 mm with a wall of 9 mm between them stand 17.4 mm apart; 3.21987 would do", "Wall between holes: 3.21 mm", "links.wall_mm", 3.21],
    ["links.width_mm", "links.width_mm = 12 is in the way; 9.87654 would do", "Width of the links: 9.87654 mm", "links.width_mm", 9.87654],  // bearings may be as wide
    ["links.hardware", 'links.hardware = "M8 bolt" is in the way; "M5 bolt" would do', "Joints made of: M5 bolt", "links.hardware", "M5 bolt"],
    ["links.thickness_mm", "links.thickness_mm = 5 is in the way; 9.5 would do", "Thickness of the links: 9.5 mm", "links.thickness_mm", 9.5],
    ["links.sections_mm", "links.sections_mm has none that is stiff enough; with 48 x 10 added a design exists", "A strip of 48 × 10 mm", "links.sections_mm", [[40, 10], [48, 10]]],
    ["load.rests", 'load.rests does not name the tracer; with "tracer" added a design exists', "The tracer rests on the table", "load.rests", ["tracer"]],
    ["load.grip_mm", "load.grip_mm, left out, is the links' thickness, 5, which is in the way; 7.5 would do", "Pin held over: 7.5 mm", "load.grip_mm", 7.5],
    ["load.grip_mm", "load.grip_mm = 3 is in the way; 7.9375 would do", "Pin held over: 7.94 mm", "load.grip_mm", 7.94],
    ["tolerance.play_mm", "tolerance.play_mm = 0.02 is in the way; 0.013 would do", "Play of each pin: 0.013 mm", "tolerance.play_mm", 0.013],
    ["material.name", 'material.name = "PLA" is in the way; "birch plywood" would do', "Material: birch plywood", "material.name", "birch plywood"],
    ["pole.at_mm", "pole.at_mm is in the way; the pole at (10, -250) mm would do", "Pole at 10; −250 mm", "pole.at_mm", [10, -250]],
    ["pole.at_mm", "pole.at_mm is in the way; with the pole free to stand within 233.23 mm of the region a design exists", "Pole anywhere within 233.3 mm of the original", "pole.within_mm",
      [[-233.3, -233.3], [353.3, -233.3], [353.3, 313.3], [-233.3, 313.3]]],
    ["pole.within_mm", "pole.within_mm is in the way; the pole 4.5611 mm outside it would do", "Pole's area wider by 4.57 mm all round", "pole.within_mm", [[-4.57, -4.57], [14.57, -4.57], [14.57, 14.57], [-4.57, 14.57]]],
    ["tolerance.length_mm", "length_mm = 0.1 and play_mm = 0.05 are in the way; 0.0125 and 0.00625 would do", "Lengths exact to ± 0.0125 mm, play 0.00625 mm", "tolerance.play_mm", 0.00625],
    ["limits.longest_strip_mm", "limits.longest_strip_mm = 150 is in the way; left out, a design exists", "Without the limit “Longest strip”", "limits.longest_strip_mm", undefined],
    ["tolerance.robust", "robust = true is in the way; without it a design exists", "Without “Holds for all of these”", "tolerance.robust", undefined],
    ["obstacles", "vice 2 is in the way; without it a design exists", "Without vice 2", "obstacles.1.name", undefined],
  ]) {
    const made = way(key, sentence);
    assert.equal(plain(made.words), words);
    assert.deepEqual(JSON.stringify(new kempe.Doc(made.text).get(path)), JSON.stringify(value), sentence);
  }
  assert.equal(new kempe.Doc(way("obstacles", "vice 2 is in the way; without it a design exists").text).get("obstacles.0.name"), "vice");
  assert.equal(way("limits.nothing_mm", "limits.nothing_mm = 5 is in the way; 3 would do"), null);
});

test("A figure is rounded to the side on which a design exists, and by little", () => {
  let state = 5;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  for (let i = 0; i < 5000; ++i) {
    const value = 10 ** (8 * random() - 4), up = kempe.safely(value, true), down = kempe.safely(value, false);
    assert.ok(down <= value * (1 + 1e-12) && up >= value * (1 - 1e-12), `${down} ${value} ${up}`);
    assert.ok(up - down <= Math.min(0.1, 0.01 * value) + 1e-9 && String(up).length < 9, `${down} ${value} ${up}`);
    assert.equal(kempe.safely(up, true), up);
    assert.equal(kempe.safely(down, false), down);
  }
  for (const value of [0, 205.1, 0.3, 27.4]) for (const side of [true, false]) assert.equal(kempe.safely(value, side), value);
});

test("A reason names the limit as the panel does, with its unit", () => {
  for (const [sentence, words] of [
    ["limits.longest_strip_mm = 150 is in the way; 205.101 would do", "“Longest strip” (150 mm) is in the way; 205.2 mm would do"],
    ["limits.transmission_deg = 60 is in the way; 27.4831 would do", "“Transmission angle, least” (60°) is in the way; 27.4° would do"],
    ["limits.sheets_gap_mm = 5 is in the way: with the pole at (0, 0) mm the copy overlaps the original, whatever the links are; the pole must move (or be free), or limits.sheets_gap_mm must be left out",
      "“Gap, original to copy” (5 mm) is in the way: with the pole at (0, 0) mm the copy overlaps the original, whatever the links are; the pole must move (or be free), or “Gap, original to copy” must be left out"],
    ["no design keeps all limits together; none was found with one of these alone relaxed: limits.transmission_deg, links.longest_mm, obstacles, pole.at_mm",
      "No design keeps all limits together; none was found with one of these alone relaxed: “Transmission angle, least”, “Joints apart, most”, the obstacles, the place of the pole"],
    ["pole.at_mm is in the way; with the pole free to stand within 233.23 mm of the region a design exists", "The place of the pole is in the way; with the pole free to stand within 233.3 mm of the original a design exists"],
    ["length_mm = 0.1 and play_mm = 0.05 are in the way; 0.0125 and 0.00625 would do", "“Lengths exact to ±” (0.1 mm) and “Play of each pin” (0.05 mm) are in the way; 0.0125 mm and 0.00625 mm would do"],
    ["links.sections_mm has none that is stiff enough; with 48 x 10 added a design exists", "“Strips at hand” has none that is stiff enough; with 48 × 10 mm added a design exists"],
    ["with none of the 5 sections; with 40 x 10 mm: links.sections_mm has none that is stiff enough; with 48 x 10 added a design exists", "With none of the 5 sections; with 40 x 10 mm: “Strips at hand” has none that is stiff enough; with 48 × 10 mm added a design exists"],
    ["material.name = \"PLA\" is in the way; \"birch plywood\" would do", "“Material” (PLA) is in the way; \"birch plywood\" would do"],
    ["load.rests does not name the pen; with \"pen\" added a design exists", "“Rests on the table” does not name the pen; with \"pen\" added a design exists"],
    ["load.grip_mm, left out, is the links' thickness, 5, which is in the way; 7.5 would do", "“Pin held over”, left out, is the links' thickness, 5 mm, which is in the way; 7.5 mm would do"],
    ["robust = true is in the way; without it a design exists", "“Holds for all of these” is in the way; without it a design exists"],
    ["links.pin_diameter_mm = 12 is in the way: two holes of 12 mm with a wall of 1.2 mm between them stand 13.2 mm apart, and links.grid_mm leaves them 10 mm; 9.0912 would fit",
      "“Diameter of the pins” (12 mm) is in the way: two holes of 12 mm with a wall of 1.2 mm between them stand 13.2 mm apart, and “Lengths in steps of” leaves them 10 mm; 9.09 mm would fit"],
    ["vice 2 is in the way; without it a design exists", "“vice 2” is in the way; without it a design exists"],
  ]) assert.equal(plain(kempe.plainly(sentence, "", doc)), words);
});

test("Every key has a name that is not the key, and nothing points at a file that is not there", () => {
  const drawn = ["region", "pole", "obstacles", "bodies", "table", "mechanism"], labels = [];
  for (const [table, of] of Object.entries(schema.properties))
    for (const [name, { description }] of Object.entries(of.type === "object" && !drawn.includes(table) ? of.properties : {})) {
      const path = `${table}.${name}`, label = kempe.words.nameOf(path), meaning = kempe.words.meaningOf(path, description);
      assert.ok(!/_|docs\//.test(label + meaning) && /^[A-Z]/.test(label) && label.length < 26 && meaning.length > 5, `${path}: ${label}, ${meaning}`);
      labels.push(label);
    }
  assert.equal(new Set(labels).size, labels.length, "two keys of one name");
  assert.equal(kempe.words.meaningOf("new.key", "one that is known by its name (docs/loads.md), or not"), "one that is known by its name, or not");
});

test("A template's name is kept while its task is, then what the numbers say stands in for it", () => {
  const text = readFileSync(`${root}specs/templates/engraver-a7.toml`, "utf8"), origin = kempe.naming.originOf({ name: "engraver-a7", text });
  const named = (now, more = {}) => kempe.naming.fileName({ doc: new kempe.Doc(now), task: null, own: null, origin, ...more });
  assert.equal(named(text), "engraver-a7");
  const other = new kempe.Doc(text).with("limits.clearance_mm", 2);
  assert.equal(kempe.naming.withoutNames(other, origin), other, "another limit is the same task");
  assert.equal(named(other), "engraver-a7");
  const half = kempe.naming.withoutNames(new kempe.Doc(text).with("copy.scale", 0.5), origin), read = new kempe.Doc(half);
  assert.equal(read.get("title"), undefined);
  assert.equal(read.get("copy.scale"), 0.5);
  assert.match(half, /^# Begun with the template "Engraver for A7" and changed: its notes may speak of that\.\n\n\[copy\]\n/);
  assert.match(half, /# ground flat bar 15 x 5 mm/, "notes beside the keys stay");
  assert.equal(kempe.naming.withoutNames(half, origin), half);
  assert.equal(named(half), "copy-0.5x");
  assert.equal(named(new kempe.Doc(half).with("copy.rotation_deg", -90)), "copy-0.5x-270deg");
  const typed = new kempe.Doc(new kempe.Doc(text).with("title", "Für Jörg: a sign")).with("copy.scale", 2);
  assert.equal(new kempe.Doc(kempe.naming.withoutNames(typed, origin)).get("title"), "Für Jörg: a sign");
  assert.equal(named(typed), "fur-jorg-a-sign");
  assert.equal(named(text, { own: "plate", origin: null }), "plate");
  assert.equal(kempe.naming.heading({ doc: read, task: null, own: null }), "A copying instrument: × 0.5");
  const first = kempe.naming.originOf({ name: null, text: template("plagiograph") }), bigger = kempe.naming.withoutNames(new kempe.Doc(first.text).with("copy.scale", 2), first);
  assert.match(bigger, /^# Begun with an example and changed/);
});
