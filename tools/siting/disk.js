// The page as it lies on a disk. A browser that opens it from there (file:) loads no module, no worker and no data of
// it; so all of that comes from packed.js, a plain script. Beside a server nothing of this happens.
"use strict";

// In the page, and in each of its workers: begins a module, for which `files` are what is on the disk, by their names.
// A worker is given them, since it may not load what the page has made of them.
function beginFrom(files, base, module) {
  const KINDS = { js: "text/javascript", mjs: "text/javascript", wasm: "application/wasm", json: "application/json" };
  const { fetch, Worker } = globalThis;
  const nameOf = (address) => {
    const whole = new URL(address, base).href;
    return whole.startsWith(base) ? whole.slice(base.length) : "";
  };
  const kindOf = (name) => KINDS[name.split(".").pop()] || "text/plain";
  const made = {};
  // Modules name each other by their places on the disk: those that a module imports are made first.
  const addressOf = (name) => made[name] ||= URL.createObjectURL(new Blob([
    new TextDecoder().decode(files[name])
      .replace(/\b(from\s*|import\s*)(["'])(\.[^"']*)\2/g, (_, word, quote, path) =>
        `${word}"${addressOf(nameOf(new URL(path, base + name)))}"`)
      .replace(/\bimport\.meta\.url\b/g, JSON.stringify(base + name))
      .replace(/\bimport\((?=[\w$]+\))/g, "importFrom("),
  ], { type: kindOf(name) }));
  globalThis.importFrom = (address) => import(files[nameOf(address)] ? addressOf(nameOf(address)) : address);
  globalThis.fetch = async (address, options) => {
    const name = nameOf(address);
    return files[name] ? new Response(files[name], { headers: { "Content-Type": kindOf(name) } })
      : fetch(address, options);
  };
  if (Worker) {
    // No module, which chromium does not start from a disk, but a script that imports one. What comes first waits.
    const script = `const waiting = [], wait = (event) => waiting.push(event.data);
      addEventListener("message", wait);
      addEventListener("message", async ({ data: { files, base, module } }) => {
        await (${beginFrom})(files, base, module);
        removeEventListener("message", wait);
        waiting.slice(1).forEach((data) => dispatchEvent(new MessageEvent("message", { data })));
      }, { once: true });`;
    globalThis.Worker = class extends Worker {
      constructor(address) {
        super(URL.createObjectURL(new Blob([script], { type: KINDS.js })));
        this.postMessage({ files, base, module: nameOf(address) });
      }
    };
  }
  return import(addressOf(module));
}

async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

if (location.protocol === "file:") {
  const script = document.createElement("script");
  script.src = "packed.js";
  script.onload = async () => {
    const files = {};
    for (const [name, base64] of Object.entries(PACKED)) files[name] = await unpacked(base64);
    beginFrom(files, new URL(".", location.href).href, "main.js");
  };
  document.head.append(script);
} else {
  import("./main.js");
}
