// What somebody needs who has read nothing: the meaning of what is seen, and a way to everything on a phone.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { answerOf, pages, rested, root, template, textOf } from "./browser.mjs";

const scratch = mkdtempSync(path.join(tmpdir(), "kempe-stranger-"));
after(() => rmSync(scratch, { recursive: true }));
const on = pages();
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const opened = async (page, text) => {
  await rested(page);
  await page.evaluate((spec) => window.kempe.studio.open(spec), text);
  await rested(page);
};
/** Opens a template as a hand does. */
const chosen = async (page, words) => {
  await rested(page);
  await page.locator("#open-gallery").click();
  await page.locator("#templates .card", { hasText: words }).click();
  await rested(page);
};

test("The legend names every colour on the table, and no other", async () => {
  await on({}, async (page) => {
    await opened(page, template("clamped-plate"));
    await page.locator("#colours summary").click();
    const there = () => page.evaluate(() => {
      const shown = [...document.querySelectorAll("#colours-list .swatch")].map((swatch) => [...swatch.classList].find((css) => css.startsWith("m-")).slice(2));
      const drawn = [...document.querySelectorAll("#map .areas > g")].map((group) => [...group.classList].find((css) => css.startsWith("m-")).slice(2));
      const titled = [...document.querySelectorAll("#map .areas path")].every((area) => area.querySelector("title").textContent.length > 5);
      return { shown, drawn, titled };
    });
    const { shown, drawn, titled } = await there();
    assert.ok(drawn.includes("free") && drawn.length >= 3 && titled, "areas say what they are");
    for (const name of [...drawn, "region", "copy", "obstacles", "pole", "mechanism"]) assert.ok(shown.includes(name), `${name} of ${shown}`);
    assert.ok(!shown.includes("pole-area"));
    const seen = await page.locator("#colours-list li").evaluateAll((items) => items.every((item) => item.getBoundingClientRect().height > 10 && item.textContent.length > 8));
    assert.ok(seen);
    await chosen(page, "Engraver");
    assert.ok((await there()).shown.includes("pole-area"));
    assert.match(await page.locator("#map .names").textContent(), /pole's area|the pole may stand here/);
    await page.locator("#colours summary").click();  // closed again, the table has room for all of it
    await page.waitForFunction(() => document.querySelector("#map .names").textContent.includes("the pole may stand here"));
  });
});

test("Joints have their letters in the drawing, and the lengths stand on the page and on paper", async () => {
  await on({}, async (page) => {
    await chosen(page, "Eidograph");
    const letters = await page.locator("#map .letters text").allTextContents();
    assert.ok(letters.length >= 4 && letters.every((letter) => /^[VABCXY]$/.test(letter)) && new Set(letters).size === letters.length, letters.join());
    await page.locator("#lengths summary").click();
    const { lengths } = await page.evaluate(() => window.kempe.studio.answer), words = await page.locator("#lengths-list").innerText();
    assert.equal(Object.keys(lengths).length, 8);
    for (const [name, mm] of Object.entries(lengths)) {
      assert.match(words, new RegExp(`${name}\\s+${mm.toFixed(2)}`));
      assert.equal(words.split(new RegExp(`${name}\\s+${mm.toFixed(2)}`)).length, 2, "said once");
    }
    const paper = path.join(scratch, "lengths.pdf");
    await page.pdf({ path: paper, format: "A4" });
    const printed = execFileSync("pdftotext", ["-layout", paper, "-"], { encoding: "utf8" });
    for (const [name, mm] of Object.entries(lengths)) assert.match(printed, new RegExp(`${name}\\s+${mm.toFixed(2)}`));
    await opened(page, `${template("plagiograph")}\n[limits]\ntransmission_deg = 88\n`);
    assert.equal(await page.locator("#lengths-list table").count(), 0, "no lengths of another task");
    await opened(page, template("plagiograph"));
    await page.evaluate((text) => window.kempe.studio.change(text), `${template("plagiograph")}\n[limits]\ntransmission_deg = 88\n`);
    await rested(page);
    assert.ok(await page.locator("#lengths").evaluate((node) => node.classList.contains("stale")), "the last design's lengths are grey");
    await page.pdf({ path: paper, format: "A4" });
    assert.doesNotMatch(execFileSync("pdftotext", ["-layout", paper, "-"], { encoding: "utf8" }), /Saw to/);
  });
});

test("On a phone Print and Share are at hand", async () => {
  await on(phone, async (page) => {
    await rested(page);
    await page.evaluate(() => { window.print = () => { window.printed = true; }; });
    assert.equal(await page.locator("#print").isVisible(), false);
    for (const button of ["print", "share"]) {
      await page.locator("#more").tap();
      const { left, right } = await page.locator(`#${button}`).evaluate((node) => node.getBoundingClientRect());
      assert.ok(left >= 0 && right <= 390);
      await page.locator(`#${button}`).tap();
      assert.equal(await page.locator(`#${button}`).isVisible(), false, "the menu closes");
    }
    assert.ok(await page.evaluate(() => window.printed));
    await page.waitForFunction(() => document.getElementById("notice-text").textContent);  // the address is made and copied first
    assert.match(await page.locator("#notice-text").textContent(), /same file|^file:/);
    await page.locator("#more").press("Enter");
    assert.equal(await page.evaluate(() => document.activeElement.id), "print");
    await page.keyboard.press("Escape");
    assert.equal(await page.evaluate(() => `${document.activeElement.id} ${document.activeElement.getAttribute("aria-expanded")}`), "more false");
  });
});

test("An obstacle is added where it can be seen, named, resized and removed, by hand and by key", async () => {
  for (const [options, press] of [[phone, "tap"], [{}, "click"]])
    await on(options, async (page) => {
      await rested(page);
      const add = async (kind) => {
        await page.locator("#add")[press]();
        await page.locator(kind)[press]();
        return page.evaluate(() => {
          const { activeElement: node } = document, { left, right, top, bottom } = node.getBoundingClientRect();
          return { id: node.dataset.id, inside: left >= 0 && right <= innerWidth && top >= 0 && bottom <= innerHeight };
        });
      };
      await page.evaluate(() => scrollTo(0, 400));
      assert.deepEqual(await add("#add-obstacle"), { id: "obstacles.0.rectangle_mm.middle", inside: true });
      assert.deepEqual(await add("#add-circle"), { id: "obstacles.1.circle_mm.centre", inside: true });
      const [one, other, region] = await page.evaluate(() => ["obstacle", "region"].flatMap((role) => window.kempe.studio.shapes.filter((shape) => shape.role === role)).map(({ rings }) => {
        const points = rings.flat(), xs = points.map(([x]) => x), ys = points.map(([, y]) => y);
        return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
      }));
      const meet = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
      assert.ok(!meet(one, other) && !meet(one, region) && !meet(other, region), "each has a place of its own");
      await rested(page);
      assert.equal(await answerOf(page), "design");
      const name = page.getByLabel("Name of obstacle 1", { exact: true });
      await name.fill('vice "blue"');
      await name.blur();
      await rested(page);
      assert.match(await textOf(page), /name = "vice \\"blue\\""/);
      await page.getByLabel('Width of vice "blue"', { exact: true }).fill("7,5");
      await page.keyboard.press("Tab");
      assert.equal(await page.evaluate(() => window.kempe.studio.doc.get("obstacles.0.rectangle_mm").size[0]), 7.5);
      await page.getByLabel('Remove vice "blue"', { exact: true })[press]();
      assert.doesNotMatch(await textOf(page), /vice/);
      assert.match(await page.locator("#notice-text").textContent(), /vice "blue".*removed/);
      await page.locator('.handle[data-id="obstacles.0.circle_mm.centre"]').focus();
      await page.keyboard.press("Delete");
      assert.doesNotMatch(await textOf(page), /obstacles/);
      await page.locator("#undo")[press]();
      assert.match(await textOf(page), /circle_mm/);
      await rested(page);
    });
});

test("After a touch no ring of the browser's own stays on a handle", async () => {
  await on(phone, async (page) => {
    await rested(page);
    await page.locator('.handle[data-id="pole.at_mm"]').tap();
    const drawn = await page.evaluate(() => { const { outlineStyle, outlineWidth } = getComputedStyle(document.activeElement); return `${document.activeElement.dataset.id} ${outlineStyle} ${parseFloat(outlineWidth)}`; });
    assert.match(drawn, /^pole\.at_mm (none|\w+ 0)/);
    assert.equal(await page.locator(".handle.held").count(), 0);
    const rim = () => page.locator('.handle[data-id="pole.at_mm"] .knob').evaluate((knob) => parseFloat(getComputedStyle(knob).strokeWidth));
    assert.equal(await rim(), 2);
    await page.keyboard.press("ArrowRight");
    assert.equal(await rim(), 4, "keys show where they act");
  });
});

test("A proof once obtained for a text stays, whatever a later search says", async () => {
  await on({}, async (page) => {
    await rested(page);
    const { proven, other } = await page.evaluate(async () => {
      const { studio } = window.kempe, ask = studio.searcher.ask.bind(studio.searcher);
      studio.searcher.ask = (question, ...rest) => (question === "design" ? Promise.resolve({ kind: "none", proven: false, reason: "the search found none that keeps all limits together", changes: [] }) : ask(question, ...rest));
      const text = new window.kempe.Doc(studio.text).with("limits.transmission_deg", 89), told = async (spec) => {
        studio.change(spec);
        await new Promise((resolve) => window.addEventListener("kempe-answer", resolve, { once: true }));
        return document.getElementById("verdict").textContent;
      };
      studio.sketchSoon = async () => {};
      studio.proveNone(text);
      return { proven: await told(text), other: await told(new window.kempe.Doc(text).with("limits.transmission_deg", 88)) };
    });
    assert.equal(proven, "Proven: no design exists. No design keeps all limits together.");
    assert.match(other, /^None found, which proves nothing\. The search found none/);
  });
});

test("Where an obstacle is in the way, dragging it is named among the ways out, by hand only", async () => {
  await on({}, async (page) => {
    await opened(page, `${template("plagiograph")}\n[[obstacles]]\nname = "vice"\ncircle_mm = {centre = [0, 1], radius = 3}\n`);
    assert.equal(await answerOf(page), "none");
    assert.match(await page.locator("#verdict").textContent(), /^Proven: no design exists\. “vice” stands over the pole.* Dragging it away may help too\.$/);
    assert.match(await page.locator("#map .names .reason").allTextContents().then((all) => all.join()), /in the way/);
    await page.locator("#changes button", { hasText: "Without vice" }).click();
    await rested(page);
    assert.equal(await answerOf(page), "design");
  });
});

test("A template chosen once more is there as before", async () => {
  await on({}, async (page) => {
    await chosen(page, "Eidograph");
    await chosen(page, "Eidograph");
    assert.equal(await answerOf(page), "design");
    assert.ok((await page.locator("#map .areas > g").count()) > 1 && (await page.locator("#map .m-mechanism .link").count()) === 4);
  });
});

test("A template that was changed goes by no template's name: in text, zip and on paper", async () => {
  await on({}, async (page) => {
    await chosen(page, "Engraver");
    const before = await textOf(page);
    await page.locator('[id="field-copy.scale"]').fill("0,5");
    await page.keyboard.press("Tab");
    await rested(page);
    assert.equal(await answerOf(page), "design");
    assert.doesNotMatch(await textOf(page), /^title|A7 plates/m);
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#download").click()]);
    assert.equal(download.suggestedFilename(), "copy-0.5x.zip");
    const zip = path.join(scratch, "changed.zip"), folder = path.join(scratch, "changed");
    await download.saveAs(zip);
    execFileSync("python3", ["-m", "zipfile", "-e", zip, folder]);
    for (const name of readdirSync(folder, { recursive: true }).map(String).filter((of) => /\.(html|json|toml|csv)$/.test(of)))
      assert.doesNotMatch(readFileSync(path.join(folder, name), "utf8").replace(/^# Begun with.*$/m, ""), /Engraver for A7/, name);
    await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
    assert.equal(await page.locator("#printed-title").textContent(), "A copying instrument: × 0.5");
    await page.locator("#undo").click();
    await rested(page);
    assert.equal(await textOf(page), before);
    assert.equal(await page.evaluate(() => window.kempe.naming.fileName(window.kempe.studio)), "engraver-a7");
  });
});
