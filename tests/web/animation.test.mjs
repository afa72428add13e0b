// Pages of linkages in a browser: the animation against the table that `kempe solve` writes, the instant centres against their
// theorem. Claims, one a test.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { launch, newPage } from "./chromium.mjs";

const kempe = process.env.KEMPE, linkages = process.env.KEMPE_LINKAGES;
if (!kempe || !linkages) {
  console.error("KEMPE names no program, or KEMPE_LINKAGES no folder of linkage files: run through ctest");
  process.exit(1);
}
const folder = mkdtempSync(path.join(tmpdir(), "kempe-animation-"));
let browser;
before(async () => { browser = await launch(); });
after(async () => { await browser.close(); rmSync(folder, { recursive: true, force: true }); });

const pageOf = (name) => path.join(folder, `${name}.html`);
const example = (name) => path.join(linkages, `${name}.toml`);

/** The table of a linkage, with as many steps as the page has moments: rows of numbers by column. */
function tableOf(name, steps) {
  const file = path.join(folder, `${name}.csv`);
  execFileSync(kempe, ["solve", example(name), "-o", file, "--steps", `${steps}`, "--velocities", "--accelerations"]);
  const [head, ...rows] = readFileSync(file, "utf8").trim().split("\n").map((line) => line.split(","));
  return rows.map((row) => Object.fromEntries(head.map((column, i) => [column, row[i] === "" ? null : Number(row[i])])));
}

/** Opens the page at its first moment, standing still. */
async function on(name, body, arguments_ = [example(name), "-o", path.join(folder, "unused.csv")], code = 0, command = "solve") {
  const made = spawnSync(kempe, [command, ...arguments_, "--animate", pageOf(name)], { encoding: "utf8" });
  assert.equal(made.status, code, made.stderr);
  const { page, context, faults } = await newPage(browser, { viewport: { width: 1400, height: 900 } });
  try {
    await page.goto(`${pathToFileURL(pageOf(name)).href}#0`);
    await body(page);
    assert.deepEqual(faults, [], "the page complained or asked for something");
  } finally {
    await context.close();
  }
}

const column = (row, name, what) => {
  const found = Object.keys(row).filter((key) => key.startsWith(`${name}_${what}_`));
  assert.equal(found.length, 1, `${name}_${what}: ${found}`);
  return row[found[0]];
};

const goTo = (page, moment) => page.locator("#moment").evaluate((slider, to) => {
  slider.value = to;
  slider.dispatchEvent(new Event("input"));
}, moment);

/** From where to where each drawn arrow of a kind leads, by the point's name; y upward. */
const arrowsOf = (page, kind) => page.evaluate((name) => {
  const names = Object.fromEntries([...document.querySelectorAll(".name")].map((e) => [e.id.slice(4), e.textContent]));
  return [...document.querySelectorAll(`.rate.${name}`)].filter((e) => e.getAttribute("d")).map((e) => {
    const [x, y, u, v] = e.getAttribute("d").match(/^M(\S+) (\S+)L(\S+) ([^M]+)/).slice(1).map(Number);
    return { name: names[e.id.slice(1)], from: [x, -y], way: [u - x, y - v] };
  });
}, kind);

/** The longest arrow of a kind in the whole motion, as the page states it. */
const longest = async (page, kind) =>
  Number((await page.locator(`#arrowkey .${kind}`).textContent()).match(/longest ([\d.e+-]+)/)[1]);

for (const name of ["watt-six-bar", "slider-crank", "geared-five-bar"])
  test(`The arrows of ${name} are the table's velocities and accelerations`, async () => {
    await on(name, async (page) => {
      await page.keyboard.press("v");
      await page.keyboard.press("a");
      const last = Number(await page.locator("#moment").getAttribute("max")), table = tableOf(name, last);
      assert.equal(table.length, last + 1);
      for (const [kind, letter] of [["velocities", "v"], ["accelerations", "a"]]) {
        const most = await longest(page, kind);
        let scale = null, compared = 0;
        for (let n = 0; n < 10; ++n) {
          const moment = Math.round((n + 0.3) * last / 10), row = table[moment];
          await goTo(page, moment);
          for (const arrow of await arrowsOf(page, kind)) {
            if (!Object.keys(row).some((key) => key.startsWith(`${arrow.name}_x_`))) continue;
            const rate = ["x", "y"].map((axis) => column(row, arrow.name, letter + axis));
            scale ??= Math.hypot(...arrow.way) / Math.hypot(...rate);
            const miss = Math.hypot(arrow.way[0] - scale * rate[0], arrow.way[1] - scale * rate[1]);
            assert.ok(miss < 1e-6 * scale * most, `${kind} of ${arrow.name} at ${moment}: ${arrow.way} is not ${scale} times ${rate}`);
            const place = ["x", "y"].map((axis) => column(row, arrow.name, axis));
            assert.ok(Math.hypot(arrow.from[0] - place[0], arrow.from[1] - place[1]) < 1e-5, `${arrow.name} at ${moment}`);
            ++compared;
          }
        }
        assert.ok(compared >= 10, `only ${compared} ${kind}`);
      }
    });
  });

