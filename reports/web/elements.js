// Elements that the scripts of pages of linkages find or make, and figures as text.
"use strict";
(function (kempe) {
  const one = (id) => document.getElementById(id);

  /** An SVG element with its attributes and, where given, its text. */
  function svg(tag, attributes = {}, text) {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    if (text !== undefined) made.textContent = text;
    return made;
  }

  function html(tag, text = "", className = "") {
    const made = document.createElement(tag);
    made.textContent = text;
    if (className) made.className = className;
    return made;
  }

  const minus = (text) => text.replace("-", "\u2212");

  /** Six digits of a value; a word where there is none. */
  const figure = (value) => (value === null || value === undefined ? "none" : minus(String(+value.toPrecision(6))));

  kempe.elements = { one, svg, html, minus, figure };
})((globalThis.kempe = globalThis.kempe || {}));
