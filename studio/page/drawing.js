// A drawing made the original: the engine reads it, and its outline is written into the spec, where it can be moved and sent on.
"use strict";
(function (kempe) {
  const one = (id) => document.getElementById(id);
  const largest = 20 << 20;  // bytes of a drawing
  const mostCorners = 4000;  // of an outline that a text can hold and a hand can move

  /** A drawing's text: UTF-8, or what older programs write. */
  function textOf(bytes) {
    const mark = bytes[0] === 0xff && bytes[1] === 0xfe ? "utf-16le" : bytes[0] === 0xfe && bytes[1] === 0xff ? "utf-16be" : null;
    try {
      return new TextDecoder(mark || "utf-8", { fatal: !mark }).decode(bytes);
    } catch {
      return new TextDecoder("windows-1252").decode(bytes);
    }
  }

  const kindOf = (name) => (/\.(svg|dxf)$/i.exec(name) || [])[1];

  /** A spec of nothing but the drawing, as the choices want it read. */
  const reading = ({ kind, cover, margin, units }) => `[copy]\nscale = 2\n\n[region]\nfile = "drawing.${kind}"\ncover = "${cover}"\nmargin_mm = ${margin}\n${units ? `units = "${units}"\n` : ""}`;

  /** Polygons with their corners on a grid of which nobody measures a step, moved. */
  function placed(polygons, by, decimals) {
    const at = ([x, y]) => [x + by[0], y + by[1]].map((value) => (decimals === null ? value : Number(value.toFixed(decimals))));
    const ring = (corners) => corners.map(at).filter(([x, y], i, all) => i === 0 || x !== all[i - 1][0] || y !== all[i - 1][1]);
    return polygons.map((rings) => rings.map(ring));
  }

  /** The spec with these polygons as what the tracer must cover. */
  function withRegion(text, polygons) {
    let doc = new kempe.Doc(text);
    for (const key of ["polygon_mm", "holes_mm", "rectangle_mm", "circle_mm", "file", "cover", "units", "margin_mm"]) doc = new kempe.Doc(doc.without(`region.${key}`));
    const outlines = polygons.map(([outline]) => outline), holes = polygons.flatMap(([, ...rest]) => rest);
    doc = new kempe.Doc(doc.with("region.polygon_mm", outlines.length === 1 ? outlines[0] : outlines));
    return holes.length ? doc.with("region.holes_mm", holes) : doc.text;
  }

  class Drawing {
    /** `use(text)`: the spec with the drawing as its region; `current()`: the spec and the middle of the region that it has. */
    constructor({ use, current, notice }) {
      Object.assign(this, { use, current, notice });
      this.count = 0;
      for (const id of ["drawing-cover", "drawing-margin", "drawing-units", "drawing-stays"]) one(id).addEventListener("change", () => this.read());
      one("drawing-use").addEventListener("click", () => this.take());
      one("close-drawing").addEventListener("click", () => one("drawing").close());
      one("drawing").addEventListener("close", () => this.end());
    }

    async open(file) {
      const kind = kindOf(file.name);
      if (!kind) return this.notice(`${file.name}: not a drawing that can be read; allowed: .svg or .dxf`);
      if (file.size > largest) return this.notice(`${file.name}: ${Math.ceil(file.size / (1 << 20))} MB; allowed: up to ${largest >> 20} MB`);
      this.file = { name: file.name, kind: kind.toLowerCase(), text: textOf(new Uint8Array(await file.arrayBuffer())) };
      one("drawing-title").textContent = file.name;
      one("drawing-units-row").hidden = this.file.kind !== "dxf";
      one("drawing-cover").value = "outline";
      one("drawing-margin").value = "0";
      one("drawing-units").value = "";
      if (!one("drawing").open) one("drawing").showModal();
      await this.read();
      if (this.file && !this.polygons && one("drawing-cover").value === "outline") {  // no closed outline: what lies round all strokes
        one("drawing-cover").value = "hull";
        await this.read();
      }
    }

    /** The worker ends with the dialog: whatever a drawing does to it, the page goes on. */
    end() {
      if (this.engine) this.engine.end();
      this.engine = this.file = this.polygons = null;
    }

    say(words, bad = false) {
      one("drawing-says").textContent = words;
      one("drawing-says").className = bad ? "verdict bad" : "verdict";
    }

    async read() {
      const { file } = this, count = ++this.count;
      if (!file) return;
      const margin = kempe.readNumber(one("drawing-margin").value || "0");
      this.polygons = null;
      one("drawing-use").disabled = true;
      one("drawing-picture").replaceChildren();
      if (!(margin >= 0 && margin <= 10000)) return this.say(`The margin: found ${one("drawing-margin").value}; allowed: a number from 0 to 10000`, true);
      this.say("Reading …");
      if (this.engine && this.engine.busy) this.engine.stop();
      this.engine = this.engine || new kempe.Engine();
      const text = reading({ kind: file.kind, cover: one("drawing-cover").value, margin, units: one("drawing-units").value });
      const answer = await this.engine.ask("region", { text, files: [{ name: `drawing.${file.kind}`, text: file.text }] });
      if (answer.stopped || count !== this.count || this.file !== file) return;
      if (!answer.polygons) return this.say(answer.faults ? answer.faults.map((fault) => this.words(fault)).join(" ") : answer.error, true);
      const corners = answer.polygons.flat(2).length;
      if (corners > mostCorners) return this.say(`The outline has ${corners} corners; allowed: up to ${mostCorners}. The convex hull has fewer.`, true);
      this.polygons = answer.polygons;
      this.show(corners);
    }

    words({ file, line, key, found, allowed }) {
      const where = file || /^region\.(file|units|cover|margin_mm)$/.test(key) ? this.file.name + (file && line ? `, line ${line}` : "") : key;
      return `${where}: found ${found}${allowed ? `; allowed: ${allowed.replace(/drawing\.(svg|dxf)/g, this.file.name)}` : ""}.`;
    }

    show(corners) {
      const all = this.polygons.flat(2), xs = all.map(([x]) => x), ys = all.map(([, y]) => y);
      const box = [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)], size = [box[2] - box[0], box[3] - box[1]], pad = 0.04 * Math.max(...size);
      one("drawing-picture").setAttribute("viewBox", `${box[0] - pad} ${-box[3] - pad} ${size[0] + 2 * pad} ${size[1] + 2 * pad}`);
      const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
      path.setAttribute("class", "outline");
      path.setAttribute("d", this.polygons.flat().map((ring) => `M${ring.map(([x, y]) => `${x},${-y}`).join("L")}Z`).join(""));
      one("drawing-picture").append(path);
      this.box = box;
      this.say(`${kempe.figure(size[0], 1)} × ${kempe.figure(size[1], 1)} mm, ${corners} corners`);
      one("drawing-use").disabled = false;
    }

    async take() {
      const { text, middle } = this.current(), [left, near, right, far] = this.box;
      const by = one("drawing-stays").checked || !middle ? [0, 0] : [middle[0] - (left + right) / 2, middle[1] - (near + far) / 2];
      const fine = Math.max(right - left, far - near) < 10 ? 7 : 4;
      let fault = null;
      for (const decimals of [fine, null]) {  // as it was read, where the grid would let edges meet
        const changed = withRegion(text, placed(this.polygons, by, decimals));
        const answer = await this.engine.ask("validate", { text: changed });
        if (answer.kind === "task") {
          one("drawing").close();
          return this.use(changed);
        }
        const about = (answer.faults || []).filter(({ key }) => /^region/.test(key));
        fault = fault || about[0];
        if (answer.faults && !about.length) {  // the faults are elsewhere: they stand at their lines
          one("drawing").close();
          return this.use(changed);
        }
      }
      this.say(fault ? this.words(fault) : "The outline cannot be used.", true);
    }
  }

  Object.assign(kempe, { Drawing, drawingKind: kindOf, drawingText: textOf });
})((globalThis.kempe = globalThis.kempe || {}));
