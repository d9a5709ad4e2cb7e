// Both wires of the line as a VCD file, for a logic analyser's program: bit by bit, idle high, as frames crossed it.

const STEP_S = 1e-7;
const WIRES = { ">": ["!", "mega_tx"], "<": ["\"", "mega_rx"] };

// frames: [{way, hex, began, ended}].
export function vcdOf(frames) {
  const heads = Object.values(WIRES).map(([sign, name]) => `$var wire 1 ${sign} ${name} $end`);
  const lines = ["$timescale 100 ns $end", "$scope module line $end", ...heads, "$upscope $end",
    "$enddefinitions $end", "#0", ...Object.values(WIRES).map(([sign]) => `1${sign}`)];
  const changes = frames.flatMap(changesOf).sort((a, b) => a.at - b.at);
  let at = 0;
  for (const change of changes) {
    if (change.at !== at) lines.push(`#${change.at}`);
    at = change.at;
    lines.push(`${change.bit}${change.sign}`);
  }
  return `${lines.join("\n")}\n`;
}

function changesOf({ way, hex, began, ended }) {
  const bytes = (hex.match(/../g) || []).map((byte) => parseInt(byte, 16));
  const bitS = (ended - began) / bytes.length / 10;
  const [sign] = WIRES[way];
  const changes = [];
  let level = 1;
  bytes.forEach((byte, turn) => {
    const bits = [0, ...Array.from({ length: 8 }, (_, bit) => (byte >> bit) & 1), 1];
    bits.forEach((bit, place) => {
      if (bit === level) return;
      level = bit;
      changes.push({ at: Math.round((began + (10 * turn + place) * bitS) / STEP_S), bit, sign });
    });
  });
  return changes;
}
