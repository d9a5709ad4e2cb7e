// The sketch's source, which may be changed, compiled by the server beside the page, and run. Errors name their lines.

export class Editor {
  // parts: the elements {area, compile, back, errors, says}. begins: is called when something is compiled; ran: with what
  // was compiled, and says whether it runs.
  constructor(parts, begins, ran) {
    Object.assign(this, parts, { begins, ran, shown: "", name: "", isBusy: false });
    this.compile.onclick = () => this.run();
    this.area.oninput = () => { this.back.hidden = this.area.value === this.shown; };
    this.back.onclick = () => {
      this.area.value = this.shown;
      this.show(this.name);
    };
  }

  // An example's source, unless somebody has written in it.
  async show(name) {
    this.name = name;
    const isWritten = this.area.value !== this.shown;
    this.back.hidden = !isWritten;
    if (isWritten) {
      this.says.textContent = `${name} runs, and this is what you have written.`;
      return;
    }
    const source = await fetch(`examples/${name}.ino`).then((answer) => answer.text()).catch(() => "");
    if (this.name !== name || this.area.value !== this.shown) return; // another one was chosen, or somebody has written
    this.shown = source;
    this.area.value = source;
    this.tell([]);
  }

  offer(hasCompiler) {
    this.compile.disabled = !hasCompiler;
    this.says.textContent = hasCompiler ? "The compiler beside this page makes it anew, for a Mega."
      : "To change and compile it, serve the page with tools/playground.";
    this.area.readOnly = !hasCompiler;
  }

  async run() {
    if (this.isBusy) return;
    this.isBusy = true;
    this.begins();
    this.says.textContent = "The sketch is being compiled.";
    try {
      const made = await (await fetch("compile", { method: "POST", body: this.area.value })).json();
      const runs = made.hex && this.ran(made);
      this.tell(made.errors || [], runs ? "It was compiled, and runs." : "It was compiled.");
    } catch (error) {
      this.tell([[null, `the compiler does not answer: ${error.message}`]]);
    }
    this.isBusy = false;
  }

  // good: what to say of a sketch without errors.
  tell(errors, good = "") {
    if (this.isBusy) this.says.textContent = errors.length ? "It was not compiled." : good;
    this.errors.replaceChildren(...errors.map(([line, words]) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = line ? `line ${line}: ${words}` : words;
      button.onclick = () => this.select(line);
      const row = document.createElement("li");
      row.append(button);
      return row;
    }));
    if (errors[0]?.[0]) this.select(errors[0][0]);
  }

  select(line) {
    if (!line) return;
    const lines = this.area.value.split("\n");
    const from = lines.slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
    this.area.focus();
    this.area.setSelectionRange(from, from + (lines[line - 1] || "").length);
    this.area.scrollTop = ((line - 4) / lines.length) * this.area.scrollHeight;
  }
}
