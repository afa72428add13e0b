// The report in a browser. Claims, one a test; run by CTest (tests/web/CMakeLists.txt).
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { readFileSync } from "node:fs";
import path from "node:path";
import { folder, launch, open, screenOf, shown } from "./browser.mjs";

const specimens = ["plagiograph", "matlab-circle", "half-turn", "hostile"];
const isLive = process.env.KEMPE_LIVE !== "0";
const live = isLive ? test : () => {};
let browser;
before(async () => { browser = await launch(); });
after(async () => { await browser.close(); });

async function on(name, options, body) {
  const opened = await open(browser, name, options);
  try {
    await body(opened.page, opened.faults);
    assert.deepEqual(opened.faults, [], "the page complained or asked for something");
  } finally {
    await opened.context.close();
  }
}

const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** The lengths of the linkage and the copy, from what the page shows. */
function checkPose({ model, pose, tracer, pen, k }) {
  const [V, A, B, C, X, Y] = pose, s = Math.hypot(...model.s), scale = model.VA + model.VB;
  const expected = [[V, A, model.VA], [V, B, model.VB], [A, C, model.VB], [B, C, model.VA], [A, X, model.VB / s], [B, Y, model.VA * s]];
  for (const [a, b, length] of expected) assert.ok(Math.abs(distance(a, b) - length) < 1e-9 * scale, "a link has lost its length");
  const reach = [tracer[0] - model.pole[0], tracer[1] - model.pole[1]];
  const image = [model.pole[0] + k[0] * reach[0] - k[1] * reach[1], model.pole[1] + k[0] * reach[1] + k[1] * reach[0]];
  assert.ok(distance(pose[model.joints.pen], image) < 1e-9 * scale, "the pen is not at the similar image");
  assert.ok(distance(pen, image) < 1e-9 * scale);
  assert.ok(distance(pose[model.joints.tracer], tracer) < 1e-9 * scale);
  assert.ok(distance(pose[model.joints.pole], model.pole) < 1e-9 * scale, "the pole has moved");
}

test("The report that should be alive is alive", async () => {
  await on("plagiograph", {}, async (page) => {
    const found = await page.evaluate(() => Boolean(window.kempe && window.kempe.report));
    assert.equal(found, isLive, isLive ? "report.html was built without JSXGraph" : "");
  });
});

for (const name of specimens)
  test(`The ${name} report opens without a complaint and without a network`, async () => {
    await on(name, {}, async (page) => {
      assert.equal(await page.evaluate(() => window.hostile), undefined, "text from outside has run as a script");
      assert.equal(await page.locator("#map .m-mechanism .link").count(), 4);
    });
  });

test("Without JavaScript the design is drawn and the controls are hidden", async () => {
  await on("plagiograph", { javaScriptEnabled: false }, async (page) => {
    assert.ok(await page.locator("#map .m-mechanism .link").first().isVisible());
    if (isLive) assert.equal(await page.locator("#controls").isVisible(), false);
  });
});

