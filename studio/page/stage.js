// The table seen from above: map, region, copy, obstacles, bodies, linkage and handles, as one SVG. Lines and colours are the report's.
"use strict";
(function (kempe) {
  const svg = "http://www.w3.org/2000/svg";

  function element(name, attributes = {}, text) {
    const node = document.createElementNS(svg, name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    if (text !== undefined) node.textContent = text;
    return node;
  }

  const path = (rings) => rings.map((ring) => `M${ring.map(([x, y]) => `${x},${-y}`).join("L")}Z`).join("");
  const line = (points) => `M${points.map(([x, y]) => `${x},${-y}`).join("L")}`;

  const joints = "VABCXY";  // in the order of Linkage.poseAt

  const mostEdges = 600;  // of outlines that words keep off: more would take long at every step of a drag

  /** [left, top, right, bottom] in the picture's frame. */
  function boxOf(points) {
    const xs = points.map(([x]) => x), ys = points.map(([, y]) => -y);
    return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
  }

  /** The groups of the report's picture that show areas; the rest the stage draws itself. */
  const areas = ["reachable", "usable", "free", "uncertain", "change", "transmission", "contact", "obstructed", "overlap"];

  class Stage {
    constructor(root, acts) {
      this.root = root;
      this.acts = acts;
      this.view = { left: -100, top: -100, width: 200, height: 200 };
      this.pixel = 1;  // mm of one pixel; to ask the browser anew at every word would lay out the page as often
      this.groups = {};
      for (const name of ["defs", "photo", "map", "grid", "pole-area", "table", "obstacles", "region", "copy", "ghost", "mechanism", "bodies", "mark", "names", "letters", "handles", "grip", "scale"]) {
        const css = { map: "areas", "pole-area": "pole-areas", ghost: "ghost", handles: "handles", mark: "binding", names: "names", letters: "letters", grip: "grip" }[name] || `m-${name}`;
        this.groups[name] = element(name === "defs" ? "defs" : "g", name === "defs" ? {} : { class: css });
        root.append(this.groups[name]);
      }
      this.nodes = new Map();
      this.listen();
      new ResizeObserver(() => this.resize()).observe(root);
    }

    resize() {
      const { clientWidth: wide, clientHeight: high } = this.root;
      if (!wide || !high) return;
      if (this.wanted) return this.lookHome();
      const { left, top, width, height } = this.view;
      this.look([left + width / 2, top + height / 2], Math.max(width / wide, height / high));
    }

    /** The middle (SVG's frame) and mm a pixel. */
    look(centre, scale) {
      const { clientWidth: wide, clientHeight: high } = this.root;
      const kept = Math.min(1e6, Math.max(1e-5, scale));
      this.pixel = kept;
      this.view = { left: centre[0] - (wide * kept) / 2, top: centre[1] - (high * kept) / 2, width: wide * kept, height: high * kept };
      const { left, top, width, height } = this.view;
      this.root.setAttribute("viewBox", `${left} ${top} ${width} ${height}`);
      kempe.drawFrame(this.root, this.view, false);
      this.root.setAttribute("font-size", 15 * kept);
      this.redraw();
    }

    /** All of the given places in view. */
    fit(points) {
      const all = points.filter((at) => at.every(Number.isFinite));
      if (all.length === 0) return;
      const xs = all.map(([x]) => x), ys = all.map(([, y]) => -y);
      const box = [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
      const width = Math.max(box[2] - box[0], 1e-3), height = Math.max(box[3] - box[1], 1e-3);
      this.wanted = { width, height, middle: [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2] };
      this.lookHome();
    }

    /** What fit() was told, whatever the window has become: with room for the buttons above and the figures below. */
    lookHome() {
      const { clientWidth: wide, clientHeight: high } = this.root, { width, height, middle } = this.wanted;
      const [side, above, below] = [Math.min(70, wide / 8), 76, 50];
      const scale = Math.max(width / Math.max(1, wide - 2 * side), height / Math.max(1, high - above - below));
      this.look([middle[0], middle[1] - ((above - below) / 2) * scale], scale);
    }

    /** The window in mm: [left, lower, right, upper]. */
    get window() {
      const { left, top, width, height } = this.view;
      return [left, -top - height, left + width, -top];
    }

    isWithin(box) {
      const [left, lower, right, upper] = this.window;
      return box[0] >= left && box[1] >= lower && box[2] <= right && box[3] <= upper;
    }

    isBeyond(box) {
      const [left, lower, right, upper] = this.window;
      return box[2] < left || box[3] < lower || box[0] > right || box[1] > upper;
    }

    /** How much of the window a box takes, of its width or its height. */
    shareOf(box) {
      return Math.max((box[2] - box[0]) / this.view.width, (box[3] - box[1]) / this.view.height);
    }

    zoom(factor, at) {
      const { left, top, width, height } = this.view, pivot = at || [left + width / 2, top + height / 2];
      this.wanted = null;
      this.look([pivot[0] + (left + width / 2 - pivot[0]) / factor, pivot[1] + (top + height / 2 - pivot[1]) / factor], this.pixel / factor);
    }

    placeOf(event) {
      const box = this.root.getBoundingClientRect();
      return [this.view.left + (event.clientX - box.left) * this.pixel, -(this.view.top + (event.clientY - box.top) * this.pixel)];
    }

    /** A place as a hand means it: on round numbers of the size of a pixel. */
    snapped([x, y], finer = 1) {
      const step = 10 ** Math.ceil(Math.log10(this.pixel * 0.9)) * finer;
      return [x, y].map((value) => Number((Math.round(value / step) * step).toFixed(9)));
    }

    // ---- what is shown

    show(scene) {
      this.scene = scene;
      this.redraw();
    }

    redraw() {
      const { scene, groups } = this;
      if (!scene) return;
      const handles = scene.shapes.flatMap((shape) => shape.handles.map((handle) => ({ ...handle, role: shape.role, shape })));
      this.labels = this.freeRoom(handles);
      const outlines = (role) => scene.shapes.filter((shape) => shape.role === role && shape.rings.length);
      const drawn = (role, css, title) => outlines(role).map((shape) => {
        const node = element("path", { class: css, d: path(shape.rings) });
        node.append(element("title", {}, title(shape)));
        return node;
      });
      groups.region.replaceChildren(...drawn("region", "outline", () => "The original: what the tracer must reach. Drag it, or its handles"));
      groups.copy.replaceChildren(...drawn("copy", "outline", () => "The copy: what the pen draws"));
      groups["pole-area"].replaceChildren(...drawn("pole-area", "pole-area", () => "The pole may stand here"));
      groups.obstacles.replaceChildren(...drawn("obstacle", "thing", ({ name }) => name));
      groups.table.replaceChildren(...drawn("table", "edge", () => "The edge of the table"));
      this.drawBodies(groups.bodies, scene);
      groups.names.replaceChildren();
      this.drawReasons();
      this.drawLinkage(groups.ghost, scene.ghost, scene.tracer);
      this.drawLinkage(groups.mechanism, scene.model, scene.tracer);
      this.drawNames(outlines, ["region", "copy"]);
      this.drawGrip(scene.model, scene.tracer);
      this.drawHandles(handles);
      this.drawNames(outlines, ["pole-area", "obstacle"]);
      this.drawLetters(scene.model, scene.tracer);
      this.hideTicks(handles);
    }

    /** The axes' numbers stay away where a handle stands on them. */
    hideTicks(handles) {
      const px = this.pixel;
      for (const tick of this.groups.grid.querySelectorAll("text.tick")) {
        const half = 3.6 * px * tick.textContent.length, x = Number(tick.getAttribute("x")) + (tick.classList.contains("start") ? half : 0), y = Number(tick.getAttribute("y"));
        const covered = handles.some(({ at }) => Math.abs(at[0] - x) < half + 9 * px && Math.abs(-at[1] - y) < 15 * px);
        tick.setAttribute("visibility", covered ? "hidden" : "visible");
      }
    }

    /** The first of some wordings that has room. */
    writeFirst(middles, wordings, asked, css) {
      for (const words of wordings) {
        const at = this.labels.put(middles, words, asked);
        if (at) return this.groups.names.append(element("text", { x: at[0], y: at[1], dy: ".35em", class: css }, words));
      }
    }

    /** What outlines are called, each where it is not taken for another's name. */
    drawNames(outlines, roles) {
      const words = { region: ["original"], copy: ["copy"], "pole-area": ["the pole may stand here", "pole's area"] }, px = this.pixel, { labels } = this;
      const named = [...Object.keys(words), "obstacle"].flatMap((role) => outlines(role).map(({ name, rings }) => ({ role, wordings: words[role] || [name], box: boxOf(rings.flat()) })));
      for (const { role, wordings, box } of named.filter(({ role: of }) => roles.includes(of))) {
        const others = named.filter((of) => of.box !== box).map((of) => of.box), asked = { fits: kempe.Labels.isOf(box, others) };
        const beside = kempe.Labels.beside(box, px), inside = kempe.Labels.inside(box, px), inner = role === "pole-area" || role === "obstacle";
        // A name outside an area that reaches beyond the window would stand anywhere.
        if (role === "pole-area" && !labels.holds(box)) {
          const seen = labels.within(box);
          this.writeFirst(kempe.Labels.inside(seen, px), wordings, asked, `name ${role}`);
          continue;
        }
        const middles = (wide, high) => (inner ? [...inside(wide, high), ...beside(wide, high)] : [...beside(wide, high), ...inside(wide, high)]);
        this.writeFirst(middles, wordings, { ...asked, must: role === "obstacle" || wordings.length > 1 }, `name ${role}`);
      }
    }

    /** Rings at what holds back or is in the way, with a word: the longest of its wordings that has room. */
    drawReasons() {
      const { scene, groups, pixel } = this, reasons = scene.reasons || [];
      groups.mark.replaceChildren(...[...(scene.binding || []), ...reasons.map(({ at }) => at)].map((at) => {
        const ring = element("circle", { class: "tight", cx: at[0], cy: -at[1], r: 11 * pixel });
        ring.append(element("title", {}, kempe.words.colours.tightest[1]));
        return ring;
      }));
      for (const { at, words } of reasons)
        this.writeFirst(kempe.Labels.round([at[0], -at[1]], 13 * pixel, pixel), [].concat(words), { weight: 650 }, "name reason");
    }

    /** The joints' letters, where nothing else needs the room. */
    drawLetters(model, tracer) {
      const { letters } = this.groups, found = model ? this.poseOf(model, tracer) : null;
      if (!found) return void letters.replaceChildren();
      const radius = Math.max(1.55 * model.pin_radius, 6 * this.pixel), nodes = [];
      found.pose.forEach(([x, y], joint) => {
        const place = this.labels.put(kempe.Labels.round([x, -y], radius, this.pixel, [1]), joints[joint], { pixels: 11, weight: 600 });
        if (place) nodes.push(element("text", { class: "letter", x: place[0], y: place[1], dy: ".35em" }, joints[joint]));
      });
      letters.replaceChildren(...nodes);
    }

    /** What no word may cover: handles, the linkage's joints, marks and buttons. */
    freeRoom(handles) {
      const { scene, view, pixel } = this, ticks = 34 * pixel;  // the numbers at the left edge
      const labels = new kempe.Labels({ left: view.left + ticks, width: view.width - ticks, top: view.top + 48 * pixel, height: view.height - 72 * pixel }, pixel);
      labels.handles = handles.map(({ at }) => [at[0], -at[1]]);
      for (const at of labels.handles) labels.keepOff(at, 9);
      for (const at of [...(scene.binding || []), ...(scene.reasons || []).map(({ at: spot }) => spot)]) labels.keepOff([at[0], -at[1]], 12);
      const corners = scene.shapes.filter(({ role }) => role !== "body").flatMap(({ rings }) => rings);
      const drawn = ([x, y]) => [x, -y];
      if (corners.flat().length <= mostEdges) labels.edges = corners.flatMap((ring) => ring.map((at, i) => [drawn(at), drawn(ring[(i + 1) % ring.length])]));
      const found = scene.model ? this.poseOf(scene.model, scene.tracer) : null;
      if (found) labels.bars = scene.model.bodies.flatMap(({ line: along }) => along.slice(1).map((joint, i) => [drawn(found.pose[along[i]]), drawn(found.pose[joint]), Math.max(scene.model.width, 3 * pixel) / 2]));
      if (found) for (const [x, y] of found.pose) labels.keepOff([x, -y], Math.max((1.55 * scene.model.pin_radius) / this.pixel, 6));
      return labels;
    }

    /** The areas of the report's picture; none without one. */
    showMap(picture) {
      const { defs, map } = this.groups;
      defs.replaceChildren();
      map.replaceChildren();
      if (!picture) return;
      const read = new DOMParser().parseFromString(`<div xmlns="http://www.w3.org/1999/xhtml">${picture}</div>`, "text/html");
      for (const pattern of read.querySelectorAll("svg defs > *")) defs.append(document.importNode(pattern, true));
      for (const name of areas)
        for (const group of read.querySelectorAll(`svg g.m-${name}`)) map.append(this.explained(document.importNode(group, true), kempe.words.colours[name][1]));
    }

    /** An area that says what it is where a mouse points: of what is lost, why. */
    explained(group, words) {
      for (const node of group.querySelectorAll("path")) node.append(element("title", {}, node.dataset.why ? `Lost: ${node.dataset.why}` : words));
      return group;
    }

    /** A picture of the bench, from above: {url, box: [left, near, right, far]}, {strength: 0..1}, or null for none. */
    showPhoto(photo) {
      const group = this.groups.photo;
      if (!photo) return void group.replaceChildren();
      if (photo.strength !== undefined) group.setAttribute("opacity", photo.strength);
      if (!photo.url) return;
      const [left, near, right, far] = photo.box;
      group.replaceChildren(element("image", { href: photo.url, x: left, y: -far, width: right - left, height: far - near, preserveAspectRatio: "none" }));
    }

    /** The tracer's place for a model: as wanted, or as near as this assembly comes. */
    poseOf(model, tracer) {
      const linkage = new kempe.Linkage(model), place = linkage.nearestReachable(tracer || model.pole);
      const found = linkage.poseWithTracerAt(place);
      return found.why ? null : { ...found, place, linkage };
    }

    /** What tracer and pen carry, where they stand. */
    drawBodies(group, { shapes, model, tracer }) {
      const found = model ? this.poseOf(model, tracer) : null;
      if (!found) return void group.replaceChildren();
      group.replaceChildren(...shapes.filter(({ role }) => role === "body").map(({ name, at, turnsWith, carried }) => {
        const mount = model.joints[at === "tracer" ? "tracer" : "pen"], [x, y] = found.pose[mount];
        const [c, s] = this.axisOf(turnsWith, mount, found.pose);
        const placed = ([dx, dy]) => [x + dx * c - dy * s, y + dx * s + dy * c];
        const shape = element("path", { class: "thing", d: path(carried.map((ring) => ring.map(placed))) });
        shape.append(element("title", {}, name));
        return shape;
      }));
    }

    /** The direction from a joint to the nearest other one of its link, of size 1; [1, 0] without a link that has the joint. */
    axisOf(link, mount, pose) {
      const held = [...(link || "")].map((letter) => joints.indexOf(letter));
      if (!held.includes(mount)) return [1, 0];
      const ways = held.filter((joint) => joint !== mount).map((joint) => [pose[joint][0] - pose[mount][0], pose[joint][1] - pose[mount][1]]);
      const [x, y] = ways.reduce((near, way) => (Math.hypot(...way) < (1 - 1e-9) * Math.hypot(...near) ? way : near));
      return [x / Math.hypot(x, y), y / Math.hypot(x, y)];
    }

    drawLinkage(group, model, tracer) {
      const found = model ? this.poseOf(model, tracer) : null;
      if (!found) return void group.replaceChildren();
      const { pose } = found, px = this.pixel, nodes = [];
      const width = Math.max(model.width, 3 * px), face = width - Math.min(2.4 * px, 0.5 * width);
      for (const body of model.bodies) {
        const d = line(body.line.map((joint) => pose[joint])) + (body.filled ? "Z" : "");
        const link = element("g", { class: `link layer-${body.layer} ${body.filled ? "filled" : "open"}` });
        link.append(element("title", {}, body.name), element("path", { class: "rim", d, "stroke-width": width }), element("path", { class: "face", d, "stroke-width": face }));
        nodes.push(link);
      }
      const radius = Math.max(model.pin_radius, 3.2 * px);
      const roles = Object.fromEntries(Object.entries(model.joints).map(([role, joint]) => [joint, role]));
      pose.forEach(([x, y], joint) => {
        const role = roles[joint], at = { cx: x, cy: -y };
        if (!role) return void nodes.push(element("circle", { class: "pin", ...at, r: radius }));
        nodes.push(element("circle", { class: `mark ${role}`, ...at, r: 1.55 * radius }), element("circle", { class: `core ${role}`, ...at, r: 0.6 * radius }));
        if (role === "pole" || group !== this.groups.mechanism) return;
        const place = this.labels.put(kempe.Labels.round([x, -y], 1.55 * radius, px), role, { weight: 650 });
        if (place) nodes.push(element("text", { class: `role joint ${role}`, x: place[0], y: place[1], dy: ".35em" }, role));
      });
      group.replaceChildren(...nodes);
    }

    /** What the hand takes hold of to move the linkage. */
    drawGrip(model, tracer) {
      const found = model ? this.poseOf(model, tracer) : null;
      if (!found) return void this.groups.grip.replaceChildren();
      const [x, y] = found.pose[model.joints.tracer];
      const grip = element("circle", { class: "hold", cx: x, cy: -y, r: Math.max(1.55 * model.pin_radius, 11 * this.pixel) });
      grip.append(element("title", {}, "The tracer: drag it to move the linkage"));
      this.groups.grip.replaceChildren(grip);
    }

    drawHandles(handles) {
      const px = this.pixel, kept = new Set(), touch = window.matchMedia("(pointer: coarse)").matches;
      const focused = handles.find(({ id }) => id === this.held);
      for (const handle of focused ? [focused, ...handles.filter((h) => h !== focused)] : handles) {
        let node = this.nodes.get(handle.id);
        if (!node) {
          node = element("g", { class: `handle ${handle.role}`, tabindex: 0, role: "slider", "data-id": handle.id });
          node.append(element("circle", { class: "reach" }), element("circle", { class: "knob" }), element("path", { class: "arrows" }), element("text", { class: "says" }));
          this.nodes.set(handle.id, node);
          this.groups.handles.append(node);
        }
        node.handle = handle;
        kept.add(handle.id);
        const [x, y] = handle.at, [reach, knob, arrows, says] = node.children;
        node.setAttribute("class", `handle ${handle.role}${handle.whole ? " whole" : ""}${handle.id === this.held ? " held" : ""}`);
        node.setAttribute("aria-label", handle.label);
        node.setAttribute("aria-valuenow", x);
        node.setAttribute("aria-valuetext", handle.role === "copy" ? handle.says : `${handle.says || `${kempe.figure(x)}, ${kempe.figure(y)}`}`);
        for (const circle of [reach, knob]) { circle.setAttribute("cx", x); circle.setAttribute("cy", -y); }
        // No handle takes what belongs to a neighbour.
        const near = Math.min(...handles.map(({ at }) => Math.hypot(at[0] - x, at[1] - y)).filter((distance) => distance > 0));
        reach.setAttribute("r", Math.max(8 * px, Math.min((touch ? 22 : 14) * px, near / 2)));
        knob.setAttribute("r", (handle.whole ? 7.5 : 6) * px);
        const a = 4.2 * px;
        arrows.setAttribute("d", handle.whole ? `M${x - a},${-y}h${2 * a}M${x},${-y - a}v${2 * a}` : "");
        // Where nothing is free, a number waits until its handle is held.
        const held = handle.id === this.held, { rings } = handle.shape, around = kempe.Labels.at([x, -y], px);
        const outside = handle.role === "copy" ? kempe.Labels.beside(boxOf(rings.flat()), px) : () => [];
        const places = (wide, high) => [...around(wide, high), ...outside(wide, high)];
        const place = handle.says ? this.labels.put(places, handle.says, { pixels: 11.7, own: [x, -y], crossing: 40 }) || (held ? places(handle.says.length * 7.4 * px)[0] : null) : null;
        says.textContent = place ? handle.says : "";
        if (!place) continue;
        says.setAttribute("x", place[0]);
        says.setAttribute("y", place[1]);
      }
      for (const [id, node] of this.nodes) if (!kept.has(id)) { node.remove(); this.nodes.delete(id); }
    }

    /** The handle as if a hand held it, until the next touch. */
    choose(id) {
      const node = this.nodes.get(id);
      if (!node) return;
      this.held = id;
      this.redraw();
      node.focus({ preventScroll: true });
    }

    /** Which colours are on the table now, by the names of kempe.words.colours. */
    colours() {
      const { scene, groups } = this, roles = { region: "region", copy: "copy", "pole-area": "pole-area", pole: "pole", obstacle: "obstacles", table: "table", body: "bodies" };
      const present = new Set(scene.shapes.map(({ role }) => roles[role]));
      if (scene.model) present.add("mechanism");
      if (scene.model) present.add("pole");
      if (scene.ghost) present.add("ghost");
      if ((scene.binding || []).length || (scene.reasons || []).length) present.add("tightest");
      for (const name of areas) if (groups.map.querySelector(`.m-${name}`)) present.add(name);
      return present;
    }

    // ---- hands

    /** The handle that moves an outline as a whole. */
    wholeOf(body) {
      const role = body.closest(".m-region") ? "region" : body.closest(".m-obstacles") ? "obstacle" : "pole-area";
      const shapes = this.scene.shapes.filter((shape) => shape.role === role && shape.rings.length);
      const shape = shapes[[...body.parentNode.querySelectorAll("path")].indexOf(body)];
      const whole = shape && shape.handles.find((handle) => handle.whole);
      return whole && this.nodes.has(whole.id) ? whole : null;
    }

    /** What a press begins to move: {handle}, {tracer}, or {} for the table itself. A finger takes no outline: it would move what it only swipes over. */
    takenBy(target, byTouch) {
      const node = target.closest(".handle");
      if (node) return { handle: node.handle };
      if (target.closest(".hold")) return { tracer: true };
      const body = byTouch ? null : target.closest(".m-region .outline, .m-obstacles .thing, .pole-areas .pole-area"), handle = body && this.wholeOf(body);
      return handle ? { handle } : {};
    }

    listen() {
      const { root } = this;
      let drag = null;
      root.addEventListener("pointerdown", (event) => {
        if (event.button > 0 || !event.isPrimary) return;
        this.held = null;
        root.classList.add("by-hand");  // no ring of the keyboard's stays where a hand has been
        const taken = this.takenBy(event.target, event.pointerType === "touch"), { handle } = taken;
        root.setPointerCapture(event.pointerId);
        const at = this.placeOf(event);
        if (handle) {
          this.nodes.get(handle.id).focus({ preventScroll: true });
          this.held = handle.id;
          drag = { handle, offset: [handle.at[0] - at[0], handle.at[1] - at[1]], moved: false };
          this.acts.begin(handle);
        } else drag = taken.tracer ? taken : { from: [event.clientX, event.clientY], pan: { ...this.view } };
        event.preventDefault();
      });
      // A browser decides here whether the finger scrolls the page: of what is taken hold of, it does not.
      root.addEventListener("touchstart", (event) => {
        const { handle, tracer } = this.takenBy(event.target, true);
        if ((handle || tracer) && event.cancelable) event.preventDefault();
      }, { passive: false });
      root.addEventListener("pointermove", (event) => {
        if (!drag || !event.isPrimary) return;
        const at = this.placeOf(event);
        if (drag.tracer) return this.acts.tracer(at);
        if (drag.handle) {
          drag.moved = true;
          const to = [at[0] + drag.offset[0], at[1] + drag.offset[1]];
          return this.acts.drag(drag.handle, drag.handle.free ? to : this.snapped(to, event.altKey ? 0.1 : 1));
        }
        const px = this.pixel, { left, top, width, height } = drag.pan;
        this.wanted = null;
        this.look([left + width / 2 - (event.clientX - drag.from[0]) * px, top + height / 2 - (event.clientY - drag.from[1]) * px], px);
      });
      const end = (event) => {
        if (!event.isPrimary) return;
        if (drag && drag.handle) this.acts.end(drag.handle, drag.moved);
        drag = null;
        this.held = null;
        if (this.scene) this.redraw();
      };
      root.addEventListener("pointerup", end);
      root.addEventListener("pointercancel", end);
      root.addEventListener("wheel", (event) => {
        event.preventDefault();
        const [x, y] = this.placeOf(event);
        this.zoom(Math.exp(-0.0015 * event.deltaY), [x, -y]);
      }, { passive: false });
      document.addEventListener("keydown", () => root.classList.remove("by-hand"));
      root.addEventListener("keydown", (event) => this.key(event));
    }

    key(event) {
      const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }, arrow = arrows[event.key];
      const node = event.target.closest(".handle");
      if (event.ctrlKey || event.metaKey) return;
      if (node && (event.key === "Delete" || event.key === "Backspace") && node.handle.shape.without) {
        event.preventDefault();
        return this.acts.remove(node.handle.shape);
      }
      if (!arrow || !node) {
        const act = { "+": () => this.zoom(1.3), "-": () => this.zoom(1 / 1.3), 0: () => this.acts.fit() }[event.key];
        if (act) { event.preventDefault(); act(); }
        return;
      }
      event.preventDefault();
      const { handle } = node, step = 10 ** Math.ceil(Math.log10(this.pixel)) * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
      this.acts.nudge(handle, [handle.at[0] + arrow[0] * step, handle.at[1] + arrow[1] * step].map((value) => Number(value.toFixed(9))));
    }
  }

  kempe.Table = Stage;
})((globalThis.kempe = globalThis.kempe || {}));
