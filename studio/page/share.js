// What leaves the page by the hand of its user: the address that holds a spec, and a zip of files.
"use strict";
(function (kempe) {
  const longest = 60000, largest = 1 << 20;  // characters of an address that programs pass on; bytes of a spec in it

  async function through(stream, bytes, most) {
    const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader(), chunks = [];
    let size = 0;
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      size += value.length;
      if (size > most) {
        await reader.cancel();
        throw new Error("more than a spec can be");
      }
      chunks.push(value);
    }
    return new Uint8Array(await new Blob(chunks).arrayBuffer());
  }

  /** "#k1:" and the spec, deflated and in base64url; null if that is too long for an address. */
  async function fragmentOf(text) {
    const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(text), Infinity);
    let binary = "";
    for (const byte of bytes) binary += String.fromCharCode(byte);
    const fragment = "#k1:" + btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
    return fragment.length > longest ? null : fragment;
  }

  /** The spec of an address; null if it holds none. Throws what is to be said of one that cannot be read. */
  async function textOf(fragment) {
    if (!fragment || fragment === "#") return null;
    const found = /^#k(\d+):([A-Za-z0-9_-]*)$/.exec(fragment);
    if (!found) throw new Error("This address holds no spec that the studio can read.");
    if (found[1] !== "1") throw new Error(`This address was made by another version of the studio (k${found[1]}; this page reads k1).`);
    try {
      const binary = atob(found[2].replace(/-/g, "+").replace(/_/g, "/"));
      const bytes = await through(new DecompressionStream("deflate-raw"), Uint8Array.from(binary, (c) => c.charCodeAt(0)), largest);
      return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    } catch {
      throw new Error("This address is damaged: the spec in it cannot be read.");
    }
  }

  const table = Uint32Array.from({ length: 256 }, (_, n) => {
    for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
    return n;
  });
  function crc32(bytes) {
    let crc = ~0;
    for (const byte of bytes) crc = table[(crc ^ byte) & 255] ^ (crc >>> 8);
    return ~crc >>> 0;
  }

  /** A zip archive of [{name, bytes}], stored as they are (APPNOTE 6.3, sections 4.3.7, 4.3.12 and 4.3.16). */
  function zip(files) {
    const parts = [], directory = [];
    let offset = 0;
    const record = (size, fields) => {
      const view = new DataView(new ArrayBuffer(size));
      for (const [at, width, value] of fields) width === 2 ? view.setUint16(at, value, true) : view.setUint32(at, value, true);
      return new Uint8Array(view.buffer);
    };
    for (const { name, bytes } of files) {
      const title = new TextEncoder().encode(name), crc = crc32(bytes), day = 0x21;  // 1 January 1980: the same files, the same bytes
      const head = [[0, 2, 20], [2, 2, 0x800], [8, 2, day], [10, 4, crc], [14, 4, bytes.length], [18, 4, bytes.length], [22, 2, title.length]];
      const local = record(30, [[0, 4, 0x04034b50], ...head.map(([at, width, value]) => [at + 4, width, value])]);
      const central = record(46, [[0, 4, 0x02014b50], [4, 2, 20], ...head.map(([at, width, value]) => [at + 6, width, value]), [42, 4, offset]]);
      parts.push(local, title, bytes);
      directory.push(central, title);
      offset += local.length + title.length + bytes.length;
    }
    const size = directory.reduce((sum, part) => sum + part.length, 0);
    const end = record(22, [[0, 4, 0x06054b50], [8, 2, files.length], [10, 2, files.length], [12, 4, size], [16, 4, offset]]);
    return new Blob([...parts, ...directory, end], { type: "application/zip" });
  }

  function save(name, blob) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }

  Object.assign(kempe, { fragmentOf, textOf, zip, save });
})((globalThis.kempe = globalThis.kempe || {}));
