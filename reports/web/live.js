// The page comes alive: dragging, playing, drawing, asking the map, keyboard.
"use strict";
(function (kempe) {
  const one = (id) => document.getElementById(id);
  const { mm, degrees, point: pointText } = kempe.text;

  /** The region's outlines as one tour: places at equal speed, the pen lifted between two outlines. */
  class Tour {
    constructor(rings) {
      this.legs = rings.filter((ring) => ring.length > 1).map((ring) => {
        const points = [...ring, ring[0]], at = [0];
        for (let i = 1; i < points.length; ++i) at.push(at[i - 1] + Math.hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]));
        return { points, at, length: at[at.length - 1] };
      });
      this.length = this.legs.reduce((sum, leg) => sum + leg.length, 0);
      this.restart();
    }

    restart() {
      this.leg = 0;
      this.along = 0;
      this.laps = 0;
    }

    place() {
      const { points, at } = this.legs[this.leg];
      let i = 1;
      while (i < at.length - 1 && at[i] < this.along) ++i;
      const t = (this.along - at[i - 1]) / (at[i] - at[i - 1] || 1);
      return [points[i - 1][0] + t * (points[i][0] - points[i - 1][0]), points[i - 1][1] + t * (points[i][1] - points[i - 1][1])];
    }

    /** Goes on by a way of at most `step`, to the next corner if that is nearer. Returns the place and whether it begins a new outline. */
    advance(step) {
      const leg = this.legs[this.leg];
      if (this.along >= leg.length) {
        this.along = 0;
        this.leg = (this.leg + 1) % this.legs.length;
        if (this.leg === 0) ++this.laps;
        return { place: this.place(), lifted: true, way: 0 };
      }
      const corner = leg.at.find((at) => at > this.along + 1e-12 * leg.length);
      const to = Math.min(corner === undefined ? leg.length : corner, this.along + step), way = to - this.along;
      this.along = to;
      return { place: this.place(), lifted: false, way };
    }
  }

  class Report {
    constructor() {
      const model = JSON.parse(one("kempe-model").textContent);
      this.model = model;
      this.linkage = new kempe.Linkage(model);
      this.contacts = new kempe.Contacts(model);
      this.map = one("map");
      this.container = this.addContainer();
      this.places = new kempe.Places(model, this.linkage, this.contacts, this.map);
      this.stage = new kempe.Stage(model, this.container, this.map);
      this.tour = new Tour(model.region);
      this.timer = null;
      this.draws = one("draw");
      this.tip = one("tip");
      one("map-figure").classList.add("is-live");
      for (const id of ["controls", "readings", "help"]) one(id).hidden = false;
      this.listen();
      this.moveTo(model.tracer, { lifted: true });
    }

    addContainer() {
      const container = document.createElement("div");
      container.id = "live-board";
      container.className = "live-board";
      container.tabIndex = 0;
      one("board").append(container);
      return container;
    }

    /** The tracer to a place, as near as the assembly reaches it; the pen draws. */
    moveTo(wanted, { lifted = false } = {}) {
      const place = this.linkage.nearestReachable(wanted);
      const here = this.places.at(place);
      if (!here.pose) return null;
      this.draw(place, here.pen, lifted);
      const tooNear = here.gaps.filter(({ gap }) => gap < this.model.clearance).sort((a, b) => a.gap - b.gap);
      this.here = here;
      this.stage.show(here.pose, tooNear);
      this.tell(here);
      return here;
    }

    draw(tracer, pen, lifted) {
      const { trails } = this.stage;
      if (lifted || !this.draws.checked) {
        if (trails.pen.length && !Number.isNaN(trails.pen[trails.pen.length - 1][0])) for (const trail of Object.values(trails)) trail.push([NaN, NaN]);
        if (!this.draws.checked) return;
      }
      trails.tracer.push(tracer);
      trails.pen.push(pen);
      const most = 12000;
      if (trails.pen.length > most) for (const trail of Object.values(trails)) trail.splice(0, most / 4);
    }

    tell(here) {
      const { tightest } = here;
      one("at-tracer").textContent = pointText(here.place);
      one("at-pen").textContent = pointText(here.pen);
      one("at-opening").textContent = degrees(here.opening);
      one("at-transmission").textContent = degrees(here.transmission);
      one("at-gap").textContent = Number.isFinite(tightest.gap) ? mm(tightest.gap) : "none";
      one("at-gap").classList.toggle("bad", tightest.gap < this.model.clearance);
      one("at-parts").textContent = tightest.names.join(" – ");
      one("at-error").textContent = here.error ? mm(here.error.worst, 3) : "–";
      one("verdict").textContent = here.sentence;
      one("verdict").className = `verdict ${here.kind}`;
    }

    listen() {
      const { joints } = this.stage;
      for (const { role, point } of joints) {
        if (role !== "tracer" && role !== "pen") continue;
        point.on("down", () => { this.pause(); this.dragged = true; });
        point.on("drag", () => this.dragTo(role, [point.X(), point.Y()]));
      }
      this.container.addEventListener("pointermove", (event) => this.hover(event));
      this.container.addEventListener("pointerleave", () => (this.tip.hidden = true));
      this.container.addEventListener("pointerdown", (event) => { this.pressed = [event.clientX, event.clientY]; this.tip.hidden = true; });
      this.container.addEventListener("pointerup", (event) => this.release(event));
      this.container.addEventListener("keydown", (event) => this.key(event));
      one("play").addEventListener("click", () => this.toggle());
      one("clear").addEventListener("click", () => this.clear());
      one("zoom-in").addEventListener("click", () => this.stage.zoom(1.5));
      one("zoom-out").addEventListener("click", () => this.stage.zoom(1 / 1.5));
      one("zoom-job").addEventListener("click", () => this.stage.zoomToJob());
      one("zoom-all").addEventListener("click", () => this.stage.zoomToAll());
      one("map-figure").addEventListener("change", () => (this.stage.words = null));
      const linkage = one("layer-mechanism");
      const shown = () => this.container.classList.toggle("no-linkage", !linkage.checked);
      linkage.addEventListener("change", shown);
      shown();
      // Paper shows the whole map, whatever the screen has been zoomed to.
      window.addEventListener("beforeprint", () => { const { left, top, width, height } = this.model.view; this.map.setAttribute("viewBox", `${left} ${top} ${width} ${height}`); kempe.drawFrame(this.map, this.model.view, true); });
      window.addEventListener("afterprint", () => this.stage.follow());
    }

    dragTo(role, at) {
      // The pen leads the tracer by the inverse of the copy: tracer = pole + (pen - pole) / k.
      const [kx, ky] = this.model.k, norm = kx * kx + ky * ky, [px, py] = this.model.pole, x = at[0] - px, y = at[1] - py;
      this.moveTo(role === "tracer" ? at : [px + (x * kx + y * ky) / norm, py + (y * kx - x * ky) / norm]);
    }

    hover(event) {
      if (event.pointerType === "touch" || event.buttons !== 0) return;
      const here = this.places.at(this.stage.placeOf(event)), rows = [];
      const add = (name, value) => rows.push([name, value]);
      add("Place", pointText(here.place));
      if (here.pose) {
        add("Transmission", degrees(here.transmission));
        if (Number.isFinite(here.tightest.gap)) add("Smallest gap", `${mm(here.tightest.gap)}, ${here.tightest.names.join(" – ")}`);
        if (here.error) add("Copy error", `${mm(here.error.worst, 3)} worst, ${mm(here.error.rss, 3)} typical`);
      }
      const list = document.createElement("dl");
      for (const [name, value] of rows) {
        const [term, figure] = ["dt", "dd"].map((tag) => document.createElement(tag));
        term.textContent = name;
        figure.textContent = value;
        list.append(term, figure);
      }
      const sentence = document.createElement("p");
      sentence.className = here.kind;
      sentence.textContent = here.sentence;
      this.tip.replaceChildren(sentence, list);
      this.tip.hidden = false;
      const box = this.container.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
      this.tip.style.left = `${Math.min(x + 14, Math.max(0, box.width - this.tip.offsetWidth - 6))}px`;
      this.tip.style.top = `${y + 18 + this.tip.offsetHeight < box.height ? y + 18 : Math.max(0, y - this.tip.offsetHeight - 12)}px`;
    }

    /** A tap that is no drag brings the tracer there. */
    release(event) {
      const [x, y] = this.pressed || [NaN, NaN], dragged = this.dragged;
      this.pressed = null;
      this.dragged = false;
      if (dragged || event.button > 0 || event.shiftKey || !(Math.hypot(event.clientX - x, event.clientY - y) < 5)) return;
      this.pause();
      this.moveTo(this.stage.placeOf(event), { lifted: true });
    }

    key(event) {
      const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
      const acts = { " ": () => this.toggle(), c: () => this.clear(), "+": () => this.stage.zoom(1.5), "-": () => this.stage.zoom(1 / 1.5), 0: () => this.stage.zoomToJob(), a: () => this.stage.zoomToAll(), Home: () => this.home(), Escape: () => this.pause() };
      if (event.ctrlKey || event.metaKey) return;
      const arrow = arrows[event.key], act = acts[event.key];
      if (!arrow && !act) return;
      event.preventDefault();
      if (act) return void act();
      this.pause();
      const step = event.shiftKey ? 10 : event.altKey ? 0.1 : 1, [x, y] = this.here.place;
      this.moveTo([x + step * arrow[0], y + step * arrow[1]]);
    }

    home() {
      this.pause();
      this.moveTo(this.model.tracer, { lifted: true });
    }

    clear() {
      for (const trail of Object.values(this.stage.trails)) trail.length = 0;
      this.tour.restart();
      this.stage.board.update();
    }

    toggle() {
      if (this.timer === null) this.play();
      else this.pause();
    }

    pause() {
      if (this.timer !== null) cancelAnimationFrame(this.timer);
      this.timer = null;
      this.showPlaying();
    }

    showPlaying() {
      one("play").textContent = this.timer === null ? "▶ Play" : "❚❚ Pause";
      one("play").setAttribute("aria-pressed", String(this.timer !== null));
    }

    play() {
      if (this.tour.length === 0) return;
      this.onTour = false;
      let last = null;
      const frame = (now) => {
        this.timer = requestAnimationFrame(frame);
        const seconds = last === null ? 0 : Math.min(0.1, (now - last) / 1000);
        last = now;
        this.follow(seconds);
      };
      this.timer = requestAnimationFrame(frame);
      this.showPlaying();
    }

    /** The tracer goes on along the tour. Corners and short steps are drawn, the last place is shown. */
    follow(seconds) {
      if (!this.onTour) {
        this.onTour = true;
        this.moveTo(this.tour.place(), { lifted: true });
        return;
      }
      let way = (this.tour.length / 10) * Number(one("speed").value) * seconds;
      const step = 3 * this.model.view.unit;
      let next = null, lifted = false;
      for (let steps = 0; way > 0 && steps < 400; ++steps) {
        if (next) this.passed(next, lifted);
        const moved = this.tour.advance(Math.min(way, step));
        next = moved.place;
        lifted = moved.lifted;
        way -= moved.way || 1e-9;
      }
      if (!next) return;
      if (this.tour.laps > 0) this.showOnly(next);
      else this.moveTo(next, { lifted });
    }

    passed(place, lifted) {
      if (this.tour.laps === 0 && !this.linkage.poseWithTracerAt(place).why) this.draw(place, this.linkage.copyOf(place), lifted);
    }

    /** The second time round nothing new is drawn. */
    showOnly(place) {
      const wasDrawing = this.draws.checked;
      this.draws.checked = false;
      this.moveTo(place);
      this.draws.checked = wasDrawing;
    }
  }

  if (globalThis.JXG && one("kempe-model")) {
    try {
      kempe.report = new Report();
    } catch (error) {
      // The static picture stands; nothing is lost but the motion.
      one("map-figure").classList.remove("is-live");
      for (const id of ["controls", "readings", "help"]) one(id).hidden = true;
      console.error(error);
    }
  }
})((globalThis.kempe = globalThis.kempe || {}));
