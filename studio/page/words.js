// What keys, figures and colours are called on the page, for somebody who has read no manual.
"use strict";
(function (kempe) {
  const units = { mm: "mm", deg: "°", N: "N", kg: "kg", GPa: "GPa", MPa: "MPa", kg_m3: "kg/m³" };
  const ending = /_(mm|deg|N|kg_m3|kg|GPa|MPa)$/;
  const unitOf = (name) => units[(ending.exec(name) || [])[1]] || "";

  /** [name, what it means] of a key; its own words stand in for what is missing. */
  const spoken = {
    title: ["Title", "Heads the report and the drawings"],
    "copy.scale": ["Scale, copy to original", "How many times as long as the original's the copy's lengths are: 0.5, or 1:2"],
    "copy.rotation_deg": ["Rotation of the copy", "How far the copy is turned against the original, counter-clockwise"],
    "limits.clearance_mm": ["Clearance of parts", "The least gap between parts that pass each other"],
    "limits.transmission_deg": ["Transmission angle, least", "How far the arms stay from stretching or folding flat, where they jam: 90° is best, below 20° is stiff"],
    "limits.sheets_gap_mm": ["Gap, original to copy", "The least distance of the original from its copy. 0: they may touch. Left out: they may overlap"],
    "limits.copy_error_mm": ["Copy error, most", "How far the pen may be off at worst, by the tolerances given below. Left out: not limited"],
    "limits.longest_strip_mm": ["Longest strip", "The longest strip at hand, from end to end. Left out: not limited"],
    "limits.load_error_mm": ["Pen gives way, most", "How far the pen may give way under the load, in its worst direction. Left out: not limited"],
    "limits.load_error_in_all": ["Counts pins and layers", "What pins, layers and the links' own weight add counts towards how far the pen may give way. Else the links alone do"],
    "limits.sag_mm": ["Sag, most", "How far tracer or pen may sink by weight and play. Left out: not limited"],
    "links.width_mm": ["Width of the links", "All four moving links are strips of this width"],
    "links.pin_diameter_mm": ["Diameter of the pins", "Of pins and of the pole's post; at most the links' width"],
    "links.thickness_mm": ["Thickness of the links", "All four moving links have this thickness"],
    "links.sections_mm": ["Strips at hand", "Width × thickness of the strips at hand, instead of one width and thickness; all links are cut from one of them"],
    "links.hardware": ["Joints made of", "What is bought for the joints; it gives the pins' diameters and the holes. Left out: plain pins"],
    "links.plate": ["Links of three joints", "Two of the four links have three joints: a bent strip, or a triangle"],
    "links.layers": ["Layers, most", "Links lie in layers above each other, so that they pass; some may stay empty"],
    "links.shortest_mm": ["Joints apart, least", "The least distance of two joints of a link"],
    "links.longest_mm": ["Joints apart, most", "The largest distance of two joints of a link"],
    "links.wall_mm": ["Wall between holes", "The least material between two holes of a link. Left out: a tenth of the pin's diameter"],
    "links.grid_mm": ["Lengths in steps of", "Every length between joints is a whole multiple of this"],
    "links.stock_mm": ["Lengths at hand", "Lengths between joints are taken from this list"],
    "objective.minimize": ["Make small", "What the search makes as small as the limits allow"],
    "objective.maximize": ["Make large instead", "The transmission angle instead: a motion as easy as the limits allow"],
    "objective.groundings": ["Point at joint V", "Which of the three points may be joint V, a corner of the parallelogram"],
    "material.name": ["Material", "One of the list, or any name beside figures of your own"],
    "material.E_GPa": ["Modulus of elasticity", "How stiff it is (E). Left out: that of the material named"],
    "material.density_kg_m3": ["Density", "Left out: that of the material named"],
    "material.strength_MPa": ["Strength in bending", "The stress that it bears. Left out: that of the material named"],
    "material.G_GPa": ["Shear modulus", "How stiff it is in torsion (G). Left out: that of the material named, else E / 2.6"],
    "load.pen_N": ["Force at the pen", "In any direction on the table"],
    "load.rests": ["Rests on the table", "What the table carries besides the pole's post. Left out: nothing"],
    "load.pen_mass_kg": ["Mass at the pen", "What the pen carries: a router"],
    "load.tracer_mass_kg": ["Mass at the tracer", "What the tracer carries"],
    "load.tilt_deg": ["Tilt of the table", "0 lies, 90 is upright, with y uphill"],
    "load.grip_mm": ["Pin held over", "The length over which a pin is held in the link that turns on it. Left out: the links' thickness"],
    "load.friction": ["Friction in the pins", "The coefficient of friction: 0.15 for dry metal"],
    "tolerance.length_mm": ["Lengths exact to ±", "How far any length may be off, more or less"],
    "tolerance.play_mm": ["Play of each pin", "How far a pin can move in its hole"],
    "tolerance.robust": ["Holds for all of these", "Every instrument made within the tolerances must cover the original and keep its clearance"],
    "tool.follower_radius_mm": ["Radius of the follower", "Of the wheel or pin with which the tracer follows a template"],
    "tool.cutter_radius_mm": ["Radius of the cutter", "Of the bit at the pen"],
    "cutting.process": ["Holes are made by", "Its usual fit stands in for the one below"],
    "cutting.hole_fit_mm": ["Hole wider than pin by", "A hole's diameter less the pin's. Left out: that of the process, or 0"],
    "cutting.kerf_mm": ["Width of the cut", "What the saw or the laser takes away (kerf)"],
    "cutting.sheet_mm": ["Sheet, width; height", "The sheet on which the parts are laid out. Left out: they are not"],
    "cutting.gap_mm": ["Gap between parts", "On the sheet, and to its edge"],
    "pole.at_mm": ["Place of the pole", "The one point that is fixed to the table"],
    "pole.within_mm": ["Area of the pole", "Where the pole may stand"],
    obstacles: ["Obstacles", ""],
    bodies: ["What tracer and pen carry", ""],
    table: ["Edge of the table", ""],
  };

  /** What a choice is called in its list. */
  const choices = { size: "total length", copy_error: "copy error", footprint: "bench space", load_error: "giving way", mass: "mass", transmission: "transmission" };

  const isNamed = (path) => Boolean(spoken[path]);
  const nameOf = (path) => {
    if (spoken[path]) return spoken[path][0];
    const name = path.split(".").pop(), length = /^links\.([A-Z]{2})_mm$/.exec(path);
    return length ? `Length ${length[1]}` : name.replace(ending, "").replaceAll("_", " ").replace(/^./, (c) => c.toUpperCase());
  };

  /** What a key means; the words of the table of keys without what points at files that are not here. */
  const meaningOf = (path, description = "") => {
    const length = /^links\.([A-Z])([A-Z])_mm$/.exec(path);
    if (length) return `Fixes the distance of the joints ${length[1]} and ${length[2]}: their letters stand in the drawing`;
    return spoken[path] ? spoken[path][1] : description.replace(/\s*\(?docs\/[^\s)]*\)?/g, "");
  };

  /** The figures above the table: [what they are called, what they mean]. */
  const figures = {
    size: ["Total length", "The lengths of the four moving links, added up. Unless you ask for something else, the search makes this as small as your limits allow."],
    bound: ["Best possible", "Proven: no instrument within your limits can do better than this."],
    transmission: ["Transmission angle", "The least angle at which the links drive each other, over all of the original. Near 0° they jam; 30° and more moves easily."],
    clearance: ["Clearance", "The least gap between parts that pass each other, over all of the original."],
    free: ["Free area", "How much of the table the tracer reaches without anything touching: green on the table."],
    longest: ["Longest strip", "The longest of the four links, from end to end: what you need of strip in one piece."],
    load_error: ["Gives way", "How far the pen gives way under the load, at worst."],
    sag: ["Sags", "How far tracer or pen sinks by weight and play, at worst."],
    mass: ["Links weigh", "The four moving links together."],
  };

  /** What is drawn: [group, name in the legend]; areas of the map have the report's names. */
  const colours = {
    region: ["things", "Original: what the tracer must reach"],
    copy: ["things", "Copy: what the pen draws"],
    "pole-area": ["things", "The pole may stand here"],
    pole: ["things", "Pole: the one point fixed to the table"],
    obstacles: ["things", "Obstacle: no part may touch it"],
    bodies: ["things", "What tracer or pen carries"],
    table: ["things", "Edge of the table"],
    mechanism: ["things", "Links; each shade is a layer"],
    ghost: ["things", "The last design, as a shadow"],
    tightest: ["things", "What holds the design back, or is in the way"],
    reachable: ["map", "Within the arms' reach"],
    usable: ["map", "Within reach, and moves easily enough"],
    free: ["map", "Free: the tracer goes here and nothing touches"],
    uncertain: ["map", "Not certain either way"],
    change: ["lost", "The links would have to fold over"],
    transmission: ["lost", "Transmission angle below the limit"],
    contact: ["lost", "Links would touch each other"],
    obstructed: ["lost", "Something on the table is in the way"],
    overlap: ["lost", "The copy would lie on the original"],
  };
  const colourGroups = { things: "On the table", map: "Where the tracer can be", lost: "Lost, and why" };

  kempe.words = { isNamed, nameOf, meaningOf, unitOf, choices, figures, colours, colourGroups };
})((globalThis.kempe = globalThis.kempe || {}));
