// Arrows on the picture of an animated linkage: velocities, accelerations, reactions of the joints, and the given forces.
"use strict";
(function (kempe) {
  const { one, svg, html, figure } = kempe.elements;

  /** An arrow's path from its tail; empty if it is too short for a head of the size asked. */
  function path([x, y], [u, v], head) {
    const length = Math.hypot(u, v);
    if (length < 0.43 * head) return "";
    const share = Math.min(head / length, 0.5), [tipX, tipY] = [x + u, y + v];
    const [backX, backY] = [tipX - share * u, tipY - share * v], [sideX, sideY] = [0.4 * share * v, 0.4 * share * u];
    return `M${x} ${y}L${tipX} ${tipY}M${backX - sideX} ${backY + sideY}L${tipX} ${tipY}L${backX + sideX} ${backY - sideY}`;
  }

  /** Arrows that are switched on and off together, all of one scale through the whole motion. */
  class Kind {
    /** at(index, moment) is [place, vector], or null; the arrow begins at the place, or ends there. The largest vector is drawn
        `longest` long, if that scale is not above the greatest allowed. */
    constructor({ name, unit, ids, count, at, endsAtPlace = false, longest, greatestScale = Infinity }) {
      Object.assign(this, { name, unit, count, at, endsAtPlace, isOn: false, largest: 0 });
      this.paths = ids.map((id) => svg("path", { class: `rate ${name}`, id, fill: "none" }));
      this.each((_, vector) => (this.largest = Math.max(this.largest, Math.hypot(...vector))));
      this.scale = this.largest > 0 ? Math.min(greatestScale, longest / this.largest) : 0;
    }

    each(act) {
      for (let moment = 0; moment < this.count; moment++)
        this.paths.forEach((_, index) => {
          const found = this.at(index, moment);
          if (found) act(...found);
        });
    }

    /** Tail and vector of an arrow as it is drawn. */
    drawn([x, y], [u, v]) {
      const [across, down] = [u * this.scale, v * this.scale];
      return this.endsAtPlace ? [[x - across, y - down], [across, down]] : [[x, y], [across, down]];
    }

    show(moment, head) {
      this.paths.forEach((node, index) => {
        const found = this.isOn && this.at(index, moment);
        node.setAttribute("d", found ? path(...this.drawn(...found), head) : "");
      });
    }
  }

  class Arrows {
    constructor(motion, picture) {
      const { x, y, width, height } = picture.viewBox.baseVal, { scene } = motion, { loads } = scene;
      Object.assign(this, { motion, picture, loads, home: [x, y, width, height] });
      this.extent = Math.max(width, height) / 1.18;  // of the linkage: the picture has a margin
      this.head = 1.4 * scene.offset;
      const longest = 0.2 * this.extent, points = motion.movingPoints;
      this.rates = motion.kinds.map(({ name, letter, unit, of }) => new Kind({
        name, unit, longest, count: motion.count, ids: points.map((point) => `${letter}${point}`),
        at: (index, moment) => {
          const rate = of(points[index], moment);
          return rate && [motion.place(points[index], moment), rate];
        },
      }));
      // A reaction is drawn no longer than a given force of its size: the two share a scale while reactions are on.
      this.reactions = loads && loads.reactions.length > 0 ? new Kind({
        name: "reactions", unit: "N", longest, greatestScale: loads.scale || Infinity, count: motion.count, endsAtPlace: true,
        ids: loads.reactions.map((_, index) => `r${index}`),
        at: (index, moment) => {
          const found = loads.forces[moment][index];
          return found && [found.slice(0, 2), found.slice(2)];
        },
      }) : null;
      this.layer();
    }

    kinds() {
      return this.reactions ? [...this.rates, this.reactions] : this.rates;
    }

    /** The arrows lie above the links and below the names. */
    layer() {
      const line = this.picture.querySelector(".link") || this.picture.querySelector(".pin");
      const width = Number(line?.getAttribute("stroke-width")) || this.extent / 200;
      const layer = svg("g", { "stroke-width": 0.75 * width, "stroke-linecap": "round", "stroke-linejoin": "round", "pointer-events": "none" });
      layer.append(...this.kinds().flatMap((kind) => kind.paths));
      this.picture.insertBefore(layer, this.picture.querySelector(".name"));
    }

    show(moment) {
      for (const kind of this.kinds()) kind.show(moment, this.head);
      if (this.loads) this.showForces(this.loads.moments[moment]);
    }

    /** A row of loads: the drivers' forces, then x, y, fx, fy of each given force. */
    showForces(row) {
      const { units, arrows } = this.loads, scale = this.reactions?.isOn ? this.reactions.scale : this.loads.scale;
      units.forEach((unit, driver) => {
        one(`force${driver}`).textContent = row[driver] === null ? "no force balances the loads" : `${+row[driver].toPrecision(4)} ${unit}`;
      });
      for (let arrow = 0; arrow < arrows; arrow++) {
        const [x, y, fx, fy] = row.slice(units.length + 4 * arrow, units.length + 4 * arrow + 4);
        one(`arrow${arrow}`).setAttribute("d", path([x - fx * scale, y - fy * scale], [fx * scale, fy * scale], this.head));
      }
    }

    /** Switches a kind; the picture is widened to hold every arrow that is on, at every moment. */
    turn(kind, isOn) {
      kind.isOn = isOn;
      this.widen();
      one("arrowkey").replaceChildren(...this.kinds().filter((each) => each.isOn).map(({ name, largest, unit }) =>
        html("span", `${name}: longest ${figure(largest)} ${unit}`, name)));
    }

    widen() {
      const [homeLeft, homeTop, width, height] = this.home, margin = 0.03 * this.extent;
      let [left, top, right, bottom] = [homeLeft, homeTop, homeLeft + width, homeTop + height];
      const hold = ([x, y]) => {
        left = Math.min(left, x - margin);
        right = Math.max(right, x + margin);
        top = Math.min(top, y - margin);
        bottom = Math.max(bottom, y + margin);
      };
      for (const kind of this.kinds().filter((each) => each.isOn))
        kind.each((place, vector) => {
          const [[x, y], [u, v]] = kind.drawn(place, vector);
          hold([x, y]);
          hold([x + u, y + v]);
        });
      this.picture.setAttribute("viewBox", `${left} ${top} ${right - left} ${bottom - top}`);
    }
  }

  kempe.Arrows = Arrows;
})((globalThis.kempe = globalThis.kempe || {}));
