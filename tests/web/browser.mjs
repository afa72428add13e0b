// The reports that the tests open in Chromium.
import { existsSync } from "node:fs";
import { pathToFileURL } from "node:url";
import path from "node:path";
import { newPage } from "./chromium.mjs";

export { launch } from "./chromium.mjs";

export const folder = process.env.KEMPE_SPECIMENS;
if (!folder || !existsSync(folder)) {
  console.error("KEMPE_SPECIMENS names no folder of reports: run through ctest, or write them with kempe_report_specimens");
  process.exit(1);
}

/** Opens a specimen's report; `faults` collects what a page must never do. */
export async function open(browser, name, options = {}) {
  const opened = await newPage(browser, { viewport: { width: 1200, height: 1400 }, ...options });
  await opened.page.goto(pathToFileURL(path.join(folder, `${name}.html`)).href);
  return opened;
}

/** Where a place of the table is on the screen. */
export async function screenOf(page, place) {
  return page.evaluate(([x, y]) => {
    const at = new DOMPoint(x, -y).matrixTransform(document.getElementById("map").getScreenCTM());
    return { x: at.x, y: at.y };
  }, place);
}

/** The six points as the page shows them, with the tracer and the pen. */
export async function shown(page) {
  return page.evaluate(() => {
    const { model, here, linkage } = window.kempe.report;
    return { model, pose: here.pose, tracer: here.place, pen: here.pen, kind: here.kind, k: linkage.k };
  });
}
