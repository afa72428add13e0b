// A field for every key of a spec, made from the table of keys: a new key appears by itself.
"use strict";
(function (kempe) {
  const titles = { "": "Title", copy: "Copy", pole: "Pole", region: "Original", obstacles: "Obstacles", links: "Links", limits: "Limits", tolerance: "Tolerances", tool: "Follower and cutter", objective: "Aim of the search", material: "Material", load: "Load", cutting: "Cutting the parts" };
  const open = new Set(["copy", "limits", "links"]);
  const { nameOf, meaningOf, unitOf, choices } = kempe.words;
  const figure = (value) => kempe.figure(value, 6);
  const wordOf = (choice) => choices[choice] || choice;

  /** Lists in a field. Between two numbers of a list stands a semicolon or a blank, so that a comma may be decimal. */
  const lists = {
    numbers: { show: (list) => list.map(figure).join("; "), hint: "20; 40; 60", read: (text) => text.split(/[;\s]+/).filter(Boolean).map((one) => kempe.readNumber(one.replace(/,$/, ""))) },
    pairs: { show: (list) => list.map((pair) => pair.map(figure).join(" × ")).join("; "), hint: "12 × 4; 15 × 5", read: (text) => text.split(";").filter((part) => part.trim()).map((part) => part.split(/[×x*]/i).map(kempe.readNumber)) },
  };
  const isList = (kind, value) => Array.isArray(value) && value.length > 0 && value.every((of) => (kind === "pairs" ? Array.isArray(of) && of.length === 2 && of.every(Number.isFinite) : Number.isFinite(of)));

  class Panel {
    /** `change(text)`: the spec as a field leaves it; `remove(shape)`: without something on the table. */
    constructor(root, keys, { change, remove }) {
      Object.assign(this, { root, change, remove });
      this.fields = [];
      const { make } = kempe;
      this.measured = { kinds: "", fields: [], heads: [], list: make("div", { className: "field-list" }) };
      root.append(make("details", { open: true }, make("summary", { textContent: "On the table" }), this.measured.list));
      for (const table of [...new Set(keys.map(({ table }) => table))]) {
        const part = make("details", { open: open.has(table) }, make("summary", { textContent: titles[table] || table })), list = make("div", { className: "field-list" });
        for (const key of keys.filter((of) => of.table === table)) list.append(this.field(key));
        part.append(list);
        root.append(part);
      }
    }

    /** Names that a field suggests; any other may be typed. */
    suggest(path, names) {
      const { make } = kempe, { input } = this.fields.find((of) => of.path === path), list = make("datalist", { id: `${input.id}-names` }, ...names.map((value) => make("option", { value })));
      input.after(list);
      input.setAttribute("list", list.id);
    }

    /** A box for each word of which a spec may name several; a spec that names none leaves what holds then ticked. */
    choices(path, key) {
      const { make } = kempe, boxes = key.enum.map((word) => make("input", { type: "checkbox", value: word }));
      for (const box of boxes)
        box.addEventListener("change", () => {
          const chosen = boxes.filter(({ checked }) => checked).map(({ value }) => value), usual = key.default || [];
          this.change(chosen.length === usual.length && usual.every((word) => chosen.includes(word)) ? this.doc.cleared(path) : this.doc.with(path, chosen));
        });
      this.fields.push({ path, key, boxes });
      const label = make("span", { className: "label", title: meaningOf(path, key.description), id: `field-${path}` }, nameOf(path));
      const group = make("span", { className: "entry choices" }, ...boxes.map((box) => make("label", {}, box, box.value)));
      group.setAttribute("role", "group");
      group.setAttribute("aria-labelledby", label.id);
      return make("div", { className: "field" }, label, group);
    }

    field(key) {
      const { make } = kempe, path = key.table ? `${key.table}.${key.name}` : key.name, id = `field-${path}`;
      if (key.type === "words") return this.choices(path, key);
      const input = key.enum ? make("select", { id }) : make("input", { id, type: key.type === "boolean" ? "checkbox" : "text" });
      if (key.enum) input.append(make("option", { value: "", textContent: key.default ? wordOf(key.default) : "–" }), ...key.enum.filter((of) => of !== key.default).map((of) => make("option", { value: of, textContent: wordOf(of) })));
      else if (key.type !== "boolean") {
        input.inputMode = key.type === "string" ? "text" : "decimal";
        input.autocomplete = "off";
        input.placeholder = key.default ?? (lists[key.type] ? lists[key.type].hint : "–");
        if (lists[key.type]) Object.assign(input, { inputMode: "text", className: "list" });
      }
      input.addEventListener("change", () => this.typed(path, key, input));
      this.fields.push({ path, key, input });
      const label = make("label", { htmlFor: id, title: meaningOf(path, key.description) }, nameOf(path));
      return make("div", { className: "field" }, label, make("span", { className: "entry" }, input, make("span", { className: "unit", textContent: unitOf(key.name) })));
    }

    /** Sizes, places and names of what stands on the table, to be typed; `shapes` as shapesOf() gives them. */
    showMeasures(shapes) {
      const { measured } = this, shown = shapes.filter(({ measures, without }) => measures || without);
      const all = shown.flatMap(({ name, measures }) => (measures || []).map((measure) => ({ measure, name })));
      const kinds = JSON.stringify(shown.map(({ role, measures }) => [role, measures ? measures.map((of) => of.name) : []]));
      if (kinds !== measured.kinds) {
        Object.assign(measured, { kinds, fields: [], heads: [] });
        measured.list.replaceChildren(...shown.flatMap((shape) => [this.shapeHead(shape), ...(shape.measures || []).map((of) => this.measureField(of))]));
      }
      all.forEach(({ measure, name }, i) => {
        const field = measured.fields[i];
        field.measure = measure;
        field.input.setAttribute("aria-label", `${measure.name} of ${name}`);
        if (document.activeElement !== field.input) field.input.value = figure(measure.value);
      });
      shown.filter(({ without }) => without).forEach((shape, i) => this.showHead(measured.heads[i], shape));
    }

    /** What a thing is called above its measures; an obstacle's name can be typed, and it can be removed. */
    shapeHead({ role, without }) {
      const { make } = kempe;
      if (!without) return make("p", { className: "of-shape", textContent: { region: "Original", pole: "Pole", "pole-area": "Area of the pole", table: "Table" }[role] });
      const input = make("input", { type: "text", className: "name-of", autocomplete: "off", maxLength: 60 }), button = make("button", { type: "button", textContent: "Remove" });
      const head = { input, button };
      input.addEventListener("change", () => {
        const name = input.value.replace(/[\u0000-\u001f\u007f]/g, " ").trim();
        if (name) this.change(head.shape.rename(name));
        else input.value = head.shape.name;
      });
      button.addEventListener("click", () => this.remove(head.shape));
      this.measured.heads.push(head);
      return make("div", { className: "of-shape field" }, input, button);
    }

    showHead(head, shape) {
      head.shape = shape;
      head.input.setAttribute("aria-label", `Name of ${shape.name}`);
      head.button.setAttribute("aria-label", `Remove ${shape.name}`);
      if (document.activeElement !== head.input) head.input.value = shape.name;
    }

    measureField({ name }) {
      const { make } = kempe, id = `measure-${this.measured.fields.length}`, input = make("input", { id, type: "text", inputMode: "decimal", autocomplete: "off" });
      const field = { input };
      this.measured.fields.push(field);
      input.addEventListener("change", () => {
        const value = kempe.readNumber(input.value), good = value > field.measure.least;
        input.setCustomValidity(good ? "" : field.measure.least === 0 ? "a number above 0, please" : "a number, please");
        if (!good) return void input.reportValidity();
        this.change(field.measure.text(value));
      });
      return make("div", { className: "field" }, make("label", { htmlFor: id }, name), make("span", { className: "entry" }, input, make("span", { className: "unit", textContent: "mm" })));
    }

    typed(path, key, input) {
      const value = key.type === "boolean" ? input.checked : input.value.trim();
      if (value === "") return this.change(this.doc.cleared(path));
      if (key.type === "boolean" || key.type === "string" || key.enum) return this.change(this.doc.with(path, value));
      if (key.ratio) return this.typedRatio(path, input, value);
      if (lists[key.type]) {
        const list = lists[key.type].read(value), good = isList(key.type, list);
        input.setCustomValidity(good ? "" : `a list, please: ${lists[key.type].hint}`);
        return good ? this.change(this.doc.with(path, list)) : void input.reportValidity();
      }
      const number = kempe.readNumber(value);
      input.setCustomValidity(Number.isNaN(number) ? "a number, please" : "");
      if (Number.isNaN(number)) return void input.reportValidity();
      this.change(this.doc.with(path, key.type === "integer" ? Math.round(number) : number));
    }

    /** A ratio: a number, so many per cent, or one number to another, which stays as it was typed. */
    typedRatio(path, input, value) {
      const parts = value.replaceAll(",", "."), isPair = /[:/]/.test(parts);
      const ratio = isPair ? kempe.ratio(parts) : kempe.readNumber(value.replace(/%$/, "")) / (value.endsWith("%") ? 100 : 1), good = ratio > 0 && ratio < Infinity;
      input.setCustomValidity(good ? "" : "a number such as 0.4, 40 % or 2:5, please");
      if (!good) return void input.reportValidity();
      this.change(this.doc.with(path, isPair ? parts : ratio));
    }

    show(doc) {
      this.doc = doc;
      for (const { path, key, input, boxes } of this.fields) {
        if (boxes) {
          const chosen = doc.get(path) || key.default || [];
          for (const box of boxes) box.checked = Array.isArray(chosen) && chosen.includes(box.value);
          continue;
        }
        if (document.activeElement === input && key.type !== "boolean") continue;
        const given = doc.get(path), found = lists[key.type] && isList(key.type, given) ? lists[key.type].show(given) : given;
        const byParts = (typeof found === "object" && found !== null) || [...doc.values.keys()].some((of) => of.startsWith(`${path}.`));
        const value = byParts ? undefined : found;
        input.disabled = byParts;  // a table, such as the hardware joint by joint: it is changed in the text
        input.title = byParts ? "Given part by part: change it in the spec's text" : "";
        if (path === "links.pin_diameter_mm") input.placeholder = [...doc.values.keys()].some((of) => of.startsWith("links.hardware")) ? "the bolts'" : key.default;
        if (key.type === "boolean") input.checked = value ?? key.default ?? false;
        else input.value = value === undefined ? "" : typeof value === "number" ? figure(value) : String(value);
      }
    }
  }

  /** A first click or tap in a field of numbers selects all of it, so that what is typed stands in its place; a second one puts the caret. */
  function selectWhole(root) {
    let entered = null;
    const numbers = 'input[inputmode="decimal"], input.list';
    root.addEventListener("pointerdown", ({ target }) => { entered = target.matches(numbers) && target !== document.activeElement ? target : null; });
    root.addEventListener("click", ({ target, pointerType }) => {
      if (!target.matches(numbers)) return;
      const { selectionStart: from, selectionEnd: to, value } = target;
      if (target === entered && from === to) target.select();
      else if (target !== entered && pointerType === "touch" && from === 0 && to === value.length) target.setSelectionRange(to, to);  // a finger's second tap would keep all selected
      entered = null;
    });
  }

  Object.assign(kempe, { Panel, selectWhole });
})((globalThis.kempe = globalThis.kempe || {}));
