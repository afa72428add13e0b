// The plane seen by a camera: the projective map that takes four places to four others, and a photo drawn as seen from above.
"use strict";
(function (kempe) {
  // 3 x 3 matrices, row by row.
  const adjugate = ([a, b, c, d, e, f, g, h, i]) => [e * i - f * h, c * h - b * i, b * f - c * e, f * g - d * i, a * i - c * g, c * d - a * f, d * h - e * g, b * g - a * h, a * e - b * d];
  const product = (m, n) => Array.from({ length: 9 }, (_, at) => [0, 1, 2].reduce((sum, k) => sum + m[3 * Math.floor(at / 3) + k] * n[3 * k + (at % 3)], 0));
  const image = (m, [x, y, w]) => [0, 3, 6].map((row) => m[row] * x + m[row + 1] * y + m[row + 2] * w);

  /** The map that takes the three unit vectors and their sum to four places; null where three of those lie nearly on a line. */
  function basis([p, q, r, s]) {
    const columns = [p[0], q[0], r[0], p[1], q[1], r[1], 1, 1, 1];
    const weights = image(adjugate(columns), [s[0], s[1], 1]);  // twice the areas of the triangles that s makes with two others
    const area = weights[0] + weights[1] + weights[2];  // and of p, q, r
    const all = [...weights, area].map(Math.abs);
    if (!(Math.min(...all) > 1e-3 * Math.max(...all))) return null;
    return columns.map((value, at) => value * weights[at % 3]);
  }

  /** Takes each of four places `from` to one of `to`; null where three places of either lie nearly on a line. */
  function homography(from, to) {
    const one = basis(from), other = basis(to);
    if (!one || !other) return null;
    const map = product(other, adjugate(one)), most = Math.max(...map.map(Math.abs));
    const sign = image(map, [...from[0], 1])[2] < 0 ? -1 : 1;  // the third coordinate is positive where the camera looks
    return map.map((value) => (sign * value) / most);
  }

  /** Where a place goes; null if it lies behind the camera. */
  function mapped(map, [x, y]) {
    const [u, v, w] = image(map, [x, y, 1]);
    return w > 1e-12 ? [u / w, v / w] : null;
  }

  /** Why four pixels of a photo cannot be these four places of a table (y upward, the photo's y downward); nothing if they can. */
  function whyNotSeen(pixels, places) {
    const map = homography(pixels, places);
    if (!map) return "Three of the points lie nearly on a line, in the photo or on the table: choose four that span an area.";
    if (pixels.some((at) => !mapped(map, at))) return "No camera sees these four so: two of them are exchanged.";
    const area = (ring) => ring.reduce((sum, [x, y], i) => sum + x * ring[(i + 1) % 4][1] - ring[(i + 1) % 4][0] * y, 0);
    const turn = (ring) => Math.sign(area(ring.slice(0, 3).concat([ring[0]])));
    return turn(pixels) === -turn(places) ? null : "The points run the other way round on the table: the photo would be mirrored.";
  }

  /**
   * The photo from above: `source` ({width, height, data}, RGBA), `toPixel` from table to photo, `box` [left, near, right, far] in mm,
   * into `target` of the same kind; what the photo does not show stays transparent.
   */
  function fromAbove(source, toPixel, [left, near, right, far], target) {
    const { width, height, data } = source, out = new Uint32Array(target.data.buffer), pixels = new Uint32Array(data.buffer);
    const [a, b, c, d, e, f, g, h, i] = toPixel;
    for (let row = 0; row < target.height; ++row) {
      const y = far - ((row + 0.5) * (far - near)) / target.height;
      for (let column = 0; column < target.width; ++column) {
        const x = left + ((column + 0.5) * (right - left)) / target.width, w = g * x + h * y + i;
        if (w <= 1e-12) continue;
        const u = Math.floor((a * x + b * y + c) / w), v = Math.floor((d * x + e * y + f) / w);
        if (u >= 0 && v >= 0 && u < width && v < height) out[row * target.width + column] = pixels[v * width + u];
      }
    }
  }

  Object.assign(kempe, { homography, mapped, whyNotSeen, fromAbove });
})((globalThis.kempe = globalThis.kempe || {}));