live("The page's kinematics and gaps are the library's on a thousand positions", async () => {
  let positions = 0;
  for (const name of specimens)
    await on(name, {}, async (page) => {
      const cases = JSON.parse(readFileSync(path.join(folder, `${name}.positions.json`), "utf8"));
      const found = await page.evaluate((tracers) => {
        const { linkage, contacts } = window.kempe.report;
        return tracers.map((tracer) => {
          const { why, opening, pose } = linkage.poseWithTracerAt(tracer);
          if (why) return { why };
          const gaps = contacts.gaps(pose);
          return { opening, pose, transmission: linkage.transmissionAt(opening), gaps: gaps.map(({ gap }) => gap), names: gaps.map(({ names }) => names) };
        });
      }, cases.map(({ tracer }) => tracer));
      cases.forEach((expected, i) => {
        ++positions;
        const here = found[i], at = `${name} ${JSON.stringify(expected.tracer)}`;
        assert.equal(here.why, expected.why, at);
        if (expected.why) return;
        assert.ok(Math.abs(here.opening - expected.opening) < 1e-9, at);
        assert.ok(Math.abs(here.transmission - expected.transmission) < 1e-9, at);
        here.pose.forEach((point, j) => assert.ok(distance(point, expected.pose[j]) < 1e-9 * expected.scale, at));
        expected.gaps.forEach((gap, j) => assert.ok(Math.abs(here.gaps[j] - gap) < 1e-9 * expected.scale, `${at} ${here.names[j]}: ${here.gaps[j]}, ${gap}`));
        if (expected.obstacle_gap !== null) {
          // The pole post and what is at rest do not move: the library asks for them once, not at every place.
          const bodies = ["router", "grip", "holder"];
          const asked = (j) => !here.names[j][0].startsWith("pole post") || bodies.includes(here.names[j][1]);
          const least = Math.min(...here.gaps.filter((_, j) => j >= expected.gaps.length && asked(j)));
          assert.ok(Math.abs(least - expected.obstacle_gap) < 2e-3, `${at}: ${least}, ${expected.obstacle_gap}`);
        }
      });
    });
  assert.ok(positions >= 1000);
});

live("Dragging the tracer moves the linkage, keeps its lengths and draws both lines", async () => {
  await on("plagiograph", {}, async (page) => {
    const start = await shown(page), [x, y] = start.tracer;
    const from = await screenOf(page, [x, y]);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    for (let i = 1; i <= 40; ++i) {
      const to = await screenOf(page, [x * Math.cos(i / 25) - y * Math.sin(i / 25), x * Math.sin(i / 25) + y * Math.cos(i / 25)]);
      await page.mouse.move(to.x, to.y);
      if (i % 8 === 0) checkPose(await shown(page));
    }
    await page.mouse.up();
    const end = await shown(page);
    checkPose(end);
    const wanted = [x * Math.cos(1.6) - y * Math.sin(1.6), x * Math.sin(1.6) + y * Math.cos(1.6)];
    assert.ok(distance(end.tracer, wanted) < 1, "the tracer did not follow the pointer");
    const drawn = await page.evaluate(() => Object.values(window.kempe.report.stage.trails).map((trail) => trail.length));
    assert.ok(drawn.every((count) => count >= 40), `drawn: ${drawn}`);
  });
});

live("A body moves with its point, and its name with it", async () => {
  await on("router", {}, async (page) => {
    const off = () => page.evaluate(() => {
      const { here } = window.kempe.report, [x, y] = here.pen, box = document.querySelector(".m-bodies .thing").getBoundingClientRect();
      const wanted = new DOMPoint(x + 3, -(y - 4)).matrixTransform(document.getElementById("map").getScreenCTM());
      const name = document.querySelector(".words .bodies").getBoundingClientRect();
      return { body: Math.hypot(box.x + box.width / 2 - wanted.x, box.y + box.height / 2 - wanted.y), name: [name.x - box.x, name.y - box.y] };
    });
    const first = await off();
    assert.ok(first.body < 1, `${first.body} px off at first`);
    await page.evaluate(() => window.kempe.report.moveTo([40, 40]));
    const then = await off();
    assert.ok(then.body < 1, `${then.body} px off after a move`);
    first.name.forEach((part, i) => assert.ok(Math.abs(part - then.name[i]) < 1));
  });
});

