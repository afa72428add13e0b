// Grid, its figures and the scale bar for a window of the map that has been zoomed or moved.
"use strict";
(function (kempe) {
  const svg = "http://www.w3.org/2000/svg";
  const nominal = 760;
  let original = null;

  function roundStep(wanted) {
    const power = 10 ** Math.floor(Math.log10(wanted));
    return [1, 2, 5, 10].map((factor) => factor * power).find((step) => wanted <= step * (1 + 1e-9));
  }

  function element(name, attributes, text) {
    const node = document.createElementNS(svg, name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    if (text !== undefined) node.textContent = text;
    return node;
  }

  const figure = (value, step) => value.toFixed(Math.max(0, -Math.floor(Math.log10(step) + 1e-9))).replace("-", "\u2212");

  function gridOf({ left, top, width, height }) {
    const px = width / nominal, step = roundStep(width / 9), nodes = [];
    let lines = "";
    for (let i = Math.ceil(left / step); i * step <= left + width; ++i) {
      lines += `M${i * step},${top}v${height}`;
      const half = 6 * figure(i * step, step).length * px;
      if (i * step + half > left + width || i * step - half < left) continue;  // its figure would be cut
      nodes.push(element("text", { class: "tick", x: i * step, y: top + height - 12 * px, dy: ".35em" }, figure(i * step, step)));
    }
    for (let i = Math.ceil(top / step); i * step <= top + height; ++i) {
      lines += `M${left},${i * step}h${width}`;
      if (i * step < top + 7 * px || i * step > top + height - 20 * px) continue;  // it would be cut, or stand on the figures below
      nodes.push(element("text", { class: "tick start", x: left + 6 * px, y: i * step, dy: ".35em" }, figure(-i * step + 0, step)));
    }
    return [element("path", { class: "grid-line", d: lines }), ...nodes];
  }

  function scaleOf({ left, top, width, height }) {
    const px = width / nominal, length = roundStep(width / 12), x = left + width - 10 * px, y = top + height - 34 * px;
    return [
      element("path", { class: "scale-bar", d: `M${x - length},${y - 4 * px}v${8 * px}m0,${-4 * px}h${length}m0,${-4 * px}v${8 * px}` }),
      element("text", { class: "tick end strong", x: x - length - 8 * px, y, dy: ".35em" }, figure(length, length) + "\u00a0mm"),
    ];
  }

  /** Redraws the frame for a window; at home it is the page's own again. */
  kempe.drawFrame = function (map, view, isHome) {
    const groups = [map.querySelector("g.m-grid"), map.querySelector("g.m-scale")];
    if (!original) original = { nodes: groups.map((group) => [...group.childNodes]), size: map.getAttribute("font-size"), width: map.viewBox.baseVal.width };
    const drawn = isHome ? original.nodes : [gridOf(view), scaleOf(view)];
    groups.forEach((group, i) => group.replaceChildren(...drawn[i]));
    map.setAttribute("font-size", isHome ? original.size : (15 * view.width) / nominal);
  };
})((globalThis.kempe = globalThis.kempe || {}));
