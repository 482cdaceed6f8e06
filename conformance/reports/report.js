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
    return kinds.every(([kind, set]) => !set.size || set.has(item.dataset[kind]))
      && words.every((word) => item.textContent.toLowerCase().includes(word));
  }

  function apply() {
    const words = text.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const item of items) item.hidden = !isShown(item, words);
    const rows = items.filter((item) => item.tagName === "TR");
    const shown = rows.filter((row) => !row.hidden).length;
    shownCount.textContent = `${shown} of ${rows.length} rules`;
    for (const section of document.querySelectorAll("section")) {
      section.hidden = !section.querySelector("[data-verdict]:not([hidden])");
    }
  }

  filters.addEventListener("click", (event) => {
    const button = event.target.closest("button");
    if (!button) return;
    const set = chosen[button.dataset.kind];
    const isPressed = !set.delete(button.dataset.value);
    if (isPressed) set.add(button.dataset.value);
    button.setAttribute("aria-pressed", isPressed);
    apply();
  });
  text.addEventListener("input", apply);

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
})();
