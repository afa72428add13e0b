// What a task is called: a template's name as long as it is the template's task, then what the numbers say.
"use strict";
(function (kempe) {
  const head = (text) => (/^(?:#[^\n]*\n)+/.exec(text) || [""])[0];
  const title = (doc) => (typeof doc.get("title") === "string" ? doc.get("title") : null);

  /** What makes a task the one that its template speaks of. */
  function taskOf(doc) {
    const all = [...doc.values].filter(([key]) => /^(copy|region)(\.|$)/.test(key))
      .map(([key, { value }]) => [key, key === "copy.scale" ? kempe.ratio(value) : value]);
    return JSON.stringify(all.filter(([key, value]) => key !== "copy.rotation_deg" || value !== 0).sort(([one], [other]) => (one < other ? -1 : 1)));
  }

  /** The template that a text was begun with; `name` is null for one that goes by no name. */
  function originOf({ name, text }) {
    const doc = new kempe.Doc(text);
    return { name, text, head: head(text), title: title(doc), task: taskOf(doc) };
  }

  const isStill = (doc, origin) => Boolean(origin) && taskOf(doc) === origin.task;

  /** The text without the template's title and heading once its task is another. Notes beside the keys stay. */
  function withoutNames(text, origin) {
    if (!origin || text === origin.text) return text;
    try {
      let doc = new kempe.Doc(text);
      if (isStill(doc, origin)) return text;
      const called = origin.title || origin.name;
      if (origin.title && doc.get("title") === origin.title) doc = new kempe.Doc(doc.without("title").replace(/^((?:#[^\n]*\n)*)\n+/, "$1\n"));
      if (!origin.head || !doc.text.startsWith(origin.head)) return doc.text;
      return `# Begun with ${called ? `the template "${called}"` : "an example"} and changed: its notes may speak of that.\n${doc.text.slice(origin.head.length)}`;
    } catch {
      return text;
    }
  }

  /** [scale, turn in whole degrees from 0 to 359] of the copy; null where nothing says them. */
  function ratioOf(doc, task) {
    const [x, y] = task && doc.has("copy.pairs_mm") ? task.k : [NaN, NaN];
    const scale = Number.isFinite(x) ? Math.hypot(x, y) : kempe.ratio(doc.get("copy.scale") ?? 1);
    const turn = Number.isFinite(x) ? (Math.atan2(y, x) * 180) / Math.PI : Number(doc.get("copy.rotation_deg") ?? 0);
    return scale > 0 && Number.isFinite(turn) ? [scale, turn] : null;
  }

  /** The name of files: what the user or the template calls it, else what it does, such as "copy-0.5x-90deg". */
  function fileName({ doc, task, own, origin }) {
    if (own) return own;
    const still = isStill(doc, origin), typed = title(doc);
    if (still && origin.name) return origin.name;
    const plain = typed && typed.normalize("NFKD").replace(/\p{M}/gu, "").replace(/[^\w]+/g, "-").replace(/^-+|-+$/g, "").slice(0, 60);
    if (plain) return plain.toLowerCase();
    const ratio = ratioOf(doc, task);
    if (!ratio) return "copy";
    const turn = ((Math.round(ratio[1]) % 360) + 360) % 360;
    return `copy-${Number(ratio[0].toPrecision(3))}x${turn ? `-${turn}deg` : ""}`;
  }

  /** What stands above it on paper. */
  function heading({ doc, task, own }) {
    const ratio = ratioOf(doc, task), copy = ratio ? `: × ${kempe.figure(ratio[0], 4)}${ratio[1] ? `, ${kempe.figure(ratio[1], 4)}°` : ""}` : "";
    return `${title(doc) || own || "A copying instrument"}${copy}`;
  }

  kempe.naming = { originOf, withoutNames, fileName, heading };
})((globalThis.kempe = globalThis.kempe || {}));
