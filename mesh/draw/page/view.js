// SPDX-License-Identifier: MIT
// Draws the mesh by WebGL 2, or slowly by a plain canvas where there is none.

const fillVertex = `#version 300 es
precision highp float; precision highp int;
layout(location = 0) in uvec2 at;
layout(location = 1) in float shade;
uniform uvec2 centre;
uniform vec2 scale;
uniform sampler2D palette;
flat out vec3 colour;
out vec3 corner;
void main() {
  gl_Position = vec4(vec2(ivec2(at - centre)) * scale, 0.0, 1.0);
  colour = texelFetch(palette, ivec2(int(shade * 255.0 + 0.5), 0), 0).rgb;
  int i = gl_VertexID % 3;
  corner = vec3(i == 0, i == 1, i == 2);
}`;
// Edges lie where a barycentric coordinate is nearly 0; they fade where triangles are a few pixels.
const fillFragment = `#version 300 es
precision highp float;
flat in vec3 colour;
in vec3 corner;
uniform vec4 edge;
out vec4 result;
void main() {
  vec3 width = max(fwidth(corner), vec3(1e-12));
  vec3 pixels = corner / width;
  float nearest = min(min(pixels.x, pixels.y), pixels.z);
  float largest = max(max(width.x, width.y), width.z);
  float ink = (1.0 - smoothstep(0.3, 1.1, nearest)) * (1.0 - smoothstep(0.12, 0.5, largest));
  result = vec4(mix(colour, edge.rgb, ink * edge.a), 1.0);
}`;
const lineVertex = `#version 300 es
precision highp float; precision highp int;
layout(location = 0) in uvec4 ends;
uniform uvec2 centre;
uniform vec2 scale;
uniform vec2 pixel;
uniform float width;
void main() {
  vec2 a = vec2(ivec2(ends.xy - centre)) * scale, b = vec2(ivec2(ends.zw - centre)) * scale;
  vec2 along = normalize((b - a) / pixel + vec2(1e-9, 0.0));
  vec2 off = vec2(-along.y, along.x) * (float(gl_VertexID & 1) - 0.5) * width * pixel;
  gl_Position = vec4((gl_VertexID < 2 ? a : b) + off, 0.0, 1.0);
}`;
const lineFragment = `#version 300 es
precision highp float;
uniform vec4 edge;
out vec4 result;
void main() { result = edge; }`;

function makeProgram(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  const at = (name) => gl.getUniformLocation(program, name);
  return { program, at: Object.fromEntries(["centre", "scale", "pixel", "width", "edge", "palette"].map((n) => [n, at(n)])) };
}

function fill(gl, data) {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
  return buffer;
}

function makeFillArray(gl, mesh, order) {
  const corners = new Uint32Array(3 * mesh.count);
  order.forEach((t, k) => corners.set(mesh.triangles.subarray(3 * t, 3 * t + 3), 3 * k));
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  fill(gl, toFixed(mesh, corners));
  gl.enableVertexAttribArray(0);
  gl.vertexAttribIPointer(0, 2, gl.UNSIGNED_INT, 0, 0);
  const shades = fill(gl, new Uint8Array(3 * mesh.count));
  gl.enableVertexAttribArray(1);
  gl.vertexAttribPointer(1, 1, gl.UNSIGNED_BYTE, true, 0, 0);
  return { array, shades };
}

function makeLineArray(gl, mesh) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  fill(gl, toFixed(mesh, mesh.boundary));
  gl.enableVertexAttribArray(0);
  gl.vertexAttribIPointer(0, 4, gl.UNSIGNED_INT, 0, 0);
  gl.vertexAttribDivisor(0, 1);
  return array;
}

const numbersOfColour = (text) => {
  const digits = text.trim().slice(1);
  return [0, 2, 4].map((i) => parseInt(digits.slice(i, i + 2), 16) / 255);
};

// The two backends have: paint(camera, look), setMode(mode), and finish(), which waits for the picture.
function makeCardView(gl, mesh, places) {
  const { order, chunks } = places;
  const triangles = makeProgram(gl, fillVertex, fillFragment), lines = makeProgram(gl, lineVertex, lineFragment);
  const filled = makeFillArray(gl, mesh, order), edges = makeLineArray(gl, mesh);
  const palette = gl.createTexture();
  const use = (program, camera, ink) => {
    const { box } = mesh, sx = fixedRange / (box.x1 - box.x0), sy = fixedRange / (box.y1 - box.y0);
    gl.useProgram(program.program);
    gl.uniform2ui(program.at.centre, Math.round((camera.x - box.x0) * sx), Math.round((camera.y - box.y0) * sy));
    gl.uniform2f(program.at.scale, 2 * camera.scale / camera.width / sx, 2 * camera.scale / camera.height / sy);
    gl.uniform4f(program.at.edge, ...ink);
  };
  return {
    setMode(mode) {
      const shades = new Uint8Array(3 * mesh.count), colours = new Uint8Array(4 * 256);
      for (let k = 0; k < mesh.count; ++k) shades.fill(mode.of(order[k]), 3 * k, 3 * k + 3);
      for (let i = 0; i < 256; ++i) colours.set([...mode.colour(i).map(Math.round), 255], 4 * i);
      gl.bindBuffer(gl.ARRAY_BUFFER, filled.shades);
      gl.bufferData(gl.ARRAY_BUFFER, shades, gl.STATIC_DRAW);
      gl.bindTexture(gl.TEXTURE_2D, palette);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, colours);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    },
    paint(camera, look) {
      const { canvas } = gl, sight = camera.sight();
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(...look.paper, 1);
      gl.clear(gl.COLOR_BUFFER_BIT);
      gl.bindVertexArray(filled.array);
      gl.bindTexture(gl.TEXTURE_2D, palette);
      use(triangles, camera, [...look.edge, look.edges ? 0.75 : 0]);
      for (const { from, to, box } of chunks)
        if (meet(box, sight)) gl.drawArrays(gl.TRIANGLES, 3 * from, 3 * (to - from));
      gl.bindVertexArray(edges);
      use(lines, camera, [...look.ink, 1]);
      gl.uniform2f(lines.at.pixel, 2 / canvas.width, 2 / canvas.height);
      gl.uniform1f(lines.at.width, 2 * camera.ratio);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, mesh.boundary.length / 2);
    },
    finish: () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)),
  };
}

// Without a graphics card's interface: the same picture of what is in sight, at most a part of it.
function makePlainView(context, mesh, places) {
  const most = 100000;
  let shown = null;
  return {
    setMode(mode) { shown = mode; },
    paint(camera, look) {
      const { canvas } = context, { positions: p, triangles } = mesh, sight = camera.sight();
      context.fillStyle = css(look.paper.map((x) => 255 * x));
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.strokeStyle = css(look.edge.map((x) => 255 * x));
      context.lineWidth = 0.5 * camera.ratio;
      let painted = 0;
      for (const { from, to, box } of places.chunks) {
        if (!meet(box, sight)) continue;
        for (let k = from; k < to && painted < most; ++k, ++painted) {
          const t = places.order[k];
          context.beginPath();
          for (let i = 0; i < 3; ++i) {
            const v = triangles[3 * t + i], at = camera.toPage(p[2 * v], p[2 * v + 1]);
            context.lineTo(at.x * camera.ratio, at.y * camera.ratio);
          }
          context.closePath();
          context.fillStyle = css(shown.colour(shown.of(t)));
          context.fill();
          if (look.edges) context.stroke();
        }
      }
    },
    finish() {},
  };
}
