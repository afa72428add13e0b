// What is to be said of a place of the table: the map's own areas decide, the kinematics give the figures.
"use strict";
(function (kempe) {
  const unreachable = {
    [kempe.why.tooFar]: "Out of reach: farther than the linkage stretched straight.",
    [kempe.why.tooNear]: "Out of reach: nearer to the pole than the linkage folded.",
    [kempe.why.beyondChangePoint]: "Beyond the change point: the parallelogram would have to fold over.",
  };
  const degrees = (angle) => (angle * 180) / Math.PI;
  const minus = (text) => text.replace("-", "\u2212");
  /** What the decimals would round to 0 has two digits, as in the page's tables. */
  const mm = (value, decimals = 2) => {
    const hidesIt = Math.abs(value) > 1e-9 && Math.abs(value) < 0.5 * 10 ** -decimals;
    return minus(hidesIt ? String(Number(value.toPrecision(2))) : value.toFixed(decimals)) + "\u00a0mm";
  };

  class Places {
    constructor(model, linkage, contacts, map) {
      Object.assign(this, { model, linkage, contacts });
      const areas = (selector) => [...map.querySelectorAll(selector)];
      this.free = areas(".m-free .area");
      this.uncertain = areas(".m-uncertain .area");
      this.lost = areas(".lost");
    }

    /** True if one of the map's areas holds the place: the browser's own test, so that arcs stay true arcs. */
    holds(areas, [x, y]) {
      return areas.some((area) => area.isPointInFill(new DOMPoint(x, -y)));
    }

    /** Worst and typical copy error at an opening, between the rows of the table; nothing outside of it. */
    errorAt(opening) {
      const rows = this.model.copy_errors;
      if (rows.length < 2 || opening < rows[0][0] || opening > rows[rows.length - 1][0]) return null;
      const step = (rows[rows.length - 1][0] - rows[0][0]) / (rows.length - 1);
      const i = Math.min(rows.length - 2, Math.max(0, Math.floor((opening - rows[0][0]) / step)));
      const t = (opening - rows[i][0]) / (rows[i + 1][0] - rows[i][0]);
      return { worst: rows[i][1] + t * (rows[i + 1][1] - rows[i][1]), rss: rows[i][2] + t * (rows[i + 1][2] - rows[i][2]) };
    }

    /** Figures and a sentence for the tracer at a place. */
    at(place) {
      const found = this.linkage.poseWithTracerAt(place);
      if (found.why) return { place, kind: "outside", sentence: unreachable[found.why] };
      const gaps = this.contacts.gaps(found.pose);
      return {
        place, ...found, gaps, tightest: kempe.tightest(gaps), pen: this.linkage.copyOf(place),
        transmission: this.linkage.transmissionAt(found.opening), error: this.errorAt(found.opening), ...this.judged(place),
      };
    }

    judged(place) {
      const lost = this.lost.find((area) => this.holds([area], place));
      if (this.holds(this.free, place)) return { kind: "free", sentence: "Free: the tracer can work here." };
      if (this.holds(this.uncertain, place)) return { kind: "uncertain", sentence: "Neither proven free nor proven in contact." };
      return { kind: "lost", sentence: lost ? lost.dataset.why : "Outside the workspace." };
    }
  }

  kempe.Places = Places;
  kempe.text = { mm, degrees: (angle, decimals = 1) => minus(degrees(angle).toFixed(decimals)) + "°", point: ([x, y]) => `${minus(x.toFixed(1))}, ${minus(y.toFixed(1))}` };
})((globalThis.kempe = globalThis.kempe || {}));
