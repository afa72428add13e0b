// The motion of a linkage moment by moment, as `kempe solve` has written it into the page (reports/linkages/animation.cpp,
// scene_motion.hpp). Lengths in the scene's unit, angles in rad, y downward as on the screen. A moment is told by its number.
"use strict";
(function (kempe) {
  class Motion {
    constructor(scene) {
      this.scene = scene;
      this.count = scene.moments.length;
      this.last = this.count - 1;
      this.links = scene.motion.links - 1;  // that move; they are counted from 1, the ground is 0
      this.bodies = (scene.moments[0].length - 1) / 3;  // that are drawn: the links, then the blocks of sliding joints
      this.movingPoints = scene.points.flatMap(([body], point) => (body === 0 ? [] : [point]));
      this.kinds = [
        { name: "velocities", title: "velocity", letter: "v", unit: `${scene.unit}/s`, of: (point, moment) => this.velocity(point, moment) },
        { name: "accelerations", title: "acceleration", letter: "a", unit: `${scene.unit}/s\u00b2`, of: (point, moment) => this.acceleration(point, moment) },
      ];
    }

    nameOf(point) {
      return this.scene.motion.names[point];
    }

    /** x, y and angle of a body's frame. */
    frame(body, moment) {
      return this.scene.moments[moment].slice(3 * body - 2, 3 * body + 1);
    }

    /** The first and the second rates of x, y and angle of a link's frame; null where the motion has none. */
    rates(link, moment) {
      const row = this.scene.motion.rates[moment];
      return row && row.slice(6 * link - 6, 6 * link);
    }

    /** A point seen from the origin of its link's frame. */
    arm(point, moment) {
      const [link, x, y] = this.scene.points[point], angle = this.frame(link, moment)[2];
      return [Math.cos(angle) * x - Math.sin(angle) * y, Math.sin(angle) * x + Math.cos(angle) * y];
    }

    place(point, moment) {
      const [link, x, y] = this.scene.points[point];
      if (link === 0) return [x, y];
      const [originX, originY] = this.frame(link, moment), [armX, armY] = this.arm(point, moment);
      return [originX + armX, originY + armY];
    }

    /** The velocity of a point: its frame's, and the turning of its arm; null where there is none. */
    velocity(point, moment) {
      const [link] = this.scene.points[point], rates = link && this.rates(link, moment);
      if (!rates) return rates === 0 ? [0, 0] : null;
      const [x, y, turn] = rates, [armX, armY] = this.arm(point, moment);
      return [x - turn * armY, y + turn * armX];
    }

    /** The acceleration of a point: its frame's, the tangential and the centripetal one of its arm; null where there is none. */
    acceleration(point, moment) {
      const [link] = this.scene.points[point], rates = link && this.rates(link, moment);
      if (!rates) return rates === 0 ? [0, 0] : null;
      const [, , turn, x, y, spin] = rates, [armX, armY] = this.arm(point, moment);
      return [x - spin * armY - turn * turn * armX, y + spin * armX - turn * turn * armY];
    }

    /** The step at a place between two moments (2.5: half way between the third and the fourth). */
    stepAt(at) {
      const before = Math.floor(at), after = Math.min(before + 1, this.last), step = (moment) => this.scene.moments[moment][0];
      return step(before) + (at - before) * (step(after) - step(before));
    }
  }

  kempe.Motion = Motion;
})((globalThis.kempe = globalThis.kempe || {}));