live("A body that is fixed to a link turns with it", async () => {
  await on("router", {}, async (page) => {
    const off = () => page.evaluate(() => {
      const [V, , B] = window.kempe.report.here.pose;
      const node = document.querySelectorAll(".m-bodies .thing")[1], [, x, y] = node.getAttribute("d").match(/^M\s*([-\d.]+)[ ,]*([-\d.]+)/);
      const length = Math.hypot(B[0] - V[0], B[1] - V[1]), [c, s] = [(B[0] - V[0]) / length, (B[1] - V[1]) / length];
      const corners = [[-4, -3], [9, -3], [9, 4], [2, 1], [-4, 4]].map(([u, v]) => [V[0] + u * c - v * s, V[1] + u * s + v * c]);
      const at = new DOMPoint(Number(x), Number(y)).matrixTransform(node.getScreenCTM()), map = document.getElementById("map").getScreenCTM();
      return Math.min(...corners.map(([u, v]) => new DOMPoint(u, -v).matrixTransform(map)).map((to) => Math.hypot(at.x - to.x, at.y - to.y)));
    });
    for (const tracer of [[50, 50], [40, 40], [30, 60]]) {
      await page.evaluate((to) => window.kempe.report.moveTo(to), tracer);
      const away = await off();
      assert.ok(away < 1, `${away} px off with the tracer at ${tracer}`);
    }
  });
});

live("Dragging far outside leaves the tracer at the edge of its reach", async () => {
  await on("plagiograph", {}, async (page) => {
    const start = await shown(page), from = await screenOf(page, start.tracer), to = await screenOf(page, [start.tracer[0] * 0.2, start.tracer[1] + 2]);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 6 });
    await page.mouse.up();
    const end = await shown(page);
    checkPose(end);
    const inner = await page.evaluate(() => window.kempe.report.linkage.radii()[0]);
    assert.ok(Math.abs(Math.hypot(...end.tracer) - inner) < 1e-4 * inner);
  });
});

live("Dragging the pen moves the tracer by the inverse of the copy", async () => {
  await on("half-turn", {}, async (page) => {
    const start = await shown(page), from = await screenOf(page, start.pen), to = await screenOf(page, [start.pen[0] + 5, start.pen[1] - 4]);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 5 });
    await page.mouse.up();
    const end = await shown(page);
    checkPose(end);
    assert.ok(distance(end.pen, [start.pen[0] + 5, start.pen[1] - 4]) < 1.5);
  });
});

live("Playing carries the tracer round the source's circle, and space stops it", async () => {
  await on("matlab-circle", {}, async (page) => {
    await page.locator("#speed").selectOption("2");
    await page.locator("#play").click();
    await page.waitForFunction(() => window.kempe.report.stage.trails.pen.length > 60);
    const places = await page.evaluate(() => window.kempe.report.stage.trails);
    for (const at of places.tracer.slice(-50)) assert.ok(Math.abs(distance(at, [50, 50]) - 10) < 0.02, `${at}`);
    for (const at of places.pen.slice(-50)) assert.ok(Math.abs(distance(at, [75, 75]) - 15) < 0.03, `${at}`);
    checkPose(await shown(page));
    await page.locator("#live-board").focus();
    await page.keyboard.press("Space");
    const stopped = (await shown(page)).tracer;
    await page.waitForTimeout(150);
    assert.deepEqual((await shown(page)).tracer, stopped);
  });
});

live("A whole tour of the region is drawn, corner by corner, and then nothing new", async () => {
  await on("half-turn", {}, async (page) => {
    await page.evaluate(() => { const { report } = window.kempe; report.clear(); for (let i = 0; i < 700; ++i) report.follow(1 / 60); });
    const { trail, region, laps } = await page.evaluate(() => ({ trail: window.kempe.report.stage.trails.tracer, region: window.kempe.report.model.region, laps: window.kempe.report.tour.laps }));
    assert.ok(laps >= 1);
    for (const ring of region) for (const corner of ring) assert.ok(trail.some((at) => distance(at, corner) < 1e-6), `corner ${corner} is not drawn`);
    assert.equal(trail.filter(([x]) => Number.isNaN(x)).length, region.length, "the pen is lifted between outlines and only there");
  });
});

