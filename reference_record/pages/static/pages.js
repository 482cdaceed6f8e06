"use strict";
// Filters of tables, the player of an episode, its plots, and the step that all of them
// show. Everything that is said here in pictures stands in the page as text, too.

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

// --- pictures and films of one play ---

class Player {
  constructor(section) {
    this.data = JSON.parse(section.querySelector(".data").textContent);
    this.label = section.dataset.label;
    this.pictures = [...section.querySelectorAll("figure[data-camera]")].map(figure => ({
      image: figure.querySelector("img"),
      frames: (this.data.pictures || {})[figure.dataset.camera] || [],
    }));
    this.videos = [...section.querySelectorAll("video")];
    for (const video of this.videos) video.controls = false;  // the page has controls
  }

  show(step, isPlaying) {
    step = Math.min(step, this.data.total);
    for (const {image, frames} of this.pictures) {
      const frame = frames.filter(([at]) => at <= step).at(-1) || frames[0];
      if (frame && image.getAttribute("src") !== frame[1]) image.src = frame[1];
    }
    for (const video of this.videos) {
      if (!video.duration) continue;
      // A film has one picture before the first step, and one after each.
      const at = video.duration * (step + 0.5) / (this.data.total + 1);
      if (!isPlaying || Math.abs(video.currentTime - at) > 0.3) video.currentTime = at;
      if (isPlaying && step < this.data.total) video.play().catch(() => {});
      else video.pause();
    }
  }

  setSpeed(speed) {
    for (const video of this.videos) video.playbackRate = speed;
  }

  describe(step) {
    const {x, turns, think_ms} = this.data;
    const turn = x.last.findIndex(last => last >= step);
    return step && turn >= 0 ? `turn ${turns[turn]}, policy ${think_ms[turn]} ms` : "";
  }
}

// --- plots: a small one for each number, with a line for each play ---

const PLOTS_OPEN = 24;  // those beyond are drawn when they are asked for
const PLOT_HEIGHT = 118;

class Plots {
  constructor(parent, players, onStep) {
    this.players = players;
    this.total = Math.max(1, ...players.map(player => player.data.total));
    this.onStep = onStep;
    this.cells = [];
    const titles = new Set(players.flatMap(one => one.data.groups.map(group => group.title)));
    let count = 0, place = parent, singles = null;
    for (const title of titles) {
      const names = new Set(this.groups(title).flatMap(group => group.plots.map(one => one.name)));
      if (place === parent && count && count + names.size > PLOTS_OPEN) {
        place = add(parent, "details");
        add(place, "summary", "More numbers");
        const drawn = place;
        drawn.addEventListener("toggle", () => this.resize(), {once: true});
        singles = null;
      }
      count += names.size;
      // Single numbers stand together, without a heading for each.
      const isSingle = names.size === 1;
      if (!isSingle) add(place, "h3", title);
      const grid = isSingle && singles || add(place, "div");
      singles = isSingle ? grid : null;
      grid.className = "plots";
      for (const name of names) this.add(grid, title, name);
    }
  }

  groups(title) {
    return this.players.flatMap(one => one.data.groups.filter(group => group.title === title));
  }

  add(grid, title, name) {
    const lines = this.players.map(player => {
      const group = player.data.groups.find(one => one.title === title);
      const plot = group && group.plots.find(one => one.name === name);
      return plot && {...plot, steps: player.data.x[plot.x]};
    });
    const {unit} = lines.find(Boolean);
    const cell = add(grid, "div"), head = add(cell, "p", name);
    add(head, "small", unit);
    const values = lines.map((_, side) => {
      const value = add(head, "output");
      value.className = `side-${side + 1}`;
      return value;
    });
    const ground = add(cell, "div");
    this.cells.push({cell, ground, name, lines, values, plot: null});
  }

