"use strict";
// Filters of tables, plots of an episode, and the step that all of them show. Everything
// that is said here in pictures stands in the page as text, too.

const COLOURS = ["#1a7fd1", "#d1651a", "#2e9e4f", "#b03ac2", "#c2973a", "#3aa8b0", "#d13a5e",
  "#7a6ff0"];
const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name);

// --- filters of a table that is whole ---

function filterRows(form) {
  const kind = form.dataset.filter === "pairs" ? "table.pairs" : "table.episodes";
  const rows = [...document.querySelectorAll(`${kind} tbody tr`)];
  const show = () => {
    const wanted = [...new FormData(form)].filter(([, value]) => value);
    let count = 0;
    for (const row of rows) {
      row.hidden = !wanted.every(([name, value]) => row.dataset[name] === value);
      count += !row.hidden;
    }
    const output = form.querySelector("output");
    if (output) output.textContent = `${count} of ${rows.length} rows`;
  };
  form.addEventListener("change", show);
  form.addEventListener("submit", event => { event.preventDefault(); show(); });
}

// --- one recorded episode ---

class Player {
  constructor(section) {
    this.data = JSON.parse(section.querySelector(".data").textContent);
    this.label = section.getAttribute("aria-label");
    this.section = section;
    this.plots = [];
    this.onStep = () => {};
    this.pictures = [...section.querySelectorAll("figure[data-camera]")].map(figure => ({
      image: figure.querySelector("img"),
      frames: (this.data.pictures || {})[figure.dataset.camera] || [],
    }));
    this.videos = [...section.querySelectorAll("video")];
    const {steps, actions, rewards, turns} = this.data;
    for (const [name, columns] of Object.entries(actions))
      this.plot(name, steps, columns, columns.map((_, i) => columns.length > 1 ? `${i}` : name));
    if (rewards.some(value => value)) this.plot("reward", steps, [rewards], ["reward"]);
    if (turns.last.length > 1) {
      this.plot("score", turns.last, [turns.score], ["score"]);
      this.plot("time of a turn, ms", turns.first, [turns.think_ms, turns.simulate_ms],
        ["policy", "simulator"]);
    }
  }

  plot(title, x, columns, labels) {
    const parent = this.section.querySelector(".plots");
    const heading = document.createElement("h3");
    heading.textContent = title;
    parent.append(heading);
    const axis = {stroke: colour("--soft"), grid: {stroke: colour("--line"), width: 1},
      ticks: {stroke: colour("--line")}};
    // A score is from 0 to 1; what never changes is no line at the foot of 0 to 100.
    const range = title === "score" ? [-0.05, 1.05] : (_, low, high) =>
      low === high ? [low - 1, high + 1] : uPlot.rangeNum(low, high, 0.1, true);
    const made = new uPlot({
      width: Math.max(260, parent.clientWidth), height: 170,
      scales: {x: {time: false, range: () => [0, Math.max(1, this.data.total)]},
        y: {range}},
      axes: [{...axis}, {...axis, size: 62}],
      legend: {live: false, show: labels.length > 1},
      cursor: {drag: {x: false, y: false}},
      series: [{label: "step"}, ...labels.map((label, i) => ({label, width: 1.5,
        stroke: COLOURS[i % COLOURS.length], points: {show: x.length < 40}}))],
      hooks: {draw: [plot => this.drawMarks(plot)]},
    }, [x, ...columns], parent);
    made.over.addEventListener("click", event => {
      const box = made.over.getBoundingClientRect();
      this.onStep(Math.round(made.posToVal(event.clientX - box.left, "x")));
    });
    this.plots.push(made);
  }

  drawMarks(plot) {
    const line = (step, style, dash) => {
      const at = plot.valToPos(step, "x", true), {ctx, bbox} = plot;
      ctx.save();
      ctx.strokeStyle = style;
      ctx.lineWidth = 2;
      ctx.setLineDash(dash);
      ctx.beginPath();
      ctx.moveTo(at, bbox.top);
      ctx.lineTo(at, bbox.top + bbox.height);
      ctx.stroke();
      ctx.restore();
    };
    if (this.step !== undefined) line(this.step, colour("--text"), []);
    if (this.divergence !== undefined) line(this.divergence, colour("--mark"), [6, 5]);
  }

