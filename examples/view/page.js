// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Controls, the picked particle and curves. The address may end with #frame=10&scalar=velocity&pick=5.
const by = (id) => document.getElementById(id);
const short = (x) => !Number.isFinite(x) ? "-" : x === 0 ? "0" : String(Number(x.toPrecision(4)));
const unitOf = (unit) => unit === "1" ? "" : ` (${unit})`;

function plot(canvas, times, values, marker, text) {
  const dots = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = width * dots;
  canvas.height = height * dots;
  const pen = canvas.getContext("2d");
  pen.scale(dots, dots);
  pen.font = "11px sans-serif";
  const found = values.filter(Number.isFinite);
  pen.fillStyle = "#333";
  pen.fillText(text, 8, 14);
  if (!found.length) return;
  let low = Infinity, high = -Infinity;
  for (const each of found) [low, high] = [Math.min(low, each), Math.max(high, each)];
  if (low === high) [low, high] = [low - 1, high + 1];
  const first = times[0], last = times[times.length - 1] || 1;
  const x = (t) => 56 + (t - first) / (last - first || 1) * (width - 70), y = (v) => height - 24 - (v - low) / (high - low) * (height - 50);
  pen.fillText(short(high), 4, y(high) + 4);
  pen.fillText(short(low), 4, y(low) + 4);
  pen.fillText(short(first), x(first), height - 8);
  pen.textAlign = "right";
  pen.fillText(short(last), x(last), height - 8);
  if (marker !== null) {
    pen.strokeStyle = "#c33";
    pen.beginPath();
    pen.moveTo(x(marker), 20);
    pen.lineTo(x(marker), height - 22);
    pen.stroke();
  }
  pen.strokeStyle = "#0072b2";
  pen.beginPath();
  let drawn = false;
  times.forEach((t, k) => {
    if (!Number.isFinite(values[k])) drawn = false;
    else if (drawn) pen.lineTo(x(t), y(values[k]));
    else pen.moveTo(x(t), y(values[k])), drawn = true;
  });
  pen.stroke();
}

