"use strict";
// Filters and the copy buttons. Without it the page shows everything.
(() => {
  const filters = document.querySelector(".filters");
  const items = [...document.querySelectorAll("[data-verdict]")];
  const text = filters.querySelector("input");
  const shownCount = filters.querySelector("output");
  const chosen = { verdict: new Set(), area: new Set(), level: new Set() };

  function isShown(item, words) {
    const kinds = Object.entries(chosen);
    const isChosen = ([kind, set]) =>
      !set.size || item.dataset[kind].split(" ").some((value) => set.has(value));
    return kinds.every(isChosen)
      && words.every((word) => item.textContent.toLowerCase().includes(word));
  }

  function apply() {
    const words = text.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const item of items) item.hidden = !isShown(item, words);
    const rows = items.filter((item) => item.tagName === "TR");
    const shown = rows.filter((row) => !row.hidden).length;
    shownCount.textContent = `${shown} of ${rows.length} rules`;
    for (const part of document.querySelectorAll("section, tbody")) {
      part.hidden = !part.querySelector("[data-verdict]:not([hidden])");
    }
  }

  // The filters stand in the address, so that a link shows what its sender saw.
  function write() {
    const kinds = Object.entries(chosen).filter(([, set]) => set.size);
    const parts = kinds.map(([kind, set]) => [kind, [...set].join(" ")]);
    if (text.value) parts.push(["text", text.value]);
    const hash = new URLSearchParams(parts).toString();
    history.replaceState(null, "", hash ? `#${hash}` : "#top");
  }

  function read() {
    if (!location.hash.includes("=")) return; // the address of a rule or a card
    const asked = new URLSearchParams(location.hash.slice(1));
    text.value = asked.get("text") ?? "";
    for (const [kind, set] of Object.entries(chosen)) {
      set.clear();
      (asked.get(kind) ?? "").split(" ").filter(Boolean).forEach((v) => set.add(v));
    }
    for (const button of filters.querySelectorAll("button")) {
      const { kind, value } = button.dataset;
      button.setAttribute("aria-pressed", chosen[kind].has(value));
    }
    apply();
  }

  filters.addEventListener("click", (event) => {
    const button = event.target.closest("button");
    if (!button) return;
    const set = chosen[button.dataset.kind];
    const isPressed = !set.delete(button.dataset.value);
    if (isPressed) set.add(button.dataset.value);
    button.setAttribute("aria-pressed", isPressed);
    apply();
    write();
  });
  text.addEventListener("input", () => { apply(); write(); });
  addEventListener("hashchange", read);

  for (const script of document.querySelectorAll(".script")) {
    const button = document.createElement("button");
    button.className = "copy";
    button.textContent = "copy";
    button.addEventListener("click", () => {
      const range = document.createRange();
      range.selectNodeContents(script.querySelector("pre"));
      getSelection().removeAllRanges();
      getSelection().addRange(range);
      // A file opened from disk may not use the newer way.
      button.textContent = document.execCommand("copy") ? "copied" : "press Ctrl+C";
    });
    script.append(button);
  }
  filters.hidden = false;
  apply();
  read();
})();
