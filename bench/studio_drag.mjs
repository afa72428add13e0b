// How long the studio takes from a hand's move to the picture: a handle of the original is dragged about in headless Chromium.
// usage: node bench/studio_drag.mjs [STEPS] [TEMPLATE ...]      (scripts/studio first; prints one JSON line a template)
import { launch, open, rested } from "../tests/studio/browser.mjs";
import { drag, memory } from "../tests/studio/dragging.mjs";

const steps = Number(process.argv[2] || 1000);
const templates = process.argv.length > 3 ? process.argv.slice(3) : ["plagiograph", "nameplate", "clamped-plate", "pantorouter"];

const browser = await launch();
for (const name of templates) {
  const { page, context, faults } = await open(browser);
  await rested(page);
  await page.evaluate((wanted) => {
    const { studio } = window.kempe;
    studio.open([studio.data.first, ...studio.data.templates, ...studio.data.examples].find(({ name }) => name === wanted).text);
  }, name);
  await rested(page);
  await page.evaluate(drag, Math.min(50, steps));  // what is made once
  await rested(page);
  const before = await memory(page), found = await page.evaluate(drag, steps);
  await rested(page);
  const after = await memory(page);
  if (faults.length) throw new Error(`${name}: ${faults.join("; ")}`);
  console.log(JSON.stringify({ template: name, ...found, ...after, heap_grown: after.heap_bytes - before.heap_bytes, engine_grown: after.engine_bytes - before.engine_bytes }));
  await context.close();
}
await browser.close();
