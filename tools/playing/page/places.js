// Items on a flat map: metres east and north of a place, good enough for a plan's extent.

const METRES_PER_E7 = 0.011131884502145034; // a 1e-7 degree of latitude
const NO_PLACE = 2; // MAV_FRAME_MISSION
const FLOWN_TO = new Set([16, 17, 18, 19, 21, 22, 31, 82, 84, 85, 94]);
export const WAYPOINT = 16;
export const NORTH_30_M = Math.round(30 / METRES_PER_E7); // in latitude
const RETURN = 20;
const CORNERS = new Set([5001, 5002]);
const CIRCLES = new Set([5003, 5004]);
const RALLY = 5100;

export const hasPlace = (item) => item.frame !== NO_PLACE && (item.x !== 0 || item.y !== 0);
export const isFlownTo = (item) => FLOWN_TO.has(item.command) && hasPlace(item);
export const isReturn = (item) => item.command === RETURN;
export const isCorner = (item) => CORNERS.has(item.command);
export const isCircle = (item) => CIRCLES.has(item.command);
export const isRally = (item) => item.command === RALLY;

// From {x: latitude, y: longitude} [1e-7 degrees] to [east, north] in metres, and nothing else.
export function flatAround(origin) {
  const shrink = Math.cos((origin.x * 1e-7 * Math.PI) / 180);
  return ({ x, y }) => {
    const turn = 3.6e9;
    const east = ((((y - origin.y) % turn) + 1.5 * turn) % turn) - turn / 2; // the short way round
    return [east * METRES_PER_E7 * shrink, (x - origin.x) * METRES_PER_E7];
  };
}

// And back.
export function placeFrom(origin) {
  const shrink = Math.cos((origin.x * 1e-7 * Math.PI) / 180);
  return ([east, north]) => ({
    x: Math.round(origin.x + north / METRES_PER_E7), y: Math.round(origin.y + east / METRES_PER_E7 / shrink),
  });
}

// The round number that is nearest below a length.
export function roundBelow(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return [5, 2, 1].find((digit) => digit * power <= length) * power;
}

export const lengthInWords = (metres) => (metres >= 1000 ? `${metres / 1000} km` : `${metres} m`);
