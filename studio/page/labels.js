// Where words and numbers stand on the table: beside their thing, on nothing else that a hand takes hold of and on no other word.
"use strict";
(function (kempe) {
  const gap = 6;  // pixels between two words on a line
  const widths = new Map();
  let pen = null, family = "";

  /** How wide a word is, in pixels. */
  function widthOf(word, pixels, weight) {
    const key = `${weight} ${pixels} ${word}`;
    if (!widths.has(key)) {
      if (!pen) {
        pen = document.createElement("canvas").getContext("2d");
        family = getComputedStyle(document.body).fontFamily;
      }
      pen.font = `${weight} ${pixels}px ${family}`;
      if (widths.size > 2000) widths.clear();
      widths.set(key, pen.measureText(word).width);
    }
    return widths.get(key);
  }

  /** How far a place is from a box. */
  const away = (box, [x, y]) => Math.hypot(Math.max(box[0] - x, 0, x - box[2]), Math.max(box[1] - y, 0, y - box[3]));

  /** Whether a line from one place to another meets a box (Liang and Barsky). */
  function crosses([left, top, right, bottom], [x, y], [u, v]) {
    let enter = 0, leave = 1;
    for (const [way, room] of [[x - u, x - left], [u - x, right - x], [y - v, y - top], [v - y, bottom - y]]) {
      if (way === 0 && room < 0) return false;
      if (way < 0) enter = Math.max(enter, room / way);
      if (way > 0) leave = Math.min(leave, room / way);
    }
    return enter <= leave;
  }

  /** How far two boxes are from each other. */
  const apart = (one, other) => Math.hypot(Math.max(one[0] - other[2], 0, other[0] - one[2]), Math.max(one[1] - other[3], 0, other[1] - one[3]));

  class Labels {
    /** The window in the picture's own frame (y downward), and how long a pixel is in it. */
    constructor({ left, top, width, height }, pixel) {
      const margin = 4 * pixel;
      this.room = [left + margin, top + margin, left + width - margin, top + height - margin];
      this.pixel = pixel;
      this.taken = [];
      this.handles = [];
      this.edges = [];  // of outlines: [from, to]
      this.bars = [];  // of the linkage: [from, to, half its width]
    }

    /** Nothing shall be written within `pixels` of a place. */
    keepOff([x, y], pixels) {
      const r = pixels * this.pixel;
      this.taken.push([x - r, y - r, x + r, y + r]);
    }

    box([x, y], wide, high) {
      return [x - wide / 2, y - high / 2, x + wide / 2, y + high / 2];
    }

    isFree(box) {
      const [left, top, right, bottom] = this.room;
      if (box[0] < left || box[1] < top || box[2] > right || box[3] > bottom) return false;
      return this.taken.every((other) => box[2] <= other[0] || box[0] >= other[2] || box[3] <= other[1] || box[1] >= other[3]);
    }

    /** Whether a number in this box is taken for that of the handle at `own`, and for no other's. */
    belongs(box, own) {
      const mine = away(box, own) * 1.15;
      return this.handles.every((other) => (other[0] === own[0] && other[1] === own[1]) || away(box, other) > mine);
    }

    /** Whether an outline's edge or a link runs through the box. */
    isCrossed(box) {
      const wider = (half) => [box[0] - half, box[1] - half, box[2] + half, box[3] + half];
      return this.edges.some(([from, to]) => crosses(box, from, to)) || this.bars.some(([from, to, half]) => crosses(wider(half), from, to));
    }

    /** Whether a box lies in the window, and the part of it that does. */
    holds(box) {
      return box.every((value, i) => value === this.within(box)[i]);
    }

    within([left, top, right, bottom]) {
      const [nearest, highest, farthest, lowest] = this.room;
      return [Math.max(left, nearest), Math.max(top, highest), Math.min(right, farthest), Math.min(bottom, lowest)];
    }

    /** Of some middles, the better ones first, one where a word has room, now taken; null if there is none. Rather where no outline and no link crosses it,
     * and above all where `fits(box)` holds.
     * `crossing`: so many middles further away are as good as one where an outline or a link crosses the word. `own`: the handle whose number it is; `pixels`, `weight`: the size of its letters and how bold they are; `must`: only where `fits` holds. */
    put(middles, word, { pixels = 12.6, weight = 400, own = null, fits = null, must = false, crossing = 12 } = {}) {
      const wide = (widthOf(word, pixels, weight) + 2) * this.pixel, high = (pixels + 2.4) * this.pixel;
      let middle = null, least = Infinity;
      middles(wide, high).forEach((at, i) => {
        const box = this.box(at, wide, high);
        if (i >= least || !this.isFree(box) || (own && !this.belongs(box, own))) return;
        const fitting = !fits || fits(box);
        const cost = i + (fitting ? 0 : must ? Infinity : 1000) + (this.isCrossed(box) ? crossing : 0);
        if (cost < least) [middle, least] = [at, cost];
      });
      if (!middle) return null;
      this.taken.push(this.box(middle, wide + 2 * gap * this.pixel, high));
      return middle;
    }

    /** Middles round a disc: above, below and at its sides, nearer ones first. */
    static round([x, y], radius, pixel, distances = [3, 16, 30]) {
      return (wide, high) => distances.flatMap((away) => {
        const u = radius + away * pixel + wide / 2, v = radius + away * pixel + high / 2;
        return [[x, y - v], [x, y + v], [x + u, y], [x - u, y], [x + 0.8 * u, y - 0.8 * v], [x - 0.8 * u, y - 0.8 * v], [x + 0.8 * u, y + 0.8 * v], [x - 0.8 * u, y + 0.8 * v]];
      });
    }

    /** Whether a word in a box is taken for the name of one thing and not of the others, all of them boxes. */
    static isOf(own, others) {
      return (box) => others.every((other) => apart(box, other) > 1.5 * apart(box, own));
    }

    /** Middles inside a box, beside its own middle. */
    static inside([left, top, right, bottom], pixel) {
      const x = (left + right) / 2, y = (top + bottom) / 2;
      return (wide, high) => {
        const u = 4 * pixel + wide / 2, v = 5 * pixel + high / 2, step = 12 * pixel + high / 2;
        const side = 14 * pixel + wide / 2, corners = [left + u, right - u].flatMap((at) => [[at, top + v], [at, bottom - v]]);
        return [[x, y - step], [x, y + step], [x + side, y], [x - side, y], [x, top + v], [x, bottom - v], ...corners].filter(([a, b]) => a - wide / 2 >= left && a + wide / 2 <= right && b - high / 2 >= top && b + high / 2 <= bottom);
      };
    }

    /** Middles beside a box [left, top, right, bottom]: below and above it, then at its sides, then along its edges. */
    static beside([left, top, right, bottom], pixel) {
      const x = (left + right) / 2, y = (top + bottom) / 2;
      return (wide, high) => [5, 20, 36].flatMap((away) => {
        const u = away * pixel + wide / 2, v = away * pixel + high / 2;
        const along = [left + wide / 2, right - wide / 2];
        return [[x, bottom + v], [x, top - v], [right + u, y], [left - u, y], ...along.map((at) => [at, bottom + v]), ...along.map((at) => [at, top - v])];
      });
    }

    /** Middles of a number at a handle: to the right of it if there is room. */
    static at([x, y], pixel) {
      return (wide) => {
        const u = 12 * pixel + wide / 2, near = 14 * pixel, far = 28 * pixel;
        return [[x + u, y - near], [x - u, y - near], [x + u, y + near], [x - u, y + near], [x + u, y], [x - u, y], [x, y - 17 * pixel], [x, y + 17 * pixel], [x + u, y - far], [x - u, y - far], [x + u, y + far], [x - u, y + far]];
      };
    }
  }

  kempe.Labels = Labels;
})((globalThis.kempe = globalThis.kempe || {}));