live("Pointing at a place says whether the tracer can go there, and why not", async () => {
  await on("plagiograph", {}, async (page) => {
    const said = async (place) => {
      const at = await screenOf(page, place);
      await page.mouse.move(at.x, at.y);
      return page.locator("#tip").innerText();
    };
    await page.locator("#zoom-all").click();
    assert.match(await said([67.5, 5]), /Free/);
    assert.match(await said([-68, 3]), /Transmission\s+\d/);
    assert.match(await said([-68, 3]), /Copy error\s+\d.*worst/);
    assert.match(await said([-68, 3]), /Smallest gap/);
    assert.match(await said([-58, 3]), /transmission angle is below the limit/);
    assert.match(await said([-20, -20]), /Beyond the change point/);
    assert.match(await said([-86, -60]), /Out of reach/);
    const bay = await page.evaluate(() => { const { opening, ...r } = window.kempe.report.linkage; const radius = 67; return [radius * Math.cos(1.2), radius * Math.sin(1.2)]; });
    assert.match(await said(bay), /Too close: link ACX and side clamp/);
  });
});

test("An obstacle is called by its name, and lines, footprint and sheets wait behind their switches", async () => {
  await on("plagiograph", {}, async (page) => {
    assert.equal(await page.locator("#map .words .m-obstacles text").innerHTML(), "side clamp");
    for (const layer of ["angle-lines", "error-lines", "tightest", "image"]) {
      const group = page.locator(`#map > .m-${layer}`).first(), visibility = () => group.evaluate((node) => getComputedStyle(node).visibility);
      assert.equal(await visibility(), "hidden", layer);
      await page.locator(`#layer-${layer}`).check();
      assert.equal(await visibility(), "visible", layer);
    }
    const levels = await page.locator("#map .m-angle-lines text").allTextContents();
    assert.ok(levels.length >= 3 && levels.every((text) => /^[1-8]0°$/.test(text)), `${levels}`);
    assert.ok((await page.locator("#map .m-error-lines .contour").count()) >= 2);
  });
});

live("A switched-off layer is hidden and still answers", async () => {
  await on("plagiograph", {}, async (page) => {
    for (const layer of ["free", "usable", "reachable", "transmission", "region", "copy", "obstacles", "grid"]) {
      const group = page.locator(`#map > .m-${layer}`).first(), visibility = () => group.evaluate((node) => getComputedStyle(node).visibility);
      assert.equal(await visibility(), "visible", layer);
      await page.locator(`#layer-${layer}`).uncheck();
      assert.equal(await visibility(), "hidden", layer);
    }
    assert.equal((await shown(page)).kind, "free");
    const at = await screenOf(page, [-68, 3]);
    await page.mouse.move(at.x, at.y);
    assert.match(await page.locator("#tip").innerText(), /Free/);
    await page.locator("#layer-mechanism").uncheck();
    assert.equal(await page.locator("#live-board > svg").first().evaluate((node) => getComputedStyle(node).visibility), "hidden");
  });
});

live("A triangular plate is a plate and no frame", async () => {
  await on("hostile", {}, async (page) => {
    const faces = page.locator(".live-link.filled.face");
    assert.equal(await faces.count(), 2);
    const seen = await faces.evaluateAll((nodes) => nodes.map((node) => [getComputedStyle(node).fill, Number(getComputedStyle(node).fillOpacity)]));
    for (const [fill, opacity] of seen) assert.ok(fill !== "none" && opacity > 0.5, `${fill} ${opacity}`);
  });
});

live("Joints' letters stay in the picture", async () => {
  for (const name of specimens)
    await on(name, {}, async (page) => {
      for (const share of [0, 0.3, 0.6, 0.9]) {
        await page.evaluate((part) => { const { report } = window.kempe; for (let i = 0; i < 600 * part; ++i) report.follow(1 / 60); }, share);
        const [board, ...labels] = await page.evaluate(() => {
          const box = (node) => { const { left, right, top, bottom } = node.getBoundingClientRect(); return { left, right, top, bottom, text: node.textContent }; };
          return [document.getElementById("live-board"), ...document.querySelectorAll(".live-label")].map(box);
        });
        for (const { left, right, top, bottom, text } of labels)
          assert.ok(left >= board.left - 4 && right <= board.right + 4 && top >= board.top - 6 && bottom <= board.bottom + 6, `${name}: ${text} leaves the picture`);
      }
    });
});

