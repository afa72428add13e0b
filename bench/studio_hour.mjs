// What an hour's dragging leaves in the studio's memory: as many steps as an hour has frames, at the speed of the engine.
// usage: node bench/studio_hour.mjs [MINUTES] [TEMPLATE]      (scripts/studio first; prints a JSON line after each of 1, 2, 5, 10, 20, ... minutes)
// A minute is 3600 steps, a step a sixtieth of a second; after each the hand rests, and the full search runs. The steps do not wait for a
// frame, so an hour takes some ten minutes.
import { launch, open, rested } from "../tests/studio/browser.mjs";
import { drag, memory } from "../tests/studio/dragging.mjs";

const [minutes, template] = [Number(process.argv[2] || 60), process.argv[3] || "nameplate"];
const steps_a_minute = 3600;

const browser = await launch();
const { page, context, faults } = await open(browser);
context.setDefaultTimeout(0);
await rested(page);
await page.evaluate((wanted) => {
  const { studio } = window.kempe;
  studio.open([studio.data.first, ...studio.data.templates, ...studio.data.examples].find(({ name }) => name === wanted).text);
}, template);
await rested(page);
const session = await page.context().newCDPSession(page), began = performance.now();
let steps = 0;
for (let minute = 1; minute <= minutes; ++minute) {
  steps += (await page.evaluate(drag, { steps: steps_a_minute, frames: false })).steps;
  await rested(page);
  if (![1, 2, 5].includes(minute) && minute % 10 !== 0 && minute !== minutes) continue;
  const held = await memory(page), { nodes, jsEventListeners } = await session.send("Memory.getDOMCounters");
  console.log(JSON.stringify({ template, minute, steps, ...held, nodes, listeners: jsEventListeners, seconds: Math.round((performance.now() - began) / 1000) }));
}
if (faults.length) throw new Error(faults.join("; "));
await browser.close();
