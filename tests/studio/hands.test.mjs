// Fingers and fields: what a hand takes hold of, what it types, and that nothing moves away below it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { answerOf, gallery, pages, rested, template, textOf } from "./browser.mjs";
import { program } from "./equality.mjs";

const scratch = mkdtempSync(path.join(tmpdir(), "kempe-hands-"));
after(() => rmSync(scratch, { recursive: true }));
const on = pages();
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const opened = async (page, text) => {
  await rested(page);
  await page.evaluate((spec) => window.kempe.studio.open(spec), text);
  await rested(page);
};
const field = (page, label) => page.getByLabel(label, { exact: true });
const area = "[copy]\nscale = 0.4\n[region]\nrectangle_mm = {at = [-300, 0], size = [160, 60]}\n[pole]\nwithin_mm = [[-100, 250], [200, 250], [200, 400], [-100, 400]]\n[links]\nwidth_mm = 12\n";

/** A finger from one place to another. */
async function swipe(page, { x, y }, [dx, dy]) {
  const cdp = await page.context().newCDPSession(page), send = (type, touchPoints) => cdp.send("Input.dispatchTouchEvent", { type, touchPoints });
  await send("touchStart", [{ x, y }]);
  for (let i = 1; i <= 20; ++i) {
    await send("touchMove", [{ x: x + (i * dx) / 20, y: y + (i * dy) / 20 }]);
    await page.waitForTimeout(16);
  }
  await send("touchEnd", []);
  await cdp.detach();
}

const middleOf = async (locator) => {
  const { x, y, width, height } = await locator.boundingBox();
  return { x: x + width / 2, y: y + height / 2 };
};

test("A first click or tap in a field of numbers selects all of it, a second one puts the caret", async () => {
  for (const [options, press] of [[{}, "click"], [phone, "tap"]])
    await on(options, async (page) => {
      await opened(page, template("clamped-plate"));
      const width = field(page, "Width of the original"), chosen = () => page.evaluate(() => { const { selectionStart, selectionEnd, value } = document.activeElement; return [selectionStart, selectionEnd, value.length]; });
      await width[press]();
      const [from, to, length] = await chosen();
      assert.deepEqual([from, to], [0, length]);
      await page.keyboard.type("151");
      await page.keyboard.press("Tab");
      assert.equal(await page.evaluate(() => window.kempe.studio.doc.get("region.rectangle_mm").size[0]), 151);
      await width[press]();
      await page.waitForTimeout(700);  // sooner it is a double click, which selects a word
      await width[press]();
      const [start, end] = await chosen();
      assert.equal(start, end, "a second one puts the caret");
      await page.locator('[id="field-copy.scale"]')[press]();
      await page.keyboard.type("0.5");
      await page.keyboard.press("Tab");
      assert.equal(await page.evaluate(() => window.kempe.studio.doc.get("copy.scale")), 0.5);
    });
});

test("A finger drags a handle, or the tracer, upright too; on an outline it scrolls the page and moves nothing", async () => {
  await on(phone, async (page) => {
    await opened(page, template("clamped-plate"));
    const top = () => page.evaluate(() => scrollY), at = () => page.evaluate(() => JSON.stringify(window.kempe.studio.doc.get("region.rectangle_mm")));
    for (const way of [[0, -90], [0, 70]]) {
      const before = await at(), corner = page.locator('.handle[data-id="region.rectangle_mm.size"] .knob'), from = await middleOf(corner);
      await swipe(page, from, way);
      const to = await middleOf(corner);
      assert.notEqual(await at(), before);
      assert.ok(Math.abs(to.y - from.y - way[1]) < 6, `the corner went ${to.y - from.y} of ${way[1]} pixels`);
      assert.equal(await top(), 0, "the page scrolled");
      await page.locator("#undo").tap();
      await rested(page);
      assert.equal(await at(), before, "one step");
    }
    const tracer = page.locator(".hold"), from = await middleOf(tracer), text = await textOf(page);
    await swipe(page, from, [0, -60]);
    const to = await middleOf(tracer);
    assert.ok(Math.hypot(to.x - from.x, to.y - from.y) > 30, "the tracer moves");
    assert.deepEqual([await top(), await textOf(page)], [0, text]);
    // A place of the outline that no handle has.
    const place = await page.evaluate(() => {
      const box = document.querySelector(".m-region .outline").getBoundingClientRect();
      for (let i = 1; i < 20; ++i) for (let j = 1; j < 20; ++j) {
        const x = box.left + (i / 20) * box.width, y = box.top + (j / 20) * box.height, hit = document.elementFromPoint(x, y);
        if (hit && hit.matches(".m-region .outline")) return { x, y };
      }
      return null;
    });
    await swipe(page, place, [0, -150]);
    assert.equal(await textOf(page), text, "a swipe moved the original");
    assert.ok((await top()) > 60, "the page scrolls");
  });
});