live("No joint's letter lies on another", async () => {
  for (const name of specimens)
    await on(name, { viewport: { width: 1280, height: 900 } }, async (page) => {
      for (const factor of [1, 0.4, 0.4, 0.6]) {  // a linkage that is small in its window
        await page.evaluate((zoom) => window.kempe.report.stage.zoom(zoom), factor);
        const labels = await page.evaluate(() => [...document.querySelectorAll(".live-label")].map((node) => {
          const { left, right, top, bottom } = node.getBoundingClientRect();
          return { left, right, top, bottom, text: node.textContent };
        }));
        for (const [i, one] of labels.entries())
          for (const other of labels.slice(i + 1)) {
            const across = Math.min(one.right, other.right) - Math.max(one.left, other.left), up = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
            assert.ok(across <= 1 || up <= 4, `${name}: ${one.text} lies on ${other.text}`);
          }
      }
    });
});

test("No figure of the head is cut, however narrow the page", async () => {
  for (const width of [320, 360, 390, 700, 1280])
    await on("plagiograph", { viewport: { width, height: 844 } }, async (page) => {
      await page.evaluate(() => {
        const [first] = document.querySelectorAll(".key dd");
        first.firstChild.textContent = "15679.5 × 16929.8\u00a0mm";
        document.querySelector(".keys").append(...[...document.querySelectorAll(".key")].map((node) => node.cloneNode(true)));
      });
      const cut = await page.evaluate(() => {
        const { left, right } = document.querySelector(".keys").getBoundingClientRect();
        return [...document.querySelectorAll(".key, .key dt, .key dd, .key small")].filter((node) => {
          const range = document.createRange();
          range.selectNodeContents(node);
          const box = range.getBoundingClientRect(), card = node.closest(".key").getBoundingClientRect();
          return box.left < left - 1 || box.right > right + 1 || box.right > card.right + 1;
        }).map((node) => node.textContent);
      });
      assert.deepEqual(cut, [], `${width} px`);
    });
});

live("The keyboard alone moves the tracer", async () => {
  await on("plagiograph", {}, async (page) => {
    await page.locator("#live-board").focus();
    const start = (await shown(page)).tracer;
    for (const key of ["ArrowUp", "ArrowUp", "ArrowRight", "Alt+ArrowUp"]) await page.keyboard.press(key);
    const end = await shown(page);
    checkPose(end);
    assert.ok(distance(end.tracer, [start[0] + 1, start[1] + 2.1]) < 1e-9);
    await page.keyboard.press("Home");
    assert.deepEqual((await shown(page)).tracer, start);
  });
});

live("Parts that come too close light up", async () => {
  await on("plagiograph", {}, async (page) => {
    const place = await page.evaluate(() => {
      const { linkage, contacts, model } = window.kempe.report, [near, far] = linkage.radii();
      for (let i = 0; i < 720; ++i) {
        const radius = (near + far) / 2, at = [radius * Math.cos((i * Math.PI) / 360), radius * Math.sin((i * Math.PI) / 360)];
        if (contacts.gaps(linkage.poseWithTracerAt(at).pose).some(({ gap, names }) => gap < model.clearance && names[1] === "side clamp")) return at;
      }
      return null;
    });
    assert.ok(place, "no place with contact");
    assert.equal(await page.locator(".touching").count(), 0);
    await page.evaluate((at) => window.kempe.report.moveTo(at), place);
    assert.ok((await page.locator(".live-link.touching").count()) >= 2);
    assert.equal(await page.locator("#map .thing.touching").count(), 1);
    assert.match(await page.locator("#at-gap").getAttribute("class"), /bad/);
  });
});