test("The plots' values under the pointer are the table's", async () => {
  await on("watt-six-bar", async (page) => {
    const last = Number(await page.locator("#moment").getAttribute("max")), table = tableOf("watt-six-bar", last);
    const option = (select, label) => page.locator(select).selectOption({ label });
    const values = async (plot) => (await page.locator(`#plot${plot} output`).allTextContents()).map((text) => Number(text.replace("\u2212", "-")));
    const near = (a, b) => Math.abs(a - b) <= 1e-5 * Math.abs(b) + 1e-6;
    for (const share of [0.2, 0.43, 0.77]) {
      await option("#of", "E");
      for (const plot of [0, 1, 2]) {
        const box = await page.locator(`#plot${plot} svg`).boundingBox();
        await page.mouse.move(box.x + share * box.width, box.y + 0.5 * box.height);
        const moment = Number(await page.locator("#moment").inputValue()), row = table[moment];
        const asked = (share * 400 - 58) / (400 - 58 - 12);  // the plot's frame in its own units
        assert.ok(Math.abs(moment / last - asked) < 0.01, `${moment} of ${last} at ${asked}`);
        const shown = await values(plot), letter = ["", "v", "a"][plot];
        const told = ["x", "y"].map((axis) => column(row, "E", letter + axis));
        for (const axis of [0, 1]) assert.ok(near(shown[axis], told[axis]), `plot ${plot} at ${moment}: ${shown} is not ${told}`);
      }
      await option("#of", "rocker");
      const row = table[Number(await page.locator("#moment").inputValue())];
      const shown = [await values(0), await values(1), await values(2)].flat();
      assert.ok(Math.abs(Math.sin((shown[0] - row.rocker_angle_deg) * Math.PI / 360)) < 1e-5, "the angle, whole turns apart");
      assert.ok(near(shown[1], row.rocker_rate_rad_per_s) && near(shown[2], row.rocker_acceleration_rad_per_s2), `${shown}`);
    }
  });
});

test("Keys and buttons switch arrows, polygons and reactions on and off", async () => {
  await on("shear-press-forces", async (page) => {
    const drawn = async (kind) => (await arrowsOf(page, kind)).length > 0;
    await goTo(page, 90);
    for (const kind of ["velocities", "accelerations", "reactions"]) {
      const button = page.locator(`#${kind}`), polygon = page.locator(`#polygon-${kind}`);
      for (const [act, wanted] of [[() => button.click(), true], [() => page.keyboard.press(kind[0]), false], [() => page.keyboard.press(kind[0].toUpperCase()), true], [() => button.click(), false]]) {
        await act();
        assert.equal(await drawn(kind), wanted, kind);
        assert.equal(await button.getAttribute("aria-pressed"), `${wanted}`);
        if (kind !== "reactions") assert.equal(await polygon.isVisible(), wanted, `polygon of ${kind}`);
      }
    }
  });
});

test("A point taken by hand leads the linkage", async () => {
  await on("watt-six-bar", async (page) => {
    const at = (moment) => goTo(page, moment).then(() => page.evaluate(() => {
      const t = document.querySelectorAll(".name"), e = [...t].find((one) => one.textContent === "A"), o = 1.0;
      const s = document.getElementById("picture"), offset = JSON.parse(document.getElementById("scene").textContent).offset * o;
      const p = new DOMPoint(Number(e.getAttribute("x")) - offset, Number(e.getAttribute("y")) + offset).matrixTransform(s.getScreenCTM());
      return { x: p.x, y: p.y };
    }));
    const to = await at(30), from = await at(20);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 5 });
    await page.mouse.up();
    assert.ok(Math.abs(Number(await page.locator("#moment").inputValue()) - 30) <= 1);
  });
});

