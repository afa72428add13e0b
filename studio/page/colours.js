// What the colours on the table and the figures above it mean; only what is there now.
"use strict";
(function (kempe) {
  const svg = "http://www.w3.org/2000/svg";

  function swatch(id, group) {
    const root = document.createElementNS(svg, "svg"), node = document.createElementNS(svg, id === "pole" ? "circle" : "rect");
    root.setAttribute("class", `map swatch m-${id}`);
    root.setAttribute("viewBox", "0 0 24 16");
    root.setAttribute("aria-hidden", "true");
    const shape = id === "pole" ? { cx: 12, cy: 8, r: 5 } : { x: 1, y: 1, width: 22, height: 14, rx: id === "tightest" ? 7 : 2 };
    const css = { pole: "core pole", "pole-area": "pole-area", region: "outline", copy: "outline", obstacles: "thing" }[id] || (group === "lost" ? "lost" : "area");
    for (const [key, value] of Object.entries({ ...shape, class: css })) node.setAttribute(key, value);
    root.append(node);
    return root;
  }

  class Colours {
    constructor(list) {
      const { make } = kempe, { figures } = kempe.words;
      this.colours = make("div", { className: "colour-groups" });
      this.figures = make("dl", { className: "meanings" });
      list.append(this.colours, make("h3", { textContent: "The figures" }), this.figures);
      for (const [id, [name, meaning]] of Object.entries(figures)) {
        const key = document.getElementById(id).closest(".key");
        key.title = meaning;
        key.querySelector("dt").textContent = name;
        this.figures.append(make("div", { id: `meaning-${id}`, hidden: key.hidden }, make("dt", { textContent: name }), make("dd", { textContent: meaning })));
      }
      this.shown = "";
    }

    /** The names of `kempe.words.colours` that are on the table now. */
    show(present) {
      const { make } = kempe, { colours, colourGroups } = kempe.words, shown = Object.keys(colours).filter((id) => present.has(id)).join();
      if (shown === this.shown) return;
      this.shown = shown;
      this.colours.replaceChildren(...Object.entries(colourGroups).flatMap(([group, heading]) => {
        const inside = Object.entries(colours).filter(([id, [of]]) => of === group && present.has(id));
        if (!inside.length) return [];
        const items = inside.map(([id, [, name]]) => make("li", {}, swatch(id, group), name));
        return [make("section", {}, make("h3", { textContent: heading }), make("ul", {}, ...items))];
      }));
    }

    /** Figures that stand above the table only under a load. */
    showFigures(hidden) {
      for (const id of Object.keys(kempe.words.figures)) document.getElementById(`meaning-${id}`).hidden = hidden.includes(id);
    }
  }

  kempe.Colours = Colours;
})((globalThis.kempe = globalThis.kempe || {}));