live("Zooming moves map and linkage together, and back", async () => {
  await on("plagiograph", {}, async (page) => {
    const apart = () => page.evaluate(() => {
      const { report } = window.kempe, [x, y] = report.here.place;
      const onMap = new DOMPoint(x, -y).matrixTransform(document.getElementById("map").getScreenCTM());
      const mark = document.querySelector(".live-mark.tracer").getBoundingClientRect();
      return Math.hypot(onMap.x - mark.x - mark.width / 2, onMap.y - mark.y - mark.height / 2);
    });
    assert.ok((await apart()) < 1);
    for (let i = 0; i < 2; ++i) await page.locator("#zoom-in").click();
    assert.ok((await apart()) < 1);
    assert.ok((await page.locator("#map .m-grid text").count()) > 4);
    await page.setViewportSize({ width: 900, height: 800 });
    await page.waitForTimeout(200);
    assert.ok((await apart()) < 1);
    await page.locator("#zoom-all").click();
    assert.ok((await apart()) < 1);
  });
});

live("The window shows the job at first and the whole map on demand", async () => {
  await on("plagiograph", {}, async (page) => {
    const outside = (box) => page.evaluate((name) => {
      const { stage, model } = window.kempe.report, [x1, y1, x2, y2] = stage.board.getBoundingBox(), [left, top, right, bottom] = model[name];
      return Math.max(x1 - left, top - y1, right - x2, y2 - bottom);
    }, box);
    assert.ok((await outside("job")) <= 0, "some of the job is cut off");
    await page.locator("#zoom-all").click();
    assert.ok((await outside("whole")) <= 0, "some of the map is cut off");
    await page.locator("#live-board").focus();
    await page.keyboard.press("0");
    assert.ok((await outside("job")) <= 0);
    assert.ok((await outside("whole")) > 0, "the job's window is no nearer than the whole map's");
  });
});

live("Mechanism and Play stand above the fold of a laptop", async () => {
  for (const name of ["matlab-circle", "half-turn", "router"])  // the others begin with a front
    await on(name, { viewport: { width: 1400, height: 900 } }, async (page) => {
      const play = await page.locator("#play").boundingBox(), map = await page.locator("#map").boundingBox();
      assert.ok(play.y + play.height < 900, `${name}: Play ends at ${play.y + play.height}`);
      assert.ok(map.y + map.height <= 900, `${name}: the mechanism's picture ends at ${map.y + map.height}`);
    });
});

test("Of nine key figures none stands in a row of its own", async () => {
  for (const width of [820, 1100, 1400])
    await on("plagiograph", { viewport: { width, height: 900 } }, async (page) => {
      const rows = await page.evaluate(() => {
        const keys = document.querySelector(".keys"), count = new Map();
        while (keys.children.length < 9) keys.append(keys.lastElementChild.cloneNode(true));
        for (const key of keys.children) {
          const { top } = key.getBoundingClientRect();
          count.set(top, 1 + (count.get(top) ?? 0));
        }
        return [...count.values()];
      });
      assert.ok(Math.min(...rows) > 1, `${width} px: rows of ${rows}`);
    });
});

test("No key figure is cut off, be there as many as a loaded design has", async () => {
  for (const [width, media] of [[1400, "screen"], [390, "screen"], [794, "print"]])
    await on("plagiograph", { viewport: { width, height: 900 } }, async (page) => {
      await page.emulateMedia({ media });
      const cut = await page.evaluate(() => {
        const keys = document.querySelector(".keys"), widest = keys.children[0];
        while (keys.children.length < 9) keys.append(keys.lastElementChild.cloneNode(true));
        for (const key of [widest, keys.children[1]]) key.querySelector("dd").firstChild.textContent = "1283 × 445\u00a0mm";
        const frame = keys.getBoundingClientRect();
        return [...keys.children].filter((key) => {
          const card = key.getBoundingClientRect(), figure = document.createRange();
          figure.selectNodeContents(key.querySelector("dd").firstChild);
          const { right } = figure.getBoundingClientRect();
          return right > card.right || right > frame.right;
        }).map((key) => key.textContent);
      });
      assert.deepEqual(cut, [], `${media}, ${width} px`);
    });
});