  draw(cell) {
    const axis = {stroke: colour("--soft"), grid: {stroke: colour("--line"), width: 1},
      ticks: {stroke: colour("--line"), size: 4}, font: "11px system-ui"};
    const drawn = cell.lines.map((line, side) => line && {line, side}).filter(Boolean);
    // A score is from 0 to 1; what never changes is no line at the foot of 0 to 100.
    const range = cell.name === "score" ? [-0.05, 1.05] : (_, low, high) =>
      low === high ? [low - 1, high + 1] : uPlot.rangeNum(low, high, 0.1, true);
    const plot = cell.plot = new uPlot({
      width: Math.max(120, cell.ground.clientWidth), height: PLOT_HEIGHT,
      padding: [6, 14, 0, 0],
      scales: {x: {time: false, range: () => [0, this.total]}, y: {range}},
      axes: [{...axis, size: 24}, {...axis, size: 46}],
      legend: {show: false},
      cursor: {show: false},
      series: [{}, ...drawn.map(({line, side}) => ({width: 1.5, stroke: colour(`--side-${side + 1}`),
        spanGaps: true, dash: side ? [6, 3] : undefined, points: {show: line.steps.length < 40, size: 3, fill: colour(`--side-${side + 1}`)}}))],
      hooks: {draw: [() => this.drawMark(plot)]},
    }, uPlot.join(drawn.map(({line}) => [line.steps, line.y])), cell.ground);
    cell.mark = add(plot.over, "div");
    cell.mark.className = "mark";
    const goTo = event => {
      const left = event.clientX - plot.over.getBoundingClientRect().left;
      this.onStep(Math.round(plot.posToVal(left, "x")));
    };
    plot.over.addEventListener("pointerdown", event => {
      plot.over.setPointerCapture(event.pointerId);
      goTo(event);
    });
    plot.over.addEventListener("pointermove", event => { if (event.buttons) goTo(event); });
  }

