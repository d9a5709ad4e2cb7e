// The numbers of items as the sketch counts them. ArduPilot keeps home as item 0 of its plan, where the sketch's item 0
// is number 1.

export const HOME = "home";

// hasHome: whether item 0 of the plan on the wire is home.
export const numberOf = (kind, seq, hasHome) => (kind !== "plan" || !hasHome ? seq : seq === 0 ? HOME : seq - 1);

export const numbered = (kind, items, hasHome) =>
  items.map((item) => item && { ...item, number: numberOf(kind, item.seq, hasHome) });
