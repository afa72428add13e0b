// What a spec places on the table, and the handles by which each thing is moved. A handle's move() gives the spec's new text.
"use strict";
(function (kempe) {
  const { add, subtract, times, over } = kempe.plane;
  const middle = (ring) => {
    const xs = ring.map(([x]) => x), ys = ring.map(([, y]) => y);
    return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
  };
  const isPoint = (at) => Array.isArray(at) && at.length === 2 && at.every((x) => typeof x === "number" && Math.abs(x) <= 1e8);  // farther than any spec may reach
  const isRing = (ring) => Array.isArray(ring) && ring.length > 0 && ring.every(isPoint);
  const number = (x, decimals = 2) => String(Number(x.toFixed(decimals))).replace("-", "\u2212");
  const pair = ([x, y]) => `${number(x)}, ${number(y)}`;

  function circleRing([x, y], radius) {
    return Array.from({ length: 72 }, (_, i) => [x + radius * Math.cos((i * Math.PI) / 36), y + radius * Math.sin((i * Math.PI) / 36)]);
  }

  /** A number of a shape that can be typed: its name, its value, and what a new value makes of the spec's text. */
  const measure = (name, value, text, least = -Infinity) => ({ name, value, least, text });

  /** A rectangle: its lower left corner, its upper right corner, its middle. */
  function rectangle(doc, path, name) {
    const given = doc.get(path) || {}, { at, size } = Array.isArray(given) ? { at: given.slice(0, 2), size: given.slice(2) } : given;
    if (!isPoint(at) || !isPoint(size)) return null;
    const far = add(at, size), ring = [at, [far[0], at[1]], far, [at[0], far[1]]];
    const least = 1e-3 * Math.max(...size);
    return {
      rings: [ring],
      measures: [
        measure("Width", size[0], (value) => doc.with(path, { at, size: [value, size[1]] }), 0),
        measure("Height", size[1], (value) => doc.with(path, { at, size: [size[0], value] }), 0),
        measure("Left edge", at[0], (value) => doc.with(path, { at: [value, at[1]], size })),
        measure("Lower edge", at[1], (value) => doc.with(path, { at: [at[0], value], size })),
      ],
      handles: [
        { id: `${path}.at`, label: `Lower left corner of ${name}`, at, says: pair(at), fields: [[`${path}`, "at", 0], [`${path}`, "at", 1]],
          move: ([x, y]) => doc.with(path, { at: [Math.min(x, far[0] - least), Math.min(y, far[1] - least)], size: [Math.max(far[0] - x, least), Math.max(far[1] - y, least)] }) },
        { id: `${path}.size`, label: `Upper right corner of ${name}`, at: far, says: `${number(size[0])} × ${number(size[1])}`,
          move: ([x, y]) => doc.with(path, { at, size: [Math.max(x - at[0], least), Math.max(y - at[1], least)] }) },
        { id: `${path}.middle`, label: `Middle of ${name}`, at: middle(ring), whole: true, says: "",
          move: (to) => doc.with(path, { at: add(at, subtract(to, middle(ring))), size }) },
      ],
    };
  }

  function circle(doc, path, name) {
    const given = doc.get(path) || {}, { centre, radius } = Array.isArray(given) ? { centre: given.slice(0, 2), radius: given[2] } : given;
    if (!isPoint(centre) || !(radius > 0 && radius < 1e8)) return null;
    return {
      rings: [circleRing(centre, radius)],
      measures: [
        measure("Radius", radius, (value) => doc.with(path, { centre, radius: value }), 0),
        measure("Centre, x", centre[0], (value) => doc.with(path, { centre: [value, centre[1]], radius })),
        measure("Centre, y", centre[1], (value) => doc.with(path, { centre: [centre[0], value], radius })),
      ],
      handles: [
        { id: `${path}.centre`, label: `Centre of ${name}`, at: centre, whole: true, says: pair(centre), move: (to) => doc.with(path, { centre: to, radius }) },
        { id: `${path}.radius`, label: `Radius of ${name}`, at: add(centre, [radius, 0]), says: `r ${number(radius)}`,
          move: (to) => doc.with(path, { centre, radius: Math.max(1e-3 * radius, Math.hypot(...subtract(to, centre))) }) },
      ],
    };
  }

  const mostCorners = 24;

  /** [left, lower, right, upper] of places. */
  function boxOf(points) {
    const xs = points.map(([x]) => x), ys = points.map(([, y]) => y);
    return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
  }

  /** The box of a shape with its handles; null where nothing of it has a place. */
  function boxOfShape({ rings, handles }) {
    const points = [...rings.flat(), ...handles.map(({ at }) => at)];
    return points.length ? boxOf(points) : null;
  }

  /** Whether a ring is a rectangle with upright edges. */
  function isUpright(ring) {
    const [left, lower, right, upper] = boxOf(ring), [a, b, c, d] = ring;
    const corners = ring.length === 4 && ring.every(([x, y]) => (x === left || x === right) && (y === lower || y === upper));
    return corners && right > left && upper > lower && a[0] + c[0] === b[0] + d[0] && a[1] + c[1] === b[1] + d[1] && a[0] !== c[0] && a[1] !== c[1];
  }

  /** What can be typed of a rectangle that is given by its corners; `put` makes the text of a new ring. */
  function measuresOf(ring, put) {
    const box = boxOf(ring), [left, lower, right, upper] = box;
    const placed = (to) => put(ring.map(([x, y]) => [x === left ? to[0] : to[2], y === lower ? to[1] : to[3]]));
    return [
      measure("Width", right - left, (value) => placed([left, lower, left + value, upper]), 0),
      measure("Height", upper - lower, (value) => placed([left, lower, right, lower + value]), 0),
      measure("Left edge", left, (value) => placed([value, lower, right + value - left, upper])),
      measure("Lower edge", lower, (value) => placed([left, value, right, upper + value - lower])),
    ];
  }

  /** Whether a place lies on the edge of an area, to a thousandth of its size. */
  function isOnEdge(at, rings) {
    const [left, lower, right, upper] = boxOf(rings.flat()), near = 1e-3 * Math.max(right - left, upper - lower);
    const away = (from, to) => {
      const way = subtract(to, from), length = Math.hypot(...way);
      const t = length > 0 ? Math.min(1, Math.max(0, ((at[0] - from[0]) * way[0] + (at[1] - from[1]) * way[1]) / length ** 2)) : 0;
      return Math.hypot(at[0] - from[0] - t * way[0], at[1] - from[1] - t * way[1]);
    };
    return rings.some((ring) => ring.some((from, i) => away(from, ring[(i + 1) % ring.length]) <= near));
  }

  function polygon(doc, path, name) {
    const inner = path.replace(/polygon_mm$/, "holes_mm"), hollow = inner !== path && doc.has(inner);  // holes go along
    const value = doc.get(path), one = isRing(value), rings = one ? [value] : value;
    if (!Array.isArray(rings) || rings.length === 0 || !rings.every(isRing)) return null;
    const changed = (r, i, to) => rings.map((ring, s) => ring.map((at, j) => (r === s && i === j ? to : at)));
    const shifted = (value, by) => (isPoint(value) ? add(value, by) : Array.isArray(value) ? value.map((of) => shifted(of, by)) : value);
    const put = (all) => doc.with(path, one ? all[0] : all);
    const move = (by) => {
      const text = put(shifted(rings, by));
      return hollow ? new kempe.Doc(text).with(inner, shifted(doc.get(inner), by)) : text;
    };
    const handles = [], centre = middle(rings.flat());
    if (rings.flat().length <= mostCorners)
      rings.forEach((ring, r) => ring.forEach((at, i) => handles.push({ id: `${path}.${r}.${i}`, label: `Corner ${i + 1} of ${name}`, at, says: pair(at), move: (to) => put(changed(r, i, to)) })));
    handles.push({ id: `${path}.middle`, label: `Middle of ${name}`, at: centre, whole: true, says: "", move: (to) => move(subtract(to, centre)) });
    const holes = hollow ? (isRing(doc.get(inner)) ? [doc.get(inner)] : doc.get(inner)) : [];
    const measures = rings.length === 1 && !hollow && isUpright(rings[0]) ? measuresOf(rings[0], (ring) => put([ring])) : null;
    return { rings: [...rings, ...(Array.isArray(holes) ? holes.filter(isRing) : [])], handles, ...(measures ? { measures } : {}) };
  }

  function outline(doc, table, name) {
    for (const [key, make] of [["polygon_mm", polygon], ["rectangle_mm", rectangle], ["circle_mm", circle]])
      if (doc.has(`${table}.${key}`)) return make(doc, `${table}.${key}`, name);
    return null;
  }

  /** Everything with a place. `task` is what the engine makes of the spec, `pole` where the design's pole stands; both may be absent. */
  function shapesOf(doc, task, pole) {
    const shapes = [];
    const region = outline(doc, "region", "the original") || (task && task.region.length ? { rings: task.region, handles: [] } : null);
    if (region) shapes.push({ role: "region", name: "the original", ...region });
    for (let i = 0; i < doc.count("obstacles"); ++i) {
      const name = String(doc.get(`obstacles.${i}.name`) || `obstacle ${i + 1}`), found = outline(doc, `obstacles.${i}`, name);
      const changes = { rename: (to) => doc.with(`obstacles.${i}.name`, to), without: () => doc.withoutTable(`obstacles.${i}`) };
      if (found) shapes.push({ role: "obstacle", name, index: i, layers: doc.get(`obstacles.${i}.layers`), ...changes, ...found });
    }
    const table = outline(doc, "table", "the table");
    if (table) shapes.push({ role: "table", name: "table", ...table });
    // A body's outline is seen from the point that carries it: only the linkage says where that is.
    for (let i = 0; i < doc.count("bodies"); ++i) {
      const name = String(doc.get(`bodies.${i}.name`) || `body ${i + 1}`), found = outline(doc, `bodies.${i}`, name);
      if (found) shapes.push({ role: "body", name, at: doc.get(`bodies.${i}.at`), turnsWith: doc.get(`bodies.${i}.turns_with`), carried: found.rings, rings: [], handles: [] });
    }
    let place = pole;
    if (doc.has("pole.within_mm")) {
      const area = polygon(doc, "pole.within_mm", "the pole's area");
      if (area) shapes.push({ role: "pole-area", name: "the pole's area", ...area });
    } else if (!doc.has("copy.pairs_mm") || doc.has("pole.at_mm")) {
      const at = doc.get("pole.at_mm") || [0, 0];
      if (isPoint(at)) {
        place = at;
        const measures = [0, 1].map((axis) => measure("xy"[axis], at[axis], (value) => doc.with("pole.at_mm", axis ? [at[0], value] : [value, at[1]])));
        shapes.push({ role: "pole", name: "pole", rings: [], measures, handles: [{ id: "pole.at_mm", label: "The pole", at, says: pair(at), move: (to) => doc.with("pole.at_mm", to) }] });
      }
    } else if (task && task.pole.at) place = task.pole.at;
    const ratio = ratioOf(doc, task);
    if (region && place && ratio) shapes.push(copyOf(doc, region, place, ratio));
    return shapes;
  }

  function ratioOf(doc, task) {
    if (doc.has("copy.pairs_mm")) return task ? task.k : null;
    const scale = kempe.ratio(doc.get("copy.scale") ?? 1), turn = ((doc.get("copy.rotation_deg") ?? 0) * Math.PI) / 180;
    return scale > 0 && scale <= 1e4 && Number.isFinite(turn) ? [scale * Math.cos(turn), scale * Math.sin(turn)] : null;
  }

  /** The copy; dragging its middle sets scale and rotation. */
  function copyOf(doc, region, pole, k) {
    const image = (at) => add(pole, times(k, subtract(at, pole))), centre = middle(region.rings.flat()), arm = subtract(centre, pole);
    const handles = [];
    if (!doc.has("copy.pairs_mm") && Math.hypot(...arm) > 1e-9) {
      const scale = Math.hypot(...k), turn = (Math.atan2(k[1], k[0]) * 180) / Math.PI;
      handles.push({
        id: "copy", label: "The copy: scale and rotation", at: image(centre), free: true, says: `× ${number(scale, 3)}${Math.abs(turn) > 0.005 ? `, ${number(turn, 1)}°` : ""}`,
        move: (to) => {
          const wanted = over(subtract(to, pole), arm);
          const factor = Math.max(0.01, Number(Math.hypot(...wanted).toPrecision(3))), angle = Math.round((Math.atan2(wanted[1], wanted[0]) * 180) / Math.PI);
          return new kempe.Doc(doc.with("copy.scale", factor)).with("copy.rotation_deg", angle);
        },
      });
    }
    return { role: "copy", name: "copy", rings: region.rings.map((ring) => ring.map(image)), handles };
  }

  Object.assign(kempe, { shapesOf, boxOfShape, isOnEdge, figure: number, middleOf: middle });
})((globalThis.kempe = globalThis.kempe || {}));
