// The fields of a frame as a table: a name, a value, and what it means.

export function showFields(place, frame) {
  if (!frame) {
    const words = "Choose a frame, here or in the picture: its fields stand here in words.";
    place.replaceChildren(made("p", words, "dim"));
    return;
  }
  const table = document.createElement("table");
  table.append(made("caption", frame.name));
  for (const [name, value, words] of frame.rows) {
    const row = table.insertRow();
    const head = made("th", name);
    head.scope = "row";
    row.append(head, made("td", value), made("td", words || ""));
  }
  place.replaceChildren(table);
}

function made(kind, text, name = "") {
  const element = document.createElement(kind);
  element.textContent = text;
  element.className = name;
  return element;
}
