// Three plots over a driver or the time that follow the moment; the pointer on a plot leads the linkage.
"use strict";
(function (kempe) {
  const { one, svg, html, figure, minus } = kempe.elements;
  const width = 400, height = 158, frame = { left: 58, right: 388, top: 10, bottom: 132 };

  /** Multiples of a round step between two values, about `count` of them. */
  function ticks(low, high, count) {
    const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
    return multiples(low, high, [1, 2, 2.5, 5, 10].map((factor) => factor * power).find((step) => step >= raw * (1 - 1e-9)));
  }

  const degreeTicks = (low, high) => multiples(low, high, [15, 30, 45, 60, 90, 180, 360].find((step) => (high - low) / step <= 6) ?? 360);

  function multiples(low, high, step) {
    const all = [];
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) all.push(i * step);
    return all;
  }

  function tickText(value) {
    const isFar = Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-3);
    return minus(isFar ? value.toExponential(1) : String(+value.toPrecision(5)));
  }

  /** One of the three: its axes, curves, and what follows the moment. */
  class Plot {
    constructor(box, motion) {
      Object.assign(this, { box, motion, curves: [] });
      this.drawing = box.querySelector("svg");
      this.caption = box.querySelector("figcaption");
      this.drawing.setAttribute("viewBox", `0 0 ${width} ${height}`);
    }

    /** Draws the curves of one thing over another; nothing to draw hides the plot. */
    draw(plot, thing, over) {
      this.box.hidden = !plot;
      this.curves = [];
      this.drawing.replaceChildren();
      this.caption.replaceChildren();
      if (!plot) return;
      const all = (of) => Array.from({ length: this.motion.count }, (_, moment) => of(moment));
      this.across = all(over.at);
      this.curves = plot.curves.map((curve) => ({ ...curve, values: all(curve.of) }));
      const size = this.setScales(plot.title === "place" || plot.title === "angle");
      this.rounding = 1e-8 * size;  // what is smaller is the solver's rounding
      this.drawAxes(over.isAngle, 1e-12 * size);
      this.drawMarks();
      this.drawCurves();
      this.caption.append(html("b", `${plot.title}, ${plot.unit}`), ...this.curves.map((curve) => this.captionOf(curve)));
      this.drawing.setAttribute("aria-label", `${plot.title} of ${thing} over ${over.label}`);
    }

    /** x and y on the drawing of values; a rate's axis holds zero. Returns the largest size of a value. */
    setScales(mayLeaveZeroOut) {
      const values = this.curves.flatMap((curve) => curve.values).filter((value) => value !== null);
      let low = values.length ? Infinity : -1, high = values.length ? -Infinity : 1;
      for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
      const size = Math.max(Math.abs(low), Math.abs(high), 1e-9);
      if (high - low < 1e-6 * size) [low, high] = [low - 0.5 * size, high + 0.5 * size];
      if (!mayLeaveZeroOut) [low, high] = [Math.min(low, 0), Math.max(high, 0)];
      const room = 0.05 * (high - low);
      [this.low, this.high] = [low - room, high + room];
      const ends = [this.across[0], this.across[this.across.length - 1]];
      [this.first, this.end] = [Math.min(...ends), Math.max(...ends)];
      this.x = (value) => frame.left + ((frame.right - frame.left) * (value - this.first)) / (this.end - this.first || 1);
      this.y = (value) => frame.bottom - ((frame.bottom - frame.top) * (value - this.low)) / (this.high - this.low);
      return size;
    }

    drawAxes(isAngle, zero) {
      const { left, right, top, bottom } = frame;
      for (const value of isAngle && this.end - this.first >= 60 ? degreeTicks(this.first, this.end) : ticks(this.first, this.end, 6))
        this.drawing.append(svg("path", { class: "grid", d: `M${this.x(value)} ${top}V${bottom}` }),
          svg("text", { x: this.x(value), y: bottom + 14, "text-anchor": "middle" }, tickText(value)));
      for (const value of ticks(this.low, this.high, 4)) {
        const isZero = Math.abs(value) < zero;
        this.drawing.append(svg("path", { class: isZero ? "grid zero" : "grid", d: `M${left} ${this.y(value)}H${right}` }),
          svg("text", { x: left - 6, y: this.y(value) + 4, "text-anchor": "end" }, tickText(isZero ? 0 : value)));
      }
    }

    drawMarks() {
      for (const { at, words } of this.motion.scene.motion.marks) {
        const before = Math.floor(at), after = Math.min(before + 1, this.motion.last);
        const x = this.x(this.across[before] + (at - before) * (this.across[after] - this.across[before]));
        const line = svg("path", { class: "mark", d: `M${x} ${frame.top}V${frame.bottom}` });
        line.append(svg("title", {}, words));
        this.drawing.append(line);
      }
    }

    drawCurves() {
      for (const { name, values } of this.curves) {
        let path = "", isDrawing = false;
        values.forEach((value, moment) => {
          if (value !== null) path += `${isDrawing ? "L" : "M"}${this.x(this.across[moment]).toFixed(2)} ${this.y(value).toFixed(2)}`;
          isDrawing = value !== null;
        });
        this.drawing.append(svg("path", { class: `curve ${name}`, d: path }));
      }
      this.cursor = svg("path", { class: "cursor" });
      for (const curve of this.curves) curve.dot = svg("circle", { class: `at ${curve.name}`, r: 3.2 });
      this.drawing.append(this.cursor, ...this.curves.map(({ dot }) => dot));
    }

    captionOf(curve) {
      const words = html("span", "", curve.name);
      curve.output = html("output");
      words.append(html("i", curve.words), " ", curve.output);
      return words;
    }

    show(moment) {
      if (this.curves.length === 0) return;
      const x = this.x(this.across[moment]);
      this.cursor.setAttribute("d", `M${x} ${frame.top}V${frame.bottom}`);
      for (const { values, dot, output } of this.curves) {
        const value = values[moment];
        output.textContent = figure(value !== null && Math.abs(value) < this.rounding ? 0 : value);
        dot.style.display = value === null ? "none" : "";
        if (value === null) continue;
        dot.setAttribute("cx", x);
        dot.setAttribute("cy", this.y(value));
      }
    }

    /** The moment that is plotted nearest to the pointer. */
    momentAt(event) {
      const { x } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.drawing.getScreenCTM().inverse());
      const away = this.across.map((value) => Math.abs(this.x(value) - x));
      return away.indexOf(Math.min(...away));
    }
  }

  class Plots {
    constructor(motion, player) {
      Object.assign(this, { motion, player, things: kempe.plottable(motion), abscissas: kempe.abscissas(motion) });
      this.plots = [0, 1, 2].map((number) => new Plot(one(`plot${number}`), motion));
      this.offer();
      for (const plot of this.plots) this.leadFrom(plot);
      one("of").onchange = one("over").onchange = () => this.draw();
      player.followers.push((moment) => this.show(moment));
      this.draw();
    }

    /** Fills the two lists; a traced point is plotted first. */
    offer() {
      const option = (text, value) => Object.assign(html("option", text), { value });
      for (const label of new Set(this.things.map(({ group }) => group))) {
        const group = Object.assign(html("optgroup"), { label });
        this.things.forEach((thing, i) => thing.group === label && group.append(option(thing.name, i)));
        one("of").append(group);
      }
      this.abscissas.forEach(({ label }, i) => one("over").append(option(label, i)));
      const traced = this.motion.scene.motion.names[this.motion.scene.traced[0]];
      one("of").value = Math.max(0, this.things.findIndex(({ name }) => name === traced));
    }

    draw() {
      const thing = this.things[one("of").value], over = this.abscissas[one("over").value];
      this.plots.forEach((plot, i) => plot.draw(thing.plots[i], thing.name, over));
      one("overword").textContent = over.label;
      this.show(this.player.moment);
    }

    show(moment) {
      for (const plot of this.plots) plot.show(moment);
    }

    leadFrom(plot) {
      const lead = (event) => {
        const isPassing = event.type === "pointermove" && event.pointerType !== "mouse" && !event.buttons;
        if (!isPassing && plot.curves.length > 0) this.player.stopAt(plot.momentAt(event));
      };
      plot.drawing.addEventListener("pointermove", lead);
      plot.drawing.addEventListener("pointerdown", lead);
    }
  }

  kempe.Plots = Plots;
})((globalThis.kempe = globalThis.kempe || {}));
