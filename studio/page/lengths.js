// The eight lengths of a design and its four links, as tables: on the page and on paper.
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

  /** The distances between the joints of a link, named by its joints' letters. */
  function distances(letters, lengths) {
    const pairs = [...letters].flatMap((one, i) => [...letters].slice(i + 1).map((other) => lengths[one + other] ?? lengths[other + one]));
    return pairs.filter(Number.isFinite).map((mm) => mm.toFixed(2)).join(", ");
  }

  /** `answer`: a design of the engine. On paper the eight lengths stand two and two, and nothing points at a button. */
  kempe.lengthTables = function ({ lengths, design }, onPaper = false) {
    const { make } = kempe, { mechanism } = design, help = (textContent) => make("p", { className: "help", textContent });
    const links = (mechanism.links || []).map(({ name, joints, shape, layer }) => {
      const letters = Array.isArray(joints) ? joints.join("") : String(joints || name);
      return [name, distances(letters, lengths), letters.length > 2 ? shape : "strip", String(layer ?? "–")];
    });
    const all = Object.entries(lengths).map(([name, mm]) => [name, mm.toFixed(2)]);
    const roles = ["pole", "tracer", "pen"].filter((role) => mechanism[role]).map((role) => `${mechanism[role]} is the ${role}`).join(", ");
    return [
      help(`Between the middles of the joints, in mm; their letters stand in the drawing: ${roles}.`),
      onPaper ? table(["Length", "mm", "Length", "mm"], all.slice(0, 4).map((row, i) => [...row, ...all[i + 4]])) : table(["Length", "mm"], all),
      table(["Link", "Between joints, mm", "Shape", "Layer"], links),
      help(`All links ${kempe.figure(mechanism.link_width_mm)} mm wide and ${kempe.figure(mechanism.thickness_mm)} mm thick.${onPaper ? "" : more}`),
    ];
  };
})((globalThis.kempe = globalThis.kempe || {}));