live("A window that has been hidden comes back as it was", async () => {
  await on("plagiograph", { viewport: { width: 794, height: 900 } }, async (page) => {
    const window = () => page.locator("#map").evaluate((map) => map.getAttribute("viewBox").split(" ").map(Number));
    const settled = () => page.waitForTimeout(400);  // the board answers to its new size after a moment
    // Paper hides the board: before it has ever measured itself, at its first window, and after it was zoomed.
    for (const zooms of [0, 1, 2]) {
      if (zooms > 1) await page.locator("#zoom-in").click();
      if (zooms) await settled();
      const before = await window();
      await page.emulateMedia({ media: "print" });
      await settled();
      assert.deepEqual(await window(), before, "on paper");
      await page.emulateMedia({ media: "screen" });
      await settled();
      const after = await window();
      before.forEach((value, i) => assert.ok(Math.abs(after[i] - value) < 0.02 * before[2], `${after} instead of ${before}`));
    }
  });
});

/** Pairs of words on the map that lie on each other, of all that are visible. */
const collisions = (page) => page.evaluate(() => {
  const visible = [...document.querySelectorAll("#map text, .live-board text")].filter((node) => getComputedStyle(node).visibility === "visible" && node.textContent.trim());
  const boxes = visible.map((node) => ({ words: node.textContent, css: node.getAttribute("class"), box: node.getBoundingClientRect() }));
  const found = [];
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(i + 1)) {
      const wide = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left), high = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
      if (wide > 1 && high > 3) found.push(`${a.words} (${a.css}) on ${b.words} (${b.css})`);
    }
  return found;
});

test("With every layer on no word lies on another", async () => {
  for (const name of specimens)
    for (const javaScriptEnabled of [true, false])
      await on(name, { viewport: { width: 1400, height: 900 } }, async (page) => {
        for (const box of await page.locator(".legend input").all()) await box.setChecked(true);
        assert.deepEqual(await collisions(page), [], name);
      });
});

test("The tolerance bars are as long as their figures say, whatever the font", async () => {
  for (const fontSize of [12, 16, 30])
    await on("plagiograph", {}, async (page) => {
      const rows = await page.evaluate((size) => {
        document.documentElement.style.fontSize = `${size}px`;
        document.body.style.fontSize = `${size}px`;
        return [...document.querySelectorAll(".budget tbody tr")].map((row) => {
          const bar = row.querySelector(".bar rect").getBoundingClientRect(), scroller = row.closest(".scroll").getBoundingClientRect();
          return { value: Number(row.querySelectorAll("td")[1].textContent), length: bar.width, left: bar.left, right: bar.right, shown: [scroller.left, scroller.right] };
        });
      }, fontSize);
      assert.ok(rows.length >= 8);
      for (const { value, length, left, right, shown } of rows) {
        assert.ok(Math.abs(length / rows[0].length - value / rows[0].value) < 0.01, `${length} px for ${value} mm, ${rows[0].length} px for ${rows[0].value} mm`);
        assert.ok(left >= shown[0] - 0.5 && right <= shown[1] + 0.5, "a bar is cut off");
      }
    });
});

test("A legend speaks in one unit of area", async () => {
  for (const name of specimens)
    await on(name, {}, async (page) => {
      const text = await page.locator(".legend").innerText();
      assert.ok(!(text.includes("mm²") && text.includes("cm²")), name);
    });
});

live("On a phone nothing overflows, and a tap brings the tracer", async () => {
  for (const name of specimens)
    await on(name, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 }, async (page) => {
      const [content, screen] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
      assert.ok(content <= screen, `${name}: ${content} wide on a screen of ${screen}`);
      if (name !== "plagiograph") return;
      await page.locator("#board").scrollIntoViewIfNeeded();
      await page.locator("#zoom-all").click();
      const at = await screenOf(page, [-60, -31]);
      await page.touchscreen.tap(at.x, at.y);
      const end = await shown(page);
      checkPose(end);
      assert.ok(distance(end.tracer, [-60, -31]) < 1.5, `${end.tracer}`);
    });
});

