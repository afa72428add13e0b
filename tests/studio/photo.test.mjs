// A photo of one's own bench behind the grid, set to scale by four points.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import vm from "node:vm";
import { pages, rested, root, textOf } from "./browser.mjs";

const on = pages();
const { kempe } = vm.runInNewContext(`${readFileSync(`${root}studio/page/homography.js`, "utf8")}; globalThis`, {});

/** A camera's map of the table, pixels from mm: turned, tilted, any place. */
function camera(random) {
  const turn = 2 * Math.PI * random(), scale = 2 + 8 * random(), tilt = () => 8e-4 * (random() - 0.5);
  const [c, s] = [scale * Math.cos(turn), scale * Math.sin(turn)];
  return [c, s, 1500 + 500 * random(), s, -c, 1000 + 500 * random(), tilt(), tilt(), 1];  // y is downward in a photo
}
const seen = (map, at) => kempe.mapped(map, at);
const sheet = [[0, 0], [297, 0], [297, 210], [0, 210]];

test("Four points give back the camera, whatever it was", () => {
  let state = 7, tried = 0;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  for (let i = 0; i < 500; ++i) {
    const truth = camera(random), places = sheet.map(([x, y]) => [x + 60 * (random() - 0.5), y + 60 * (random() - 0.5)]);
    const pixels = places.map((at) => seen(truth, at));
    assert.equal(kempe.whyNotSeen(pixels, places), null);
    const back = kempe.homography(pixels, places), forth = kempe.homography(places, pixels);
    for (let j = 0; j < 20; ++j) {
      const place = [700 * random() - 200, 600 * random() - 200], pixel = seen(truth, place), found = seen(back, pixel);
      assert.ok(Math.hypot(found[0] - place[0], found[1] - place[1]) < 1e-8, `${found} instead of ${place}`);
      const again = seen(forth, place);
      assert.ok(Math.hypot(again[0] - pixel[0], again[1] - pixel[1]) < 1e-7);
      ++tried;
    }
  }
  assert.equal(tried, 10000);
});

test("Four points that no camera sees so are refused with the reason", () => {
  const pixels = [[100, 900], [900, 900], [900, 300], [100, 300]];
  assert.equal(kempe.whyNotSeen(pixels, sheet), null);
  assert.match(kempe.whyNotSeen(pixels, [[0, 0], [100, 0], [200, 0], [0, 90]]), /on a line/);
  assert.match(kempe.whyNotSeen([[5, 5], [5, 5], [9, 5], [5, 9]], sheet), /on a line/);
  assert.match(kempe.whyNotSeen(pixels, [sheet[0], sheet[2], sheet[1], sheet[3]]), /exchanged/);
  assert.match(kempe.whyNotSeen(pixels, [...sheet].reverse()), /mirrored/);
  assert.equal(kempe.homography(pixels, sheet.map(() => [Infinity, 0])), null);
});

const truth = [2.6, 0.3, 260, -0.25, -2.3, 900, 2e-4, 1.1e-3, 1];

/** In the page: a photo, taken by that camera, of a table with a red square of 40 mm at (200, 120). */
async function photograph(page) {
  const corners = [[180, 100], [220, 100], [220, 140], [180, 140]].map((at) => seen(truth, at));
  await page.evaluate(async (ring) => {
    const canvas = Object.assign(document.createElement("canvas"), { width: 1200, height: 1000 }), context = canvas.getContext("2d");
    context.fillStyle = "#ddd";
    context.fillRect(0, 0, 1200, 1000);
    context.fillStyle = "#f00";
    context.beginPath();
    for (const [x, y] of ring) context.lineTo(x, y);
    context.fill();
    const blob = await new Promise((resolve) => canvas.toBlob(resolve, "image/png")), data = new DataTransfer();
    data.items.add(new File([blob], "bench.png", { type: "image/png" }));
    document.body.dispatchEvent(new DragEvent("drop", { bubbles: true, cancelable: true, dataTransfer: data }));
  }, corners);
  await page.waitForFunction(() => document.getElementById("photo").open);
}

/** The colour that the picture behind the grid has at a place of the table. */
const colourAt = (page, place) => page.evaluate(async ([x, y]) => {
  const shown = document.querySelector(".m-photo image"), picture = new Image();
  const [left, top, width, height] = ["x", "y", "width", "height"].map((name) => Number(shown.getAttribute(name)));
  picture.src = shown.getAttribute("href");
  await picture.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: picture.width, height: picture.height }), context = canvas.getContext("2d");
  context.drawImage(picture, 0, 0);
  return [...context.getImageData(((x - left) / width) * picture.width, ((-y - top) / height) * picture.height, 1, 1).data];
}, place);

test("A photo lies behind the grid to scale, and goes away again", async () => {
  await on({}, async (page) => {
    await rested(page);
    const spec = await textOf(page);
    await photograph(page);
    await page.evaluate((pixels) => pixels.forEach((at, i) => window.kempe.studio.photo.move(i, at)), sheet.map((at) => seen(truth, at)));
    assert.match(await page.locator("#photo-says").textContent(), /Four points are enough/);
    await page.locator("#photo-use").click();
    await page.waitForFunction(() => document.querySelector(".m-photo image"));
    const red = [255, 0, 0, 255], grey = [221, 221, 221, 255];
    for (const place of [[200, 120], [182, 102], [218, 138], [218, 102]]) assert.deepEqual(await colourAt(page, place), red, `${place}`);
    for (const place of [[177, 120], [223, 120], [200, 97], [200, 143], [10, 10]]) assert.deepEqual(await colourAt(page, place), grey, `${place}`);
    assert.equal(await textOf(page), spec, "a photo is no part of the spec");
    assert.ok(!(await page.evaluate(() => location.hash)).includes("blob"));
    await page.locator("#photo-remove").click();
    assert.equal(await page.locator(".m-photo image").count(), 0);
  });
});

test("The marks follow mouse and keys, and places that cannot be are refused", async () => {
  await on({}, async (page) => {
    await rested(page);
    await photograph(page);
    const knob = page.locator(".photo-knob").first(), box = await knob.locator(".ring").boundingBox(), pixels = () => page.evaluate(() => window.kempe.studio.photo.pixels);
    const [[x, y]] = await pixels();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 30, box.y + box.height / 2 - 20, { steps: 3 });
    await page.mouse.up();
    const [[u, v]] = await pixels();
    assert.ok(u > x + 10 && v < y - 10, `${u}, ${v}`);
    await knob.focus();
    await page.keyboard.press("ArrowRight");
    assert.ok(Math.abs((await pixels())[0][0] - u - 1) < 1e-9);
    await page.locator("#photo-2-x").fill("abc");
    assert.match(await page.locator("#photo-says").textContent(), /^Point 2: found “abc”/);
    assert.ok(await page.locator("#photo-use").isDisabled());
    await page.locator("#photo-2-x").fill("297,5");
    assert.ok(await page.locator("#photo-use").isEnabled());
  });
});

test("What is no picture is refused with its name", async () => {
  await on({}, async (page) => {
    await rested(page);
    await page.evaluate(() => {
      const data = new DataTransfer();
      data.items.add(new File([new Uint8Array(2000)], "noise.png", { type: "image/png" }));
      document.body.dispatchEvent(new DragEvent("drop", { bubbles: true, cancelable: true, dataTransfer: data }));
    });
    await page.waitForFunction(() => /^noise\.png: not a picture/.test(document.getElementById("notice-text").textContent));
  });
});
