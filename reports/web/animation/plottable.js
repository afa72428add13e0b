// What an animation's page can plot: of each point, link, joint and driver up to three plots, each with its curves; and over what.
"use strict";
(function (kempe) {
  /** A curve: its class (which gives its colour), its words, and its value at a moment, or null. */
  const curve = (name, words, of) => ({ name, words, of });
  const upward = (vector) => vector && [vector[0], -vector[1]];

  /** A vector's two coordinates (y upward) and its size. */
  function vectorCurves(words, of) {
    const part = (at) => (moment) => upward(of(moment))?.[at] ?? null;
    const length = (moment) => {
      const vector = of(moment);
      return vector && Math.hypot(...vector);
    };
    return [curve("x", words[0], part(0)), curve("y", words[1], part(1)), curve("size", words[2], length)];
  }

  function ofPoint(motion, point) {
    const [x, y] = vectorCurves(["x", "y", ""], (moment) => motion.place(point, moment));
    const rates = motion.kinds.map(({ title, letter, unit, of }) =>
      ({ title, unit, curves: vectorCurves([`${letter}x`, `${letter}y`, `|${letter}|`], (moment) => of(point, moment)) }));
    return { group: "Points", name: motion.nameOf(point), plots: [{ title: "place", unit: motion.scene.unit, curves: [x, y] }, ...rates] };
  }

  function ofLink(motion, link) {
    const rate = (at) => (moment) => {
      const rates = motion.rates(link, moment);
      return rates && -rates[at];  // counter-clockwise, with y upward
    };
    return {
      group: "Links", name: motion.scene.motion.bodies[link], plots: [
        { title: "angle", unit: "degrees", curves: [curve("x", "angle", (moment) => (-motion.frame(link, moment)[2] * 180) / Math.PI)] },
        { title: "angular velocity", unit: "rad/s", curves: [curve("x", "\u03c9", rate(2))] },
        { title: "angular acceleration", unit: "rad/s\u00b2", curves: [curve("x", "\u03b1", rate(5))] },
      ],
    };
  }

  function ofLoads({ loads, motion }) {
    const reactions = loads.reactions.map((name, joint) => ({
      group: "Reactions", name,
      plots: [{ title: "force", unit: "N", curves: vectorCurves(["Fx", "Fy", "|F|"], (moment) => loads.forces[moment][joint]?.slice(2) ?? null) }],
    }));
    const drivers = loads.units.map((unit, driver) => {
      const [title, letter] = unit === "N" ? ["force", "F"] : ["moment", "M"];
      return { group: "Drivers", name: motion.drivers[driver][0], plots: [{ title, unit, curves: [curve("x", letter, (moment) => loads.moments[moment][driver])] }] };
    });
    return [...reactions, ...drivers];
  }

  function plottable(motion) {
    const { scene } = motion, { names, bodies } = scene.motion;
    const links = Array.from({ length: motion.links }, (_, i) => i + 1).filter((link) => !names.includes(bodies[link]));  // no lone points
    return [
      ...motion.movingPoints.map((point) => ofPoint(motion, point)),
      ...links.map((link) => ofLink(motion, link)),
      ...(scene.loads ? ofLoads(scene) : []),
    ];
  }

  /** Over what can be plotted: a driver that goes one way, or the time. */
  function abscissas(motion) {
    const { drivers, values, seconds_a_step: seconds } = motion.scene.motion;
    const goesOneWay = ({ at }) => {
      const signs = new Set();
      for (let moment = 1; moment < motion.count; moment++) signs.add(Math.sign(at(moment) - at(moment - 1)));
      return signs.size === 1 && !signs.has(0);
    };
    const driven = drivers.map(([label, unit], driver) =>
      ({ label: `${label}, ${unit === "deg" ? "degrees" : unit}`, isAngle: unit === "deg", at: (moment) => values[moment][driver] }));
    return [...driven.filter(goesOneWay), { label: "time, s", isAngle: false, at: (moment) => motion.scene.moments[moment][0] * seconds }];
  }

  Object.assign(kempe, { plottable, abscissas });
})((globalThis.kempe = globalThis.kempe || {}));
