// The studio's page in Chromium, opened as a file.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { after, before } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { launch, newPage } from "../web/chromium.mjs";

export { launch } from "../web/chromium.mjs";

export const root = fileURLToPath(new URL("../..", import.meta.url));
export const file = process.env.KEMPE_STUDIO || `${root}out/studio.html`;
if (!existsSync(file)) {
  console.error(`${file} is not there: run scripts/studio`);
  process.exit(1);
}

/** Opens the page; `faults` collects what it must never do. */
export async function open(browser, { fragment = "", page: other = file, ...options } = {}) {
  const opened = await newPage(browser, { viewport: { width: 1400, height: 900 }, offline: true, ...options });
  await opened.page.goto(pathToFileURL(other).href + fragment);
  return opened;
}

/** For the tests of one file: on(options, body) gives the body a page, which may complain of nothing and ask for nothing. */
export function pages() {
  let browser;
  before(async () => { browser = await launch(); });
  after(() => browser.close());
  return async (options, body) => {
    const opened = await open(browser, options);
    try {
      await body(opened.page, opened.faults);
      assert.deepEqual(opened.faults, [], "the page complained or asked for something");
    } finally {
      await opened.context.close();
    }
  };
}

/** All specs that the gallery offers, and what the page opens with: name and text as they stand in the page. */
export const gallery = (page) => page.evaluate(() => ["templates", "examples"].flatMap((group) => window.kempe.studio.data[group]).concat(window.kempe.studio.data.first));
/** A shipped example's text. */
export const template = (name) => readFileSync(`${root}specs/examples/${name}.toml`, "utf8");
export const answerOf = (page) => page.evaluate(() => document.body.dataset.answer);
export const textOf = (page) => page.evaluate(() => window.kempe.studio.text);

/** The page rests: the engine has answered about the spec that stands there. */
export async function rested(page) {
  await page.waitForFunction(() => window.kempe.studio.answerIsCurrent);
}