class Page {
  constructor(meta, frames) {
    Object.assign(this, {meta, frames, number: 0, scalar: 0, identity: null, first: meta.dimension + 1});
    this.colours = meta.scalars.map((each) => [...each.colours]);
    this.places = meta.identities && this.placesByIdentity();
    this.particles = new Particles(by("particles"), meta, frames);
    this.fillControls();
    this.listen();
    this.followAddress();
  }
  fillControls() {
    const {meta} = this;
    by("slider").max = this.frames.length - 1;
    by("scalar").append(...meta.scalars.map(({name, unit}, k) => new Option(name.replaceAll("_", " ") + unitOf(unit), k)));
    by("history").append(...meta.histories.map(({table, name, unit}, k) => new Option(`${name}${unitOf(unit)}, ${table}`, k)));
    if (!meta.histories.length) by("history").append(new Option("the run left no table with times", 0));
    const every = meta.stride > 1 ? `, one in ${meta.stride}` : "";
    by("summary").textContent = `${meta.counts[0]} particles${every}, ${this.frames.length} states`;
    by("help").textContent = meta.dimension === 2 ? "Drag to move, turn the wheel to zoom, click a particle."
                                                  : "Drag to turn, with Shift to move, wheel to zoom, click a particle.";
    const pen = by("bar").getContext("2d");
    for (let k = 0; k < 220; ++k) pen.fillStyle = `rgb(${colour(k / 219)})`, pen.fillRect(k, 0, 1, 1);
  }
  listen() {
    by("slider").oninput = () => this.show(Number(by("slider").value));
    by("scalar").onchange = () => (this.scalar = Number(by("scalar").value), this.show(this.number));
    by("walls").onchange = () => this.show(this.number);
    by("history").onchange = () => this.drawCurves();
    for (const [k, id] of ["from", "to"].entries())
      by(id).onchange = () => (this.colours[this.scalar][k] = Number(by(id).value), this.show(this.number));
    by("play").onclick = () => this.play();
    window.onresize = () => this.show(this.number);
    window.onhashchange = () => this.followAddress();
    const canvas = by("particles");
    let last = null, moved = 0;
    canvas.onpointerdown = (event) => (last = [event.clientX, event.clientY], moved = 0, canvas.setPointerCapture(event.pointerId));
    canvas.onpointermove = (event) => {
      if (!last) return;
      const [dx, dy] = [event.clientX - last[0], event.clientY - last[1]], view = this.particles;
      moved += Math.abs(dx) + Math.abs(dy);
      if (this.meta.dimension === 3 && !event.shiftKey) view.turn -= dx * 0.008, view.tilt = Math.min(Math.max(view.tilt + dy * 0.008, -1.5), 1.5);
      else view.shift[0] += 2 * dx / canvas.clientWidth, view.shift[1] -= 2 * dy / canvas.clientHeight;
      last = [event.clientX, event.clientY];
      view.draw();
    };
    canvas.onpointerup = (event) => {
      last = null;
      const box = canvas.getBoundingClientRect();
      if (moved < 4) this.pick(this.particles.at(event.clientX - box.left, event.clientY - box.top));
    };
    canvas.onwheel = (event) => {
      event.preventDefault();
      const factor = Math.exp(-event.deltaY * 0.001), view = this.particles;
      view.zoom *= factor;
      view.shift = view.shift.map((s) => s * factor);
      view.draw();
    };
    canvas.ondblclick = () => (this.particles.lookAtAll(), this.particles.draw());
  }
  followAddress() {
    const wanted = new URLSearchParams(location.hash.slice(1));
    const scalar = this.meta.scalars.findIndex(({name}) => name === wanted.get("scalar"));
    if (scalar >= 0) this.scalar = scalar;
    by("scalar").value = this.scalar;
    const frame = Math.min(Math.max(Number(wanted.get("frame")) || 0, 0), this.frames.length - 1);
    this.show(frame);
    if (wanted.has("pick")) this.pick(Number(wanted.get("pick")));
  }
  // For each state, where the particle with an identity is.
  placesByIdentity() {
    let present = null;
    return this.meta.identities.map((list) => present = list ? new Map(list.map((identity, i) => [identity, i])) : present);
  }
  identityOf(k, i) {
    if (!this.places) return i;
    while (!this.meta.identities[k]) --k;
    return this.meta.identities[k][i];
  }
  placeOf(k) {
    if (this.identity === null) return -1;
    if (!this.meta.follows) return k === this.pickedAt ? this.identity : -1;
    const place = this.places ? this.places[k].get(this.identity) : this.identity;
    return place === undefined || place >= this.meta.counts[k] ? -1 : place;
  }
  pick(i) {
    this.pickedAt = this.number;
    this.identity = i < 0 || i >= this.meta.counts[this.number] ? null : this.identityOf(this.number, i);
    this.show(this.number);
  }
  show(number) {
    this.number = number;
    by("slider").value = number;
    by("clock").textContent = `${short(this.meta.times[number])} s`;
    const [low, high] = this.colours[this.scalar], {name, unit} = this.meta.scalars[this.scalar];
    [by("from").value, by("to").value, by("low").textContent, by("high").textContent] = [short(low), short(high), short(low), short(high)];
    by("legend_name").textContent = name.replaceAll("_", " ") + unitOf(unit);
    this.particles.picked = this.placeOf(number);
    this.particles.show(number, this.first + this.scalar, [low, high], by("walls").checked);
    this.describe();
    this.drawCurves();
  }
  describe() {
    const {meta} = this, i = this.particles.picked, rows = [];
    if (this.identity === null) rows.push(["none; click one", ""]);
    else if (i < 0) rows.push(["number", this.identity], ["is not here at this time", ""]);
    else {
      const frame = this.frames[this.number], names = meta.dimension === 2 ? ["x", "z"] : ["x", "y", "z"];
      rows.push([this.places ? "identity" : "number", this.identity]);
      names.forEach((name, k) => rows.push([`${name} (m)`, short(value(meta, frame, k, i))]));
      meta.scalars.forEach(({name, unit}, k) =>
        rows.push([name.replaceAll("_", " ") + unitOf(unit), short(value(meta, frame, this.first + k, i))]));
    }
    by("picked").replaceChildren(...rows.map((cells) => {
      const line = document.createElement("tr");
      line.append(...cells.map((text) => Object.assign(document.createElement("td"), {textContent: text})));
      return line;
    }));
  }
  drawCurves() {
    const {meta} = this, time = meta.times[this.number], {name, unit} = meta.scalars[this.scalar];
    const values = this.frames.map((frame, k) => {
      const i = this.placeOf(k);
      return i < 0 || !this.meta.follows ? NaN : value(meta, frame, this.first + this.scalar, i);
    });
    plot(by("track"), meta.times, values, time, this.identity === null ? "" : !this.meta.follows ?
           "To follow particles that come and go, write the field identity." : `${name.replaceAll("_", " ")}${unitOf(unit)} over time (s)`);
    const history = meta.histories[by("history").value || 0];
    if (history) plot(by("curve"), history.time, history.values.map((v) => v === null ? NaN : v),
                      history.time_unit === "s" ? time : null,
                      `${history.name}${unitOf(history.unit)} over time (${history.time_unit})`);
  }
  play() {
    if (this.timer) {
      clearInterval(this.timer);
      this.timer = null;
    } else this.timer = setInterval(() => this.show((this.number + 1) % this.frames.length), 70);
    by("play").textContent = this.timer ? "stop" : "play";
  }
}

(async () => {
  try {
    const meta = JSON.parse(by("meta").textContent);
    window.page = new Page(meta, await unpack(meta, by("data").textContent));
    document.body.dataset.ready = "yes";
  } catch (error) {
    by("error").style.display = "block";
    by("error").textContent = `This page cannot be shown: ${error.message}`;
    document.body.dataset.ready = "no";
  }
})();
