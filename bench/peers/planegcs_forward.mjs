// FreeCAD's constraint solver (planegcs, as WebAssembly from npm) on the task that kempe_forward_bench wrote.
//
// usage: node planegcs_forward.mjs FOLDER_WITH_NODE_MODULES TASK.json ROUNDS
// Prints one JSON object: CPU time per pose, poses given up, the largest distance from Kempe's points.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [, , folder, taskFile, rounds] = process.argv;
const entry = createRequire(join(resolve(folder), "here.js")).resolve("@salusoft89/planegcs/package.json");
const library = await import(pathToFileURL(join(dirname(entry), "dist", "index.js")));
const { init_planegcs_module, GcsWrapper, Algorithm } = library;
const task = JSON.parse(readFileSync(taskFile, "utf8"));
const module = await init_planegcs_module();

/** Parameters of point i stand at 2 i and 2 i + 1, since the points are pushed first. */
function sketch() {
  const wrapper = new GcsWrapper(new module.GcsSystem());
  task.start.forEach(([x, y], i) => wrapper.push_primitive({ id: `p${i}`, type: "point", x, y, fixed: task.fixed[i] }));
  task.bars.forEach(([a, b, distance], i) =>
    wrapper.push_primitive({ id: `d${i}`, type: "p2p_distance", p1_id: `p${a}`, p2_id: `p${b}`, distance }));
  return wrapper;
}

function move(wrapper, apart) {
  const { gcs } = wrapper;
  const points = task.start.length, driven = 2 * task.driven;
  let failures = 0, largest = 0;
  for (let pose = 0; pose < task.places.length; ++pose) {
    gcs.set_p_param(driven, task.places[pose][0], true);
    gcs.set_p_param(driven + 1, task.places[pose][1], true);
    if (gcs.solve_system(Algorithm.DogLeg) !== 0) ++failures;
    gcs.apply_solution();
    for (let i = 0; i < points; ++i) {
      const x = gcs.get_p_param(2 * i), y = gcs.get_p_param(2 * i + 1);
      if (!apart) continue;
      const [X, Y] = task.answer[pose * points + i];
      largest = Math.max(largest, Math.hypot(x - X, y - Y));
    }
  }
  return { failures, largest };
}

let best = Infinity, failures = 0, largest = 0;
for (let round = 0; round < Number(rounds) + 1; ++round) {
  const wrapper = sketch();
  const begin = process.cpuUsage();
  const found = move(wrapper, round === 0);  // the first round warms up and compares
  const spent = process.cpuUsage(begin);
  if (round === 0) ({ failures, largest } = found);
  else best = Math.min(best, (spent.user + spent.system) / task.places.length);
  wrapper.destroy_gcs_module();
}
console.log(JSON.stringify({ planegcs_us: best, planegcs_failures: failures, planegcs_apart_mm: largest }));
