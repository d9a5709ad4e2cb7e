// A real autopilot in the place of the simulated one: a serial port of this computer, which its user chooses.
//
// A port is opened by a press of the button and by nothing else: no address opens one, and none is remembered.

const BAUD = 57600;

export const isOffered = () => "serial" in navigator;

export class Pixhawk {
  // hear: is called with the bytes that arrive; ended: when the port is gone, with the reason.
  constructor(hear, ended) {
    this.hear = hear;
    this.ended = ended;
    this.port = null;
  }

  // To be called from the press of a button; false if the user has chosen none.
  async open() {
    let port;
    try {
      port = await navigator.serial.requestPort();
    } catch (error) {
      if (error.name === "NotFoundError") return false;
      throw error;
    }
    await port.open({ baudRate: BAUD });
    this.port = port;
    this.writer = port.writable.getWriter();
    this.read();
    return true;
  }

  send(bytes) {
    this.writer?.write(bytes).catch((error) => this.close(error.message));
  }

  async read() {
    let why = "the port was closed";
    try {
      this.reader = this.port.readable.getReader();
      for (;;) {
        const { value, done } = await this.reader.read();
        if (done) break;
        this.hear(value);
      }
    } catch (error) {
      why = error.message;
    }
    this.close(why);
  }

  async close(why = "the port was closed") {
    const { port, reader, writer } = this;
    if (!port) return;
    this.port = null;
    this.writer = null;
    try {
      await reader?.cancel();
      reader?.releaseLock();
      writer?.releaseLock();
      await port.close();
    } catch {
      // The cable was pulled: there is nothing left to close.
    }
    this.ended(why);
  }
}
