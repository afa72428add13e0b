// Why there is no design, and what would allow one, in plain words; and the text that a way out makes of the spec.
"use strict";
(function (kempe) {
  const number = "[-+\\d.e]+";
  const upper = new Set(["links.longest_mm", "limits.longest_strip_mm", "limits.copy_error_mm", "limits.load_error_mm", "limits.sag_mm",
    "load.grip_mm"]);

  /** A figure of few digits on the safe side of a limit: what allows a design still allows one. */
  function safely(value, up) {
    if (!(Math.abs(value) > 1e-9)) return value;
    const power = Math.min(-1, Math.floor(Math.log10(Math.abs(value))) - 2), step = 10 ** power;
    const steps = up ? Math.ceil(value / step - 1e-9) : Math.floor(value / step + 1e-9);
    return Number((steps * step).toFixed(-power));
  }

  /** The figure that a key gets: larger where it is an upper limit or a grip, smaller where it is a lower one or a play. */
  function givenWay(key, value, doc) {
    const rounded = safely(value, upper.has(key));
    // No link is narrower than its pin.
    if (key === "links.width_mm" && !(rounded >= (doc.get("links.pin_diameter_mm") ?? (doc.has("links.hardware") ? Infinity : 6)))) return value;
    return rounded;
  }

  const figure = (value) => kempe.figure(value, 6);
  const withUnit = (value, key) => {
    const unit = kempe.words.unitOf(key);
    return unit === "" ? figure(value) : unit === "°" ? `${figure(value)}°` : `${figure(value)}\u00a0${unit}`;
  };
  const unquoted = { "pole.at_mm": "the place of the pole", "pole.within_mm": "the area of the pole", obstacles: "the obstacles",
    bodies: "what tracer and pen carry", table: "the table's edge" };
  const quoted = (path) => unquoted[path] || `“${kempe.words.nameOf(path)}”`;
  const capital = (words) => words.replace(/^./, (c) => c.toUpperCase());

  /** The rectangle around rings that is so much wider on every side. */
  function around(rings, margin) {
    const points = rings.flat(), xs = points.map(([x]) => x), ys = points.map(([, y]) => y);
    const [left, right, near, far] = [Math.min(...xs) - margin, Math.max(...xs) + margin, Math.min(...ys) - margin, Math.max(...ys) + margin];
    return [[left, near], [right, near], [right, far], [left, far]];
  }

  /** The text with the pole at a place (at_mm) or in an area (within_mm), wherever it might stand before; null where it cannot be changed so. */
  function withPole(given, key, value) {
    const instead = key === "at_mm" ? "within_mm" : "at_mm";
    try {
      let doc = given;
      if (doc.has("pole")) return doc.with("pole", { [key]: value });  // pole = {...} in one line
      const first = doc.has(`pole.${instead}`) && !doc.tables.has("pole");  // pole.within_mm = ..., without a table's head
      doc = new kempe.Doc(doc.without(`pole.${instead}`));
      doc = new kempe.Doc(first ? doc.withAbove(`pole.${key} = ${kempe.written(value)}`) : doc.with(`pole.${key}`, value));
      return doc.has(`pole.${key}`) && !doc.has(`pole.${instead}`) ? doc.text : null;
    } catch (error) {
      return null;
    }
  }

  /** The text without a table, or without all tables [[name]]; null where it cannot be changed so. */
  function withoutAll(given, name) {
    let doc = given;
    if (!doc.count(name)) return doc.tables.has(name) ? doc.withoutTable(name) : null;
    for (let i = doc.count(name) - 1; i >= 0; --i) doc = new kempe.Doc(doc.withoutTable(`${name}.${i}`));
    return doc.text;
  }

  /** The obstacle of the spec that a sentence names: the longest name wins; -1 if it names none. */
  function obstacleNamed(doc, words) {
    const names = Array.from({ length: doc.count("obstacles") }, (_, i) => String(doc.get(`obstacles.${i}.name`) || `obstacle ${i + 1}`));
    const named = names.filter((name) => words.includes(name)).sort((one, other) => other.length - one.length);
    return named.length ? names.indexOf(named[0]) : -1;
  }

  /** Of each kind of sentence what its button says and does: [pattern, (match, {key, doc, task}) -> {words, text} or null]. */
  const kinds = [
    [new RegExp(`^length_mm = .* and play_mm = .*; (${number}) and (${number}) would do`), ([, length, play], { doc }) => {
      const [off, loose] = [length, play].map((value) => safely(Number(value), false));
      const text = new kempe.Doc(doc.with("tolerance.length_mm", off)).with("tolerance.play_mm", loose);
      return { words: `Lengths exact to ± ${withUnit(off, "_mm")}, play ${withUnit(loose, "_mm")}`, text };
    }],
    [new RegExp(`; the pole at \\((${number}), (${number})\\) mm would do`), ([, ...at], { doc }) => {
      const [x, y] = at.map(Number);
      return { words: `Pole at ${figure(x)}; ${figure(y)}\u00a0mm`, text: withPole(doc, "at_mm", [x, y]) };
    }],
    [new RegExp(`; the pole (${number}) mm outside it would do`), ([, margin], { doc, task }) => {
      const wider = safely(Number(margin), true), words = `Pole's area wider by ${withUnit(wider, "_mm")} all round`;
      return task && task.pole.within ? { words, text: withPole(doc, "within_mm", around(task.pole.within, wider)) } : null;
    }],
    [new RegExp(`; with the pole free to stand within (${number}) mm of the region`), ([, margin], { doc, task }) => {
      const wider = safely(Number(margin), true), words = `Pole anywhere within ${withUnit(wider, "_mm")} of the original`;
      return task ? { words, text: withPole(doc, "within_mm", around(task.region, wider)) } : null;
    }],
    [new RegExp(`; (${number}) would do`), ([, value], { key, doc, isKey }) => {
      if (!isKey(key)) return null;
      const enough = givenWay(key, Number(value), doc);
      return { words: `${kempe.words.nameOf(key)}: ${withUnit(enough, key)}`, text: doc.with(key, enough) };
    }],
    [new RegExp(`^links\\.sections_mm has none .*; with (${number}) x (${number}) added`), ([, ...sizes], { key, doc }) => {
      const section = sizes.map(Number), given = doc.get(key);
      return { words: `A strip of ${sizes.map((size) => figure(Number(size))).join(" × ")}\u00a0mm`, text: doc.with(key, [...(Array.isArray(given) ? given : []), section]) };
    }],
    [/^load\.rests does not name the (tracer|pen)/, ([, point], { key, doc }) => {
      const given = doc.get(key);
      return { words: `The ${point} rests on the table`, text: doc.with(key, [...(Array.isArray(given) ? given : []), point]) };
    }],
    [/; "([^"]+)" would do/, ([, name], { key, doc }) => (doc.has(key) ? { words: `${kempe.words.nameOf(key)}: ${name}`, text: doc.with(key, name) } : null)],
    [/; left out, a design exists/, (_, { key, doc }) =>
      (doc.has(key) ? { words: `Without the limit “${kempe.words.nameOf(key)}”`, text: doc.cleared(key) } : null)],
    [/; without them/, (_, { key, doc }) => {
      const words = { obstacles: "Without the obstacles", bodies: "With nothing carried" }[key];
      return words ? { words, text: withoutAll(doc, key) } : null;
    }],
    [/(.*) is in the way; without it/, ([, name], { key, doc }) => {
      if (key === "table" || key === "bodies") return { words: key === "table" ? "Without the table's edge" : "With nothing carried", text: withoutAll(doc, key) };
      if (key !== "obstacles") return doc.has(key) ? { words: `Without “${kempe.words.nameOf(key)}”`, text: doc.without(key) } : null;
      const index = obstacleNamed(doc, name);
      return index < 0 ? null : { words: `Without ${name}`, text: doc.withoutTable(`obstacles.${index}`) };
    }],
  ];

  /** What a change of the engine, {key, sentence}, makes of the spec: {words, text}; null where it cannot be written into the text. */
  function wayOut({ key, sentence }, about) {
    for (const [pattern, way] of kinds) {
      const found = pattern.exec(sentence), made = found && way(found, { key, ...about });
      if (made && made.text !== null) return made;
    }
    return null;
  }

  /** The sentence with an obstacle's name, where it begins with one, as a name. */
  function withNameQuoted(sentence, doc) {
    const index = obstacleNamed(doc, sentence), name = index < 0 ? "" : String(doc.get(`obstacles.${index}.name`) || `obstacle ${index + 1}`);
    return name && sentence.startsWith(`${name} `) ? `“${name}”${sentence.slice(name.length)}` : sentence;
  }

  const keyed = /\b((?:copy|limits|links|pole|objective|tolerance|material|load|tool|cutting)\.[A-Za-z]\w*)(?: = ("[^"]*"|-?\d+(?:\.\d+)?(?:e[-+]?\d+)?|true))?/g;

  /** A sentence of the engine with the page's names, and with the figures that its button has. */
  function plainly(sentence, key, doc) {
    const first = (keyed.exec(sentence) || [])[1] || key;
    keyed.lastIndex = 0;
    const wide = (_, before, value, after) => `${before}${figure(safely(Number(value), true))}${after}`;
    const plain = withNameQuoted(sentence, doc)
      .replace(/^robust = true/, quoted("tolerance.robust"))
      .replace(new RegExp(`^length_mm = (${number}) and play_mm = (${number})(.*); (${number}) and (${number}) would do`), (_, length, play, middle, off, loose) =>
        `${quoted("tolerance.length_mm")} (${withUnit(Number(length), "_mm")}) and ${quoted("tolerance.play_mm")} (${withUnit(Number(play), "_mm")})${middle}; ` +
        `${withUnit(safely(Number(off), false), "_mm")} and ${withUnit(safely(Number(loose), false), "_mm")} would do`)
      .replace(new RegExp(`(; the pole )(${number})( mm outside it would do)`), wide)
      .replace(new RegExp(`(free to stand within )(${number})( mm of the region)`), wide)
      .replace(new RegExp(`; with (${number}) x (${number}) added`), (_, width, thickness) => `; with ${figure(Number(width))} × ${withUnit(Number(thickness), "_mm")} added`)
      .replace(new RegExp(`(thickness, )(${number})(, which)`), (_, before, value, after) => `${before}${withUnit(Number(value), "_mm")}${after}`)
      .replace(new RegExp(`; (${number}) would (do|fit)`), (_, value, verb) => `; ${withUnit(givenWay(first, Number(value), doc), first)} would ${verb}`)
      .replace(keyed, (_, path, value) => quoted(path) + (value === undefined || value === "true" ? "" : ` (${value[0] === '"' ? value.slice(1, -1) : withUnit(Number(value), path)})`))
      .replace(/(relaxed: .*)$/, (_, list) => list.replace(/\b(obstacles|bodies|table)\b(?=,|$)/g, (name) => quoted(name)))
      .replace(/\bthe region\b/g, "the original");
    return capital(plain);
  }

  /** What to say of an original that strips of the task's longest length are far too short for; "" of any other. */
  function tooLarge({ region, longest, longest_strip: strip }) {
    const points = region.flat(), xs = points.map(([x]) => x), ys = points.map(([, y]) => y);
    const across = points.length ? Math.hypot(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys)) : 0;
    return across > 2 * longest ? `The original is very large for strips of at most ${figure(Number((strip ?? longest).toPrecision(4)))}\u00a0mm. ` : "";
  }

  Object.assign(kempe, { wayOut, plainly, tooLarge, safely, obstacleNamed });
})((globalThis.kempe = globalThis.kempe || {}));
