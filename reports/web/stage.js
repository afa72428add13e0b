// The moving picture: a jsxgraph board lies over the static map and shares its frame. It draws what it is told to.
"use strict";
(function (kempe) {
  const letters = "VABCXY";

  /** One shape of the board, styled by the page's style sheet alone. */
  function styled(element, css) {
    element.rendNode.setAttribute("class", css);
    return element;
  }

  class Stage {
    constructor(model, container, map) {
      this.model = model;
      this.map = map;
      this.pose = null;
      const { left, top, width, height } = model.view;
      this.still = [left, -top, left + width, -top - height];
      this.container = container;
      JXG.Options.precision.touch = 34;
      JXG.Options.precision.mouse = 8;
      this.board = JXG.JSXGraph.initBoard(container.id, {
        boundingbox: this.home(), keepaspectratio: true, axis: false, grid: false, showNavigation: false, showCopyright: false,
        showInfobox: false, maxFrameRate: 1000, keyboard: { enabled: false }, browserPan: true, registerFullscreenEvent: false,
        pan: { enabled: true, needShift: true, needTwoFingers: true }, zoom: { wheel: true, needShift: true, min: 0.2, max: 60 },
        title: "The linkage", description: "The linkage on its map; the tracer can be dragged.",
      });
      this.trails = { tracer: this.trail("live-trail tracer"), pen: this.trail("live-trail pen") };
      this.bodies = model.bodies.map((body) => this.body(body));
      this.marks = [0, 1, 2].map(() => this.contactMark());
      this.joints = [...letters].map((letter, i) => this.joint(letter, i));
      this.labels = [...letters].map((letter, i) => this.label(letter, i));
      this.board.on("boundingbox", () => this.follow());
      new ResizeObserver(() => this.reappear()).observe(container);
    }

    /** The window at first: the still picture's, or the job alone where the screen is too narrow for that. */
    home() {
      const [x1, y1, x2, y2] = this.still, { clientWidth, clientHeight } = this.container;
      const narrow = clientWidth / clientHeight < (0.9 * (x2 - x1)) / (y1 - y2);
      return narrow ? this.around(this.model.job) : this.still;
    }

    /** A window with some room around a box. */
    around([x1, y1, x2, y2]) {
      const room = 0.07 * Math.max(x2 - x1, y1 - y2);
      return [x1 - room, y1 + room, x2 + room, y2 - room];
    }

    pixel() {
      return 1 / this.board.unitX;
    }

    polyline(points, css, width) {
      const curve = this.board.create("curve", [[0], [0]], { fixed: true, highlight: false, strokeWidth: width, lineCap: "round", fillColor: "none" });
      curve.updateDataArray = function () {
        const places = points();
        this.dataX = places.map((at) => at[0]);
        this.dataY = places.map((at) => at[1]);
      };
      return styled(curve, css);
    }

    trail(css) {
      const points = [];
      const curve = this.board.create("curve", [[0], [0]], { fixed: true, highlight: false, strokeWidth: 2, fillColor: "none" });
      curve.updateDataArray = function () {
        this.dataX = points.map((at) => at[0]);
        this.dataY = points.map((at) => at[1]);
      };
      styled(curve, css);
      return points;
    }

    /** A link as two strokes over its axis, a rim and a face: the outline of the part, as in the static picture. */
    body(body) {
      const joints = body.filled ? [...body.line, body.line[0]] : body.line;
      const points = () => (this.pose ? joints.map((joint) => this.pose[joint]) : [[0, 0]]);
      const width = () => Math.max(this.model.width * this.board.unitX, 3);
      const css = `live-link layer-${body.layer} ${body.filled ? "filled" : "open"}`;
      const rim = this.polyline(points, css + " rim", width);
      const face = this.polyline(points, css + " face", () => width() - Math.min(2.4, 0.5 * width()));
      return { name: body.name, nodes: [rim.rendNode, face.rendNode] };
    }

    contactMark() {
      const mark = { at: null };
      const places = () => (mark.at ? [mark.at.from, mark.at.to] : [[NaN, NaN]]);
      mark.line = this.polyline(places, "live-contact", () => Math.max(10, 0.6 * this.model.width * this.board.unitX));
      return mark;
    }

    joint(letter, i) {
      const { joints, pin_radius } = this.model;
      const role = Object.keys(joints).find((name) => joints[name] === i) || "";
      const movable = role === "tracer" || role === "pen";
      const radius = () => Math.max(pin_radius * this.board.unitX, 3.2) * (role ? 1.55 : 1);
      const point = this.board.create("point", [0, 0], {
        fixed: !movable, highlight: false, withLabel: false, size: radius, strokeWidth: role ? 2.4 : 1.5, face: "o", snapToGrid: false,
        showInfobox: false, tabindex: null,
      });
      styled(point, role ? `live-mark ${role}` : "live-pin");
      if (role) {
        const core = this.board.create("point", [() => point.X(), () => point.Y()], {
          fixed: true, highlight: false, withLabel: false, size: () => 0.4 * radius(), strokeWidth: 0, face: "o", showInfobox: false, tabindex: null,
        });
        styled(core, `live-core ${role}`);
      }
      return { letter, role, point };
    }

    /** A joint's letter; a named point's task too where the window has room for it. */
    label(letter, i) {
      const { role } = this.joints[i];
      const place = () => (this.pose ? this.labelPlaces()[i] : [0, 0]);
      const css = `live-label ${role}`;
      return this.board.create("text", [() => place()[0], () => place()[1], () => this.labelWords(i)], {
        display: "internal", anchorX: "middle", anchorY: "middle", fixed: true, highlight: false, fontSize: 14, parse: false, tabindex: null,
        cssClass: css, highlightCssClass: css, cssDefaultStyle: "", highlightCssDefaultStyle: "",
      });
    }

    labelWords(i) {
      const { letter, role } = this.joints[i];
      return role && this.board.canvasWidth > 520 ? `${letter} ${role}` : letter;
    }

    /** Where all letters stand in this pose and window, the longer words placed first, so that none lies on another. */
    labelPlaces() {
      const window = `${this.board.getBoundingBox()} ${this.board.canvasWidth}`, { placed } = this;
      if (placed && placed.pose === this.pose && placed.window === window && placed.words === this.words) return placed.at;
      const order = this.joints.map((_, i) => i).sort((a, b) => this.labelWords(b).length - this.labelWords(a).length || a - b);
      const at = [], taken = [];
      for (const i of order) {
        const half = [3 + 4 * this.labelWords(i).length, 9];
        at[i] = this.labelPlace(i, half, taken);
        taken.push({ at: at[i], half });
      }
      this.placed = { pose: this.pose, window, words: this.words, at };
      return at;
    }

    /** On the side that the joint's links leave free; on another where the window's edge would push the words over what they name, or where words stand. */
    labelPlace(i, half, taken) {
      const neighbours = [...new Set(this.model.bodies.flatMap(({ line }) => (line.includes(i) ? line.filter((j) => Math.abs(line.indexOf(j) - line.indexOf(i)) === 1) : [])))];
      const away = this.freeSide(i, neighbours), px = this.pixel();
      const beside = (eighth, further) => {
        const turn = (eighth * Math.PI) / 4, x = away[0] * Math.cos(turn) - away[1] * Math.sin(turn), y = away[0] * Math.sin(turn) + away[1] * Math.cos(turn);
        const support = Math.min(half[0] / Math.max(1e-9, Math.abs(x)), half[1] / Math.max(1e-9, Math.abs(y)));
        const reach = Math.max(this.model.width / 2, 1.6 * Math.max(this.model.pin_radius, 3.2 * px)) + (5 + support + further) * px;
        return [this.pose[i][0] + x * reach, this.pose[i][1] + y * reach];
      };
      const around = (further) => [0, 1, -1, 2, -2, 3, -3, 4].map((eighth) => beside(eighth, further));
      const inside = [0, 18, 36].flatMap(around).filter((at) => this.kept(at, half).every((value, axis) => value === at[axis]));
      const isApart = (at, other) => [0, 1].some((axis) => Math.abs(at[axis] - other.at[axis]) >= (half[axis] + other.half[axis]) * px);
      const mark = 1.6 * Math.max(this.model.pin_radius / px, 3.2), marks = this.pose.map((at) => ({ at, half: [mark, mark] }));
      const apart = inside.filter((at) => taken.every((other) => isApart(at, other)));
      const free = apart.filter((at) => marks.every((other) => isApart(at, other)));
      return free.find((at) => this.isClear(at, half)) || free[0] || apart[0] || inside[0] || this.kept(beside(0, 0), half);
    }

    /** A place for a box of half size `half` (px), moved into the window if it would stick out a little. */
    kept([x, y], half) {
      const [x1, y1, x2, y2] = this.board.getBoundingBox(), px = this.pixel(), [wide, high] = [half[0] * px, half[1] * px];
      const into = (value, lower, upper, slack) => (value < lower - slack || value > upper + slack ? value : Math.min(upper, Math.max(lower, value)));
      return [into(x, x1 + wide, x2 - wide, 2 * wide), into(y, y2 + high, y1 - high, 2 * high)];
    }

    /** Whether a box of half size `half` (px) covers no word of the static map. */
    isClear([x, y], half) {
      const [wide, high] = half.map((size) => size * this.pixel());
      this.words ||= this.shownWords();
      return this.words.every((box) => box.width === 0 || x + wide < box.x || x - wide > box.x + box.width || -y + high < box.y || -y - high > box.y + box.height);
    }

    /** The boxes of the map's own words, but for the frame's figures and the letters that the moving ones replace. */
    shownWords() {
      const words = [...this.map.querySelectorAll("text:not(.tick, .joint)")];
      return words.filter((node) => getComputedStyle(node).visibility === "visible").map((node) => node.getBBox());
    }

    freeSide(i, neighbours) {
      let x = 0, y = 0;
      for (const j of neighbours) {
        const dx = this.pose[j][0] - this.pose[i][0], dy = this.pose[j][1] - this.pose[i][1], length = Math.hypot(dx, dy) || 1;
        x -= dx / length;
        y -= dy / length;
      }
      const length = Math.hypot(x, y);
      if (length > 0.15) return [x / length, y / length];
      // Links leave on opposite sides: to the side of one of them.
      const j = neighbours[0], dx = this.pose[j][0] - this.pose[i][0], dy = this.pose[j][1] - this.pose[i][1], l = Math.hypot(dx, dy) || 1;
      return [-dy / l, dx / l];
    }

    /** Shows a pose and what is too near in it. */
    show(pose, tooNear) {
      this.pose = pose;
      this.joints.forEach(({ point }, i) => point.setPositionDirectly(JXG.COORDS_BY_USER, pose[i]));
      this.marks.forEach((mark, i) => (mark.at = tooNear[i] || null));
      const touching = new Set(tooNear.flatMap(({ names }) => names));
      for (const { name, nodes } of this.bodies) for (const node of nodes) node.classList.toggle("touching", touching.has(name));
      const struck = new Set(tooNear.flatMap(({ things }) => things));
      const obstacles = this.map.querySelectorAll(".m-obstacles .thing");
      obstacles.forEach((node, i) => node.classList.toggle("touching", struck.has(this.model.obstacles[i])));
      const names = this.map.querySelectorAll(".words .bodies");
      this.map.querySelectorAll(".m-bodies .thing").forEach((node, i) => {
        const { joint, toward, bearing, x, y } = node.dataset, at = pose[Number(joint)];
        const moved = `translate(${at[0] - Number(x)} ${-at[1] - Number(y)})`;
        // Upright on the screen y runs downward, and so does a bearing.
        const to = toward && pose[Number(toward)];
        const now = to && (-Math.atan2(to[1] - at[1], to[0] - at[0]) * 180) / Math.PI;
        node.setAttribute("transform", to ? `${moved} rotate(${now - Number(bearing)} ${x} ${y})` : moved);
        if (names[i]) names[i].setAttribute("transform", moved);
      });
      const named = (name) => touching.has(name);
      this.map.querySelectorAll(".m-bodies .thing").forEach((node, i) => node.classList.toggle("touching", named(this.model.carried[i])));
      this.map.querySelectorAll(".m-table .edge").forEach((node) => node.classList.toggle("touching", named("the table's edge")));
      this.board.update();
    }

    /** A board that was hidden (on paper, for one) has lost its window: here it gets back the last that it had. */
    reappear() {
      if (!this.container.clientWidth || !this.container.clientHeight || this.board.getBoundingBox().every(Number.isFinite)) return;
      this.board.setBoundingBox(this.window || this.home(), true);
      this.follow();
    }

    /** The static map keeps to the board's window; a hidden board has none, and then the map stays as it is. */
    follow() {
      const window = this.board.getBoundingBox(), [x1, y1, x2, y2] = window;
      if (!window.every(Number.isFinite)) return;
      this.window = window;
      this.map.setAttribute("viewBox", `${x1} ${-y1} ${x2 - x1} ${y1 - y2}`);
      kempe.drawFrame(this.map, { left: x1, top: -y1, width: x2 - x1, height: y1 - y2 }, this.isStill());
      this.words = null;  // their size follows the window's
    }

    /** Whether the window is the still picture's, but for the pixels that its shape is off. */
    isStill() {
      return this.board.getBoundingBox().every((value, i) => Math.abs(value - this.still[i]) < 0.01 * (this.still[2] - this.still[0]));
    }

    zoom(factor) {
      const [x1, y1, x2, y2] = this.board.getBoundingBox(), x = (x1 + x2) / 2, y = (y1 + y2) / 2;
      const wide = (x2 - x1) / 2 / factor, high = (y1 - y2) / 2 / factor;
      this.board.setBoundingBox([x - wide, y + high, x + wide, y - high], true);
      this.follow();
    }

    zoomTo(box) {
      this.board.setBoundingBox(box, true);
      this.follow();
    }
    zoomToJob() { this.zoomTo(this.home()); }
    zoomToAll() { this.zoomTo(this.around(this.model.whole)); }

    /** Where a pointer event is on the table, mm. */
    placeOf(event) {
      const [x, y] = this.board.getUsrCoordsOfMouse(event);
      return [x, y];
    }
  }

  kempe.Stage = Stage;
})((globalThis.kempe = globalThis.kempe || {}));
