// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The data of the page, and particles drawn by WebGL.
// The states: for each one Uint16Array per row (positions, body, scalars).
async function unpack(meta, text) {
  let bytes = Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0));
  if (meta.packing !== "none") {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  }
  const half = bytes.length / 2, rows = meta.ranges.length, frames = [];
  let start = 0;
  meta.counts.forEach((count, k) => {
    const frame = [];
    for (let row = 0; row < rows; ++row) {
      const values = new Uint16Array(count);
      for (let i = 0; i < count; ++i) {
        values[i] = bytes[start + i] | (bytes[half + start + i] << 8);
        if (meta.continues[k]) values[i] += frames[k - 1][row][i];
      }
      start += count;
      frame.push(values);
    }
    frames.push(frame);
  });
  return frames;
}

function value(meta, frame, row, i) {
  const [low, high] = meta.ranges[row];
  return low + frame[row][i] / 65535 * (high - low);
}

// The box that the picture shows at first: around the material and all bodies but the walls, which are the second one, at all
// times, and around the walls as far as they are near.
function boxOf(meta, frames) {
  const axes = meta.dimension, none = () => Array.from({length: axes}, () => [Infinity, -Infinity]), boxes = [none(), none()];
  frames.forEach((frame, k) => {
    for (let a = 0; a < axes; ++a)
      for (let i = 0; i < frame[a].length; ++i) {
        const body = Math.round(value(meta, frame, axes, i)) === 1 ? 1 : 0;
        if (body && k) continue;  // walls of the first state
        const range = boxes[body][a], x = frame[a][i];
        if (x < range[0]) range[0] = x;
        if (x > range[1]) range[1] = x;
      }
  });
  const metres = (range, a) => range.map((x) => meta.ranges[a][0] + x / 65535 * (meta.ranges[a][1] - meta.ranges[a][0]));
  const [material, walls] = boxes.map((box) => box[0][0] <= box[0][1] ? box.map(metres) : null);
  const half = meta.spacing / 2, around = material || walls || meta.ranges.slice(0, axes);
  const reach = 0.6 * Math.max(...around.map(([low, high]) => high - low), 4 * meta.spacing);
  return around.map(([low, high], a) => walls
      ? [Math.min(low, Math.max(walls[a][0], low - reach)) - half, Math.max(high, Math.min(walls[a][1], high + reach)) + half]
      : [low - half, high + half]);
}

