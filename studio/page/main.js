// The studio: one spec, its design, and what follows while a hand moves something.
"use strict";
(function (kempe) {
  const one = (id) => document.getElementById(id);
  const make = (tag, properties = {}, ...children) => {
    const node = Object.assign(document.createElement(tag), properties);
    node.append(...children);
    return node;
  };
  const degrees = (angle) => (angle * 180) / Math.PI;
  const underLoad = { load_error: "mm", sag: "mm", mass: "kg" };  // figures of the engine that are there only beside a load and a material
  // What the engine does at rest, by the words with which it tells its progress.
  const steps = [
    { name: "Possible?", words: "Is a design possible at all?", of: /^looking whether/ },
    { name: "Search", words: "Searching for the best design", of: /^searching/, always: true },
    { name: "Bound", words: "Proving what no design can beat", of: /^proving/, always: true },
    { name: "Way out", words: "No design so far; looking for the least change that allows one", of: /^looking (again )?for what/ },
    { name: "Map", words: "Mapping where the tracer can go", of: /^mapping/, always: true },
  ];
  const shownAfter = 250;  // ms: what is done sooner needs no list
  const rest = 220;  // ms after the last move before the full search begins

  /** A number as people write it, with a point or a comma; NaN if it is none. */
  const readNumber = (text) => {
    const plain = text.trim().replace(/\s|\u00a0/g, "").replace("\u2212", "-");
    return /^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain.replace(",", ".")) : NaN;
  };

  class Studio {
    constructor() {
      this.data = JSON.parse(one("studio-data").textContent);
      this.history = [];
      this.future = [];
      this.stage = new kempe.Table(one("map"), {
        begin: () => this.begin(),
        drag: (handle, to) => this.drag(handle, to),
        end: (handle, moved) => { if (moved) this.settle(); this.base = null; },
        nudge: (handle, to) => { this.begin(); this.drag(handle, to); this.base = null; this.settle(); },
        tracer: (at) => this.moveTracer(at),
        fit: () => this.fit(),
        remove: (shape) => this.remove(shape),
      });
      this.searcher = new kempe.Engine();
      this.sketcher = new kempe.Engine();
      this.files = [];  // the drawings that came with a spec; the engine looks there for region.file
      this.drawing = new kempe.Drawing({
        use: (text) => { this.fitNext = true; this.change(text); },
        current: () => ({ text: this.text, middle: this.middleOfRegion() }),
        notice: (words) => this.notice(words),
      });
      this.photo = new kempe.Photo({ show: (photo) => this.stage.showPhoto(photo), notice: (words) => this.notice(words) });
      this.panel = new kempe.Panel(one("fields"), this.data.keys, { change: (text) => this.change(text), remove: (shape) => this.remove(shape) });
      this.colours = new kempe.Colours(one("colours-list"));
      this.proven = new Set();  // texts for which it is proven that no design exists
      this.own = this.origin = null;  // what the user calls the task; the template it was begun with
      this.listen();
    }

    async start() {
      try {
        await Promise.all([this.searcher.ready, this.sketcher.ready]);
      } catch (fault) {
        document.body.classList.add("refused");
        this.say("bad", fault.message);
        throw fault;
      }
      this.searcher.ask("materials", {}).then(({ names }) => names && this.panel.suggest("material.name", names));
      let text = null;
      try {
        text = await kempe.textOf(location.hash);
      } catch (fault) {
        this.notice(fault.message);
      }
      const inside = this.inside();
      if (text) this.open(text);
      else if (inside) this.open(inside.text, { own: inside.name });
      else this.open(this.data.first.text, { origin: { ...this.data.first, name: null } });
      document.body.classList.add("started");
    }

    /** The spec that `kempe studio` has put into this page, with its drawing; null if there is none. */
    inside() {
      const held = JSON.parse(one("studio-spec").textContent);
      if (!held) return null;
      this.files = held.files;
      try {  // here the drawing lies beside the spec, wherever it lay
        const doc = new kempe.Doc(held.text), [file] = held.files;
        return { name: held.name, text: file && doc.get("region.file") !== file.name ? doc.with("region.file", file.name) : held.text };
      } catch {
        return held;
      }
    }

    // ---- the spec

    /** What the engine is asked about a text: with the drawing that it names, if that came along. */
    asked(text, more = {}) {
      const files = this.files.filter(({ name }) => text.includes(name));
      return { text, ...(files.length ? { files } : {}), ...more };
    }

    middleOfRegion() {
      const region = (this.shapes || []).find(({ role }) => role === "region");
      return region ? kempe.middleOf(region.rings.flat()) : null;
    }

    /** Another spec altogether: the user's `own` by name, or one that was begun with a template. */
    open(text, { own = null, origin = null } = {}) {
      this.model = this.ghost = this.from = this.answer = null;
      this.tracer = null;
      this.stage.showMap(null);
      this.fitNext = true;
      one("lengths").classList.add("stale");
      one("lengths-list").replaceChildren(make("p", { className: "help", textContent: "No design so far." }));
      const before = this.state();
      Object.assign(this, { own, origin: origin && kempe.naming.originOf(origin) });
      if (text !== this.text) return this.change(text, { before });
      this.adopt(text);  // the same once more: what was taken away above is made again
      this.settle();
    }

    /** What undo goes back to. */
    state() {
      const { text, own, origin } = this;
      return { text, own, origin };
    }

    /** A new text, as one step that can be undone. What was `typed` as a text stays as it was typed. */
    change(wanted, { before = this.state(), typed = false } = {}) {
      const text = typed ? wanted : kempe.naming.withoutNames(wanted, this.origin);
      if (text === this.text) return;
      this.hint("");
      if (this.text !== undefined) this.remember(before);
      this.adoptInView(text);
      this.settle();
    }

    /** A text that no hand drags there: all is put into view again where what it changes has gone out of view, or has become too small to see. */
    adoptInView(text) {
      const before = new Map((this.shapes || []).map((shape) => [shape.name, kempe.boxOfShape(shape)])), { stage } = this;
      this.adopt(text);
      const lost = ({ name, role, ...shape }) => {
        const was = before.get(name), now = kempe.boxOfShape(shape);
        if (!now || role === "body" || JSON.stringify(was) === JSON.stringify(now)) return false;
        return stage.isBeyond(now) || (was && stage.isWithin(was) && !stage.isWithin(now)) || (role === "region" && stage.shareOf(now) < 0.1);
      };
      if (this.shapes.some(lost)) this.fitNext = true;
    }

    remember(state) {
      this.history.push(state);
      if (this.history.length > 200) this.history.shift();
      this.future = [];
    }

    /** The text is the spec from now on; nothing is searched yet. */
    adopt(text) {
      this.text = text;
      if (one("spec").value !== text && document.activeElement !== one("spec")) one("spec").value = text;
      try {
        this.doc = new kempe.Doc(text);
      } catch (fault) {
        this.doc = this.doc || new kempe.Doc("");
      }
      this.place();
      this.panel.show(this.doc);
    }

    undo(from, to) {
      if (from.length === 0) return;
      to.push(this.state());
      const { text, own, origin } = from.pop();
      Object.assign(this, { own, origin });
      one("spec").value = text;
      this.adoptInView(text);
      this.settle();
    }

    begin() {
      this.hint("");
      this.fitNext = false;  // nothing moves below a hand
      this.base = this.doc;
      this.before = this.state();
      // What was searched no longer matters; the last design is the ghost.
      if (this.answer && this.answer.kind === "design") this.ghost = this.answer.model;
    }

    drag(handle, to) {
      const current = kempe.shapesOf(this.base, this.task, this.polePlace()).flatMap(({ handles }) => handles).find(({ id }) => id === handle.id);
      if (!current) return;
      const text = kempe.naming.withoutNames(current.move(to), this.origin);
      if (text === this.text) return;
      if (this.before) this.remember(this.before);
      this.before = null;
      this.stage.showMap(null);
      this.adopt(text);
      one("spec").value = text;
      this.sketchSoon();
      this.settle(rest);
    }

    // ---- the engine

    /** The fast answer, one at a time, always about the newest text. */
    async sketchSoon() {
      this.sketchWanted = true;
      if (this.sketching || !this.from && !this.hasSketched) return;
      this.sketching = true;
      while (this.sketchWanted) {
        this.sketchWanted = false;
        const from = this.from;
        this.from = null;
        const asked = performance.now(), { text } = this;
        const answer = await this.sketcher.ask("sketch", this.asked(text, { from }));
        this.hasSketched = true;
        this.sketchTime = performance.now() - asked;
        if (answer.stopped || answer.error) break;
        if (answer.kind === "none" && answer.proven) this.proveNone(text);
        if (this.answerIsCurrent) break;  // the full search was quicker
        this.takeSketch(answer);
      }
      this.sketching = false;
    }

    takeSketch(answer) {
      if (answer.kind === "sketch") {
        this.model = answer.model;
        this.figures(answer.figures, true);
        this.place();
      } else if (answer.kind === "none") {
        this.model = null;
        this.say("wait", answer.proven ? "Proven: no design exists here. The reason follows when you rest." : "Nothing near the last design; searching when you rest …");
        this.place();
      }
    }

    /** A proof stays, whatever a later search finds or does not find. */
    proveNone(text) {
      this.proven.add(text);
      if (this.proven.size > 200) this.proven.delete(this.proven.values().next().value);
    }

    /** After the last move: the search, its map and its bound. */
    settle(wait = 0) {
      clearTimeout(this.timer);
      this.answerIsCurrent = false;
      this.timer = setTimeout(() => this.search(), wait);
    }

    async search() {
      const { text } = this;
      if (this.searcher.busy) this.searcher.stop();
      this.keep(text);
      one("stop").hidden = false;
      this.progress(0, "");
      let answer;
      try {
        const checked = await this.searcher.ask("validate", this.asked(text));
        if (checked.stopped || text !== this.text) return;
        if (checked.kind === "faults" || checked.error) return this.finish(checked);
        this.task = checked.task;
        this.faults([]);
        if (this.fitNext) this.fit();
        this.place();
        answer = await this.searcher.ask(this.isGiven() ? "map" : "design", this.asked(text), ({ share, what }) => { if (text === this.text) this.progress(share, what); });
      } catch (fault) {
        answer = { error: fault.message };
      }
      if (answer.stopped || text !== this.text) return;
      this.finish(answer);
    }

    /** True where there is nothing to design for: the spec gives a mechanism, and its map is asked for. */
    isGiven() {
      return this.task.mechanism && this.task.region.length === 0;
    }

    finish(answer) {
      one("stop").hidden = true;
      this.progress(null, "");
      this.answer = answer;
      this.answerIsCurrent = true;
      this.faults(answer.kind === "faults" ? answer.faults : []);
      one("download").disabled = answer.kind !== "design";
      document.body.dataset.answer = answer.kind || "error";
      one("changes").replaceChildren();
      one("lengths").classList.toggle("stale", answer.kind !== "design");
      if (answer.kind === "design") this.take(answer);
      else if (answer.kind === "none") this.takeNone(answer);
      else if (answer.kind === "faults") this.say("bad", `${answer.faults.length === 1 ? "The spec has a fault" : `The spec has ${answer.faults.length} faults; the first`}: ${this.wordsOf(answer.faults[0])}`);
      else this.say("bad", answer.error || "The engine gave no answer.");
      window.dispatchEvent(new CustomEvent("kempe-answer", { detail: answer.kind || "error" }));
    }

    take(answer) {
      this.model = answer.model;
      this.ghost = null;
      this.from = answer.handover;
      if (!this.tracer) this.tracer = this.goodPlace();
      this.stage.showMap(answer.picture);
      this.reasons = [];
      const binding = this.bindings(answer);
      this.binding = binding.flatMap(({ at }) => (at ? [at] : []));
      const { figures } = answer;
      this.figures(figures, false);
      if (!figures.covers) this.say("bad", figures.why_not_covered);
      else this.say("good", `${this.howGood(figures)}${binding.length ? ` What holds it back: ${binding.map(({ text }) => text).join("; ")}.` : ""}`);
      if (!figures.complete) this.say("wait", "The search was stopped early: a better one may exist.");
      if (this.fitNext) this.fit();
      this.fitNext = false;
      one("lengths-list").replaceChildren(...kempe.lengthTables(answer));
      this.place();
    }

    /** What may be said of a design, and no more. */
    howGood({ value, bound, objective }) {
      if (value === null) return "The map of the mechanism that the spec gives.";
      if (bound === null) return "The best that the search has found.";
      const share = 100 * Math.abs(value / bound - 1), what = objective === "transmission" ? "moves more easily" : "is smaller";
      return `Proven: no other ${what} by more than ${kempe.figure(Math.max(0.01, share + 0.005), 2)} %.`;
    }

    /** A place of the original beside its middle, where the handle is that moves it. */
    goodPlace() {
      const ring = this.task.region[0];
      if (!ring) return null;
      const [x, y] = kempe.middleOf(this.task.region.flat());
      return [x + 0.45 * (ring[0][0] - x), y + 0.45 * (ring[0][1] - y)];
    }

    takeNone(answer) {
      this.model = null;
      this.binding = [];
      this.reasons = this.reasonsOnTheTable(answer);
      this.ghost = this.ghost || null;
      this.stage.showMap(null);
      this.figures(null, false);
      if (answer.proven) this.proveNone(this.text);
      const proven = this.proven.has(this.text), [first] = answer.changes, key = first && answer.reason === first.sentence ? first.key : "";
      const reason = kempe.plainly(answer.reason.replace(/^the search found none that keeps/, proven ? "no design keeps" : "$&"), key, this.doc).replace(/[^.]$/, "$&.");
      const drag = this.isObstacleInTheWay(answer) ? " Dragging it away may help too." : "";
      this.say("bad", `${proven ? "Proven: no design exists." : "None found, which proves nothing."} ${kempe.tooLarge(this.task)}${reason}${drag}`, answer.reason);
      one("changes").replaceChildren(...answer.changes.map((change) => this.changeButton(change)));
      this.place();
    }

    /** Where on the table the limits lie that are in the way, each with a word: at most three. */
    reasonsOnTheTable({ reason, changes }) {
      const { task, doc } = this, area = task.pole.within, pole = task.pole.at || (area && area.length ? kempe.middleOf(area.flat()) : null);
      const copy = kempe.shapesOf(doc, task, pole).find(({ role }) => role === "copy"), points = task.region.flat();
      if (!pole || points.length === 0) return [];
      const away = ([x, y], [u, v]) => Math.hypot(x - u, y - v), least = (all, of) => all.reduce((best, at) => (of(at) < of(best) ? at : best));
      const far = least(points, (at) => -away(at, pole)), near = least(points, (at) => away(at, pole)), middle = kempe.middleOf(points);
      const spots = ({ key, sentence }) => {
        if (key.startsWith("pole.")) return [[pole, key === "pole.within_mm" ? ["the pole's area is in the way", "in the way"] : "the pole stands here"]];
        if (key === "limits.sheets_gap_mm") return copy ? [[least(copy.rings.flat(), (at) => away(at, middle)), "copy too near"]] : [];
        if (key === "limits.transmission_deg") return [[far, ["transmission angle", "transmission"]], [near, ["transmission angle", "transmission"]]];
        if (/longest/.test(key)) return [[far, "too far for the strips"]];
        if (key === "limits.copy_error_mm") return [[far, "copy error"]];
        const index = this.namesObstacle(key, sentence) ? kempe.obstacleNamed(this.doc, sentence) : -1;
        const obstacle = (this.shapes || []).find((of) => of.role === "obstacle" && of.index === index);
        return obstacle ? [[kempe.middleOf(obstacle.rings.flat()), ["in the way: dragging it away may help", "in the way: drag it away?", "in the way"]]] : [];
      };
      const told = changes.length ? changes : [{ key: (/\b(?:limits|links|pole)\.\w+|\bobstacles\b/.exec(reason) || ["obstacles"])[0], sentence: reason }];
      const found = [];
      for (const [at, words] of told.flatMap(spots)) if (found.length < 3 && found.every((one) => away(one.at, at) > 1e-6)) found.push({ at, words });
      return found;
    }

    namesObstacle(key, sentence) {
      return key.startsWith("obstacles") && kempe.obstacleNamed(this.doc, sentence) >= 0;
    }

    /** Whether a sentence says that an obstacle, which a hand could drag, is in the way. */
    isObstacleInTheWay({ reason, changes }) {
      const named = changes.some(({ key, sentence }) => this.namesObstacle(key, sentence));
      return named || (/stands over the pole/.test(reason) && kempe.obstacleNamed(this.doc, reason) >= 0);
    }

    /** What would make a design possible, as a button where the change can be written into the spec. */
    changeButton(change) {
      const isKey = (path) => this.data.keys.some(({ table, name }) => `${table}.${name}` === path);
      const way = kempe.wayOut(change, { doc: this.doc, task: this.task, isKey });
      if (!way) return make("span", { className: "change", textContent: kempe.plainly(change.sentence, change.key, this.doc), title: change.sentence });
      const button = make("button", { type: "button", textContent: way.words, title: kempe.plainly(change.sentence, change.key, this.doc) });
      button.addEventListener("click", () => this.change(way.text));
      return button;
    }

    /** The limits that the design keeps with nothing to spare, with the place where, if it is one. */
    bindings({ model, lengths, figures }) {
      const { task } = this, found = [];
      const at = this.leastTransmission(model);
      if (at && degrees(at.angle - task.transmission) < 0.02) found.push({ text: `the transmission angle at ${this.cornerName(at.place)}`, at: at.place });
      const slack = 1e-3 * (1 + Math.max(...Object.values(lengths))) * 0.1;
      const names = (test) => Object.keys(lengths).filter((name) => test(lengths[name]));
      const long = names((of) => task.longest - of < slack), short = names((of) => of - task.shortest < slack);
      if (long.length) found.push({ text: `the ${task.longest_strip !== null ? "longest strip" : "largest distance of joints"}, ${long.join(" and ")}` });
      if (short.length) found.push({ text: `the least distance of joints, ${short.join(" and ")}` });
      if (figures.clearance !== null && figures.clearance - task.clearance < 0.01) found.push({ text: "the clearance between parts" });
      for (const [key, words] of [["load_error", "how far the pen gives way"], ["sag", "the sag"]])
        if (task[key] !== null && figures[key] !== null && figures[key] > 0.999 * task[key]) found.push({ text: words });
      if (task.pole.within && kempe.isOnEdge(model.pole, task.pole.within)) found.push({ text: "the pole's area, on whose edge the pole stands: drag it or make it larger", at: model.pole });
      return found;
    }

    leastTransmission(model) {
      const linkage = new kempe.Linkage(model);
      let least = null;
      const look = (place) => {
        const { opening, why } = linkage.openingAt(Math.hypot(place[0] - model.pole[0], place[1] - model.pole[1]));
        if (why) return;
        const angle = linkage.transmissionAt(opening);
        if (!least || angle < least.angle - 1e-12) least = { angle, place };
      };
      for (const ring of this.task.region)
        ring.forEach(([x, y], i) => {
          const [u, v] = ring[(i + 1) % ring.length];
          for (let t = 0; t < 16; ++t) look([x + ((u - x) * t) / 16, y + ((v - y) * t) / 16]);
        });
      return least;
    }

    /** "the far left corner": a place of the region, for a person at the table. */
    cornerName([x, y]) {
      const points = this.task.region.flat(), xs = points.map((at) => at[0]), ys = points.map((at) => at[1]);
      const [left, right, near, far] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
      const part = (value, low, high) => (value < low + 0.2 * (high - low) ? 0 : value > high - 0.2 * (high - low) ? 2 : 1);
      const across = ["left", "", "right"][part(x, left, right)], deep = ["near", "", "far"][part(y, near, far)];
      const words = [deep, across].filter(Boolean).join(" ");
      return words ? `the original's ${words} ${deep && across ? "corner" : "edge"}` : "a place inside the original";
    }

    // ---- what is seen

    polePlace() {
      if (this.model) return this.model.pole;
      if (this.answer && this.answer.model) return this.answer.model.pole;
      const area = this.answerIsCurrent && this.task && this.task.pole.within;  // no design: the copy is shown for a pole in its middle
      return area && area.length ? kempe.middleOf(area.flat()) : null;
    }

    place() {
      one("play").disabled = !this.model;
      const shapes = kempe.shapesOf(this.doc, this.task, this.polePlace());
      this.shapes = shapes;
      this.panel.showMeasures(shapes);
      const region = shapes.find(({ role }) => role === "region");
      const tracer = this.tracer || (region ? kempe.middleOf(region.rings.flat()) : [0, 0]);
      this.stage.show({ shapes, model: this.model, ghost: this.answerIsCurrent ? (this.model ? null : this.ghost) : this.ghost, tracer, binding: this.answerIsCurrent ? this.binding : [], reasons: this.answerIsCurrent ? this.reasons : [] });
      this.colours.show(this.stage.colours());
    }

    fit() {
      const points = kempe.shapesOf(this.doc, this.task, this.polePlace()).flatMap(({ rings, handles }) => [...rings.flat(), ...handles.map(({ at }) => at)]);
      if (this.model) {
        const found = this.stage.poseOf(this.model, this.tracer);
        if (found) points.push(...found.pose);
      }
      this.stage.fit(points);
    }

    moveTracer(at) {
      if (!this.model) return;
      this.pause();
      const found = this.stage.poseOf(this.model, at);
      if (found) this.tracer = found.place;
      this.place();
    }

    figures(of, isSketch) {
      const set = (id, value, note = "") => {
        one(id).textContent = value;
        one(`${id}-note`).textContent = note;
      };
      const mm = (value) => `${kempe.figure(value, value < 10 ? 2 : 1)}\u00a0mm`;
      document.body.classList.toggle("sketched", isSketch);
      if (!of) {
        for (const id of ["size", "bound", "transmission", "clearance", "free", "longest", ...Object.keys(underLoad)]) set(id, "–");
        return;
      }
      if (!isSketch) this.showLoads(of, set);
      else for (const id of Object.keys(underLoad)) set(id, "…");
      set("size", mm(of.size));
      const unit = (value) => (this.task && this.task.objective === "transmission" ? `${kempe.figure(degrees(value), 2)}°` : mm(value));
      const share = of.bound && of.value ? 100 * Math.abs(of.value / of.bound - 1) : null;
      set("bound", of.bound === null || of.bound === undefined ? "–" : unit(of.bound), share === null ? this.whyNoBound(of) : share < 0.01 ? "reached to 0.01 %" : `this is ${kempe.figure(share, share < 1 ? 2 : 1)} % off`);
      set("transmission", `${kempe.figure(degrees(of.transmission), 1)}°`, this.task ? `limit ${kempe.figure(degrees(this.task.transmission), 1)}°` : "");
      const { longest, longest_strip: strip } = this.task || {};  // the task limits the holes' distance, and may limit the strip
      set("longest", mm(of.longest_strip), !this.task ? "" : strip ? `limit ${kempe.figure(strip, 1)} mm` : `joints ${kempe.figure(of.longest, 1)} of ${kempe.figure(longest, 1)}`);
      if (isSketch) {
        set("clearance", "…");
        set("free", "…");
        this.say("wait", "Following your hand. The full search runs when you rest.");
        return;
      }
      set("clearance", of.clearance === null ? "nothing near" : mm(of.clearance), this.task ? `limit ${kempe.figure(this.task.clearance, 2)} mm` : "");
      set("free", `${kempe.figure(of.free_area / 100, of.free_area < 10000 ? 1 : 0)}\u00a0cm²`);
    }

    /** Bounds are proven of two goals. */
    whyNoBound({ value, bound }) {
      const goal = this.task ? this.task.objective : "";
      return !value || bound ? "" : ["size", "transmission"].includes(goal) ? "nothing is proven" : `no bound for ${goal.replace("_", " ")}`;
    }

    /** What a load and a material make known: shown where the spec has them. */
    showLoads(of, set) {
      const known = Object.keys(underLoad).filter((id) => of[id] !== null && of[id] !== undefined);
      one("figures").style.setProperty("--loads", known.length);
      this.colours.showFigures(Object.keys(underLoad).filter((id) => !known.includes(id)));
      for (const [id, unit] of Object.entries(underLoad)) {
        one(`${id}-key`).hidden = !known.includes(id);
        const limit = this.task ? this.task[id] : null;
        const digits = (value) => kempe.figure(Number(value.toPrecision(3)), 6);
        if (known.includes(id)) set(id, `${digits(of[id])}\u00a0${unit}`, limit === null || limit === undefined ? "" : `limit ${digits(limit)} ${unit}`);
      }
    }

    /** `title`: what the engine itself says. */
    say(kind, words, title = "") {
      if (one("verdict").textContent === words && one("verdict").className === `verdict ${kind}` && one("verdict").title === title) return;
      Object.assign(one("verdict"), { className: `verdict ${kind}`, textContent: words, title });
      one("answer").className = `answer ${kind}`;
      one("answer").scrollTop = 0;
    }

    /** A notice that goes by itself with the next step. */
    hint(words) {
      if (words || this.hinted) this.notice(words);
      this.hinted = words !== "";
    }

    notice(words) {
      this.hinted = false;
      one("notice-text").textContent = words;
      one("notice").hidden = !words;
    }

    /** The share done of what the engine does now; null once it rests. Search, bound and map stand in a row, each with its own. */
    progress(share, what) {
      const bar = one("progress"), list = one("steps");
      bar.hidden = share === null;
      if (share === null || what === "") {
        this.steps = { begun: performance.now(), reached: new Set() };
        list.hidden = true;
        bar.value = 0;
        if (share !== null && !document.body.classList.contains("sketched")) this.say("wait", "Searching …");
        return;
      }
      const step = steps.find(({ of }) => of.test(what)) || steps[1], { reached, begun } = this.steps;
      reached.add(step);
      bar.value = share;
      bar.setAttribute("aria-label", step.name);
      list.hidden = performance.now() - begun < shownAfter;
      list.replaceChildren(...steps.filter((one) => (one.always && !this.isGiven()) || reached.has(one)).map((one) => {
        const done = reached.has(one) && one !== step;
        const item = make("li", { className: done ? "done" : "" }, one.name, make("span", { className: "share", textContent: one === step ? `${Math.floor(100 * share)} %` : done ? "✓" : "" }));
        if (one === step) item.setAttribute("aria-current", "step");
        return item;
      }));
      if (!this.steps.said || this.steps.said !== step) this.say("wait", `${step.words} …`);
      this.steps.said = step;
    }

    wordsOf({ file, line, key, found, allowed }) {
      const named = kempe.words.isNamed(key) ? `${kempe.words.nameOf(key)} (${key})` : key;
      return `${file ? `${file}: ` : ""}${line ? `Line ${line}: ` : ""}${key ? `${named}: ` : ""}${found ? `found ${found}` : ""}${allowed ? `; allowed: ${allowed}` : ""}`;
    }

    faults(all) {
      const here = all.map((fault) => (fault.file ? { ...fault, line: null } : fault));  // lines of the spec's text
      one("faults").replaceChildren(...all.map((fault) => {
        const button = make("button", { type: "button", className: "fault", textContent: this.wordsOf(fault) });
        button.addEventListener("click", () => this.showLine(fault.file ? null : fault.line));
        return make("li", {}, button);
      }));
      one("spec").classList.toggle("faulty", all.length > 0);
      const lines = new Set(here.map(({ line }) => line));
      one("lines").replaceChildren(...one("spec").value.split("\n").map((_, i) => make("span", { textContent: i + 1, className: lines.has(i + 1) ? "bad" : "" })));
      if (all.length) one("text-part").open = true;
    }

    showLine(line) {
      const field = one("spec"), lines = field.value.split("\n"), start = lines.slice(0, Math.max(0, (line || 1) - 1)).join("\n").length + (line > 1 ? 1 : 0);
      one("text-part").open = true;
      field.focus();
      field.setSelectionRange(start, start + (lines[(line || 1) - 1] || "").length);
    }

    // ---- playing

    play() {
      const ring = this.task && this.task.region[0];
      if (!ring || !this.model) return;
      const points = [...ring, ring[0]], lengths = points.slice(1).map((at, i) => Math.hypot(at[0] - points[i][0], at[1] - points[i][1]));
      const total = lengths.reduce((sum, of) => sum + of, 0);
      let along = 0, last = null;
      const frame = (now) => {
        this.playing = requestAnimationFrame(frame);
        along = (along + (last === null ? 0 : Math.min(100, now - last) / 8000) * total) % total;
        last = now;
        let i = 0, left = along;
        while (i < lengths.length - 1 && left > lengths[i]) left -= lengths[i++];
        const t = left / (lengths[i] || 1);
        this.tracer = [points[i][0] + t * (points[i + 1][0] - points[i][0]), points[i][1] + t * (points[i + 1][1] - points[i][1])];
        this.place();
      };
      this.playing = requestAnimationFrame(frame);
      this.showPlaying();
    }

    pause() {
      if (this.playing) cancelAnimationFrame(this.playing);
      this.playing = null;
      this.showPlaying();
    }

    showPlaying() {
      one("play").textContent = this.playing ? "❚❚ Pause" : "▶ Play";
      one("play").setAttribute("aria-pressed", String(Boolean(this.playing)));
    }

    // ---- taking away

    async keep(text) {
      const fragment = await kempe.fragmentOf(text);
      if (text !== this.text) return;
      this.fragment = fragment;
      try {
        history.replaceState(null, "", fragment || "#");
      } catch {
        this.notice("");  // some browsers let no file's address change: the button still copies it
      }
    }

    async share() {
      const fragment = await kempe.fragmentOf(this.text);
      if (this.asked(this.text).files) return this.notice("This spec reads a drawing, which no address holds. Make the drawing the original with “Add”, “Original from a drawing …”, or pass on the files of Download.");
      if (!fragment) return this.notice("This spec is too long for an address. Download its text instead.");
      const address = location.href.replace(/#.*$/, "") + fragment;
      try {
        await navigator.clipboard.writeText(address);
        this.notice("The address is copied. It holds your whole task and opens it in this same file: send the file along to somebody who does not have it.");
      } catch {
        this.notice(address);
      }
    }

    async download() {
      if (this.searcher.busy) return;
      one("download").disabled = true;
      const name = kempe.naming.fileName(this), answer = await this.searcher.ask("files", { title: name });
      one("download").disabled = false;
      if (!answer.files) return this.notice(answer.reason || answer.error || "The files could not be written.");
      const spec = { name: "spec.toml", bytes: new TextEncoder().encode(this.text) };
      const drawings = (this.asked(this.text).files || []).map(({ name, text }) => ({ name, bytes: new TextEncoder().encode(text) }));
      kempe.save(`${name}.zip`, kempe.zip([...answer.files, spec, ...drawings]));
      this.notice(`${name}.zip is saved. In it, workshop.pdf has the drawings at full size, bom.csv what to buy, report.html the instrument as it moves.`);
    }

    /** What stands on paper alone. */
    fillPrint() {
      one("printed-title").textContent = kempe.naming.heading(this);
      one("printed-lengths").replaceChildren(...(document.body.dataset.answer !== "design" ? [] : kempe.lengthTables(this.answer, true)));
      one("printed-spec").textContent = this.text;
    }

    // ---- hands and keys

    listen() {
      kempe.selectWhole(document);
      const gallery = one("gallery");
      for (const group of ["templates", "examples"]) one(group).replaceChildren(...this.data[group].map((spec) => this.card(spec)));
      one("open-gallery").addEventListener("click", () => gallery.showModal());
      one("close-gallery").addEventListener("click", () => gallery.close());
      one("undo").addEventListener("click", () => this.undo(this.history, this.future));
      one("redo").addEventListener("click", () => this.undo(this.future, this.history));
      one("print").addEventListener("click", () => window.print());
      window.addEventListener("beforeprint", () => this.fillPrint());
      one("share").addEventListener("click", () => this.share());
      one("download").addEventListener("click", () => this.download());
      one("play").addEventListener("click", () => (this.playing ? this.pause() : this.play()));
      one("zoom-in").addEventListener("click", () => this.stage.zoom(1.4));
      one("zoom-out").addEventListener("click", () => this.stage.zoom(1 / 1.4));
      one("zoom-all").addEventListener("click", () => this.fit());
      one("stop").addEventListener("click", () => { this.searcher.stop(); this.finish({ error: "Stopped. Move something, or type, to search again." }); });
      one("close-notice").addEventListener("click", () => this.notice(""));
      kempe.menu(one("more"), one("more-list"));
      kempe.menu(one("add"), one("add-list"));
      one("add-obstacle").addEventListener("click", () => this.addObstacle("rectangle"));
      one("add-circle").addEventListener("click", () => this.addObstacle("circle"));
      for (const [button, input, open] of [["from-drawing", "drawing-file", (file) => this.drawing.open(file)], ["from-photo", "photo-file", (file) => this.photo.open(file)]]) {
        one(button).addEventListener("click", () => one(input).click());
        one(input).addEventListener("change", () => {
          const [file] = one(input).files;
          one(input).value = "";
          if (file) open(file);
        });
      }
      this.listenToDrops();
      one("spec").addEventListener("input", () => {
        clearTimeout(this.typing);
        this.typing = setTimeout(() => this.change(one("spec").value, { typed: true }), 350);
      });
      one("spec").addEventListener("scroll", () => (one("lines").scrollTop = one("spec").scrollTop));
      window.addEventListener("hashchange", async () => {
        if (location.hash === (this.fragment || "#")) return;
        try {
          const text = await kempe.textOf(location.hash);
          if (text !== null && text !== this.text) this.open(text);
        } catch (fault) {
          this.notice(fault.message);
        }
      });
      document.addEventListener("keydown", (event) => {
        if (!(event.ctrlKey || event.metaKey) || event.target === one("spec")) return;
        const key = event.key.toLowerCase();
        if (key === "z" && !event.shiftKey) this.undo(this.history, this.future);
        else if (key === "y" || (key === "z" && event.shiftKey)) this.undo(this.future, this.history);
        else return;
        event.preventDefault();
      });
    }

    /** A drawing, a photo or a spec let fall anywhere on the page. */
    listenToDrops() {
      const holdsFile = (event) => [...event.dataTransfer.types].includes("Files");
      document.addEventListener("dragover", (event) => {
        if (!holdsFile(event)) return;
        event.preventDefault();
        document.body.classList.add("dropping");
      });
      document.addEventListener("dragleave", (event) => { if (!event.relatedTarget) document.body.classList.remove("dropping"); });
      document.addEventListener("drop", (event) => {
        document.body.classList.remove("dropping");
        if (!holdsFile(event)) return;
        event.preventDefault();
        const [file] = event.dataTransfer.files;
        if (file) this.takeFile(file);
      });
    }

    async takeFile(file) {
      if (/\.toml$/i.test(file.name) && file.size < 1 << 20) {
        return this.open(await file.text(), { own: file.name.replace(/\.toml$/i, "") });
      }
      if (/^image\/(?!svg)/.test(file.type)) return this.photo.open(file);
      if (kempe.drawingKind(file.name)) return this.drawing.open(file);
      this.notice(`${file.name}: not a file that the studio takes; allowed: a drawing (.svg, .dxf), a photo, a spec (.toml)`);
    }

    card({ name, title, text }) {
      const button = make("button", { type: "button", className: "card" });
      button.append(kempe.preview(text), make("strong", { textContent: (name[0].toUpperCase() + name.slice(1)).replaceAll("-", " ").replace(/\ba(?=\d)/, "A") }), make("span", { textContent: title }));
      button.addEventListener("click", () => { one("gallery").close(); this.open(text, { origin: { name, text } }); });
      return button;
    }

    /** A new obstacle where nothing else stands, in the hand's focus. */
    addObstacle(kind) {
      const { left, top, width, height } = this.stage.view, size = this.stage.snapped([width / 10, width / 10])[0];
      const [x, y] = this.stage.snapped(this.freePlace([left, top, left + width, top + height], size)), names = this.shapes.map(({ name }) => name);
      let count = this.doc.count("obstacles") + 1;
      while (names.includes(`obstacle ${count}`)) ++count;
      const shape = kind === "circle" ? { circle_mm: { centre: [x, y], radius: size / 2 } } : { rectangle_mm: { at: [x - size / 2, y - size / 2], size: [size, size] } };
      const path = `obstacles.${this.doc.count("obstacles")}`;
      this.change(this.doc.withTable("obstacles", { name: `obstacle ${count}`, ...shape }));
      one("map").closest(".table").scrollIntoView({ block: "nearest" });
      this.stage.choose(`${path}.${kind === "circle" ? "circle_mm.centre" : "rectangle_mm.middle"}`);
      this.hint(`“obstacle ${count}” stands on the table: drag it where it is, and ${kind === "circle" ? "drag the point on its rim or type its radius" : "drag its corner or type its size"} under “On the table”.`);
    }

    /** The middle of a place in the window for something of a size, clear of what stands on the table; the window's middle if there is none. */
    freePlace([left, top, right, bottom], size) {
      const boxes = this.shapes.map(({ rings, handles }) => [...rings.flat(), ...handles.map(({ at }) => at)]).filter(({ length }) => length).map((points) => {
        const xs = points.map(([x]) => x), ys = points.map(([, y]) => y);
        return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
      });
      const middle = [(left + right) / 2, -(top + bottom) / 2], gap = 0.8 * size, places = [];
      for (let i = 2; i <= 10; ++i) for (let j = 2; j <= 10; ++j) places.push([left + (i / 12) * (right - left), -top - (j / 12) * (bottom - top)]);
      const isClear = ([x, y]) => boxes.every(([near, low, far, high]) => x + gap < near || x - gap > far || y + gap < low || y - gap > high);
      const away = ([x, y]) => Math.hypot(x - middle[0], y - middle[1]);
      return places.filter(isClear).sort((one, other) => away(one) - away(other))[0] || middle;
    }

    remove({ name, without }) {
      this.change(without());
      this.hint(`“${name}” is removed. Undo brings it back.`);
      one("map").focus({ preventScroll: true });
    }
  }

  /** A template's task, small: original, copy, pole and what is in the way. */
  kempe.preview = function (text) {
    const svg = "http://www.w3.org/2000/svg", root = document.createElementNS(svg, "svg");
    root.setAttribute("class", "map preview");
    root.setAttribute("aria-hidden", "true");
    const doc = new kempe.Doc(text), area = doc.get("pole.within_mm");
    const shapes = kempe.shapesOf(doc, null, area ? kempe.middleOf(area.flat(Array.isArray(area[0][0]) ? 1 : 0)) : null), points = shapes.flatMap(({ rings, handles }) => [...rings.flat(), ...handles.map(({ at }) => at)]);
    const xs = points.map(([x]) => x), ys = points.map(([, y]) => -y), pad = 0.08 * Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
    const width = Math.max(...xs) - Math.min(...xs) + 2 * pad, height = Math.max(...ys) - Math.min(...ys) + 2 * pad;
    root.setAttribute("viewBox", `${Math.min(...xs) - pad} ${Math.min(...ys) - pad} ${width} ${height}`);
    const css = { region: ["m-region", "outline"], copy: ["m-copy", "outline"], obstacle: ["m-obstacles", "thing plain"], "pole-area": ["pole-areas", "pole-area"], table: ["m-table", "edge"] };
    for (const { role, rings, handles } of shapes.filter(({ role }) => role !== "body")) {
      const group = document.createElementNS(svg, "g"), path = document.createElementNS(svg, "path"), dot = document.createElementNS(svg, "circle");
      if (role === "pole") {
        dot.setAttribute("cx", handles[0].at[0]);
        dot.setAttribute("cy", -handles[0].at[1]);
        dot.setAttribute("r", 0.03 * Math.max(width, height));
        dot.setAttribute("class", "core pole");
        group.append(dot);
      } else {
        group.setAttribute("class", css[role][0]);
        path.setAttribute("class", css[role][1]);
        path.setAttribute("d", rings.map((ring) => `M${ring.map(([x, y]) => `${x},${-y}`).join("L")}Z`).join(""));
        group.append(path);
      }
      root.append(group);
    }
    return root;
  };

  Object.assign(kempe, { readNumber, make });
  kempe.begin = () => {
    const studio = new Studio();
    kempe.studio = studio;
    kempe.started = studio.start();
    kempe.started.catch(() => {});
    /** The design of a spec, as design.json holds it; rejects with {faults}, {no_design} or {error}. In a worker of its own. */
    kempe.design = async (text) => {
      const engine = kempe.asked || (kempe.asked = new kempe.Engine());
      const answer = await engine.ask("design", { text: String(text) });
      if (answer.kind === "design") return answer.design;
      throw answer.kind === "faults" ? { faults: answer.faults } : answer.kind === "none" ? { no_design: answer.reason, proven: answer.proven, changes: answer.changes } : { error: answer.error || "stopped" };
    };
  };
})((globalThis.kempe = globalThis.kempe || {}));
