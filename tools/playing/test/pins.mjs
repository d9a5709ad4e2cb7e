// Runs a .hex on the page's Mega; what its pins are at the times that are asked for [s], as JSON.
import fs from "node:fs";

const [, , script, file, card, ...times] = process.argv;
const { HZ, Mega } = await import(script);
const mega = new Mega(fs.readFileSync(file, "latin1"), 0, card);
const printed = [];
const seen = times.map((time) => {
  mega.run(Number(time) * HZ);
  printed.push(...mega.serial(0).takeSent().map(({ byte }) => byte));
  return mega.pins.state;
});
process.stdout.write(JSON.stringify({ seen, printed: String.fromCharCode(...printed) }));
