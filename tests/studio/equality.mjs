// The page's engine beside the native program: the same spec, the same design.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { root } from "./browser.mjs";

export const program = process.env.KEMPE || path.join(root, "build/release/app/kempe");

/** Throws where two designs differ by more than twelve digits. */
export function compare(native, here, where) {
  if (typeof native === "number" && typeof here === "number") {
    const digits = /robust/.test(where.replace(/^[^.]*/, "")) ? 1e-10 : 1e-12;  // of the smallest of many proven gaps
    assert.ok(Math.abs(native - here) <= digits * Math.max(1, Math.abs(native)), `${where}: ${native} natively, ${here} here`);
  } else if (native && typeof native === "object") {
    assert.deepEqual(Object.keys(native), Object.keys(here), where);
    for (const key of Object.keys(native)) compare(native[key], here[key], `${where}.${key}`);
  } else assert.equal(here, native, where);
}

/** Without what may differ: the record of the search (the engine finishes without Ipopt), the verification, and the bound (it depends on the
 * order in which boxes are cut up; each is proven). */
export function comparable(design) {
  const { search: _, verification: __, ...rest } = design;
  const { lower_bound: ___, ...quality } = design.quality;
  return { ...rest, quality };
}

/** The native program's answer: {design}, {none: whether proven, sentence}, or {late: true} after so many seconds. */
export function natively(text, seconds = 600) {
  const folder = mkdtempSync(path.join(tmpdir(), "kempe-native-"));
  try {
    const spec = path.join(folder, "spec.toml");
    writeFileSync(spec, text);
    const run = spawnSync(program, ["synthesize", spec, "-o", path.join(folder, "out"), "--quiet", "--json"], { encoding: "utf8", maxBuffer: 1 << 28, timeout: 1000 * seconds });
    if (run.error && run.error.code === "ETIMEDOUT") return { late: true };
    if (run.status === 0) return { design: JSON.parse(readFileSync(path.join(folder, "out/design.json"), "utf8")) };
    if (![3, 6].includes(run.status)) throw new Error(`${program} ended with ${run.status}: ${run.stderr}`);
    const { proven, sentence } = JSON.parse(run.stdout);
    assert.equal(run.status, proven ? 3 : 6);
    return { none: proven, sentence };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The same from the page. */
export function inPage(page, text) {
  return page.evaluate((spec) => window.kempe.design(spec).then((design) => ({ design }), (why) => (why.no_design ? { none: why.proven, sentence: why.no_design } : { fault: JSON.stringify(why) })), text);
}

/** Random specs of bench/random_specs.py, as TOML. */
export function randomSpecs(count, seed) {
  const lines = execFileSync("python3", ["-c", `import json, random, sys
sys.path.insert(0, sys.argv[1])
import random_specs
rng = random.Random(int(sys.argv[3]))
for _ in range(int(sys.argv[2])): print(json.dumps(random_specs.spec(rng)))`, path.join(root, "bench"), String(count), String(seed)], { encoding: "utf8", maxBuffer: 1 << 28 });
  const written = (value) => (Array.isArray(value) ? `[${value.map(written).join(", ")}]` : value && typeof value === "object" ? `{${fields(value, ", ")}}` : JSON.stringify(value));
  const fields = (object, between) => Object.entries(object).map(([key, value]) => `${key} = ${written(value)}`).join(between);
  return lines.trim().split("\n").map((line) => `${fields(JSON.parse(line), "\n")}\n`);
}

/** What two answers have in common: "equal", "both none", or a sentence on where they part. */
export function verdictOn(native, here) {
  if (here.fault) return `the page: ${here.fault.slice(0, 200)}`;
  if (native.none !== undefined && here.none !== undefined) return native.none === here.none ? "both none" : `proven ${native.none} natively, ${here.none} here`;
  if (!native.design || !here.design) return native.design ? `none here: ${here.sentence}` : `none natively: ${native.sentence}`;
  try {
    compare(comparable(native.design), comparable(here.design), "design");
    return "equal";
  } catch (fault) {
    return fault.message.split("\n")[0];
  }
}
