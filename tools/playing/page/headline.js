// What the sketch is doing, in a sentence, where no plan is on its way: by what the autopilot shows, and by what the
// sketch has printed last.

const AIRBORNE_M = 0.5;
export const BUTTONS = " Its buttons stand under “Inside the Mega”: a press holds one down, a second lets it go.";
const ORDER = " It waits for an order: the button that sends one stands under “Inside the Mega”.";

export function flightInWords({ vehicle, flown }) {
  if (vehicle?.armed) return `${vehicle.height > AIRBORNE_M ? "In flight" : "Armed"}, in ${vehicle.mode}.`;
  return flown ? "The flight is over." : "";
}

// name: the example's. autopilot: its name. heard: the Mega has heard it. flown: it was armed in this run. reads: the
// sketch reads a plan, and has if `read`. said: the last line that it printed. waits: buttons at its pins are there.
// ordered: a button orders its payload something.
export function headline({ name, autopilot, heard, vehicle, flown, reads, read, prints, said, waits, ordered }) {
  const flight = flightInWords({ vehicle, flown });
  if (flight) return flight + (said ? ` The sketch says: ${said}` : "");
  if (read) return `The Mega has read the plan that ${autopilot} holds.`;
  if (!heard) return `The Mega is looking for ${autopilot}.`;
  if (reads) return `The Mega reads the plan that ${autopilot} holds.`;
  const printed = said ? ": the serial monitor has what it prints" : ", and has printed nothing yet";
  return `${name} runs beside ${autopilot}${prints ? printed : ""}.${waits ? BUTTONS : ""}${ordered ? ORDER : ""}`;
}