test("Where links turn back and where a change point stops the motion is said on the page", async () => {
  const file = path.join(folder, "kite.toml");
  writeFileSync(file, `name = "A parallelogram up to its change point"
ground = { O = [0, 0], D = [100, 0] }
links.crank = { joints = ["O", "A"], O-A = 40 }
links.coupler = { joints = ["A", "B"], A-B = 100 }
links.rocker = { joints = ["D", "B"], D-B = 40 }
drivers = [{ angle = "crank", from_deg = 60, to_deg = 240 }]
motion.steps = 36
guess = { A = [20, 35], B = [120, 35] }
`);
  await on("kite", async (page) => {
    assert.match(await page.locator("#marks").textContent(), /step 24 change point: O, A and B in line/);
    await page.locator("#marks button").last().click();
    assert.match(await page.locator("#step").textContent(), /^step 24 of/);
    assert.match(await page.locator("header").textContent(), /ends early: change point/);
  }, [file, "-o", path.join(folder, "unused.csv")], 3);
  await on("watt-six-bar", async (page) => {
    const words = await page.locator("#marks li").allTextContents();
    assert.ok(words.filter((text) => /rocker.* turns? back/.test(text)).length >= 2, `${words}`);
    assert.ok(words.every((text) => /step [\d.]+ \S/.test(text)), `${words}`);
  });
});

/** The wanted places of a generator's page: where their rings stand, and what the table says; y upward. */
const wantedOn = (page) => page.evaluate(() => {
  const numbers = (text) => text.match(/-?\d+(\.\d+)?/g).map(Number);
  const ends = (path) => path.getAttribute("d").match(/-?\d+(\.\d+)?/g).map(Number);
  return {
    rings: [...document.querySelectorAll("#wanted circle")].map((ring) => [Number(ring.getAttribute("cx")), -Number(ring.getAttribute("cy"))]),
    order: [...document.querySelectorAll("#wanted text")].map((text) => text.textContent),
    axes: [...document.querySelectorAll("#wanted path")].map(ends).map(([x, y, u, v]) => (Math.atan2(v - y, x - u) * 180) / Math.PI),
    rows: [...document.querySelectorAll("#wantedbox tbody tr")].map((row) => [...row.cells].map((cell) => cell.textContent)),
    places: [...document.querySelectorAll("#wantedbox tbody td:nth-child(2)")].map((cell) => numbers(cell.textContent)),
  };
});

/** The page of `kempe path` for a spec of the examples, and the same linkage moved by `kempe solve` in so many steps. */
async function onPath(name, steps, body) {
  const file = path.join(folder, `${name}-path.toml`), table = path.join(folder, `${name}-path.csv`);
  await on(`${name}-path`, async (page) => {
    execFileSync(kempe, ["solve", file, "-o", table, "--steps", `${steps}`]);
    const [head, ...rows] = readFileSync(table, "utf8").trim().split("\n").map((line) => line.split(","));
    const of = (name_) => rows.map((row) => Number(row[head.indexOf(name_)]));
    await body(page, of, readFileSync(path.join(linkages, "..", "generators", `${name}.toml`), "utf8"));
  }, [path.join(linkages, "..", "generators", `${name}.toml`), "-o", file], 0, "path");
}

test("The page of a path generator shows the wanted places in order, and how far the curve passes each", async () => {
  await onPath("loop", 17, async (page, of, spec) => {
    const asked = [...spec.split("driver_deg")[0].matchAll(/\[([-\d.]+), ([-\d.]+)\]/g)].map((m) => [Number(m[1]), Number(m[2])]);
    const { rings, order, rows, axes, places } = await wantedOn(page), x = of("P_x_mm"), y = of("P_y_mm");
    assert.equal(asked.length, 18);
    assert.equal(rings.length, 18);
    assert.deepEqual(order, asked.map((_, i) => `${i + 1}`));
    assert.deepEqual(axes, []);
    let most = 0;
    for (const [i, [wantedX, wantedY]] of asked.entries()) {
      assert.ok(Math.hypot(rings[i][0] - wantedX, rings[i][1] - wantedY) < 1e-4, `ring ${i + 1} at ${rings[i]}`);
      assert.ok(Math.hypot(places[i][0] - wantedX, places[i][1] - wantedY) < 1e-3, `row ${i + 1}: ${places[i]}`);
      const off = Math.hypot(x[i] - wantedX, y[i] - wantedY);
      assert.ok(Math.abs(Number(rows[i][3]) - off) < 0.006 * off, `row ${i + 1}: ${rows[i][3]} is not ${off}`);
      most = Math.max(most, off);
      // Its button brings P there, as near as the moments lie.
      await page.locator("#wantedbox button").nth(i).click();
      const shown = (await page.locator("[id^=place]:not(#places)").first().textContent()).match(/-?\d+\.\d+/g).map(Number);
      assert.ok(Math.hypot(shown[0] - x[i], shown[1] - y[i]) < 0.02, `button ${i + 1}: ${shown}`);
    }
    const told = Number((await page.locator("header").textContent()).match(/18 wanted places of P: off by at most ([\d.]+) mm/)[1]);
    assert.ok(Math.abs(told - most) < 0.006 * most, `${told} is not ${most}`);
  });
});

