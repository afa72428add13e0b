// The copying linkage in closed form, as kinematics/copying_linkage.cpp has it; a test compares the two on a thousand
// positions. Complex numbers and points are [re, im].
"use strict";
(function (kempe) {
  const add = (a, b) => [a[0] + b[0], a[1] + b[1]];
  const subtract = (a, b) => [a[0] - b[0], a[1] - b[1]];
  const times = (a, b) => [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
  const over = (a, b) => {
    const norm = b[0] * b[0] + b[1] * b[1];
    return [(a[0] * b[0] + a[1] * b[1]) / norm, (a[1] * b[0] - a[0] * b[1]) / norm];
  };
  const polar = (length, angle) => [length * Math.cos(angle), length * Math.sin(angle)];
  const size = (a) => Math.hypot(a[0], a[1]);
  const direction = (a) => Math.atan2(a[1], a[0]);
  const clamp = (value, lower, upper) => Math.min(upper, Math.max(lower, value));

  /** Why the tracer cannot stand somewhere. */
  const why = { tooFar: "too far", tooNear: "too near", beyondChangePoint: "beyond the change point" };

  class Linkage {
    constructor(model) {
      this.k = model.k;
      this.s = model.s;
      this.VA = model.VA;
      this.VB = model.VB;
      this.pole = model.pole;
      this.assembly = model.assembly;
      this.poleIsV = model.vertex === "pole";
      // chain = X - V as a factor of tracer - pole: 1, -1 or -k.
      this.chain = { pole: [1, 0], tracer: [-1, 0], pen: [-model.k[0], -model.k[1]] }[model.vertex];
    }

    transmissionAt(opening) {
      const angle = (sine) => Math.asin(Math.min(1, Math.abs(sine)));
      return Math.min(angle(Math.sin(opening - direction(this.s))), angle(Math.sin(opening)));
    }

    /** p + q/s with p along the x axis. */
    stretched(opening) {
      return add([this.VA, 0], over(polar(this.VB, opening), this.s));
    }

    radiusAt(opening) {
      return size(this.stretched(opening)) / size(this.chain);
    }

    /** Distances pole-tracer between which this assembly works. */
    radii() {
      const ends = this.assembly.map((opening) => this.radiusAt(opening));
      return [Math.min(...ends), Math.max(...ends)];
    }

    /** {opening}, or {why} it does not exist. */
    openingAt(radius) {
      const a = this.VA, b = this.VB / size(this.s), chain = radius * size(this.chain);
      if (!(chain > 0)) return { why: why.tooNear };
      const outer = (a + b - chain) * (a + b + chain);
      const inner = (chain - Math.abs(a - b)) * (chain + Math.abs(a - b));
      const slack = 1e-12 * (a + b) * (a + b);
      if (outer < -slack) return { why: why.tooFar };
      if (inner < -slack) return { why: why.tooNear };
      const elbow = 2 * Math.atan2(Math.sqrt(Math.max(0, outer)), Math.sqrt(Math.max(0, inner)));
      const [lower, upper] = this.assembly, middle = 0.5 * (lower + upper);
      const grows = Math.sin(middle - direction(this.s)) < 0;
      let opening = (grows ? -elbow : elbow) + direction(this.s);
      opening -= 2 * Math.PI * Math.round((opening - middle) / (2 * Math.PI));
      const rounding = 3.2e-15;
      if (opening < lower - rounding || opening > upper + rounding) return { why: why.beyondChangePoint };
      return { opening: clamp(opening, lower, upper) };
    }

    /** The six points in the order V A B C X Y. */
    poseAt(opening, bearing) {
      const unturned = over(this.stretched(opening), this.chain);
      const turn = over(polar(size(unturned), bearing), unturned);
      const p = times([this.VA, 0], turn), q = times(polar(this.VB, opening), turn);
      const points = [[0, 0], p, q, add(p, q), add(p, over(q, this.s)), add(q, times(this.s, p))];
      const ground = this.poleIsV ? points[0] : points[4];
      return points.map((at) => add(this.pole, subtract(at, ground)));
    }

    /** {pose, opening}, or {why} there is none. */
    poseWithTracerAt(tracer) {
      const reach = subtract(tracer, this.pole);
      const found = this.openingAt(size(reach));
      if (found.why) return found;
      return { opening: found.opening, pose: this.poseAt(found.opening, direction(reach)) };
    }

    /** The place nearest to `wanted` that this assembly reaches. */
    nearestReachable(wanted) {
      const reach = subtract(wanted, this.pole), radius = size(reach), [lower, upper] = this.radii();
      // A hair inside, so that rounding does not put the tracer out of reach.
      const kept = clamp(radius, lower * (1 + 1e-9), upper * (1 - 1e-9));
      return kept === radius ? wanted : add(this.pole, polar(kept, direction(reach)));
    }

    copyOf(tracer) {
      return add(this.pole, times(this.k, subtract(tracer, this.pole)));
    }
  }

  kempe.Linkage = Linkage;
  kempe.plane = { add, subtract, times, over };
  kempe.why = why;
})((globalThis.kempe = globalThis.kempe || {}));
