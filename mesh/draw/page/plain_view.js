// SPDX-License-Identifier: MIT
// Draws the mesh on a canvas in two dimensions, slowly, where there is no WebGL 2.

const mostPlain = 100000;  // triangles of a picture: those in sight beyond these are left out

function paintPlain(context, camera, mesh, t) {
  const { positions: p, triangles } = mesh;
  context.beginPath();
  for (let i = 0; i < 3; ++i) {
    const v = triangles[3 * t + i], at = camera.toPage(p[2 * v], p[2 * v + 1]);
    context.lineTo(at.x * camera.ratio, at.y * camera.ratio);
  }
  context.closePath();
  context.fill();
}

function makePlainView(context, mesh, places) {
  const { canvas } = context;
  const paper = (on, look) => {
    on.fillStyle = css(look.paper.map((x) => 255 * x));
    on.fillRect(0, 0, canvas.width, canvas.height);
  };
  let shown = null;
  return {
    setMode(mode) { shown = mode; },
    fits: ({ kept }) => kept.width === canvas.width && kept.height === canvas.height,
    makePicture() {
      const kept = document.createElement("canvas");
      kept.width = canvas.width;
      kept.height = canvas.height;
      return { kept, context: kept.getContext("2d"), painted: 0, free() {} };
    },
    begin(picture, look) {
      picture.painted = 0;
      paper(picture.context, look);
    },
    add(picture, camera, look, some) {
      const on = picture.context;
      on.strokeStyle = css(look.edge.map((x) => 255 * x));
      on.lineWidth = 0.5 * camera.ratio;
      for (const { from, to } of some)
        for (let k = from; k < to && picture.painted < mostPlain; ++k, ++picture.painted) {
          on.fillStyle = css(shown.colour(shown.of(places.order[k])));
          paintPlain(on, camera, mesh, places.order[k]);
          if (look.edges) on.stroke();
        }
    },
    end() {},
    show(pictures, camera, look) {
      paper(context, look);
      for (const { kept, from } of pictures) {
        const zoom = camera.scale / from.scale, corner = camera.toPage(from.x, from.y);
        const x = corner.x - zoom * from.width / 2, y = corner.y - zoom * from.height / 2;
        context.drawImage(kept, x * camera.ratio, y * camera.ratio, zoom * kept.width, zoom * kept.height);
      }
    },
    finish: () => context.getImageData(0, 0, 1, 1),
  };
}