test("The page of poses shows each as a frame, and the coupler carries its own over them", async () => {
  await onPath("five-poses", 60, async (page, of, spec) => {
    const asked = [...spec.matchAll(/\[(-?\d+), (-?\d+), (-?\d+)\]/g)].map((m) => m.slice(1).map(Number));
    const { rings, rows, axes } = await wantedOn(page);
    assert.equal(asked.length, 5);
    assert.equal(rings.length, 5);
    for (const [i, [x, y, turned]] of asked.entries()) {
      assert.ok(Math.hypot(rings[i][0] - x, rings[i][1] - y) < 0.01, `ring ${i + 1} at ${rings[i]}`);
      assert.ok(Math.abs(axes[i] - turned) < 0.1, `frame ${i + 1} turned by ${axes[i]}`);
      assert.deepEqual(rows[i].slice(2), [`${turned}°`, "<\u00a01e-9", "<\u00a01e-9"]);
    }
    assert.match(await page.locator("header").textContent(), /5 wanted poses: off by less than 1e-9 mm and less than 1e-9 degrees/);
    // At the last pose, which is the last moment, the carried frame lies on the wanted one.
    await page.locator("#wantedbox button").last().click();
    const gap = await page.evaluate(() => {
      const end = (path) => { const [x, y] = path.getAttribute("d").match(/-?\d+(\.\d+)?/g).map(Number); return new DOMPoint(x, y).matrixTransform(path.getScreenCTM()); };
      const wanted = end([...document.querySelectorAll("#wanted path")].at(-1)), carried = end(document.querySelector("[id^=body] .spoke"));
      return Math.hypot(wanted.x - carried.x, wanted.y - carried.y);
    });
    assert.ok(gap < 0.5, `${gap} pixels apart`);
    assert.equal(of("P_x_mm").length, 61);
    assert.ok(Math.hypot(of("P_x_mm")[60] - 88, of("P_y_mm")[60] - 20) < 1e-6);
  });
});

test("The page of instant centres shows at each step two lines that meet in the centre, through centres shown before", async () => {
  const file = path.join(folder, "centres.html");
  execFileSync(kempe, ["centres", example("watt-six-bar"), "--at", "20", "--page", file]);
  const { page, context, faults } = await newPage(browser, { viewport: { width: 1400, height: 900 } });
  try {
    await page.goto(pathToFileURL(file).href);
    const steps = await page.locator("#steps li").count();
    assert.equal(steps, 8);  // 15 pairs of six links less the seven joints
    let told = 0;
    for (let step = 0; step <= steps; ++step) {
      await page.keyboard.press("ArrowRight");  // from the whole picture to the joints alone, then step by step
      const seen = await page.evaluate(() => {
        const visible = (node) => getComputedStyle(node).visibility === "visible";
        const dots = Object.fromEntries([...document.querySelectorAll("#centres circle[data-centres]")].filter(visible).flatMap((dot) =>
          dot.dataset.centres.split(" ").map((name) => [name, [Number(dot.getAttribute("cx")), Number(dot.getAttribute("cy"))]])));
        const lines = [...document.querySelectorAll("#centres .lines.now .line")].map((line) => line.getAttribute("d").match(/-?[\d.]+/g).map(Number));
        const now = document.querySelector("#steps li.now")?.dataset;
        return { dots, lines, now: now && { ...now }, others: [...document.querySelectorAll("#centres .lines:not(.now)")].filter(visible).length };
      });
      assert.equal(seen.others, 0);
      assert.equal(Boolean(seen.now), step > 0);
      if (!seen.now) continue;
      assert.equal(seen.lines.length, 2);
      if (!seen.dots[seen.now.centre]) assert.match(await page.locator("#told").textContent(), /, outside the picture$/);
      const away = ([x, y], [x1, y1, x2, y2]) => Math.abs((x - x1) * (y2 - y1) - (y - y1) * (x2 - x1)) / Math.hypot(x2 - x1, y2 - y1);
      const used = seen.now.uses.split(" ");
      for (const [i, line] of seen.lines.entries())
        for (const name of [seen.now.centre, used[2 * i], used[2 * i + 1]])
          if (seen.dots[name] && !(await page.locator(`text[data-inset][data-centres~="${name}"]`).count()))
            assert.ok(away(seen.dots[name], line) < 0.2, `${name} is off a line of ${seen.now.centre} by ${away(seen.dots[name], line)}`);
      ++told;
    }
    assert.equal(told, steps);
    assert.deepEqual(faults, [], "the page complained or asked for something");
  } finally {
    await context.close();
  }
});
