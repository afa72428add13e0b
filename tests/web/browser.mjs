// Chromium, driven by playwright-core, and the reports it opens.
import { existsSync } from "node:fs";
import { pathToFileURL } from "node:url";
import path from "node:path";

const packages = new URL("./node_modules/playwright-core/package.json", import.meta.url);
if (!existsSync(packages)) {
  console.error("tests/web/node_modules has no playwright-core: run scripts/bootstrap tests");
  process.exit(1);
}
const { chromium } = await import("playwright-core");

export const folder = process.env.KEMPE_SPECIMENS;
if (!folder || !existsSync(folder)) {
  console.error("KEMPE_SPECIMENS names no folder of reports: run through ctest, or write them with kempe_report_specimens");
  process.exit(1);
}

const executablePath = process.env.CHROMIUM || "/usr/bin/chromium";
if (!existsSync(executablePath)) {
  console.error(`${executablePath} is not there: run scripts/bootstrap tests, or name a browser with CHROMIUM`);
  process.exit(1);
}

export async function launch() {
  return chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"] });
}

/** Opens a specimen's report; `faults` collects what a page must never do: errors, violations, requests. */
export async function open(browser, name, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 1400 }, ...options });
  context.setDefaultTimeout(240000);  // a busy machine is no fault of the page
  const page = await context.newPage();
  page.setDefaultTimeout(120000);  // a machine that does other work meanwhile
  const faults = [];
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) faults.push(message.text()); });
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) faults.push(`request ${request.url()}`); });
  await page.goto(pathToFileURL(path.join(folder, `${name}.html`)).href);
  return { page, context, faults };
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