  show(step) {
    this.step = Math.min(step, this.data.total);
    for (const plot of this.plots) plot.redraw(false);
    for (const {image, frames} of this.pictures) {
      const frame = frames.filter(([at]) => at <= this.step).at(-1) || frames[0];
      if (frame && image.getAttribute("src") !== frame[1]) image.src = frame[1];
    }
    for (const video of this.videos)
      if (video.duration)
        video.currentTime = video.duration * this.step / Math.max(1, this.data.total);
  }

  describe() {
    const {steps, actions, rewards, turns, stride} = this.data;
    if (!this.step) return "before the first action";
    const at = Math.min(steps.length - 1, Math.floor((this.step - 1) / stride));
    const turn = turns.last.findIndex(last => last >= this.step);
    const parts = [];
    if (turn >= 0) parts.push(`turn ${turns.seq[turn]}, policy ${turns.think_ms[turn]} ms`);
    if (rewards[at] !== null) parts.push(`reward ${rewards[at]}`);
    for (const [name, columns] of Object.entries(actions))
      parts.push(`${name} ${columns.map(column => column[at]).join(" ")}`);
    return parts.join("; ");
  }
}

function startPlayers(sections) {
  const slider = document.getElementById("step"), readout = document.getElementById("readout");
  const players = sections.map(section => new Player(section));
  for (const one of document.querySelectorAll(".step, .keys")) one.hidden = false;
  const divergence = slider.closest(".step").dataset.divergence;
  const show = (step, isTyped) => {
    step = Math.max(0, Math.min(Number(slider.max), step || 0));
    slider.value = step;
    for (const player of players) player.show(step);
    const texts = players.map(player => players.length > 1 ?
      `${player.label}: ${player.describe()}` : player.describe());
    readout.textContent = `${step} of ${slider.max}. ${texts.join(" | ")}`;
    if (isTyped) history.replaceState(null, "", `#step=${step}`);
  };
  for (const player of players) {
    if (divergence) player.divergence = Number(divergence);
    player.onStep = step => show(step, true);
  }
  const named = () => {
    const found = /^#step=(\d{1,9})$/.exec(location.hash);
    return found ? Number(found[1]) : Number(slider.value);
  };
  slider.addEventListener("input", () => show(Number(slider.value), true));
  addEventListener("hashchange", () => show(named(), false));
  addEventListener("resize", () => {
    for (const player of players)
      for (const plot of player.plots)
        plot.setSize({width: Math.max(260, plot.root.parentNode.clientWidth), height: 170});
  });
  addEventListener("keydown", event => {
    // Keyboards that have brackets behind AltGr say that Ctrl and Alt are held, too.
    const isCharacter = event.getModifierState("AltGraph");
    if (event.metaKey || (!isCharacter && (event.ctrlKey || event.altKey))) return;
    const typing = event.target.matches("input:not([type=range]), select, textarea, video, .wide");
    const now = Number(slider.value);
    const wanted = {ArrowLeft: now - 1, ArrowRight: now + 1, Home: 0, End: Number(slider.max)};
    const link = {"[": "prev", "]": "next"}[event.key];
    if (typing) return;
    if (event.key in wanted) {
      event.preventDefault();
      show(wanted[event.key], true);
    } else if (link) document.querySelector(`a[rel=${link}]`)?.click();
  });
  show(named(), false);
}

for (const form of document.querySelectorAll("form[data-filter]"))
  if (document.querySelector("table.whole")) filterRows(form);
const sections = [...document.querySelectorAll("section.player")];
if (sections.length) startPlayers(sections);

// A run that was watched to its end: the whole page has more than its live part.
document.addEventListener("htmx:sseClose", event => {
  if (event.detail.type === "message") location.reload();
});