/** What a reader of the page would miss: boxes that hold more than they show, texts that their picture cuts. */
const hidden = (page) => page.evaluate(() => {
  const found = [];
  for (const node of document.querySelectorAll("main *:not(svg, svg *)")) {
    const hides = getComputedStyle(node).overflowX !== "visible" && !node.matches(".live-board, .live-board *");
    if (hides && node.scrollWidth > node.clientWidth + 1) found.push(`${node.tagName}.${node.className}: ${node.scrollWidth} in ${node.clientWidth}`);
  }
  for (const picture of document.querySelectorAll("main svg:not(.live-board *)")) {
    const box = picture.getBoundingClientRect();
    for (const text of picture.querySelectorAll("text")) {
      const at = text.getBoundingClientRect();
      const isCut = at.left < box.left - 0.5 || at.right > box.right + 0.5 || at.top < box.top - 1 || at.bottom > box.bottom + 1;
      if (at.width > 0 && isCut && getComputedStyle(text).visibility === "visible") found.push(`"${text.textContent}" is cut`);
    }
  }
  return found;
});

test("On a phone and on a screen every column is there and no figure is cut", async () => {
  for (const name of specimens)
    for (const phone of [true, false])
      await on(name, phone ? { viewport: { width: 390, height: 844 }, isMobile: true } : { viewport: { width: 1280, height: 900 } }, async (page) => {
        const lost = (await hidden(page)).filter((line) => phone || !line.startsWith("PRE"));  // a spec's long lines may be scrolled to on a screen
        assert.deepEqual(lost, [], `${name} at ${phone ? 390 : 1280}`);
      });
});

test("On a phone each cell of a wide table stands behind its column's heading", async () => {
  await on("plagiograph", { viewport: { width: 390, height: 844 }, isMobile: true }, async (page) => {
    const rows = await page.locator(".hardware tbody tr").evaluateAll((all) => all.map((row) => [...row.cells].slice(1).map((cell) => getComputedStyle(cell, "::before").content)));
    assert.ok(rows.length > 3);
    for (const row of rows) assert.deepEqual(row, ['"Number"', '"Diameter, mm"', '"Length needed, mm"', '"Use"']);
    assert.equal(await page.locator(".hardware thead").isVisible(), false);
  });
  await on("plagiograph", {}, async (page) => assert.equal(await page.locator(".hardware thead").isVisible(), true));
});

test("In the dark the page is dark, on paper it is light", async () => {
  await on("plagiograph", { colorScheme: "dark" }, async (page) => {
    const brightness = (selector) => page.locator(selector).evaluate((node) => getComputedStyle(node).backgroundColor.match(/\d+/g).slice(0, 3).reduce((sum, part) => sum + Number(part), 0) / 3);
    assert.ok((await brightness("body")) < 60);
    await page.emulateMedia({ media: "print" });
    assert.ok((await brightness(".map-figure")) > 240);
  });
});

test("On paper the design is drawn, the controls are gone and every section is there", async () => {
  await on("plagiograph", {}, async (page) => {
    if (isLive) await page.locator("#zoom-in").click();
    const pdf = await page.pdf({ preferCSSPageSize: true });
    assert.ok(pdf.length > 20000);
    const pages = pdf.toString("latin1").match(/\/Type\s*\/Page\b/g).length;
    assert.ok(pages >= 3 && pages <= 9, `${pages} pages`);
    await page.emulateMedia({ media: "print" });
    assert.equal(await page.locator("#map .m-mechanism").evaluate((node) => getComputedStyle(node).visibility), "visible");
    if (isLive) assert.equal(await page.locator("#live-board").isVisible(), false);
    for (const section of ["lengths", "quality", "workspace", "tolerance", "verification", "search", "spec"]) assert.ok(await page.locator(`#${section}`).isVisible(), section);
  });
});
