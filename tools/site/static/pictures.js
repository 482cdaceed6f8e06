// Draws the pictures of a page, if it has any, in the colours that are shown.
// The library is big: pages without pictures do not load it.
"use strict";
(() => {
  const here = document.currentScript.src;
  const dark = () => {
    const chosen = document.body.dataset.theme;
    const system = window.matchMedia("(prefers-color-scheme: dark)").matches;
    return chosen === "dark" || (chosen !== "light" && system);
  };
  // One after another: two drawings at a time write into one picture.
  let last = Promise.resolve();
  const redraw = (pictures) => {
    last = last.then(() => draw(pictures));
  };
  const draw = async (pictures) => {
    window.mermaid.initialize({
      startOnLoad: false,
      theme: dark() ? "dark" : "neutral",
      fontFamily: "sans-serif",
    });
    for (const [number, picture] of pictures.entries()) {
      const id = `picture-${number}`;
      const drawn = await window.mermaid.render(id, picture.dataset.text);
      picture.innerHTML = drawn.svg;
    }
  };
  window.addEventListener("DOMContentLoaded", () => {
    const pictures = [...document.querySelectorAll("pre.mermaid")];
    if (pictures.length === 0) return;
    for (const picture of pictures) picture.dataset.text = picture.textContent;
    const library = document.createElement("script");
    library.src = here.replace(/pictures\.js.*$/, "mermaid.min.js");
    library.onload = () => {
      redraw(pictures);
      new MutationObserver(() => redraw(pictures)).observe(document.body, {
        attributes: true,
        attributeFilter: ["data-theme"],
      });
    };
    document.head.append(library);
  });
})();
