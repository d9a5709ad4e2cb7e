// The worker in which a build of ArduPilot's simulator runs, with the threads that it starts. It keeps real time.

const SERIAL = 0; // the port that the Mega is connected to
const SIZE = 4096; // of each of the two buffers, in the vehicle's memory [bytes]
const EVERY_MS = 5;
// The sizes that ArduPilot's page gives, in pages of 64 KB.
const FIRST = 2 ** 8, MOST = 2 ** 15;

const waiting = []; // bytes that the vehicle has not taken yet

onmessage = ({ data }) => {
  if (data.bytes) waiting.push(data.bytes);
  else start(data).catch((error) => end(error.message));
};

function end(text) {
  postMessage({ says: "ended", text: String(text) });
}

async function start({ script, binary, parameters, words }) {
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const memory = new WebAssembly.Memory({ initial: FIRST, maximum: MOST, shared: true });
  const { default: create } = await import(address);
  const vehicle = await create({
    wasmMemory: memory,
    wasmBinary: new Uint8Array(await binary.arrayBuffer()),
    mainScriptUrlOrBlob: address,
    preRun: [({ FS }) => FS.writeFile("page.parm", parameters)],
    arguments: [...words, "--defaults", "page.parm", "--serial0", "wasm", "--serial1", "none", "--serial2", "none"],
    onAbort: end, // as it does to reboot
  });
  const numbers = (count) => Array(count).fill("number");
  const allocate = vehicle.cwrap("ardupilot_malloc", "number", numbers(1));
  const read = vehicle.cwrap("ardupilot_serial_read", "number", numbers(3));
  const write = vehicle.cwrap("ardupilot_serial_write", "number", numbers(3));
  const sent = allocate(SIZE), received = allocate(SIZE);
  // A view of the memory is made each time: as the memory grows, an older view sees none of it.
  setInterval(() => {
    for (let length; (length = read(SERIAL, sent, SIZE)) > 0; ) {
      const bytes = new Uint8Array(memory.buffer).slice(sent, sent + length);
      postMessage({ says: "sent", bytes }, [bytes.buffer]);
    }
    while (waiting.length) {
      const next = waiting[0].subarray(0, SIZE);
      new Uint8Array(memory.buffer).set(next, received);
      const taken = write(SERIAL, received, next.length);
      if (taken < waiting[0].length) {
        waiting[0] = waiting[0].subarray(taken);
        break;
      }
      waiting.shift();
    }
  }, EVERY_MS);
  postMessage({ says: "started" });
}
