// SPDX-License-Identifier: MIT
// Draws the triangles on the graphics card, or else on a canvas in two dimensions, the farthest
// first.

// Returns arrays in which no two triangles share a corner, so that each has its own normal and
// colour.
function makeCorners(arrays) {
  const { positions, triangles } = arrays, count = triangles.length / 3;
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const v of triangles)
    for (let k = 0; k < 3; ++k) {
      low[k] = Math.min(low[k], positions[3 * v + k]);
      high[k] = Math.max(high[k], positions[3 * v + k]);
    }
  const size = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2 || 1;
  const at = new Float32Array(9 * count), normals = new Float32Array(9 * count), angles = new Float32Array(count);
  for (let t = 0; t < count; ++t) {
    for (let k = 0; k < 3; ++k)
      for (let n = 0; n < 3; ++n)
        at[9 * t + 3 * k + n] = (positions[3 * triangles[3 * t + k] + n] - (low[n] + high[n]) / 2) / size;
    const p = [0, 1, 2].map((k) => [0, 1, 2].map((n) => positions[3 * triangles[3 * t + k] + n]));
    const normal = cross(minus(p[1], p[0]), minus(p[2], p[0])), length = Math.hypot(...normal) || 1;
    for (let k = 0; k < 9; ++k) normals[9 * t + k] = normal[k % 3] / length;
    angles[t] = Math.min(...[0, 1, 2].map((k) => angleAt(p[k], p[(k + 1) % 3], p[(k + 2) % 3])));
  }
  return { at, normals, angles, count, faces: arrays.faces };
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
function angleAt(p, q, r) {
  const a = minus(q, p), b = minus(r, p);
  return Math.atan2(Math.hypot(...cross(a, b)), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180 / Math.PI;
}

// Returns the colour of a patch. Hues of successive patches are a golden ratio of the circle apart.
function colourOfPatch(face) {
  const hue = (0.58 + face * 0.618034) % 1 * 6, part = (n) => {
    const k = (n + hue) % 6;
    return 0.78 - 0.30 * Math.max(0, Math.min(k, 4 - k, 1));
  };
  return [part(5), part(3), part(1)];
}

function colourOfAngle(degrees) {
  const stops = [[0.70, 0.15, 0.12], [0.90, 0.74, 0.31], [0.27, 0.55, 0.78]];
  const x = Math.min(1, degrees / 60) * 2, k = x < 1 ? 0 : 1;
  return [0, 1, 2].map((n) => stops[k][n] + (x - k) * (stops[k + 1][n] - stops[k][n]));
}

function coloursOf(corners, mode) {
  const colours = new Float32Array(9 * corners.count);
  for (let t = 0; t < corners.count; ++t) {
    const one = mode === "patch" ? colourOfPatch(corners.faces[t] ?? 0)
      : mode === "angle" ? colourOfAngle(corners.angles[t]) : [0.55, 0.63, 0.72];
    for (let k = 0; k < 9; ++k) colours[9 * t + k] = one[k % 3];
  }
  return colours;
}

const vertexShader = `#version 300 es
in vec3 at, normal, colour, edge;
uniform mat3 turn;
uniform vec2 shift, scale;
out vec3 shade, beside;
void main() {
  vec3 p = turn * at, n = turn * normal;
  gl_Position = vec4((p.xy + shift) * scale, -p.z * 0.25, 1.0);
  float light = 0.38 + 0.62 * abs(dot(n, normalize(vec3(0.3, 0.5, 0.9))));
  shade = colour * light * (n.z < 0.0 ? 0.72 : 1.0);
  beside = edge;
}`;
const pixelShader = `#version 300 es
precision highp float;
in vec3 shade, beside;
uniform vec3 line;
uniform float edges;
out vec4 pixel;
void main() {
  vec3 width = fwidth(beside);
  vec3 near = smoothstep(vec3(0.1), vec3(1.1), beside / max(width, vec3(1e-9)));
  // Fades lines on triangles of few pixels, which lines alone would cover.
  float fade = 1.0 - smoothstep(0.1, 0.5, max(width.x, max(width.y, width.z)));
  float on = (1.0 - min(near.x, min(near.y, near.z))) * edges * 0.75 * fade;
  pixel = vec4(mix(shade, line, on), 1.0);
}`;

function makeProgram(gl) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, pixelShader]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}

function makeCardDrawing(gl, corners) {
  const program = makeProgram(gl), edge = new Float32Array(9 * corners.count);
  for (let t = 0; t < corners.count; ++t) for (let k = 0; k < 3; ++k) edge[9 * t + 4 * k] = 1;
  const buffers = {};
  const give = (name, numbers) => {
    buffers[name] ??= gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers[name]);
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
    const place = gl.getAttribLocation(program, name);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
  };
  give("at", corners.at);
  give("normal", corners.normals);
  give("edge", edge);
  const uniform = (name) => gl.getUniformLocation(program, name);
  return {
    colour(colours) { give("colour", colours); },
    paint(view) {
      gl.viewport(0, 0, view.width, view.height);
      gl.clearColor(...view.paper, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.DEPTH_TEST);
      gl.useProgram(program);
      const m = view.turn;
      gl.uniformMatrix3fv(uniform("turn"), false, [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]]);
      gl.uniform2f(uniform("shift"), view.x / view.zoom, view.y / view.zoom);
      gl.uniform2f(uniform("scale"), view.zoom * view.across, view.zoom * view.up);
      gl.uniform3f(uniform("line"), ...view.line);
      gl.uniform1f(uniform("edges"), view.edges ? 1 : 0);
      gl.drawArrays(gl.TRIANGLES, 0, 3 * corners.count);
    },
  };
}

function makePlainDrawing(context, corners) {
  let colours = null;
  const order = new Uint32Array(corners.count), depth = new Float32Array(corners.count);
  const text = (c, light) => `rgb(${c.map((x) => Math.round(255 * x * light)).join()})`;
  return {
    colour(given) { colours = given; },
    paint(view) {
      const m = view.turn, { at, normals } = corners;
      const row = (r, k) => m[3 * r] * at[k] + m[3 * r + 1] * at[k + 1] + m[3 * r + 2] * at[k + 2];
      for (let t = 0; t < corners.count; ++t) {
        order[t] = t;
        depth[t] = row(2, 9 * t) + row(2, 9 * t + 3) + row(2, 9 * t + 6);
      }
      order.sort((a, b) => depth[a] - depth[b]);
      context.fillStyle = text(view.paper, 1);
      context.fillRect(0, 0, view.width, view.height);
      context.strokeStyle = text(view.line, 1);
      for (const t of order) {
        context.beginPath();
        for (let k = 0; k < 3; ++k) {
          const x = (row(0, 9 * t + 3 * k) * view.zoom + view.x) * view.across;
          const y = (row(1, 9 * t + 3 * k) * view.zoom + view.y) * view.up;
          context[k === 0 ? "moveTo" : "lineTo"]((1 + x) * view.width / 2, (1 - y) * view.height / 2);
        }
        context.closePath();
        const n = [0, 1, 2].map((r) => m[3 * r] * normals[9 * t] + m[3 * r + 1] * normals[9 * t + 1] + m[3 * r + 2] * normals[9 * t + 2]);
        const light = 0.38 + 0.62 * Math.abs(0.28 * n[0] + 0.466 * n[1] + 0.839 * n[2]);
        context.fillStyle = text([...colours.slice(9 * t, 9 * t + 3)], light * (n[2] < 0 ? 0.72 : 1));
        context.fill();
        if (view.edges) context.stroke();
      }
    },
  };
}
