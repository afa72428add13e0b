// Chromium, driven by playwright-core, and what no page of ours may do in it.
import { existsSync } from "node:fs";

if (!existsSync(new URL("./node_modules/playwright-core/package.json", import.meta.url))) {
  console.error("tests/web/node_modules has no playwright-core: run scripts/bootstrap tests");
  process.exit(1);
}
const { chromium } = await import("playwright-core");

const executablePath = process.env.CHROMIUM || "/usr/bin/chromium";
if (!existsSync(executablePath)) {
  console.error(`${executablePath} is not there: run scripts/bootstrap tests, or name a browser with CHROMIUM`);
  process.exit(1);
}

export async function launch() {
  return chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"] });
}

/** A new page, not yet anywhere; `faults` collects what a page must never do: errors, violations, requests. */
export async function newPage(browser, options) {
  const context = await browser.newContext(options);
  context.setDefaultTimeout(240000);  // a busy machine is no fault of the page
  const page = await context.newPage();
  page.setDefaultTimeout(120000);  // a machine that does other work meanwhile
  const faults = [];
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) faults.push(message.text()); });
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) faults.push(`request ${request.url()}`); });
  return { page, context, faults };
}
