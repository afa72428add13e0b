// The four links of a design as a table: what lies between their joints, and what to saw. On the page and on paper.
"use strict";
(function (kempe) {
  function table(heads, rows) {
    const { make } = kempe, isNumber = heads.map((_, i) => rows.every((row) => /^[\d.]+$/.test(row[i])));
    const cell = (textContent, i) => make(i ? "td" : "th", { textContent, className: isNumber[i] ? "number" : "", ...(i ? {} : { scope: "row" }) });
    const head = (textContent, i) => make("th", { textContent, className: isNumber[i] ? "number" : "", scope: "col" });
    const body = rows.map((row) => make("tr", {}, ...row.map(cell)));
    return make("table", {}, make("thead", {}, make("tr", {}, ...heads.map(head))), make("tbody", {}, ...body));
  }

  const more = " Download has the drawings and the cutting list.";
  const shapes = { bent: "bent plate", triangle: "triangular plate" };

  /** The distances between the joints of a link, each with its joints' letters where there are several. */
  function distances(letters, lengths) {
    const pairs = [...letters].flatMap((one, i) => [...letters].slice(i + 1).map((other) => (lengths[one + other] === undefined ? other + one : one + other)));
    return pairs.filter((pair) => Number.isFinite(lengths[pair])).map((pair) => ({ pair, mm: lengths[pair] }));
  }

  /** A link in the words of a workshop. A straight one is a piece of strip, which ends half a width beyond its outermost joints. */
  function linkOf({ name, joints, shape, layer }, lengths, { orientation, link_width_mm: width }) {
    const letters = Array.isArray(joints) ? joints.join("") : String(joints || name), all = distances(letters, lengths);
    const three = letters.length > 2, straight = !three || (orientation || {})[`plate_${name}`] === 0;
    const between = three ? all.map(({ pair, mm }) => `${pair} ${mm.toFixed(2)}`).join(",\n") : all.map(({ mm }) => mm.toFixed(2)).join("");
    const saw = straight ? (Math.max(...all.map(({ mm }) => mm)) + width).toFixed(2) : "see its drawing";
    return [name, between, saw, !three ? "bar" : straight ? "straight bar, three holes" : shapes[shape] || shape, String(layer ?? "–")];
  }

  /** `answer`: a design of the engine. On paper nothing points at a button. */
  kempe.lengthTables = function ({ lengths, design }, onPaper = false) {
    const { make } = kempe, { mechanism } = design, help = (textContent) => make("p", { className: "help", textContent });
    const links = (mechanism.links || []).map((link) => linkOf(link, lengths, mechanism));
    const roles = ["pole", "tracer", "pen"].filter((role) => mechanism[role]).map((role) => `${mechanism[role]} is the ${role}`).join(", ");
    return [
      table(["Link", "Between joints, mm", "Saw to, mm", "Shape", "Layer"], links),
      help(`Between the middles of the joints; their letters stand in the drawing: ${roles}. “Saw to” is over both ends, half a width beyond the outermost joints.`),
      help(`All links ${kempe.figure(mechanism.link_width_mm)} mm wide and ${kempe.figure(mechanism.thickness_mm)} mm thick.${onPaper ? "" : more}`),
    ];
  };
})((globalThis.kempe = globalThis.kempe || {}));
