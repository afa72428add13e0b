// The studio's engine against the native program on random specs (bench/random_specs.py): how many designs agree to 12 digits.
// usage: node bench/studio_equality.mjs [COUNT] [SEED] [FIRST] [SECONDS]   (scripts/studio and scripts/build first)
// Prints a line a spec from the FIRST on, then a sum; a spec that takes the program more than SECONDS is left out.
import { launch, open, rested } from "../tests/studio/browser.mjs";
import { inPage, natively, randomSpecs, verdictOn } from "../tests/studio/equality.mjs";

const [count, seed, first, seconds] = [200, 1, 0, 600].map((usual, i) => Number(process.argv[2 + i] || usual));
const browser = await launch();
const { page, context } = await open(browser);
context.setDefaultTimeout(0);
await rested(page);
const sums = new Map(), ms = { native: 0, page: 0 };
for (const [i, text] of randomSpecs(count, seed).entries()) {
  if (i < first) continue;
  const begun = performance.now(), native = natively(text, seconds), between = performance.now();
  if (native.late) {
    console.log(`${i}: left out, more than ${seconds} s natively`);
    sums.set("left out", (sums.get("left out") || 0) + 1);
    continue;
  }
  const here = await inPage(page, text), end = performance.now();
  const verdict = verdictOn(native, here), sort = /^(equal|both none)$/.test(verdict) ? verdict : "different";
  const sizes = native.design && here.design ? ` (sizes ${native.design.quality.size_mm} and ${here.design.quality.size_mm})` : "";
  console.log(`${i}: ${verdict}${sort === "different" ? sizes : ""}, ${Math.round(between - begun)} ms natively, ${Math.round(end - between)} ms in the page`);
  sums.set(sort, (sums.get(sort) || 0) + 1);
  ms.native += between - begun;
  ms.page += end - between;
}
console.log(JSON.stringify({ count, seed, first, ...Object.fromEntries(sums), seconds_native: Math.round(ms.native / 1000), seconds_page: Math.round(ms.page / 1000) }));
await browser.close();
