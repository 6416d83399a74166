// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Axes with numbers, and a scale bar, over the particles.
"use strict";

// A length of 1, 2 or 5 times a power of ten, the largest one that is no longer than `most`.
function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map((n) => n * power).find((length) => length <= most * (1 + 1e-9)) || power;
}

function ticks(low, high, count) {
  const step = roundLength((high - low) / count * 2), found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) found.push(k * step);
  return found;
}

const trimmed = (x) => String(Number(x.toPrecision(6)));

class Axes {
  constructor(canvas, particles) {
    Object.assign(this, {canvas, particles});
  }
  draw() {
    const {canvas, particles} = this, dots = window.devicePixelRatio || 1;
    canvas.width = canvas.clientWidth * dots;
    canvas.height = canvas.clientHeight * dots;
    const pen = this.pen = canvas.getContext("2d");
    pen.scale(dots, dots);
    pen.font = "12px sans-serif";
    pen.lineWidth = 1;
    this.ticks = [];
    if (particles.dimension === 2) this.drawPlane();
    else this.drawSpace();
    this.drawBar();
  }
  text(words, x, y, align = "center") {
    const {pen} = this;
    pen.textAlign = align;
    pen.lineWidth = 3;
    pen.strokeStyle = "#ffffffd0";
    pen.strokeText(words, x, y);
    pen.lineWidth = 1;
    pen.fillStyle = "#333";
    pen.fillText(words, x, y);
  }
  line(...points) {
    const {pen} = this;
    pen.strokeStyle = "#555";
    pen.beginPath();
    points.forEach(([x, y], k) => k ? pen.lineTo(x, y) : pen.moveTo(x, y));
    pen.stroke();
  }
  // Along the lower and the left edge of the picture.
  drawPlane() {
    const {canvas, particles} = this, width = canvas.clientWidth, height = canvas.clientHeight, [left, low] = [44, height - 26];
    const scale = particles.pixelsPerMetre(), [x0, y0] = particles.projected([0, 0, 0]);
    this.line([left, 8], [left, low], [width - 8, low]);
    for (const x of ticks((left - x0) / scale, (width - 24 - x0) / scale, width / 60)) {
      const at = x0 + x * scale;
      this.line([at, low], [at, low + 4]);
      this.text(trimmed(x), at, low + 16);
      this.ticks.push(["x", x, at]);
    }
    for (const z of ticks((y0 - low) / scale, (y0 - 12) / scale, height / 50)) {
      const at = y0 - z * scale;
      this.line([left - 4, at], [left, at]);
      this.text(trimmed(z), left - 6, at + 4, "right");
      this.ticks.push(["z", z, at]);
    }
    this.text("x (m)", width - 8, low - 6, "right");
    this.text("z (m)", left + 6, 18, "left");
  }
  // The edges of a box around the material; numbers stand at three of them that meet nothing but the background.
  drawSpace() {
    const {particles} = this, box = particles.box, at = (p) => particles.projected(p);
    const corner = (k) => box.map(([low, high], a) => k >> a & 1 ? high : low);
    for (let k = 0; k < 8; ++k)
      for (let a = 0; a < 3; ++a)
        if (!(k >> a & 1)) this.pen.globalAlpha = 0.35, this.line(at(corner(k)), at(corner(k | 1 << a))), this.pen.globalAlpha = 1;
    const middle = at(box.map(([low, high]) => (low + high) / 2));
    ["x", "y", "z"].forEach((name, a) => {
      // Of the four edges along this axis, the lowest one in the picture, of z the leftmost one.
      const others = [0, 1, 2].filter((b) => b !== a);
      const starts = [0, 1, 2, 3].map((k) => (k & 1) << others[0] | (k >> 1) << others[1]);
      const place = (k) => {
        const [p, q] = [at(corner(k)), at(corner(k | 1 << a))];
        return a === 2 ? p[0] + q[0] : -(p[1] + q[1]);
      };
      const start = starts.reduce((best, k) => place(k) < place(best) ? k : best), from = corner(start);
      const [p, q] = [at(from), at(corner(start | 1 << a))], along = Math.hypot(q[0] - p[0], q[1] - p[1]);
      if (along < 40) return;
      this.line(p, q);
      let [nx, ny] = [-(q[1] - p[1]) / along, (q[0] - p[0]) / along];
      if (nx * ((p[0] + q[0]) / 2 - middle[0]) + ny * ((p[1] + q[1]) / 2 - middle[1]) < 0) [nx, ny] = [-nx, -ny];
      for (const value of ticks(...box[a], Math.max(along / 45, 1))) {
        const point = at(from.map((old, b) => b === a ? value : old));
        this.line(point, [point[0] + 4 * nx, point[1] + 4 * ny]);
        this.text(trimmed(value), point[0] + 18 * nx, point[1] + 14 * ny + 4);
        this.ticks.push([name, value, point]);
      }
      this.text(`${name} (m)`, (p[0] + q[0]) / 2 + 56 * nx, (p[1] + q[1]) / 2 + 40 * ny + 4);
    });
  }
  drawBar() {
    const {canvas, particles} = this, scale = particles.pixelsPerMetre(), length = roundLength(canvas.clientWidth * 0.25 / scale);
    const right = canvas.clientWidth - 16, y = canvas.clientHeight - (particles.dimension === 2 ? 52 : 16), left = right - length * scale;
    this.line([left, y - 4], [left, y], [right, y], [right, y - 4]);
    const unit = length < 1e-3 ? [1e6, "µm"] : length < 1 ? [1e3, "mm"] : length < 1e3 ? [1, "m"] : [1e-3, "km"];
    this.bar = `${trimmed(length * unit[0])} ${unit[1]}`;
    this.text(this.bar, (left + right) / 2, y - 6);
  }
}
