// Measures a report: its size, its first picture, its frames a second while it is dragged. Not a test.
// usage: node measure.mjs REPORT.html...
import path from "node:path";
import { statSync } from "node:fs";

process.env.KEMPE_SPECIMENS ??= ".";
const { launch, open } = await import("./browser.mjs");
const browser = await launch();
for (const report of process.argv.slice(2)) {
  const file = path.resolve(report);
  const { page, context } = await open(browser, path.join(path.relative(process.env.KEMPE_SPECIMENS, path.dirname(file)), path.basename(file, ".html")));
  const picture = await page.evaluate(() => new Promise((done) => {
    new PerformanceObserver((list) => done(list.getEntries()[0].startTime)).observe({ type: "paint", buffered: true });
  }));
  const start = await page.evaluate(() => {
    const { report } = window.kempe, [x, y] = report.here.place;
    const at = new DOMPoint(x, -y).matrixTransform(document.getElementById("map").getScreenCTM());
    window.frames_seen = 0;
    const count = () => { ++window.frames_seen; requestAnimationFrame(count); };
    requestAnimationFrame(count);
    return { x: at.x, y: at.y };
  });
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  const began = Date.now(), first = await page.evaluate(() => window.frames_seen);
  let moves = 0;
  for (; Date.now() - began < 3000; ++moves) await page.mouse.move(start.x - 40 * Math.sin(moves / 9), start.y + 60 * Math.sin(moves / 13));
  const seconds = (Date.now() - began) / 1000, frames = (await page.evaluate(() => window.frames_seen)) - first;
  await page.mouse.up();
  const cost = await page.evaluate(() => {
    const { report } = window.kempe, began = performance.now();
    for (let i = 0; i < 200; ++i) report.moveTo(report.here.place);
    return (performance.now() - began) / 200;
  });
  console.log(`${path.basename(file)}: ${(statSync(file).size / 1e6).toFixed(2)} MB, first picture ${picture.toFixed(0)} ms, ${(frames / seconds).toFixed(0)} frames/s and ${(moves / seconds).toFixed(0)} moves/s while dragging, ${cost.toFixed(2)} ms a pose`);
  await context.close();
}
await browser.close();