test("No field moves while a search runs, whatever comes of it", async () => {
  for (const options of [{}, phone])
    await on(options, async (page) => {
      await opened(page, template("clamped-plate"));
      await page.locator("#lengths summary").click();
      const watched = await page.evaluate(async () => {
        const { studio } = window.kempe, fields = [...document.querySelectorAll('#fields input[type="text"]')].slice(0, 8), tops = () => fields.map((node) => Math.round(node.getBoundingClientRect().top + scrollY));
        const first = tops(), moved = [], kinds = [];
        let frame = 0;
        const look = () => {
          if (tops().some((top, i) => top !== first[i])) moved.push(document.getElementById("verdict").textContent);
          frame = requestAnimationFrame(look);
        };
        look();
        const { doc } = studio;
        for (const [path, value] of [["limits.transmission_deg", 85], ["limits.transmission_deg", 20], ["copy.scale", 0.5], ["limits.longest_strip_mm", 60], ["copy.scale", -1]]) {
          studio.change(new window.kempe.Doc(path === "copy.scale" ? doc.text : studio.text).with(path, value));
          await new Promise((resolve) => window.addEventListener("kempe-answer", resolve, { once: true }));
          await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
          kinds.push(document.body.dataset.answer);
        }
        cancelAnimationFrame(frame);
        return { moved, kinds };
      });
      assert.deepEqual(watched.moved, []);
      for (const kind of ["design", "none", "faults"]) assert.ok(watched.kinds.includes(kind), watched.kinds.join());
    });
});

test("A scale is read as a number, as per cent and as a pair; any other is refused with examples", async () => {
  await on({}, async (page) => {
    await rested(page);
    const scale = page.locator('[id="field-copy.scale"]'), got = () => page.evaluate(() => window.kempe.studio.doc.get("copy.scale"));
    for (const [typed, value] of [["40%", 0.4], ["33,5 %", 0.335], ["2:5", "2:5"], ["2,5:5", "2.5:5"], ["0,7", 0.7]]) {
      await scale.fill(typed);
      await scale.blur();
      assert.equal(await got(), value, typed);
    }
    for (const wrong of ["half", "0", "-40%", "%", "2:0", "2:5%"]) {
      await scale.fill(wrong);
      await scale.blur();
      assert.equal(await got(), 0.7, wrong);
      assert.equal(await scale.evaluate((node) => node.validationMessage), "a number such as 0.4, 40 % or 2:5, please");
    }
  });
});

test("The lengths to saw are those of bom.csv, and a plate is called what it is", async () => {
  await on({}, async (page) => {
    for (const name of ["plagiograph", "clamped-plate", "half-turn"]) {
      await opened(page, template(name));
      const spec = path.join(scratch, `${name}.toml`), folder = path.join(scratch, name);
      writeFileSync(spec, template(name));
      execFileSync(program, ["synthesize", spec, "-o", folder, "--quiet"]);
      const rows = readFileSync(path.join(folder, "bom.csv"), "utf8").split("\n").filter((line) => line.startsWith("link,")).map((line) => /^link,(\w+),.*,([\d.]+),[\d.]+,"([^"]*), layer (\d)/.exec(line).slice(1));
      const shown = await page.locator("#lengths-list tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
      assert.equal(rows.length, 4);
      rows.forEach(([link, blank, form, layer], i) => {
        const [named, , saw, shape, above] = shown[i];
        assert.deepEqual([named, shape, above], [link, form, layer]);
        if (/^bar|straight/.test(form)) assert.ok(Math.abs(saw - blank) < 6e-3, `${link}: ${saw} for ${blank}`);
        else assert.equal(saw, "see its drawing");
      });
    }
  });
});

