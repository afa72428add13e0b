// Gaps between the parts of the linkage, the obstacles, bodies that tracer and pen carry, and the table's edge, for one pose: distances of axes less half widths.
"use strict";
(function (kempe) {
  const add = ([x, y], [dx, dy]) => [x + dx, y + dy];
  const cross = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);

  function nearestOnSegment(at, a, b) {
    const x = b[0] - a[0], y = b[1] - a[1], squared = x * x + y * y;
    const t = squared > 0 ? Math.min(1, Math.max(0, ((at[0] - a[0]) * x + (at[1] - a[1]) * y) / squared)) : 0;
    return [a[0] + t * x, a[1] + t * y];
  }

  /** Two points, one of each shape, and their distance. */
  const span = (from, to) => ({ distance: Math.hypot(from[0] - to[0], from[1] - to[1]), from, to });
  const nearer = (one, other) => (other.distance < one.distance ? other : one);

  function betweenSegments(a, b, c, d) {
    const one = cross(c, d, a), two = cross(c, d, b), three = cross(a, b, c), four = cross(a, b, d);
    if (one * two < 0 && three * four < 0) {
      const t = one / (one - two), at = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
      return { distance: 0, from: at, to: at };
    }
    let best = span(a, nearestOnSegment(a, c, d));
    best = nearer(best, span(b, nearestOnSegment(b, c, d)));
    best = nearer(best, span(nearestOnSegment(c, a, b), c));
    return nearer(best, span(nearestOnSegment(d, a, b), d));
  }

  /** Even-odd over all rings. */
  function isInside(at, rings) {
    let inside = false;
    for (const ring of rings)
      for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
        const a = ring[i], b = ring[j];
        if (a[1] > at[1] !== b[1] > at[1] && at[0] < ((b[0] - a[0]) * (at[1] - a[1])) / (b[1] - a[1]) + a[0]) inside = !inside;
      }
    return inside;
  }

  /** A hull of one, two or three points as the ends of its edges. */
  const edgesOf = (hull) => (hull.length === 3 ? [[0, 1], [1, 2], [2, 0]] : [[0, hull.length - 1]]);

  function betweenHulls(one, other) {
    if (one.length === 3 && isInside(other[0], [one])) return { distance: 0, from: other[0], to: other[0] };
    if (other.length === 3 && isInside(one[0], [other])) return { distance: 0, from: one[0], to: one[0] };
    let best = { distance: Infinity };
    for (const [a, b] of edgesOf(one))
      for (const [c, d] of edgesOf(other)) best = nearer(best, betweenSegments(one[a], one[b], other[c], other[d]));
    return best;
  }

  function hullToObstacle(hull, obstacle) {
    if (isInside(hull[0], obstacle.rings)) return { distance: 0, from: hull[0], to: hull[0] };
    if (hull.length === 3 && isInside(obstacle.rings[0][0], [hull]))
      return { distance: 0, from: obstacle.rings[0][0], to: obstacle.rings[0][0] };
    let best = { distance: Infinity };
    for (const ring of obstacle.rings)
      for (let i = 0, j = ring.length - 1; i < ring.length; j = i++)
        for (const [a, b] of edgesOf(hull)) best = nearer(best, betweenSegments(hull[a], hull[b], ring[j], ring[i]));
    return best;
  }

  /** The direction from one place to another, of size 1. */
  function axis([x, y], [u, v]) {
    const length = Math.hypot(u - x, v - y);
    return [(u - x) / length, (v - y) / length];
  }
  const turned = ([x, y], [c, s]) => [x * c - y * s, x * s + y * c];
  const turnedBack = (at, [c, s]) => turned(at, [c, -s]);

  const shareLayer = (a, b) => Math.max(a.layers[0], b.layers[0]) <= Math.min(a.layers[1], b.layers[1]);

  class Contacts {
    constructor(model) {
      this.parts = model.parts;
      this.pairs = model.pairs.map(([i, j]) => [model.parts[i], model.parts[j]]);
      this.encounters = [];
      for (const obstacle of model.obstacles)
        for (const part of model.parts) if (shareLayer(part, obstacle)) this.encounters.push([part, obstacle]);
      // In the frame of its joint, or of its link, a body is at rest. Of two bodies one's joint meets the difference of both, but a body
      // that turns meets others with all its pieces.
      for (const other of model.others || []) {
        const parts = other.met ? [{ name: other.met.name, half_width: 0, pieces: [[other.met.joint]] }] : other.parts.map((i) => model.parts[i]);
        for (const part of parts) this.encounters.push([part, other]);
        for (const i of other.turning || []) this.encounters.push([model.turning[i], other]);
      }
    }

    /** Every pair that may touch: {names, gap, from, to}; from and to are the nearest places of the two axes. */
    gaps(pose) {
      const hulls = new Map(this.parts.map((part) => [part, part.pieces.map((piece) => piece.map((joint) => pose[joint]))]));
      const found = [];
      for (const [one, other] of this.pairs) {
        let best = { distance: Infinity };
        for (const a of hulls.get(one)) for (const b of hulls.get(other)) best = nearer(best, betweenHulls(a, b));
        found.push(gapOf(one, other, best, one.half_width + other.half_width));
      }
      for (const [part, obstacle] of this.encounters) {
        let best = { distance: Infinity };
        const at = obstacle.frame === undefined || obstacle.frame === null ? [0, 0] : pose[obstacle.frame];
        const turn = obstacle.toward === undefined ? [1, 0] : axis(at, pose[obstacle.toward]);
        for (const hull of hulls.get(part) || hullsOf(part, pose)) {
          const seen = hull.map(([x, y]) => turnedBack([x - at[0], y - at[1]], turn));
          for (const rings of obstacle.polygons || [obstacle.rings]) best = nearer(best, hullToObstacle(seen, { rings }));
        }
        const place = (seen) => add(turned(seen, turn), at);
        if (best.from) best = { distance: best.distance, from: place(best.from), to: place(best.to) };
        found.push(gapOf(part, obstacle, best, part.half_width + (obstacle.grown || 0)));
      }
      return found;
    }
  }

  /** What of a body meets others: its joint, or, where it turns with a link, its pieces beside that. */
  function hullsOf(body, pose) {
    if (!body.places) return body.pieces.map((piece) => piece.map((joint) => pose[joint]));
    const at = pose[body.joint], turn = axis(at, pose[body.toward]);
    return body.places.map((piece) => piece.map((corner) => add(turned(corner, turn), at)));
  }

  function gapOf(one, other, nearest, halfWidths) {
    return { names: [one.name, other.name], things: [one, other], gap: nearest.distance - halfWidths, from: nearest.from, to: nearest.to };
  }

  kempe.Contacts = Contacts;
  kempe.tightest = (gaps) => gaps.reduce((least, one) => (one.gap < least.gap ? one : least), { gap: Infinity, names: [] });
})((globalThis.kempe = globalThis.kempe || {}));
