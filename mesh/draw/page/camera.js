// SPDX-License-Identifier: MIT
// Holds the view of the mesh: the middle in the mesh's coordinates, and the scale in pixels of the
// page for each unit.

class Camera {
  constructor(box) {
    Object.assign(this, { box, x: 0, y: 0, scale: 1, width: 1, height: 1, ratio: 1 });
  }
  copy() { return Object.assign(new Camera(this.box), this); }
  sees({ x, y, scale, width, height, ratio }) {
    return x === this.x && y === this.y && scale === this.scale && width === this.width && height === this.height &&
      ratio === this.ratio;
  }
  fit() {
    const { box } = this;
    this.x = (box.x0 + box.x1) / 2;
    this.y = (box.y0 + box.y1) / 2;
    this.scale = 0.94 * Math.min(this.width / (box.x1 - box.x0), this.height / (box.y1 - box.y0));
  }
  // Takes the size of the picture. A view of the whole mesh stays one.
  measure(holder) {
    const { width, height } = holder.getBoundingClientRect(), fitted = this.copy();
    fitted.fit();
    const whole = this.sees(fitted);
    this.ratio = window.devicePixelRatio || 1;
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    if (whole) this.fit();
  }
  toPage(x, y) {
    return { x: (x - this.x) * this.scale + this.width / 2, y: this.height / 2 - (y - this.y) * this.scale };
  }
  toMesh(x, y) {
    return { x: this.x + (x - this.width / 2) / this.scale, y: this.y - (y - this.height / 2) / this.scale };
  }
  sight() {
    const w = this.width / this.scale / 2, h = this.height / this.scale / 2;
    return { x0: this.x - w, x1: this.x + w, y0: this.y - h, y1: this.y + h };
  }
  keep() {
    const { box } = this, clamp = (x, low, high) => Math.max(low, Math.min(high, x));
    const whole = Math.min(this.width / (box.x1 - box.x0), this.height / (box.y1 - box.y0));
    const finest = fixedRange / 8 / Math.max(box.x1 - box.x0, box.y1 - box.y0);
    this.scale = clamp(this.scale, whole / 4, finest);
    this.x = clamp(this.x, box.x0, box.x1);
    this.y = clamp(this.y, box.y0, box.y1);
  }
  zoom(factor, x = this.width / 2, y = this.height / 2) {
    const held = this.toMesh(x, y);
    this.scale *= factor;
    const now = this.toMesh(x, y);
    this.x += held.x - now.x;
    this.y += held.y - now.y;
    this.keep();
  }
  move(x, y) {
    this.x -= x / this.scale;
    this.y += y / this.scale;
    this.keep();
  }
  // Centres the view on a box, and zooms so that the view is eight times as wide and high as it.
  show(target) {
    const { box } = this, room = 8, least = Math.max(box.x1 - box.x0, box.y1 - box.y0) * 1e-9;
    const w = Math.max(least, target.x1 - target.x0), h = Math.max(least, target.y1 - target.y0);
    this.x = (target.x0 + target.x1) / 2;
    this.y = (target.y0 + target.y1) / 2;
    this.scale = Math.min(this.width / w, this.height / h) / room;
    this.keep();
  }
}
