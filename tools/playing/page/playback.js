// A recorded run, shown while the autopilot is loading: what was told of it, at the times at which it was told.

const EVERY_MS = 100;

export class Playback {
  // show: is called with {now, news, printed}.
  constructor(show) {
    this.show = show;
    this.timer = null;
  }

  get isOn() {
    return this.timer !== null;
  }

  async begin(address) {
    const { from, told } = await (await fetch(address)).json();
    const began = performance.now() - from * 1000;
    this.timer = setInterval(() => {
      const now = (performance.now() - began) / 1000;
      while (told.length && told[0][0] <= now) {
        const [time, news, printed] = told.shift();
        this.show({ now: time, news, printed });
      }
    }, EVERY_MS);
  }

  stop() {
    clearInterval(this.timer);
    this.timer = null;
  }
}
