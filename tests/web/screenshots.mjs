// The pictures of README.md and docs/reading-the-report.md. Not a test.
// usage: node screenshots.mjs FOLDER OUT, where FOLDER/EXAMPLE/report.html is the report of specs/examples/EXAMPLE.toml
import path from "node:path";

const [folder, out] = process.argv.slice(2);
process.env.KEMPE_SPECIMENS = folder;
const { launch, open, screenOf } = await import("./browser.mjs");
const browser = await launch();

async function picture(example, name, options, prepare) {
  const { page, context, faults } = await open(browser, path.join(example, "report"), options);
  const clip = await prepare(page);
  await page.waitForTimeout(250);
  await page.screenshot({ path: path.join(out, `${name}.png`), ...(clip ? { clip } : {}) });
  if (faults.length) console.error(name, faults);
  await context.close();
}

const tour = (page, share) => page.evaluate((part) => { const { report } = window.kempe; report.clear(); for (let i = 0; i < 600 * part; ++i) report.follow(1 / 60); }, share);
const figure = async (page, margin = 0) => {
  const box = await page.locator("#map-figure").boundingBox();
  return { x: box.x - margin, y: box.y - margin, width: box.width + 2 * margin, height: box.height + 2 * margin };
};

await picture("matlab-circle", "report", { viewport: { width: 1180, height: 1240 } }, (page) => tour(page, 0.9));
await picture("sixty", "report-contact", { viewport: { width: 1180, height: 1400 } }, async (page) => {
  const place = await page.evaluate(() => {
    const { linkage, contacts, model, moveTo } = window.kempe.report, [near, far] = linkage.radii();
    for (let i = 1; i < 400; ++i) {
      const radius = near + ((far - near) * i) / 400, at = [model.pole[0] + radius, model.pole[1] + 20];
      const found = linkage.poseWithTracerAt(at);
      if (!found.why && linkage.transmissionAt(found.opening) > model.transmission && contacts.gaps(found.pose).some(({ gap }) => gap < -2)) return at;
    }
    return model.tracer;
  });
  await page.evaluate((at) => window.kempe.report.moveTo(at), place);
  const at = await screenOf(page, [place[0], place[1] - 45]);
  await page.mouse.move(at.x, at.y);
  return figure(page, 8);
});
await picture("nameplate", "report-phone", { viewport: { width: 390, height: 1180 }, deviceScaleFactor: 1.5, colorScheme: "dark", hasTouch: true, isMobile: true }, async (page) => {
  await tour(page, 0.8);
  await page.locator("#map-figure").scrollIntoViewIfNeeded();
  await page.evaluate(() => window.scrollTo(0, document.getElementById("map-figure").offsetTop - 12));
});
await picture("plagiograph", "report-parts", { viewport: { width: 1180, height: 2600 } }, async (page) => {
  const [lengths, parts] = [await page.locator("#lengths").boundingBox(), await page.locator("#parts").boundingBox()];
  return { x: lengths.x - 24, y: lengths.y + 20, width: lengths.width + 48, height: parts.y + parts.height - lengths.y };
});
await picture("clamped-plate", "report-obstacles", { viewport: { width: 1180, height: 1400 } }, async (page) => {
  for (const layer of ["sheets", "footprint"]) await page.locator(`#layer-${layer}`).check();
  const at = await screenOf(page, [-150, 600]);
  await page.mouse.move(at.x, at.y);
  return figure(page, 8);
});
await picture("nameplate", "nameplate", { viewport: { width: 1180, height: 1240 } }, async (page) => {
  await tour(page, 0.9);
  return page.locator("#board").boundingBox();
});
await browser.close();