const vertexShader = `#version 300 es
in vec3 place; in float body; in float number;
uniform mat4 camera; uniform float size; uniform vec2 colours; uniform int picked; uniform bool walls, round, bodies; uniform sampler2D map;
out vec3 shade; flat out int marked;
void main() {
  gl_Position = camera * vec4(place, 1.0);
  gl_PointSize = max(size / gl_Position.w, 1.5);
  marked = gl_VertexID == picked ? 1 : 0;
  if (marked == 1) gl_PointSize = max(gl_PointSize * 1.6, 12.0);
  if (marked == 1 && !round) gl_Position.z = -0.9;  // before all others of a plane
  bool wall = body > 0.5;
  if (wall && round && marked == 0) gl_PointSize = max(gl_PointSize * 0.3, 1.0);  // the material is seen through a vessel
  float share = bodies ? (body + 0.5) / 256.0 : (number - colours.x) / (colours.y - colours.x);
  shade = wall && !bodies ? vec3(0.62) : texture(map, vec2(share, 0.5)).rgb;
  if (body > 0.5 && !walls) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;
const fragmentShader = `#version 300 es
precision highp float;
in vec3 shade; flat in int marked; out vec4 result;
uniform bool round;
// Of a sphere in front of the eye, from above on the left.
float light(vec3 normal) { return 0.45 + 0.55 * max(dot(normal, normalize(vec3(-0.4, 0.7, 0.8))), 0.0); }
void main() {
  vec2 at = vec2(gl_PointCoord.x * 2.0 - 1.0, 1.0 - gl_PointCoord.y * 2.0);
  float r = length(at);
  if (r > 1.0) discard;
  result = vec4(marked == 1 && r > 0.65 ? vec3(0.85, 0.1, 0.1) : round ? shade * light(vec3(at, sqrt(1.0 - r * r))) : shade, 1.0);
}`;

class Particles {
  constructor(canvas, meta, frames) {
    Object.assign(this, {canvas, meta, frames, dimension: meta.dimension, picked: -1});
    const gl = this.gl = canvas.getContext("webgl2", {preserveDrawingBuffer: true, antialias: true});
    if (!gl) throw new Error("This browser has no WebGL 2.");
    const program = this.program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    this.buffers = Object.fromEntries(["place", "body", "number"].map((name) => [name, gl.createBuffer()]));
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    this.box = boxOf(meta, frames);
    this.lookAtAll();
  }
  // 256 colours, by a function of their number that returns red, green and blue from 0 to 255.
  useColours(of) {
    const {gl} = this, colours = new Uint8Array(1024);
    for (let k = 0; k < 256; ++k) colours.set([...of(k), 255], 4 * k);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, colours);
  }
  lookAtAll() {
    const ranges = this.box;
    const plane = this.dimension === 2 ? [ranges[0], [0, 0], ranges[1]] : ranges;
    this.middle = plane.map(([low, high]) => (low + high) / 2);
    this.extent = plane.map(([low, high]) => Math.max(high - low, this.meta.spacing));
    this.radius = Math.hypot(...this.extent) / 2;
    // Beside the axes, in clip coordinates.
    this.margin = this.dimension === 2 ? [56 / Math.max(this.canvas.clientWidth, 100), 34 / Math.max(this.canvas.clientHeight, 100)] : [0, 0];
    Object.assign(this, {turn: this.dimension === 2 ? 0 : 0.6, tilt: this.dimension === 2 ? 0 : 0.35, zoom: 1, shift: [...this.margin]});
  }
  // World to clip coordinates, column by column. x to the right and z upwards; a plane without perspective.
  camera() {
    const {width, height} = this.canvas, aspect = width / height, flat = this.dimension === 2;
    const [besideX, besideZ] = this.margin.map((m) => 1 - m);
    const half = flat ? Math.max(this.extent[2] / 2 / besideZ, this.extent[0] / 2 / aspect / besideX) * 1.03 / this.zoom
                      : this.radius * Math.max(1.05, 1.35 / aspect) / this.zoom;
    const [c, s, ct, st] = [Math.cos(this.turn), Math.sin(this.turn), Math.cos(this.tilt), Math.sin(this.tilt)];
    const right = [c, s, 0], up = [-s * st, c * st, ct], away = [-s * ct, c * ct, -st];
    const far = 4 * this.radius, rows = [];
    const dot = (a) => -(a[0] * this.middle[0] + a[1] * this.middle[1] + a[2] * this.middle[2]);
    rows.push([...right.map((a) => a / (half * aspect)), dot(right) / (half * aspect) + this.shift[0]]);
    rows.push([...up.map((a) => a / half), dot(up) / half + this.shift[1]]);
    // With perspective w is the distance over that of the middle.
    const w = flat ? [0, 0, 0, 1] : [...away.map((a) => a / far), dot(away) / far + 1];
    if (!flat) [0, 1].forEach((k) => rows[k] = rows[k].map((a, j) => a + this.shift[k] * (w[j] - (j === 3 ? 1 : 0))));
    rows.push([...away.map((a) => a / (8 * this.radius)), dot(away) / (8 * this.radius)]);
    rows.push(w);
    return [0, 1, 2, 3].flatMap((column) => rows.map((row) => row[column])).concat(height / (2 * half));
  }
  // `bodies`: by the place of the body instead of the numbers in `row`.
  show(number, row, colours, walls, bodies) {
    Object.assign(this, {number, row, colours, walls, byBody: bodies});
    const frame = this.frames[number], count = frame[0].length, {meta, dimension} = this;
    const place = new Float32Array(3 * count), numbers = new Float32Array(count);
    for (let i = 0; i < count; ++i) {
      place[3 * i] = value(meta, frame, 0, i);
      place[3 * i + 1] = dimension === 2 ? 0 : value(meta, frame, 1, i);
      place[3 * i + 2] = value(meta, frame, dimension - 1, i);
      numbers[i] = value(meta, frame, row, i);
    }
    this.bodies = Float32Array.from(frame[dimension], (_, i) => value(meta, frame, dimension, i));
    this.places = place;
    this.fill("place", place, 3);
    this.fill("body", this.bodies, 1);
    this.fill("number", numbers, 1);
    this.draw();
  }
  fill(name, values, components) {
    const gl = this.gl, where = gl.getAttribLocation(this.program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name]);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(where);
    gl.vertexAttribPointer(where, components, gl.FLOAT, false, 0, 0);
  }
  draw() {
    const {gl, canvas, program} = this, dots = window.devicePixelRatio || 1;
    canvas.width = canvas.clientWidth * dots;
    canvas.height = canvas.clientHeight * dots;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const camera = this.camera(), at = (name) => gl.getUniformLocation(program, name);
    gl.uniformMatrix4fv(at("camera"), false, camera.slice(0, 16));
    gl.uniform1f(at("size"), camera[16] * this.meta.spacing * 1.05);
    gl.uniform2fv(at("colours"), this.colours);
    gl.uniform1i(at("picked"), this.picked);
    gl.uniform1i(at("walls"), this.walls ? 1 : 0);
    gl.uniform1i(at("round"), this.dimension === 3 ? 1 : 0);
    gl.uniform1i(at("bodies"), this.byBody ? 1 : 0);
    gl.drawArrays(gl.POINTS, 0, this.places.length / 3);
    if (this.afterwards) this.afterwards();
  }
  // Pixels of the page for a metre; in space at the middle of the box.
  pixelsPerMetre() {
    return this.camera()[16] / (window.devicePixelRatio || 1);
  }
  // Where a point (m) is in the picture, in pixels of the page, and its depth.
  projected(p) {
    const m = this.camera();
    const [x, y, z, w] = [0, 1, 2, 3].map((k) => m[k] * p[0] + m[4 + k] * p[1] + m[8 + k] * p[2] + m[12 + k]);
    return [(x / w + 1) / 2 * this.canvas.clientWidth, (1 - y / w) / 2 * this.canvas.clientHeight, z / w];
  }
  project(i) {
    return this.projected(this.places.subarray(3 * i, 3 * i + 3));
  }
  // The particle at a point of the picture: the nearest of those in front, or -1.
  at(x, y) {
    let best = -1, least = Infinity;
    const reach = Math.max(this.camera()[16] * this.meta.spacing * 0.6 / (window.devicePixelRatio || 1), 6);
    for (let i = 0; i < this.places.length / 3; ++i) {
      if (this.bodies[i] > 0.5 && !this.walls) continue;
      const [px, py, depth] = this.project(i), distance = Math.hypot(px - x, py - y);
      if (distance > reach) continue;
      const score = this.dimension === 2 ? distance : depth + distance / reach * 1e-3;
      if (score < least) [least, best] = [score, i];
    }
    return best;
  }
}
