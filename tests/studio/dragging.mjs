// A handle of the original dragged about, step after step, and what that costs in time and memory.

/** In the page: drags the original's first corner towards its middle and back, a step once the last one is answered and, unless `frames` is
 * false, in the picture. */
export async function drag(asked) {
  const { steps, frames = true } = typeof asked === "number" ? { steps: asked } : asked;
  const { studio } = window.kempe, times = [];
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  const rings = studio.task.region.flat(), xs = rings.map(([x]) => x), ys = rings.map(([, y]) => y);
  const middle = [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
  const { handles } = studio.shapes.find(({ role }) => role === "region"), handle = handles[0], from = handle.at;
  let none = 0, late = 0, taken = null;
  const { takeSketch } = studio;
  studio.takeSketch = function (answer) {
    takeSketch.call(this, answer);
    if (answer.kind !== "sketch") none += 1;
    if (taken) taken();
  };
  // Where a sketch takes longer than a hand's rest, the full search answers first.
  const searched = () => { late += 1; if (taken) taken(); };
  window.addEventListener("kempe-answer", searched);
  studio.begin();
  for (let i = 1; i <= steps; ++i) {
    const turn = (2 * Math.PI * i) / 200, began = performance.now();
    const answered = new Promise((resolve) => (taken = resolve));
    const before = studio.text;
    studio.drag(handle, from.map((at, axis) => at + 0.15 * (1 - Math.cos((axis + 1) * turn)) * (middle[axis] - at)));
    if (studio.text === before) continue;  // finer than the grid of the table
    await answered;
    if (frames) await frame();
    times.push(performance.now() - began);
  }
  window.removeEventListener("kempe-answer", searched);
  studio.takeSketch = takeSketch;
  studio.base = null;
  times.sort((one, other) => one - other);
  const at = (share) => times[Math.min(times.length - 1, Math.floor(share * times.length))];
  return { steps: times.length, ms_median: at(0.5), ms_95: at(0.95), ms_most: times.at(-1), without_design: none, full_searches: late };
}

/** Bytes after everything that nobody needs is gone: of the page's objects, and of both engines' memory, which never shrinks. */
export async function memory(page) {
  const session = await page.context().newCDPSession(page);
  for (let i = 0; i < 3; ++i) await session.send("HeapProfiler.collectGarbage");
  const { usedSize } = await session.send("Runtime.getHeapUsage");
  await session.detach();
  const engines = await page.evaluate(async () => {
    const { searcher, sketcher } = window.kempe.studio, asked = await Promise.all([searcher, sketcher].map((engine) => engine.ask("memory", {})));
    return asked.reduce((sum, { bytes }) => sum + bytes, 0);
  });
  return { heap_bytes: usedSize, engine_bytes: engines };
}
