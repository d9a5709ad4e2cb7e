// Runs a .hex on the page's Mega: input as it is told on stdin, output with its cycles on stdout, both JSON.
import fs from "node:fs";

const { Mega } = await import(process.argv[2]);
const { hex, input, until, pass } = JSON.parse(fs.readFileSync(0, "utf8"));
const mega = new Mega(hex, pass);
const sent = { 0: [], 1: [] };
const take = () => {
  for (const port of [0, 1]) sent[port].push(...mega.serial(port).takeSent().map(({ byte, left }) => [byte, left]));
};
for (const { cycle, port, bytes, reset } of input) {
  mega.run(cycle);
  if (reset) mega.reset();
  else mega.serial(port).send(bytes, cycle);
  take();
}
mega.run(until);
take();
const { count, longest, shortest } = mega.takePasses();
process.stdout.write(JSON.stringify({
  sent, stack: mega.deepestStack, lost: mega.serial(1).lost, unheard: mega.serial(1).unheard,
  passes: { count, longest, shortest: count ? shortest : 0 }, eeprom: [...mega.eeprom.memory],
}));
