// The spec's text as values that know where they stand, so that a change of one leaves all else, notes included, as it is.
// It reads what specs need of TOML; the engine alone judges whether a text is a spec.
"use strict";
(function (kempe) {
  class Reader {
    constructor(text) {
      this.text = text;
      this.i = 0;
      this.values = new Map();  // "obstacles.0.circle_mm" -> {value, start, end}
      this.tables = new Map();  // "obstacles.0" -> {start, end}: from its header to the end of its last line with a key
      this.counts = new Map();  // "obstacles" -> how many
    }

    fail(what) {
      throw new SyntaxError(`${what} in line ${this.text.slice(0, this.i).split("\n").length}`);
    }

    blanks(lines) {
      for (;;) {
        const c = this.text[this.i];
        if (c === "#") while (this.i < this.text.length && this.text[this.i] !== "\n") ++this.i;
        else if (c === " " || c === "\t" || (lines && (c === "\n" || c === "\r"))) ++this.i;
        else return;
      }
    }

    word() {
      const found = /^(?:[A-Za-z0-9_-]+|"[^"\n]*"|'[^'\n]*')/.exec(this.text.slice(this.i, this.i + 200));
      if (!found) this.fail("no key");
      this.i += found[0].length;
      return found[0].replace(/^["']|["']$/g, "");
    }

    key() {
      const words = [this.word()];
      for (this.blanks(false); this.text[this.i] === "."; this.blanks(false)) {
        ++this.i;
        this.blanks(false);
        words.push(this.word());
      }
      return words;
    }

    expect(sign) {
      if (this.text[this.i] !== sign) this.fail(`no ${sign}`);
      ++this.i;
    }

    value(depth = 0) {
      if (depth > 64) this.fail("values nested too deep");
      const c = this.text[this.i];
      if (c === "[") return this.array(depth);
      if (c === "{") return this.inline(depth);
      if (c === '"' || c === "'") return this.string(c);
      const found = /^[^\s,\]}#]+/.exec(this.text.slice(this.i, this.i + 400));
      if (!found) this.fail("no value");
      this.i += found[0].length;
      if (found[0] === "true" || found[0] === "false") return found[0] === "true";
      const number = Number(found[0].replace(/_/g, "").replace(/^\+/, ""));
      if (Number.isNaN(number)) this.fail(`${found[0]} is no value`);
      return number;
    }

    string(mark) {
      const triple = this.text.startsWith(mark.repeat(3), this.i), end = triple ? mark.repeat(3) : mark;
      let j = this.i + end.length;
      while (j < this.text.length && !this.text.startsWith(end, j)) {
        if (!triple && this.text[j] === "\n") this.fail("a string without end");
        j += mark === '"' && this.text[j] === "\\" ? 2 : 1;
      }
      if (j >= this.text.length) this.fail("a string without end");
      const raw = this.text.slice(this.i + end.length, j);
      this.i = j + end.length;
      return mark === '"' ? raw.replace(/\\(["\\ntr])/g, (_, c) => ({ n: "\n", t: "\t", r: "\r" })[c] || c) : raw;
    }

    array(depth) {
      const all = [];
      this.expect("[");
      for (this.blanks(true); this.text[this.i] !== "]"; this.blanks(true)) {
        all.push(this.value(depth + 1));
        this.blanks(true);
        if (this.text[this.i] === ",") ++this.i;
        else if (this.text[this.i] !== "]") this.fail("no comma");
      }
      ++this.i;
      return all;
    }

    inline(depth) {
      const all = {};
      this.expect("{");
      for (this.blanks(true); this.text[this.i] !== "}"; this.blanks(true)) {
        const words = this.key();
        this.blanks(false);
        this.expect("=");
        this.blanks(false);
        all[words.join(".")] = this.value(depth + 1);
        this.blanks(true);
        if (this.text[this.i] === ",") ++this.i;
        else if (this.text[this.i] !== "}") this.fail("no comma");
      }
      ++this.i;
      return all;
    }

    header() {
      const start = this.i, many = this.text.startsWith("[[", this.i);
      this.i += many ? 2 : 1;
      this.blanks(false);
      let name = this.key().join(".");
      this.blanks(false);
      this.expect("]");
      if (many) this.expect("]");
      if (many) {
        const count = this.counts.get(name) || 0;
        this.counts.set(name, count + 1);
        name = `${name}.${count}`;
      }
      this.tables.set(name, { start, end: this.lineEnd(this.i) });
      return name;
    }

    lineEnd(at) {
      const end = this.text.indexOf("\n", at);
      return end < 0 ? this.text.length : end;
    }

    read() {
      let table = "";
      this.tables.set("", { start: 0, end: 0 });
      for (this.blanks(true); this.i < this.text.length; this.blanks(true)) {
        if (this.text[this.i] === "[") {
          table = this.header();
          continue;
        }
        const words = this.key();
        this.blanks(false);
        this.expect("=");
        this.blanks(false);
        const start = this.i, value = this.value();
        const path = (table ? `${table}.` : "") + words.join(".");
        this.values.set(path, { value, start, end: this.i });
        const of = this.tables.get(table);
        of.end = this.lineEnd(this.i);
      }
      return this;
    }
  }

  const rounded = (x) => Number(x.toPrecision(12));

  /** A scale as a spec writes it, 0.5, "1:2" or "1/2", as a number; NaN if it is none. */
  kempe.ratio = function (value) {
    const parts = /^\s*([\d.]+)\s*[:/]\s*([\d.]+)\s*$/.exec(value);
    return parts ? Number(parts[1]) / Number(parts[2]) : Number(value);
  };

  /** A value as a spec writes it. */
  function written(value) {
    if (Array.isArray(value)) return `[${value.map(written).join(", ")}]`;
    if (typeof value === "object") return `{${Object.entries(value).map(([key, of]) => `${key} = ${written(of)}`).join(", ")}}`;
    if (typeof value === "string") return JSON.stringify(value);
    if (typeof value === "boolean") return String(value);
    return String(Object.is(value, -0) ? 0 : rounded(value));
  }

  /** A text, read. Changes give a new text; they never change this one. */
  class Doc {
    /** Throws a SyntaxError for what cannot be read. */
    constructor(text) {
      this.text = text;
      const read = new Reader(text).read();
      Object.assign(this, { values: read.values, tables: read.tables, counts: read.counts });
    }

    get(path) {
      const found = this.values.get(path);
      return found === undefined ? undefined : found.value;
    }

    has(path) {
      return this.values.has(path);
    }

    /** How many tables [[name]] there are. */
    count(name) {
      return this.counts.get(name) || 0;
    }

    with(path, value) {
      const { text } = this, found = this.values.get(path);
      if (found) return text.slice(0, found.start) + written(value) + text.slice(found.end);
      const dot = path.lastIndexOf("."), table = path.slice(0, Math.max(dot, 0)), line = `${path.slice(dot + 1)} = ${written(value)}`;
      const of = this.tables.get(table);
      if (table === "" && of.end === 0) return this.withAbove(line);
      if (!of) return `${text.replace(/\s*$/, "")}\n\n[${table}]\n${line}\n`;
      return `${text.slice(0, of.end)}\n${line}${text.slice(of.end)}`;
    }

    /** With a first line at the top, below what the text says at its head. */
    withAbove(line) {
      const { text } = this, starts = [...this.tables].filter(([name]) => name !== "").map(([, { start }]) => start);
      const at = Math.min(text.length, ...starts);
      return `${text.slice(0, at)}${line}\n\n${text.slice(at)}`;
    }

    /** Without a key: its whole line, or lines. */
    without(path) {
      const found = this.values.get(path);
      if (!found) return this.text;
      const start = this.text.lastIndexOf("\n", found.start - 1) + 1, end = this.text.indexOf("\n", found.end);
      return this.text.slice(0, start) + (end < 0 ? "" : this.text.slice(end + 1));
    }

    /** Without a key, and without its table where nothing else stands in that. */
    cleared(path) {
      const left = new Doc(this.without(path)), table = path.slice(0, Math.max(path.lastIndexOf("."), 0)), inside = `${table}.`;
      const holds = [...left.values.keys(), ...left.tables.keys()].some((of) => of.startsWith(inside));
      return table && left.tables.has(table) && !holds ? left.withoutTable(table) : left.text;
    }

    /** Without a table [[name]]. */
    withoutTable(name) {
      const of = this.tables.get(name);
      return of ? (this.text.slice(0, of.start) + this.text.slice(of.end).replace(/^\n+/, "\n")).replace(/\n{3,}/g, "\n\n") : this.text;
    }

    withTable(name, fields) {
      const lines = Object.entries(fields).map(([key, value]) => `${key} = ${written(value)}`).join("\n");
      return `${this.text.replace(/\s*$/, "")}\n\n[[${name}]]\n${lines}\n`;
    }
  }

  Object.assign(kempe, { Doc, written });
})((globalThis.kempe = globalThis.kempe || {}));
