// SPDX-License-Identifier: MIT
// Reads the arrays of a mesh from the page's text: base64 of a zlib stream, each array as planes of
// bytes.

const element = (id) => document.getElementById(id);
const readJson = (id) => JSON.parse(element(id).textContent);

const kinds = { f64: Float64Array, f32: Float32Array, u32: Uint32Array, i32: Int32Array, u8: Uint8Array };

function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Returns the numbers of one array, joined from its planes of bytes.
function joinPlanes(planes, start, length, kind) {
  const size = kind.BYTES_PER_ELEMENT;
  const bytes = new Uint8Array(length * size);
  for (let k = 0; k < size; ++k)
    for (let i = 0, from = start + k * length, to = k; i < length; ++i, ++from, to += size)
      bytes[to] = planes[from];
  return new kind(bytes.buffer);
}

// Returns the arrays by name. All machines that browsers run on are little-endian, as the data is.
async function readArrays(facts) {
  const holder = element("data");
  const planes = await inflate(bytesOfBase64(holder.textContent));
  holder.textContent = "";
  const arrays = {};
  let start = 0;
  for (const { name, type, length } of facts.arrays) {
    arrays[name] = joinPlanes(planes, start, length, kinds[type]);
    start += length * kinds[type].BYTES_PER_ELEMENT;
  }
  return arrays;
}

// Returns the box of the positions. Its width and height are made positive where they are 0.
function boxOf(positions) {
  const box = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
  for (let i = 0; i < positions.length; i += 2) {
    box.x0 = Math.min(box.x0, positions[i]);
    box.x1 = Math.max(box.x1, positions[i]);
    box.y0 = Math.min(box.y0, positions[i + 1]);
    box.y1 = Math.max(box.y1, positions[i + 1]);
  }
  const least = Math.max(box.x1 - box.x0, box.y1 - box.y0) / 2 ** 20 || 1;
  if (!(box.x1 - box.x0 > least)) box.x1 = box.x0 + least;
  if (!(box.y1 - box.y0 > least)) box.y1 = box.y0 + least;
  return box;
}
