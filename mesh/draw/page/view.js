// SPDX-License-Identifier: MIT
// Draws the mesh by WebGL 2.

// Shader of triangles: one colour for each, or with `smooth` colours interpolated between the
// corners.
const fillVertex = (smooth) => `#version 300 es
precision highp float; precision highp int;
layout(location = 0) in uvec2 at;
layout(location = 1) in float shade;
uniform uvec2 centre;
uniform vec2 scale;
uniform sampler2D palette;
${smooth ? "out float place" : "flat out vec3 colour"};
out vec3 corner;
void main() {
  gl_Position = vec4(vec2(ivec2(at - centre)) * scale, 0.0, 1.0);
  ${smooth ? "place = shade" : "colour = texelFetch(palette, ivec2(int(shade * 255.0 + 0.5), 0), 0).rgb"};
  int i = gl_VertexID % 3;
  corner = vec3(i == 0, i == 1, i == 2);
}`;
// Draws edges where a barycentric coordinate is nearly 0. They fade where triangles are a few
// pixels wide.
const fillFragment = (smooth) => `#version 300 es
precision highp float;
${smooth ? "in float place" : "flat in vec3 colour"};
in vec3 corner;
uniform vec4 edge;
uniform sampler2D palette;
out vec4 result;
void main() {
  ${smooth ? "vec3 colour = texelFetch(palette, ivec2(int(place * 255.0 + 0.5), 0), 0).rgb;" : ""}
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
// Shaders that draw a kept picture as a texture between four corners.
const copyVertex = `#version 300 es
precision highp float;
uniform vec4 place;
out vec2 within;
void main() {
  within = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(mix(place.xy, place.zw, within), 0.0, 1.0);
}`;
const copyFragment = `#version 300 es
precision highp float;
uniform sampler2D palette;
in vec2 within;
out vec4 result;
void main() { result = vec4(texture(palette, within).rgb, 1.0); }`;
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
  return { program, at: Object.fromEntries(["centre", "scale", "pixel", "width", "edge", "palette", "place"].map((n) => [n, at(n)])) };
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

function makeCardPicture(gl, width, height) {
  const texture = gl.createTexture(), frame = gl.createFramebuffer();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
  for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  return { texture, frame, width, height, free() { gl.deleteTexture(texture); gl.deleteFramebuffer(frame); } };
}

// Shows a kept picture of another view, moved and stretched to its place in the present view.
function copyPicture(gl, copier, picture, camera) {
  const { from } = picture, zoom = camera.scale / from.scale;
  const x = 2 * (from.x - camera.x) * camera.scale / camera.width, w = zoom * from.width / camera.width;
  const y = 2 * (from.y - camera.y) * camera.scale / camera.height, h = zoom * from.height / camera.height;
  gl.useProgram(copier.program);
  gl.bindTexture(gl.TEXTURE_2D, picture.texture);
  const filter = zoom === 1 ? gl.NEAREST : gl.LINEAR;
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
  gl.uniform4f(copier.at.place, x - w, y - h, x + w, y + h);
  gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
}

// Makes the view on the graphics card. Both kinds of view have these functions: setMode(mode)
// chooses the colours; makePicture() makes a kept picture of the canvas's size; fits(picture) is
// true if it has that size; begin, add and end draw the paper, some chunks and the boundary into a
// picture; show draws kept pictures on the canvas, the last on top; finish waits until all is
// drawn.
function makeCardView(gl, mesh, places) {
  const { order } = places;
  const flat = makeProgram(gl, fillVertex(false), fillFragment(false)), lines = makeProgram(gl, lineVertex, lineFragment);
  let triangles = flat, smooth = null;  // made when it is first wanted
  const copier = makeProgram(gl, copyVertex, copyFragment);
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
      if (mode.atVertex === undefined) for (let k = 0; k < mesh.count; ++k) shades.fill(mode.of(order[k]), 3 * k, 3 * k + 3);
      else for (let k = 0; k < 3 * mesh.count; ++k) shades[k] = mode.atVertex(mesh.triangles[3 * order[Math.floor(k / 3)] + k % 3]);
      triangles = mode.atVertex === undefined ? flat : smooth ??= makeProgram(gl, fillVertex(true), fillFragment(true));
      for (let i = 0; i < 256; ++i) colours.set([...mode.colour(i).map(Math.round), 255], 4 * i);
      gl.bindBuffer(gl.ARRAY_BUFFER, filled.shades);
      gl.bufferData(gl.ARRAY_BUFFER, shades, gl.STATIC_DRAW);
      gl.bindTexture(gl.TEXTURE_2D, palette);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, colours);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    },
    fits: ({ width, height }) => width === gl.canvas.width && height === gl.canvas.height,
    makePicture: () => makeCardPicture(gl, gl.canvas.width, gl.canvas.height),
    begin(picture, look) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, picture.frame);
      gl.viewport(0, 0, picture.width, picture.height);
      gl.clearColor(...look.paper, 1);
      gl.clear(gl.COLOR_BUFFER_BIT);
    },
    add(picture, camera, look, some) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, picture.frame);
      gl.bindVertexArray(filled.array);
      gl.bindTexture(gl.TEXTURE_2D, palette);
      use(triangles, camera, [...look.edge, look.edges ? 0.75 : 0]);
      for (const { from, to } of some) gl.drawArrays(gl.TRIANGLES, 3 * from, 3 * (to - from));
    },
    end(picture, camera, look) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, picture.frame);
      gl.bindVertexArray(edges);
      use(lines, camera, [...look.ink, 1]);
      gl.uniform2f(lines.at.pixel, 2 / picture.width, 2 / picture.height);
      gl.uniform1f(lines.at.width, 2 * camera.ratio);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, mesh.boundary.length / 2);
    },
    show(pictures, camera, look) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.viewport(0, 0, gl.canvas.width, gl.canvas.height);
      gl.clearColor(...look.paper, 1);
      gl.clear(gl.COLOR_BUFFER_BIT);
      gl.bindVertexArray(null);
      for (const picture of pictures) copyPicture(gl, copier, picture, camera);
    },
    finish: () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)),
  };
}
