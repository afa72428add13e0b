// Where words and numbers stand on the table: beside their thing, on nothing else that a hand takes hold of and on no other word.
"use strict";
(function (kempe) {
  class Labels {
    /** The window in the picture's own frame (y downward), and how long a pixel is in it. */
    constructor({ left, top, width, height }, pixel) {
      const margin = 4 * pixel;
      this.room = [left + margin, top + margin, left + width - margin, top + height - margin];
      this.pixel = pixel;
      this.taken = [];
      this.handles = [];
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
      const away = ([x, y]) => Math.hypot(Math.max(box[0] - x, 0, x - box[2]), Math.max(box[1] - y, 0, y - box[3]));
      const mine = away(own) * 1.15;
      return this.handles.every((other) => (other[0] === own[0] && other[1] === own[1]) || away(other) > mine);
    }

    /** The first of some middles where a word of so many letters has room, now taken; null if there is none. `own`: of a handle's number. */
    put(middles, letters, { letter = 7.8, line = 15, own = null } = {}) {
      const wide = letters * letter * this.pixel, high = line * this.pixel;
      const middle = middles(wide, high).find((at) => {
        const box = this.box(at, wide, high);
        return this.isFree(box) && (!own || this.belongs(box, own));
      });
      if (!middle) return null;
      this.taken.push(this.box(middle, wide, high));
      return middle;
    }

    /** Middles round a disc: above, below and at its sides, nearer ones first. */
    static round([x, y], radius, pixel) {
      return (wide, high) => [3, 16, 30].flatMap((away) => {
        const u = radius + away * pixel + wide / 2, v = radius + away * pixel + high / 2;
        return [[x, y - v], [x, y + v], [x + u, y], [x - u, y], [x + 0.8 * u, y - 0.8 * v], [x - 0.8 * u, y - 0.8 * v], [x + 0.8 * u, y + 0.8 * v], [x - 0.8 * u, y + 0.8 * v]];
      });
    }

    /** Middles beside a box [left, top, right, bottom]: below and above it, then at its sides. */
    static beside([left, top, right, bottom], pixel) {
      const x = (left + right) / 2, y = (top + bottom) / 2;
      return (wide, high) => [5, 20, 36].flatMap((away) => {
        const u = away * pixel + wide / 2, v = away * pixel + high / 2;
        return [[x, bottom + v], [x, top - v], [right + u, y], [left - u, y]];
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
