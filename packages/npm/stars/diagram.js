// SPDX-License-Identifier: MIT
//
// Draws the anisotropic Voronoi diagram (definition 2 of the thesis): each point has the colour of
// the nearest site in the site's own metric. Computes in doubles, pixel by pixel: coarsely while
// something moves, then finer, some rows in each frame.

/** Soft colours, told apart where sites are near: the golden angle round the circle of hues. */
export function paletteOf(isDark) {
  const colours = [];
  for (let i = 0; i < 64; ++i) {
    const hue = (i * 137.508) % 360, light = isDark ? 0.2 + 0.05 * (i % 3) : 0.9 - 0.035 * (i % 3), chroma = isDark ? 0.2 : 0.5;
    const part = (n) => {
      const k = (n + hue / 30) % 12;
      return Math.round(255 * (light - chroma * Math.min(light, 1 - light) * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
    };
    colours.push([part(0), part(8), part(4)]);
  }
  return colours;
}

export class Diagram {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.key = '';
    this.pixel = 1;  // page pixels for one pixel of the canvas
  }

  /** Says what is to be drawn; what is drawn already stays until something differs. */
  ask(sites, view, version, palette) {
    const key = [version, view.width, view.height, view.centre, view.scale, palette[0]].join();
    if (key === this.key) return;
    this.key = key;
    Object.assign(this, { sites, view: { ...view, centre: [...view.centre] }, palette });
    const affordable = 900000 / Math.max(1, sites.length);  // pixels computed at once
    const coarse = Math.max(3, Math.ceil(Math.sqrt(view.width * view.height / affordable)));
    this.begin(coarse);
    this.rows(Infinity);
  }
  get isFinished() { return this.row >= this.height && this.step === this.finest; }

  begin(step) {
    const { view, sites } = this;
    this.finest = sites.length > 60 ? 2 : 1;
    this.step = step;
    this.width = Math.ceil(view.width / step);
    this.height = Math.ceil(view.height / step);
    this.owners = new Uint16Array(this.width * this.height);
    this.row = 0;
    this.flat = Float64Array.from(sites.flat());
  }

  /** Goes on for so many milliseconds. True if there is a new picture. */
  goOn(milliseconds) {
    if (this.isFinished) return false;
    if (this.row >= this.height) this.begin(this.finest);
    this.rows(performance.now() + milliseconds);
    return this.row >= this.height;
  }

  rows(end) {
    const { view, flat, step, width, height, owners } = this, count = flat.length;
    for (; this.row < height; ++this.row) {
      if (this.row % 4 === 0 && performance.now() > end) return;
      const y = view.centre[1] - ((this.row + 0.5) * step - view.height / 2) / view.scale;
      for (let column = 0; column < width; ++column) {
        const x = view.centre[0] + ((column + 0.5) * step - view.width / 2) / view.scale;
        let least = Infinity, owner = 0;
        for (let i = 0; i < count; i += 5) {
          const dx = x - flat[i], dy = y - flat[i + 1];
          const d = flat[i + 2] * dx * dx + 2 * flat[i + 3] * dx * dy + flat[i + 4] * dy * dy;
          if (d < least) least = d, owner = i;
        }
        owners[this.row * width + column] = owner / 5;
      }
    }
    this.paint();
  }

  // Draws the cells in their colours, with darker borders.
  paint() {
    const { canvas, width, height, owners, palette } = this;
    this.pixel = this.step;
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext('2d'), image = context.createImageData(width, height), { data } = image;
    for (let row = 0, at = 0; row < height; ++row)
      for (let column = 0; column < width; ++column, ++at) {
        const owner = owners[at];
        const isBorder = (column + 1 < width && owners[at + 1] !== owner) || (row + 1 < height && owners[at + width] !== owner);
        const [r, g, b] = palette[owner % palette.length], shade = isBorder ? 0.8 : 1;
        data[4 * at] = r * shade, data[4 * at + 1] = g * shade, data[4 * at + 2] = b * shade, data[4 * at + 3] = 255;
      }
    context.putImageData(image, 0, 0);
  }
}