test("A pole on the edge of its area is named as what holds back, and a rectangular area is typed", async () => {
  await on({}, async (page) => {
    await opened(page, area);
    assert.equal(await answerOf(page), "design");
    assert.match(await page.locator("#verdict").textContent(), /the pole's area, on whose edge the pole stands/);
    const within = () => page.evaluate(() => window.kempe.studio.doc.get("pole.within_mm"));
    for (const [label, value] of [["Width", "320"], ["Height", "160"], ["Left edge", "-110"], ["Lower edge", "240"]]) {
      await field(page, `${label} of the pole's area`).fill(value);
      await page.keyboard.press("Tab");
    }
    assert.deepEqual(await within(), [[-110, 240], [210, 240], [210, 400], [-110, 400]]);
    await opened(page, area.replace("[200, 400]", "[200, 410]"));
    assert.equal(await page.getByLabel("Width of the pole's area", { exact: true }).count(), 0, "only a rectangle has a width");
  });
});

test("What is typed stays in view, and an original too large for any strip is called so", async () => {
  await on({}, async (page) => {
    await opened(page, template("clamped-plate"));
    const share = () => page.evaluate(() => {
      const { stage, shapes } = window.kempe.studio, box = window.kempe.boxOfShape(shapes.find(({ role }) => role === "region"));
      return { within: stage.isWithin(box), share: stage.shareOf(box) };
    });
    const width = field(page, "Width of the original"), height = field(page, "Height of the original");
    await width.fill("210000");
    await page.keyboard.press("Tab");
    await rested(page);
    assert.ok((await share()).within);
    assert.match(await page.locator("#verdict").textContent(), /The original is very large for strips of at most \d+/);
    await width.fill("200");
    await page.keyboard.press("Tab");
    await rested(page);
    const seen = await share();
    assert.ok(seen.within && seen.share > 0.1, JSON.stringify(seen));
    assert.doesNotMatch(await page.locator("#verdict").textContent(), /very large/);
    // A window that somebody chose stays where what is typed is seen in it.
    const view = () => page.evaluate(() => JSON.stringify(window.kempe.studio.stage.view));
    await page.locator("#zoom-out").click();
    const chosen = await view();
    await height.fill("90");
    await page.keyboard.press("Tab");
    await rested(page);
    assert.equal(await view(), chosen);
  });
});

test("Every template with its design is one page on paper", async () => {
  await on({}, async (page) => {
    await rested(page);
    const paper = path.join(scratch, "page.pdf"), names = await page.evaluate(() => window.kempe.studio.data.templates.map(({ name }) => name));
    for (const { name, text } of (await gallery(page)).filter((spec) => names.includes(spec.name))) {
      await opened(page, text);
      await page.pdf({ path: paper, format: "A4" });
      const words = execFileSync("pdftotext", ["-layout", paper, "-"], { encoding: "utf8" });
      assert.equal(words.split("\f").length - 1, 1, name);
      assert.match(words, /Saw to/);
    }
  });
});

test("Names of areas stay in them, and no number of an axis lies under a handle", async () => {
  await on({}, async (page) => {
    await opened(page, area);
    const outside = () => page.evaluate(() => {
      const drawn = document.querySelector(".pole-area").getBoundingClientRect(), name = document.querySelector(".name.pole-area");
      if (!name) return 0;
      const { left, right, top, bottom } = name.getBoundingClientRect();
      return Math.max(drawn.left - left, right - drawn.right, drawn.top - top, bottom - drawn.bottom);
    });
    for (const [x, y] of [[0, 0], [200, 0], [500, 0], [600, 100], [300, -250], [-400, 200]]) {
      await page.evaluate(([dx, dy]) => {
        const { stage } = window.kempe.studio, { left, top, width, height } = stage.view, px = stage.pixel;
        window.home = window.home || [left + width / 2, top + height / 2];
        stage.look([window.home[0] - dx * px, window.home[1] - dy * px], px);
      }, [x, y]);
      assert.ok((await outside()) < 2, `moved by ${x}, ${y}`);
      const covered = await page.evaluate(() => {
        const knobs = [...document.querySelectorAll("#map .knob")].map((node) => node.getBoundingClientRect());
        return [...document.querySelectorAll("#map .m-grid text")].filter((node) => node.getAttribute("visibility") !== "hidden").filter((node) => {
          const box = node.getBoundingClientRect();
          return knobs.some((knob) => Math.min(box.right, knob.right) > Math.max(box.left, knob.left) && Math.min(box.bottom, knob.bottom) > Math.max(box.top, knob.top));
        }).length;
      });
      assert.equal(covered, 0);
    }
  });
});

test("A round obstacle is told how to be resized, and a download what to open first", async () => {
  await on({}, async (page) => {
    await rested(page);
    const told = () => page.locator("#notice-text").textContent();
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#download").click()]);
    await page.waitForFunction(() => /is saved/.test(document.getElementById("notice-text").textContent));
    assert.ok((await told()).startsWith(`${download.suggestedFilename()} is saved. In it, workshop.pdf has the drawings at full size, bom.csv what to buy`));
    await page.locator("#add").click();
    await page.locator("#add-circle").click();
    assert.match(await told(), /rim or type its radius/);
  });
});
