// The velocity and the acceleration polygon of a moment: the rates of all points drawn from one pole. The points of a link make
// its image there, turned and scaled.
"use strict";
(function (kempe) {
  const { one, svg } = kempe.elements;
  const size = 200, margin = 22;  // of the square that a polygon stands in; the whole motion fits between the margins

  class Polygon {
    constructor(motion, kind) {
      Object.assign(this, { motion, kind, isOn: false });
      this.figure = one(`polygon-${kind.name}`);
      this.drawing = this.figure.querySelector("svg");
      let [left, right, top, bottom] = [0, 0, 0, 0];
      for (let moment = 0; moment < motion.count; moment++)
        for (const { rate: [x, y] } of this.rates(moment)) {
          [left, right] = [Math.min(left, x), Math.max(right, x)];
          [top, bottom] = [Math.min(top, y), Math.max(bottom, y)];
        }
      this.scale = (size - 2 * margin) / (Math.max(right - left, bottom - top) || 1);
      this.pole = [(size - this.scale * (left + right)) / 2, (size - this.scale * (top + bottom)) / 2];
    }

    rates(moment) {
      return this.motion.movingPoints.map((point) => ({ point, rate: this.kind.of(point, moment) })).filter(({ rate }) => rate);
    }

    turn(isOn) {
      this.isOn = isOn;
      this.figure.hidden = !isOn;
    }

    show(moment) {
      if (!this.isOn) return;
      const [poleX, poleY] = this.pole;
      const tips = this.rates(moment).map(({ point, rate: [x, y] }) => ({ point, x: poleX + this.scale * x, y: poleY + this.scale * y }));
      this.drawing.replaceChildren(
        ...this.images(tips),
        ...tips.flatMap(({ x, y }) => [
          svg("path", { class: `ray ${this.kind.name}`, d: `M${poleX} ${poleY}L${x} ${y}` }),
          svg("circle", { class: `tip ${this.kind.name}`, cx: x, cy: y, r: 2.4 }),
        ]),
        svg("circle", { class: "pole", cx: poleX, cy: poleY, r: 3 }),
        ...this.letters(tips),
        svg("text", { x: poleX - 5, y: poleY + 12, "text-anchor": "end" }, "o"));
    }

    images(tips) {
      const { points } = this.motion.scene, images = [];
      for (let link = 1; link <= this.motion.links; link++) {
        const corners = tips.filter(({ point }) => points[point][0] === link).map(({ x, y }) => `${x} ${y}`);
        if (corners.length > 1) images.push(svg("path", { class: "image", d: `M${corners.join("L")}${corners.length > 2 ? "Z" : ""}` }));
      }
      return images;
    }

    /** Small letters at the tips, as the field writes them; tips that nearly coincide share one place. */
    letters(tips) {
      const taken = [];
      for (const { point, x, y } of tips) {
        const letter = this.motion.nameOf(point).toLowerCase(), near = taken.find((other) => Math.hypot(other.x - x, other.y - y) < 9);
        if (near) near.letters.push(letter);
        else taken.push({ x, y, letters: [letter] });
      }
      return taken.map(({ x, y, letters }) => svg("text", { x: x + 5, y: y - 4 }, letters.join(", ")));
    }
  }

  kempe.Polygon = Polygon;
})((globalThis.kempe = globalThis.kempe || {}));
