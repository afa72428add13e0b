// A photo of one's own bench behind the grid, set to scale by four points of known place. It stays in this page's memory.
"use strict";
(function (kempe) {
  const one = (id) => document.getElementById(id);
  const svg = "http://www.w3.org/2000/svg";
  const finest = 2000;  // pixels of a photo's longer side that are kept
  const largest = 60 << 20;  // bytes of a photo
  const sheet = [[0, 0], [297, 0], [297, 210], [0, 210]];  // a sheet of A4 on the bench, until other places are typed

  class Photo {
    /** `show({url, box})` puts the picture behind the grid, `show(null)` takes it away. */
    constructor({ show, notice }) {
      Object.assign(this, { show, notice });
      this.fields = sheet.map((_, i) => [0, 1].map((axis) => one(`photo-${i + 1}-${axis ? "y" : "x"}`)));
      this.fields.flat().forEach((field) => field.addEventListener("input", () => this.check()));
      this.knobs = sheet.map((_, i) => this.knob(i));
      one("photo-marks").append(...this.knobs);
      one("photo-use").addEventListener("click", () => this.take());
      one("close-photo").addEventListener("click", () => one("photo").close());
      one("photo-remove").addEventListener("click", () => this.remove());
      one("photo-adjust").addEventListener("click", () => one("photo").showModal());
      one("photo-strength").addEventListener("input", () => this.fade());
    }

    knob(i) {
      const knob = document.createElementNS(svg, "g");
      for (const [key, value] of Object.entries({ class: "photo-knob", tabindex: 0, role: "slider", "aria-label": `Point ${i + 1} in the photo` })) knob.setAttribute(key, value);
      const parts = ["reach", "ring", "cross"].map((css) => Object.assign(document.createElementNS(svg, css === "cross" ? "path" : "circle"), {}));
      ["reach", "ring", "cross"].forEach((css, at) => parts[at].setAttribute("class", css));
      const number = document.createElementNS(svg, "text");
      number.textContent = i + 1;
      knob.append(...parts, number);
      let offset = null;
      knob.addEventListener("pointerdown", (event) => {
        knob.setPointerCapture(event.pointerId);
        const at = this.pixelOf(event);
        offset = [0, 1].map((axis) => this.pixels[i][axis] - at[axis]);
        event.preventDefault();
        knob.focus();
      });
      knob.addEventListener("pointermove", (event) => { if (offset) this.move(i, this.pixelOf(event).map((value, axis) => value + offset[axis])); });
      for (const end of ["pointerup", "pointercancel"]) knob.addEventListener(end, () => { offset = null; });
      knob.addEventListener("keydown", (event) => {
        const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
        if (!by) return;
        event.preventDefault();
        this.move(i, this.pixels[i].map((value, axis) => value + by[axis] * (event.shiftKey ? 10 : 1)));
      });
      return knob;
    }

    pixelOf(event) {
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(one("photo-picture").getScreenCTM().inverse());
      return [at.x, at.y];
    }

    async open(file) {
      if (file.size > largest) return this.notice(`${file.name}: ${Math.ceil(file.size / (1 << 20))} MB; allowed: up to ${largest >> 20} MB`);
      let picture;
      try {
        picture = await createImageBitmap(file);
      } catch {
        return this.notice(`${file.name}: not a picture that this browser can show`);
      }
      const less = Math.min(1, finest / Math.max(picture.width, picture.height));
      const width = Math.max(1, Math.round(picture.width * less)), height = Math.max(1, Math.round(picture.height * less));
      const canvas = Object.assign(document.createElement("canvas"), { width, height }), context = canvas.getContext("2d");
      context.drawImage(picture, 0, 0, width, height);
      picture.close();
      this.source = context.getImageData(0, 0, width, height);
      this.replace("shown", await this.urlOf(canvas));
      one("photo-image").setAttribute("href", this.shown);
      for (const [key, value] of Object.entries({ width, height })) one("photo-image").setAttribute(key, value);
      one("photo-picture").setAttribute("viewBox", `0 0 ${width} ${height}`);
      this.pixels = [[0.25, 0.75], [0.75, 0.75], [0.75, 0.25], [0.25, 0.25]].map(([x, y]) => [x * width, y * height]);
      this.fields.forEach((pair, i) => pair.forEach((field, axis) => { field.value = field.value || String(sheet[i][axis]); }));
      this.draw();
      this.check();
      if (!one("photo").open) one("photo").showModal();
    }

    urlOf(canvas) {
      return new Promise((resolve) => canvas.toBlob((blob) => resolve(URL.createObjectURL(blob)), "image/png"));
    }

    /** Another address of a picture in memory; the one before is given back. */
    replace(name, url) {
      if (this[name]) URL.revokeObjectURL(this[name]);
      this[name] = url;
    }

    move(i, [x, y]) {
      this.pixels[i] = [Math.min(this.source.width, Math.max(0, x)), Math.min(this.source.height, Math.max(0, y))];
      this.draw();
      this.check();
    }

    draw() {
      const r = this.source.width / 70;
      this.knobs.forEach((knob, i) => {
        const [x, y] = this.pixels[i], [reach, ring, cross, number] = knob.children;
        knob.setAttribute("transform", `translate(${x} ${y})`);
        reach.setAttribute("r", 3 * r);
        ring.setAttribute("r", 1.3 * r);
        cross.setAttribute("d", `M${-1.3 * r},0h${2.6 * r}M0,${-1.3 * r}v${2.6 * r}`);
        number.setAttribute("x", 1.6 * r);
        number.setAttribute("y", -1.2 * r);
        number.setAttribute("font-size", 3 * r);
        knob.setAttribute("aria-valuetext", `${Math.round(x)}, ${Math.round(y)}`);
      });
    }

    places() {
      return this.fields.map((pair) => pair.map((field) => kempe.readNumber(field.value)));
    }

    check() {
      const places = this.places(), wrong = places.flat().findIndex((value) => !(Math.abs(value) <= 1e7));
      const why = wrong >= 0 ? `Point ${Math.floor(wrong / 2) + 1}: found “${this.fields.flat()[wrong].value}”; allowed: a number in mm` : kempe.whyNotSeen(this.pixels, places);
      one("photo-says").textContent = why || "Four points are enough: all else follows.";
      one("photo-says").className = why ? "verdict bad" : "verdict";
      one("photo-use").disabled = Boolean(why);
    }

    /** The bench as seen from above, as far round the four points as they span. */
    async take() {
      const places = this.places(), xs = places.map(([x]) => x), ys = places.map(([, y]) => y), beyond = 1.5;
      const [wide, deep] = [Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys)], more = beyond * Math.max(wide, deep);
      const box = [Math.min(...xs) - more, Math.min(...ys) - more, Math.max(...xs) + more, Math.max(...ys) + more];
      const mm = Math.max(box[2] - box[0], box[3] - box[1]) / finest;
      const canvas = Object.assign(document.createElement("canvas"), { width: Math.ceil((box[2] - box[0]) / mm), height: Math.ceil((box[3] - box[1]) / mm) });
      const context = canvas.getContext("2d"), target = context.createImageData(canvas.width, canvas.height);
      kempe.fromAbove(this.source, kempe.homography(places, this.pixels), box, target);
      context.putImageData(target, 0, 0);
      this.replace("above", await this.urlOf(canvas));
      this.show({ url: this.above, box });
      this.fade();
      one("photo-part").hidden = false;
      one("photo").close();
    }

    fade() {
      this.show({ strength: Number(one("photo-strength").value) / 100 });
    }

    remove() {
      this.show(null);
      this.replace("above", null);
      this.replace("shown", null);
      this.source = null;
      one("photo-part").hidden = true;
    }
  }

  kempe.Photo = Photo;
})((globalThis.kempe = globalThis.kempe || {}));
