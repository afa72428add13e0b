// A page with a spec inside, as kempe studio writes it.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { after, test } from "node:test";
import { answerOf, file, pages, rested, template, textOf } from "./browser.mjs";
import { comparable, compare, natively, program } from "./equality.mjs";

const scratch = mkdtempSync(path.join(tmpdir(), "kempe-inside-"));
after(() => rmSync(scratch, { recursive: true }));
const on = pages();
const environment = { ...process.env, KEMPE_STUDIO: file };

/** The page that the program writes for a spec. */
function pageOf(name, text) {
  const spec = path.join(scratch, `${name}.toml`);
  writeFileSync(spec, text);
  return execFileSync(program, ["studio", spec], { encoding: "utf8", env: environment }).trim();
}

test("The page opens with its spec, and designs what the program designs", async () => {
  const text = `# </script><script>window.hostile = 1</script> <!-- <script> ' " \\ ünïcode 雕 \u2028\n${template("nameplate")}`;
  const page = pageOf("plate", text), { design } = natively(text);
  await on({ page }, async (opened) => {
    await rested(opened);
    assert.equal(await textOf(opened), text);
    assert.equal(await answerOf(opened), "design");
    compare(comparable(design), comparable(await opened.evaluate(() => window.kempe.studio.answer.design)), "plate");
    assert.equal(await opened.evaluate(() => window.hostile), undefined);
    assert.equal(await opened.evaluate(() => document.querySelectorAll("script").length), await scripts(file));
  });
});

/** How many script elements the page has as it was built. */
async function scripts(built) {
  return (readFileSync(built, "utf8").match(/<script[ >][^]*?<\/script>/g) || []).length;
}

test("A drawing that the spec names is in the page", async () => {
  const svg = '<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="40mm" viewBox="0 0 90 40"><path d="M60 10H80V30H60Z"/></svg>';
  writeFileSync(path.join(scratch, "shape.svg"), svg);
  const text = `[copy]\nscale = 2\n\n[region]\nfile = "./shape.svg"  # beside the spec\n\n[pole]\nat_mm = [0, 0]\n`;
  const page = pageOf("drawn", text);
  await on({ page }, async (opened) => {
    await rested(opened);
    assert.equal(await answerOf(opened), "design");
    assert.equal(await textOf(opened), text.replace("./shape.svg", "shape.svg"));
    const outline = await opened.evaluate(() => window.kempe.studio.task.region[0]);
    assert.equal(outline.length, 4);
    await opened.locator("#share").click();
    await opened.waitForFunction(() => /drawing, which no address holds/.test(document.getElementById("notice-text").textContent));
  });
});

test("An address stands before the spec inside: what was changed survives a reload", async () => {
  const page = pageOf("first", template("half-turn"));
  await on({ page }, async (opened) => {
    await rested(opened);
    await opened.evaluate((text) => window.kempe.studio.change(text), template("two-layer"));
    await rested(opened);
    await opened.waitForFunction(() => location.hash.startsWith("#k1:"));
    await opened.reload();
    await rested(opened);
    assert.equal(await textOf(opened), template("two-layer"));
  });
});

test("The report's link opens the studio with the spec", async () => {
  const spec = path.join(scratch, "linked.toml"), folder = path.join(scratch, "linked");
  writeFileSync(spec, template("plagiograph"));
  const run = spawnSync(program, ["synthesize", spec, "-o", folder, "--studio", "--quiet"], { encoding: "utf8", env: environment });
  assert.equal(run.status, 0, run.stderr);
  await on({ page: path.join(folder, "report.html") }, async (opened) => {
    await opened.locator(".change-link a").click();
    await opened.waitForURL(pathToFileURL(path.join(folder, "studio.html")).href + "**");
    await rested(opened);
    assert.equal(await textOf(opened), template("plagiograph"));
    assert.equal(await answerOf(opened), "design");
  });
});

test("A given mechanism without anything to cover gets its map; with a region, a better one is sought", async () => {
  const page = pageOf("given", template("report-mechanism").replace(/^\[region\][^]*?(?=^\[)/m, ""));
  await on({ page }, async (opened) => {
    await rested(opened);
    assert.equal(await answerOf(opened), "design");
    assert.equal(await opened.evaluate(() => window.kempe.studio.answer.figures.value), null);
    assert.match(await opened.locator("#verdict").textContent(), /^The map of the mechanism/);
    await opened.evaluate((text) => window.kempe.studio.open(text), template("clamped-plate"));
    await rested(opened);
    assert.ok(await opened.evaluate(() => window.kempe.studio.answer.figures.bound > 0));
  });
});
