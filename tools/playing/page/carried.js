// A plan in the page's address: its name and its .waypoints text, packed by the browser's own deflate.

const LONGEST = 6000; // characters, which a chat or a mail still leaves whole

export const CARRIED = /^[A-Za-z0-9_-]{1,6000}$/;

// The word for the address; "" if it would be too long.
export async function packed({ name, waypoints }) {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(`${name}\n${waypoints}`));
  const word = btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  return word.length > LONGEST ? "" : word;
}

// {name, bytes} of a .waypoints file. Throws what DecompressionStream throws at a word that is not one of packed().
export async function unpacked(word) {
  const letters = atob(word.replaceAll("-", "+").replaceAll("_", "/"));
  const packedBytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  const bytes = await through(new DecompressionStream("deflate-raw"), packedBytes);
  const end = bytes.indexOf("\n".charCodeAt(0));
  return { name: new TextDecoder().decode(bytes.subarray(0, end)), bytes: bytes.slice(end + 1).buffer };
}

async function through(stream, bytes) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}