  drawMark(plot) {
    if (!this.divergence) return;
    const at = plot.valToPos(this.divergence, "x", true), {ctx, bbox} = plot;
    ctx.save();
    ctx.strokeStyle = colour("--mark");
    ctx.lineWidth = 2;
    ctx.setLineDash([6, 5]);
    ctx.beginPath();
    ctx.moveTo(at, bbox.top);
    ctx.lineTo(at, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  }

  resize() {
    for (const cell of this.cells) {
      const width = cell.ground.clientWidth;
      if (!width) continue;  // it is folded
      if (!cell.plot) this.draw(cell);
      else if (cell.plot.width !== width) cell.plot.setSize({width, height: PLOT_HEIGHT});
    }
    if (this.step !== undefined) this.show(this.step);
  }

  show(step) {
    this.step = step;
    for (const {plot, mark, lines, values} of this.cells) {
      if (!plot) continue;
      mark.style.transform = `translateX(${plot.valToPos(step, "x")}px)`;
      lines.forEach((line, side) => {
        const at = line ? line.steps.findLastIndex(one => one <= step) : -1;
        const value = at < 0 ? null : line.y[at];
        values[side].textContent = value === null ? "" : `${value}`;
      });
    }
  }
}

function add(parent, tag, text) {
  const made = document.createElement(tag);
  if (text !== undefined) made.textContent = text;
  parent.append(made);
  return made;
}

// --- the step that all of them show, and the clock that moves it ---

function startPlayers(sections) {
  const slider = document.getElementById("step"), readout = document.getElementById("readout");
  const button = document.getElementById("play"), loop = document.getElementById("loop");
  const speed = document.getElementById("speed"), last = Number(slider.max);
  const players = sections.map(section => new Player(section));
  const {rate} = players[0].data;
  let timer = 0, began = 0, from = 0;
  for (const one of document.querySelectorAll(".step, .keys")) one.hidden = false;
  const plots = new Plots(document.getElementById("plots"), players, step => { pause(); show(step, true); });
  plots.divergence = Number(document.querySelector(".step").dataset.divergence || 0);
  const isPlaying = () => Boolean(timer);
  const show = (step, isChosen) => {
    step = Math.max(0, Math.min(last, step || 0));
    slider.value = step;
    for (const player of players) player.show(step, isPlaying());
    plots.show(step);
    const texts = players.length > 1 ? [] : [players[0].describe(step)].filter(Boolean);
    const seconds = `${(step / rate).toFixed(1)} s of ${(last / rate).toFixed(1)} s`;
    readout.textContent = [`${step} of ${last}`, seconds, ...texts].join(" · ");
    if (isChosen) history.replaceState(null, "", `#step=${step}`);
  };
  const restart = () => {
    began = performance.now();
    from = Number(slider.value);
    for (const player of players) player.setSpeed(Number(speed.value));
  };
  const tick = () => {
    let step = from + Math.floor((performance.now() - began) / 1000 * rate * Number(speed.value));
    if (step > last && loop.checked) {
      slider.value = step = 0;
      restart();
    }
    if (step !== Number(slider.value) || !step) show(step, false);
    if (step >= last && !loop.checked) return pause();
    timer = requestAnimationFrame(tick);
  };
  const play = () => {
    if (Number(slider.value) >= last) slider.value = 0;
    restart();
    button.textContent = "Pause";
    timer = requestAnimationFrame(tick);
  };
  const pause = () => {
    cancelAnimationFrame(timer);
    timer = 0;
    button.textContent = "Play";
    show(Number(slider.value), true);
  };
  button.addEventListener("click", () => isPlaying() ? pause() : play());
  speed.addEventListener("change", restart);
  const named = () => {
    const text = /^#step=(\d{1,9})$/.exec(location.hash);
    return text ? Number(text[1]) : Number(slider.value);
  };
  slider.addEventListener("input", () => {
    const step = Number(slider.value);
    if (isPlaying()) pause();
    show(step, true);
  });
  addEventListener("hashchange", () => show(named(), false));
  addEventListener("resize", () => plots.resize());
  for (const player of players)
    for (const video of player.videos)
      video.addEventListener("loadedmetadata", () => show(Number(slider.value), false));
  addEventListener("keydown", event => {
    // Keyboards that have brackets behind AltGr say that Ctrl and Alt are held, too.
    const isCharacter = event.getModifierState("AltGraph");
    if (event.metaKey || (!isCharacter && (event.ctrlKey || event.altKey))) return;
    const typing = event.target.matches("input:not([type=range]), select, textarea, .wide");
    const now = Number(slider.value);
    const wanted = {ArrowLeft: now - 1, ArrowRight: now + 1, Home: 0, End: last};
    const link = {"[": "prev", "]": "next"}[event.key];
    if (typing) return;
    if (event.key in wanted) {
      event.preventDefault();
      if (isPlaying()) pause();
      show(wanted[event.key], true);
    } else if (event.key === " " && !event.target.matches("button, summary, a")) {
      event.preventDefault();
      button.click();
    } else if (link) document.querySelector(`a[rel=${link}]`)?.click();
  });
  plots.resize();
  show(named(), false);
}

for (const button of document.querySelectorAll("[data-copy]")) {
  button.hidden = !navigator.clipboard;
  button.addEventListener("click", async () => {
    await navigator.clipboard.writeText(button.previousElementSibling.textContent);
    button.textContent = "Copied";
    setTimeout(() => { button.textContent = "Copy"; }, 2000);
  });
}
for (const form of document.querySelectorAll("form[data-filter]"))
  if (document.querySelector("table.whole")) filterRows(form);
const sections = [...document.querySelectorAll("section.player")];
if (sections.length) startPlayers(sections);

// While a run is watched, its episodes' rows keep to the summary that was just swapped in.
document.addEventListener("htmx:sseMessage", () => {
  for (const rows of document.querySelectorAll("template[data-rows]"))
    for (const row of rows.content.querySelectorAll("tr"))
      document.getElementById(row.id)?.replaceWith(row.cloneNode(true));
});
// Who stands beside a robot has to know that a press of a button did not arrive.
const alarm = document.getElementById("alarm");
if (alarm) document.addEventListener("htmx:afterRequest", event => {
  alarm.hidden = event.detail.successful;
});
// The newest picture of each camera of a robot, twice a second while the page is seen.
function followCameras() {
  for (const image of document.querySelectorAll("img[data-live]")) {
    if (document.hidden || image.dataset.asked) continue;
    image.dataset.asked = "yes";
    const next = image.cloneNode();
    next.hidden = false;
    delete next.dataset.asked;
    next.addEventListener("load", () => image.replaceWith(next), {once: true});
    next.addEventListener("error", () => { delete image.dataset.asked; }, {once: true});
    next.src = `${image.dataset.live}?at=${Date.now()}`;
  }
}
if (document.querySelector(".cell")) setInterval(followCameras, 500);
// A film that is being drawn: the page has it when it is done.
if (document.querySelector("[data-reload]")) setTimeout(() => location.reload(), 2000);
// The films of a run: their counts and marks follow, and the rest of the page stays.
// After a refusal, as of a session that is over, they stay as they are.
async function followFilms(pause_ms = 2000) {
  const answer = document.hidden ? null : await fetch(location.href).catch(() => null);
  if (answer && !answer.ok && answer.status < 500) return;
  const text = answer?.ok ? await answer.text().catch(() => "") : "";
  if (text) {
    const page = new DOMParser().parseFromString(text, "text/html");
    for (const shown of document.querySelectorAll("#films, [id^=film-]")) {
      const now = page.getElementById(shown.id);
      if (now && !now.isEqualNode(shown)) shown.replaceWith(now);
    }
  }
  if (!document.querySelector("#films[data-pending]")) return;
  // A server that is away is asked ever more rarely; a hidden page asks nothing.
  const next_ms = text || document.hidden ? 2000 : Math.min(2 * pause_ms, 60000);
  setTimeout(followFilms, next_ms, next_ms);
}
if (document.querySelector("#films[data-pending]")) setTimeout(followFilms, 2000);

// A run that was watched to its end: the whole page has more than its live part.
document.addEventListener("htmx:sseClose", event => {
  if (event.detail.type === "message") location.reload();
});
