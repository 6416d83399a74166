// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Controls, the picked particle and curves. The address may end with #frame=10&scalar=velocity&map=heat&pick=5.
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

function rowOf(cells) {
  const line = document.createElement("tr");
  line.append(...cells.map((text) => Object.assign(document.createElement("td"), {textContent: text})));
  return line;
}

class Page {
  constructor(meta, frames) {
    Object.assign(this, {meta, frames, number: 0, identity: null, map: "viridis", first: meta.dimension + 1});
    this.colours = meta.scalars.map((each) => [...each.colours]);
    // The first scalar that is not the same everywhere, at any time.
    this.scalar = Math.max(meta.scalars.findIndex((_, k) => {
      const [low, high] = meta.ranges[this.first + k];
      return frames.some((frame) => frame[this.first + k].some((each) => each !== frame[this.first + k][0])) && high > low;
    }), 0);
    this.bodies = meta.bodies;
    if (!meta.scalars.length) this.scalar = -1;
    this.places = meta.identities && this.placesByIdentity();
    this.particles = new Particles(by("particles"), meta, frames);
    this.axes = new Axes(by("axes"), this.particles);
    this.particles.afterwards = () => this.axes.draw();
    this.fillControls();
    this.listen();
    this.followAddress();
  }
  fillControls() {
    const {meta} = this;
    by("slider").max = this.frames.length - 1;
    by("scalar").append(...meta.scalars.map(({name, unit}, k) => new Option(name.replaceAll("_", " ") + unitOf(unit), k)));
    if (this.bodies.length > 1 || !meta.scalars.length) by("scalar").append(new Option("body", -1));
    by("map").append(...Object.keys(maps).map((name) => new Option(name, name)));
    by("history").append(...meta.histories.map(({table, name, unit}, k) => new Option(`${name}${unitOf(unit)}, ${table}`, k)));
    by("of_tables").hidden = !meta.histories.length;
    by("time_row").style.display = this.frames.length > 1 ? "" : "none";
    by("report").replaceChildren(...(meta.report || []).map(rowOf));
    by("report").className = (meta.report || []).some(([, text]) => text.startsWith("refused")) ? "refused" : "";
    const every = meta.stride > 1 ? `, one in ${meta.stride}` : "";
    by("summary").textContent = `${meta.counts[0]} particles${every}, ${this.frames.length} ${this.frames.length > 1 ? "states" : "state"}`;
    by("help").textContent = (meta.dimension === 2 ? "Drag to move, wheel or two fingers to zoom, click a particle. "
                                                   : "Drag to turn, with Shift or two fingers to move, wheel or two fingers to zoom, click a particle. ") +
        "Keys: arrows, Home and End for the time, space to play, + and - to zoom, 0 to see all, C field, M colours, W walls, P picture.";
  }
  listen() {
    by("slider").oninput = () => this.show(Number(by("slider").value));
    by("scalar").onchange = () => (this.scalar = Number(by("scalar").value), this.show(this.number));
    by("map").onchange = () => (this.map = by("map").value, this.show(this.number));
    by("fit").onclick = () => this.seeAll();
    by("picture").onclick = () => this.savePicture();
    window.onkeydown = (event) => this.key(event);
    by("walls").onchange = () => this.show(this.number);
    by("history").onchange = () => this.drawCurves();
    for (const [k, id] of ["from", "to"].entries())
      by(id).onchange = () => this.scalar >= 0 && (this.colours[this.scalar][k] = Number(by(id).value), this.show(this.number));
    by("play").onclick = () => this.play();
    window.onresize = () => this.show(this.number);
    window.onhashchange = () => this.followAddress();
    const canvas = by("particles");
    const fingers = new Map(), view = this.particles;
    let moved = 0;
    canvas.onpointerdown = (event) => {
      if (!fingers.size) moved = 0;
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      canvas.setPointerCapture(event.pointerId);
    };
    canvas.onpointermove = (event) => {
      const last = fingers.get(event.pointerId);
      if (!last) return;
      const now = [event.clientX, event.clientY], [dx, dy] = [(now[0] - last[0]) / fingers.size, (now[1] - last[1]) / fingers.size];
      moved += Math.abs(dx) + Math.abs(dy);
      const other = [...fingers].find(([id]) => id !== event.pointerId);
      if (other) {
        const apart = ([x, y]) => Math.hypot(x - other[1][0], y - other[1][1]);
        this.zoomBy(apart(now) / Math.max(apart(last), 1));
      }
      if (this.meta.dimension === 3 && !event.shiftKey && !other)
        view.turn -= dx * 0.008, view.tilt = Math.min(Math.max(view.tilt + dy * 0.008, -1.5), 1.5);
      else view.shift[0] += 2 * dx / canvas.clientWidth, view.shift[1] -= 2 * dy / canvas.clientHeight;
      fingers.set(event.pointerId, now);
      view.draw();
    };
    canvas.onpointerup = (event) => {
      fingers.delete(event.pointerId);
      const box = canvas.getBoundingClientRect();
      if (moved < 4 && !fingers.size) this.pick(view.at(event.clientX - box.left, event.clientY - box.top));
    };
    canvas.onpointercancel = (event) => fingers.delete(event.pointerId);
    canvas.onwheel = (event) => (event.preventDefault(), this.zoomBy(Math.exp(-event.deltaY * 0.001)));
    canvas.ondblclick = () => this.seeAll();
  }
  zoomBy(factor) {
    const view = this.particles;
    view.zoom *= factor;
    view.shift = view.shift.map((s) => s * factor);
    view.draw();
  }
  seeAll() {
    this.particles.lookAtAll();
    this.particles.draw();
  }
  key(event) {
    if (event.target.closest && event.target.closest("input[type=number], select") || event.ctrlKey || event.metaKey || event.altKey) return;
    const last = this.frames.length - 1, next = (list, now) => list[(list.indexOf(now) + 1) % list.length];
    const keys = {
      ArrowLeft: () => this.show(Math.max(this.number - 1, 0)), ArrowRight: () => this.show(Math.min(this.number + 1, last)),
      Home: () => this.show(0), End: () => this.show(last), " ": () => last && this.play(), "+": () => this.zoomBy(1.25),
      "-": () => this.zoomBy(0.8), 0: () => this.seeAll(), p: () => this.savePicture(),
      w: () => (by("walls").checked = !by("walls").checked, this.show(this.number)),
      c: () => (this.scalar = next([...by("scalar").options].map((each) => Number(each.value)), this.scalar), this.show(this.number)),
      m: () => (this.map = next(Object.keys(maps), this.map), this.show(this.number)),
    };
    const act = keys[event.key] || keys[event.key.toLowerCase()];
    if (!act || (event.key === " " && event.target.tagName === "BUTTON")) return;
    event.preventDefault();
    act();
  }
  // The particles with axes, legend, title and time, as a canvas.
  picture() {
    this.particles.draw();
    const dots = window.devicePixelRatio || 1, source = by("particles"), head = 58, width = source.clientWidth;
    const canvas = Object.assign(document.createElement("canvas"), {width: source.width, height: source.height + head * dots});
    const pen = canvas.getContext("2d");
    pen.fillStyle = "#fff";
    pen.fillRect(0, 0, canvas.width, canvas.height);
    for (const each of [source, by("axes")]) pen.drawImage(each, 0, head * dots);
    pen.scale(dots, dots);
    pen.fillStyle = "#222";
    pen.font = "bold 14px sans-serif";
    pen.fillText(this.meta.title, 8, 18, width - 16);
    pen.font = "12px sans-serif";
    pen.fillText(`t = ${by("clock").textContent}`, 8, 40);
    const left = Math.max(width - 330, 90), bar = Math.min(width - left - 8, 200);
    pen.fillText(by("legend_name").textContent, left, 34, width - left - 8);
    if (this.scalar >= 0) {
      pen.drawImage(by("bar"), left, 38, bar, 8);
      const [low, high] = this.colours[this.scalar];
      pen.fillText(short(low), left, 57);
      pen.textAlign = "right";
      pen.fillText(short(high), left + bar, 57);
    } else
      this.bodies.reduce((x, name, k) => {
        pen.fillStyle = `rgb(${ofBody(k).map(Math.round)})`;
        pen.fillRect(x, 40, 10, 10);
        pen.fillStyle = "#222";
        pen.fillText(name, x + 14, 50);
        return x + 24 + pen.measureText(name).width;
      }, left);
    return canvas;
  }
  savePicture() {
    this.picture().toBlob((blob) => {
      const link = document.createElement("a");
      const name = `${this.meta.title.replace(/[^\w.-]+/g, "_").slice(0, 60)}_${String(this.number).padStart(3, "0")}.png`;
      Object.assign(link, {href: URL.createObjectURL(blob), download: name});
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }
  followAddress() {
    const wanted = new URLSearchParams(location.hash.slice(1));
    const scalar = this.meta.scalars.findIndex(({name}) => name === wanted.get("scalar"));
    if (scalar >= 0 || wanted.get("scalar") === "body") this.scalar = scalar;
    if (wanted.get("map") in maps) this.map = wanted.get("map");
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
    by("scalar").value = this.scalar;
    by("map").value = this.map;
    const of_body = this.scalar < 0, [low, high] = of_body ? [0, 1] : this.colours[this.scalar];
    this.drawLegend(low, high);
    this.particles.picked = this.placeOf(number);
    this.particles.useColours((k) => of_body ? ofBody(k).map(Math.round) : colour(this.map, k / 255));
    this.particles.show(number, of_body ? this.meta.dimension : this.first + this.scalar, [low, high], by("walls").checked, of_body);
    this.describe();
    this.drawCurves();
  }
  drawLegend(low, high) {
    const of_body = this.scalar < 0, ends = of_body ? this.bodies : [short(low), short(high)];
    by("legend_name").textContent = of_body ? "body" : this.nameOf(this.scalar);
    by("bar").style.display = of_body ? "none" : "";
    for (const [id, end] of [["from", low], ["to", high]]) by(id).value = short(end), by(id).disabled = of_body;
    by("map").disabled = of_body;
    by("ends").replaceChildren(...ends.map((text, k) => {
      const end = document.createElement("span");
      if (of_body) end.append(Object.assign(document.createElement("i"), {style: `background:rgb(${ofBody(k).map(Math.round)})`}));
      end.append(text);
      return end;
    }));
    const pen = by("bar").getContext("2d");
    for (let k = 0; k < 256; ++k) pen.fillStyle = `rgb(${colour(this.map, k / 255)})`, pen.fillRect(k, 0, 1, 1);
  }
  nameOf(k) {
    const {name, unit} = this.meta.scalars[k];
    return name.replaceAll("_", " ") + unitOf(unit);
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
    by("picked").replaceChildren(...rows.map(rowOf));
  }
  drawCurves() {
    const {meta} = this, time = meta.times[this.number], row = this.scalar < 0 ? meta.dimension : this.first + this.scalar;
    by("track").style.display = this.frames.length < 2 ? "none" : "";
    const values = this.frames.map((frame, k) => {
      const i = this.placeOf(k);
      return i < 0 || !this.meta.follows ? NaN : value(meta, frame, row, i);
    });
    plot(by("track"), meta.times, values, time, this.identity === null ? "" : !this.meta.follows ?
           "To follow particles that come and go, write the field identity." : `${this.scalar < 0 ? "body" : this.nameOf(this.scalar)} over time (s)`);
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
