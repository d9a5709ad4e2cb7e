// ArduPilot's own simulator as WebAssembly, in the place of the simulated autopilot: the two files of a build, which the
// visitor brings and which stay in the browser. (https://ardupilot.org/dev/docs/sitl-wasm.html)

// What a vehicle has to know before it can be armed, and what it tells unasked. Of a message's rate there are two names:
// ArduPilot 4.8 gave them new ones. Names that a version does not know are ignored there.
const PARAMETERS = ["FRAME_CLASS 1", ...["SR0", "MAV1"].flatMap((port) => [`${port}_POSITION 4`, `${port}_EXT_STAT 2`])];
const MODELS = [[/plane/, "plane"], [/rover/, "rover"], [/heli/, "heli"], [/sub/, "vectored"], [/./, "quad"]];

export class ArduPilotBuild {
  // hear: is called with the bytes that the vehicle sends; ended: when it has ended, with the reason.
  constructor(hear, ended) {
    this.hear = hear;
    this.ended = ended;
    this.worker = null;
  }

  // Starts it. files: the .js and the .wasm that one build has made. home: [latitude, longitude [1e-7 degrees], altitude
  // above sea level [m]]. Throws an Error whose text says what to do.
  async open(files, home) {
    const [script, binary] = [".js", ".wasm"].map((end) => files.find(({ name }) => name.endsWith(end)));
    if (!script || !binary) throw new Error("choose both files of a build, such as arducopter.js and arducopter.wasm");
    if (!self.crossOriginIsolated) throw new Error("the server of this page does not allow it: tools/playground does");
    const [, model] = MODELS.find(([name]) => name.test(script.name));
    const place = [home[0] / 1e7, home[1] / 1e7, home[2], 0].join(",");
    const worker = new Worker("ardupilot/worker.js", { type: "module" });
    await new Promise((resolve, reject) => {
      worker.onerror = (error) => reject(new Error(`${script.name} cannot be started: ${error.message}`));
      worker.onmessage = ({ data: { says, text, bytes } }) => {
        if (says === "sent") this.hear(bytes);
        if (says === "started") resolve();
        if (says !== "ended") return;
        reject(new Error(`${script.name} cannot be started: ${text}`));
        this.close(text);
      };
      worker.postMessage({
        script, binary, parameters: PARAMETERS.join("\n"), words: ["--model", model, "--home", place],
      });
    }).catch((error) => {
      worker.terminate();
      throw error;
    });
    this.worker = worker;
  }

  send(bytes) {
    this.worker?.postMessage({ bytes });
  }

  close(why = "it was closed") {
    if (!this.worker) return;
    this.worker.terminate();
    this.worker = null;
    this.ended(why);
  }
}
