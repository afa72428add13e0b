// A drawing let fall on the page becomes the original, whatever the drawing is.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { answerOf, pages, rested, root, template, textOf } from "./browser.mjs";
import { comparable, compare, natively } from "./equality.mjs";

const on = pages();
const plate = '<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="20mm" viewBox="0 0 30 20"><path d="M0 0H30V20H0Z M10 5V15H20V5Z"/></svg>';
const dxf = (units) => ["0", "SECTION", "2", "HEADER", "9", "$INSUNITS", "70", String(units), "0", "ENDSEC", "0", "SECTION", "2", "ENTITIES",
  ...[[0, 0, 1, 0], [1, 0, 1, 2], [1, 2, 0, 2], [0, 2, 0, 0]].flatMap(([a, b, c, d]) => ["0", "LINE", "8", "0", "10", `${a}`, "20", `${b}`, "11", `${c}`, "21", `${d}`]), "0", "ENDSEC", "0", "EOF", ""].join("\n");

/** Lets a file fall on the page; `bytes` is a text or an array of bytes. */
async function drop(page, name, bytes, type = "") {
  await page.evaluate(([called, content, kind]) => {
    const data = new DataTransfer();
    data.items.add(new File([typeof content === "string" ? content : new Uint8Array(content)], called, { type: kind }));
    document.body.dispatchEvent(new DragEvent("drop", { bubbles: true, cancelable: true, dataTransfer: data }));
  }, [name, bytes, type]);
}
const said = (page) => page.locator("#drawing-says").textContent();
const readOrRefused = (page) => page.waitForFunction(() => {
  const says = document.getElementById("drawing-says");
  return !document.getElementById("drawing-use").disabled || says.className.includes("bad");
});

test("An SVG becomes the original where the original was, holes and all, and can be moved", async () => {
  await on({}, async (page) => {
    await rested(page);
    await page.evaluate((text) => window.kempe.studio.open(text), template("half-turn"));
    await rested(page);
    const before = await page.evaluate(() => window.kempe.studio.middleOfRegion());
    await drop(page, "plate <b>.svg", plate);
    await readOrRefused(page);
    assert.equal(await said(page), "30 × 20 mm, 8 corners");
    await page.locator("#drawing-use").click();
    await page.waitForFunction(() => !document.getElementById("drawing").open);
    await rested(page);
    assert.equal(await answerOf(page), "design");
    const { text, middle, drawn } = await page.evaluate(() => ({ text: window.kempe.studio.text, middle: window.kempe.studio.middleOfRegion(), drawn: window.kempe.studio.task.region }));
    for (const axis of [0, 1]) assert.ok(Math.abs(middle[axis] - before[axis]) < 1e-3, `${middle} instead of ${before}`);
    assert.equal(drawn.length, 2);
    compare(comparable(natively(text).design), comparable(await page.evaluate(() => window.kempe.studio.answer.design)), "plate");
    await page.locator('.handle[data-id="region.polygon_mm.middle"]').focus();
    await page.keyboard.press("ArrowRight");
    await rested(page);
    const moved = await page.evaluate(() => window.kempe.studio.task.region);
    const by = moved[0][0][0] - drawn[0][0][0];
    assert.ok(by > 0);
    for (const [r, ring] of drawn.entries()) for (const [i, [x]] of ring.entries()) assert.ok(Math.abs(moved[r][i][0] - x - by) < 1e-9, "a hole stayed behind");
    await page.locator("#undo").click();
    await page.locator("#undo").click();
    assert.equal(await textOf(page), template("half-turn"));
  });
});

test("A DXF is read in its units, or in those that are chosen", async () => {
  await on({}, async (page) => {
    await rested(page);
    await drop(page, "PLATE.DXF", dxf(1));
    await readOrRefused(page);
    assert.equal(await said(page), "25.4 × 50.8 mm, 4 corners");
    await page.locator("#drawing-units").selectOption("cm");
    await page.waitForFunction(() => document.getElementById("drawing-says").textContent.startsWith("10 × 20 mm"));
    await page.locator("#drawing-margin").fill("2,5");
    await page.locator("#drawing-cover").selectOption("hull");
    await page.waitForFunction(() => document.getElementById("drawing-says").textContent.startsWith("15 × 25 mm"));
    await page.locator("#close-drawing").click();
    await drop(page, "unitless.dxf", dxf(0));
    await readOrRefused(page);
    assert.match(await said(page), /^unitless\.dxf: found .*units/);
    await page.locator("#drawing-units").selectOption("mm");
    await page.waitForFunction(() => document.getElementById("drawing-says").textContent.startsWith("1 × 2 mm"));
  });
});

test("Lines that close nothing are covered by their hull", async () => {
  await on({}, async (page) => {
    await rested(page);
    await drop(page, "open.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm" viewBox="0 0 9 9"><path d="M1 1L8 1L4 7"/></svg>');
    await readOrRefused(page);
    assert.equal(await page.locator("#drawing-cover").inputValue(), "hull");
    assert.equal(await said(page), "7 × 6 mm, 3 corners");
  });
});

test("Hostile drawings leave the page alive with a message", async () => {
  const corpus = path.join(root, "tests/corpus"), found = ["svg", "dxf"].flatMap((kind) =>
    readdirSync(path.join(corpus, kind)).map((name) => [name, [...readFileSync(path.join(corpus, kind, name))]]));
  const hostile = [...found, ["empty.svg", ""], ["empty.dxf", ""], ["bytes.svg", Array.from({ length: 4096 }, (_, i) => (i * 73) & 255)], ["bytes.dxf", Array.from({ length: 4096 }, (_, i) => (i * 73) & 255)],
    ["bomb.svg", `<!DOCTYPE svg [<!ENTITY a "${"x".repeat(99)}"><!ENTITY b "${"&a;".repeat(99)}"><!ENTITY c "${"&b;".repeat(99)}">]><svg xmlns="http://www.w3.org/2000/svg"><text>&c;</text></svg>`],
    ["script.svg", '<svg xmlns="http://www.w3.org/2000/svg" onload="window.hostile=1" width="9" height="9"><script>window.hostile=1</script><image href="http://example.org/x.png"/></svg>'],
    ["deep.svg", `<svg xmlns="http://www.w3.org/2000/svg">${"<g>".repeat(20000)}`], ["far.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm"><path d="M0 0H1e300V1e300Z"/></svg>'],
    ["cut.dxf", dxf(4).slice(0, 90)]];
  await on({}, async (page) => {
    await rested(page);
    const before = await textOf(page);
    for (const [name, bytes] of hostile) {
      await drop(page, name, bytes);
      await page.waitForFunction(() => document.getElementById("drawing").open);
      await readOrRefused(page);
      assert.ok((await said(page)).length > 5, name);
      await page.locator("#close-drawing").click();
    }
    for (const [name, bytes] of [["notes.txt", "hello"], ["noname", ""], ["<img src=x onerror=window.hostile=1>", ""]]) {
      await drop(page, name, bytes);
      await page.waitForFunction((called) => document.getElementById("notice-text").textContent.startsWith(`${called}: `), name);
    }
    assert.equal(await page.evaluate(() => window.hostile), undefined);
    assert.equal(await textOf(page), before);
    await page.evaluate((text) => window.kempe.studio.open(text), template("half-turn"));
    await rested(page);
    assert.equal(await answerOf(page), "design");
  });
});
