// A field for every key of a spec, made from the table of keys: a new key appears by itself.
"use strict";
(function (kempe) {
  const titles = { "": "Title", copy: "Copy", pole: "Pole", region: "Original", obstacles: "Obstacles", links: "Links", limits: "Limits", tolerance: "Tolerance", tool: "Tool", objective: "Objective", cutting: "Cutting" };
  const open = new Set(["", "copy", "limits", "links"]);
  const words = (name) => name.replace(/_(mm|deg)$/, "").replaceAll("_", " ");
  const unit = (name) => (name.endsWith("_mm") ? "mm" : name.endsWith("_deg") ? "°" : "");

  class Panel {
    constructor(root, keys, change) {
      this.root = root;
      this.change = change;
      this.fields = [];
      const { make } = kempe;
      this.obstacles = make("div", { className: "obstacle-list" });
      for (const table of [...new Set(keys.map(({ table }) => table))]) {
        const part = make("details", { open: open.has(table) }, make("summary", { textContent: titles[table] || table })), list = make("div", { className: "field-list" });
        for (const key of keys.filter((of) => of.table === table)) list.append(this.field(key));
        part.append(list);
        root.append(part);
      }
    }

    field(key) {
      const { make } = kempe, path = key.table ? `${key.table}.${key.name}` : key.name, id = `field-${path}`;
      const input = key.enum ? make("select", { id }) : make("input", { id, type: key.type === "boolean" ? "checkbox" : "text" });
      if (key.enum) input.append(make("option", { value: "", textContent: key.default ?? "–" }), ...key.enum.filter((of) => of !== key.default).map((of) => make("option", { value: of, textContent: of })));
      else if (key.type !== "boolean") {
        input.inputMode = key.type === "string" ? "text" : "decimal";
        input.autocomplete = "off";
        input.placeholder = key.default ?? "–";
      }
      input.addEventListener("change", () => this.typed(path, key, input));
      this.fields.push({ path, key, input });
      const label = make("label", { htmlFor: id, title: key.description }, words(key.name));
      return make("div", { className: "field" }, label, make("span", { className: "entry" }, input, make("span", { className: "unit", textContent: unit(key.name) })));
    }

    typed(path, key, input) {
      const value = key.type === "boolean" ? input.checked : input.value.trim();
      if (value === "") return this.change(this.doc.without(path));
      if (key.type === "boolean" || key.type === "string" || key.enum) return this.change(this.doc.with(path, value));
      if (key.ratio && /[:/]/.test(value) && kempe.ratio(value) > 0) return this.change(this.doc.with(path, value));
      const number = kempe.readNumber(value);
      input.setCustomValidity(Number.isNaN(number) ? "a number, please" : "");
      if (Number.isNaN(number)) return void input.reportValidity();
      this.change(this.doc.with(path, key.type === "integer" ? Math.round(number) : number));
    }

    show(doc) {
      this.doc = doc;
      for (const { path, key, input } of this.fields) {
        if (document.activeElement === input && key.type !== "boolean") continue;
        const found = doc.get(path), byParts = (typeof found === "object" && found !== null) || [...doc.values.keys()].some((of) => of.startsWith(`${path}.`));
        const value = byParts ? undefined : found;
        input.disabled = byParts;  // a table, such as the hardware joint by joint: it is changed in the text
        input.title = byParts ? "Given part by part: change it in the spec's text" : "";
        if (key.type === "boolean") input.checked = value ?? key.default ?? false;
        else input.value = value === undefined ? "" : typeof value === "number" ? kempe.figure(value, 6) : String(value);
      }
    }
  }

  kempe.Panel = Panel;
})((globalThis.kempe = globalThis.kempe || {}));
