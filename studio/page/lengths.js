// The eight lengths of a design and its four links, as tables: on the page and on paper.
"use strict";
(function (kempe) {
  const table = (heads, rows) => {
    const { make } = kempe, cells = (tag, all) => all.map((textContent, i) => make(tag, { textContent, className: i && /^[-+\d.,\s−]+$/.test(textContent) ? "number" : "" }));
    return make("table", {}, make("thead", {}, make("tr", {}, ...cells("th", heads))), make("tbody", {}, ...rows.map(([name, ...rest]) => make("tr", {}, make("th", { textContent: name, scope: "row" }), ...cells("td", rest)))));
  };
  const layerOf = ({ layer }) => (layer === undefined || layer === null ? "–" : String(layer));

  /** `answer`: a design of the engine. */
  kempe.lengthTables = function ({ lengths, design }) {
    const { make } = kempe, { mechanism } = design;
    const distance = (letters) => [...letters].flatMap((one, i) => [...letters].slice(i + 1).map((other) => lengths[one + other] ?? lengths[other + one])).filter(Number.isFinite);
    const links = (mechanism.links || []).map((link) => {
      const joints = Array.isArray(link.joints) ? link.joints.join("") : String(link.joints || link.name);
      return [link.name, distance(joints).map((mm) => mm.toFixed(2)).join(", "), joints.length > 2 ? link.shape : "strip", layerOf(link)];
    });
    const roles = ["pole", "tracer", "pen"].filter((role) => mechanism[role]).map((role) => `${mechanism[role]} is the ${role}`).join(", ");
    return [
      make("p", { className: "help", textContent: `Between the middles of the joints, in mm; their letters stand in the drawing: ${roles}.` }),
      table(["Length", "mm"], Object.entries(lengths).map(([name, mm]) => [name, mm.toFixed(2)])),
      table(["Link", "Between joints, mm", "Shape", "Layer"], links),
      make("p", { className: "help", textContent: `All links ${kempe.figure(mechanism.link_width_mm)} mm wide and ${kempe.figure(mechanism.thickness_mm)} mm thick. Download has the drawings and the cutting list.` }),
    ];
  };
})((globalThis.kempe = globalThis.kempe || {}));
