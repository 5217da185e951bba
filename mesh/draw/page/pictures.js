// SPDX-License-Identifier: MIT
// Decides what the canvas shows while a picture of the mesh takes longer than a frame to draw: kept
// pictures, moved and stretched. The exact picture is drawn in the meantime, a few chunks in each
// frame, so that the page stays responsive.

const longestFrame = 1 / 40, sliceSeconds = 0.012;

function makePictures(mesh, places, view) {
  const { chunks } = places;
  let latest = null, whole = null, spare = null;  // the last picture, one of the whole mesh, one to draw into
  let job = null, known = { seconds: 0, chunks: 0 };
  const inSight = (camera) => { const sight = camera.sight(); return chunks.filter(({ box }) => meet(box, sight)); };
  const holds = (a, b) => a.x0 <= b.x0 && a.y0 <= b.y0 && b.x1 <= a.x1 && b.y1 <= a.y1;
  const holdsMesh = ({ from }) => holds(from.sight(), mesh.box);
  const begin = (camera, look) => {
    if (spare !== null && !view.fits(spare)) spare.free();
    const picture = spare !== null && view.fits(spare) ? spare : view.makePicture();
    spare = null;
    Object.assign(picture, { from: camera.copy(), old: false });
    view.begin(picture, look);
    return { picture, look, left: inSight(camera), at: 0, slice: 1, seconds: 0, ofWhole: false };
  };
  // Draws the next chunks of a job; returns true when it is done.
  const draw = (to, count) => {
    const before = performance.now(), some = to.left.slice(to.at, to.at + count);
    view.add(to.picture, to.picture.from, to.look, some);
    to.at += some.length;
    const done = to.at >= to.left.length;
    if (done) view.end(to.picture, to.picture.from, to.look);
    view.finish();
    const seconds = (performance.now() - before) / 1000;
    to.seconds += seconds;
    to.slice = Math.max(1, Math.min(4 * count, Math.floor(count * sliceSeconds / Math.max(seconds, 1e-4))));
    return done;
  };
  const keep = ({ picture, left, seconds, ofWhole }) => {
    if (ofWhole) [whole, spare] = [picture, whole];
    else {
      known = { seconds, chunks: left.length };
      if (latest !== null && !latest.old && holdsMesh(latest)) [whole, spare] = [latest, whole];
      else spare = latest;
      latest = picture;
    }
  };
  const stop = () => {
    if (job !== null) spare = job.picture;
    job = null;
  };
  return {
    // Marks the kept pictures as outdated, as colours have changed.
    outdate() {
      stop();
      for (const one of [latest, whole]) if (one !== null) one.old = true;
    },
    get busy() { return job !== null; },
    get seconds() { return known.seconds; },
    // True if a picture of what the camera sees is expected to take less than a frame.
    quick: (camera) => latest !== null && known.seconds * Math.max(1, inSight(camera).length / Math.max(1, known.chunks)) < longestFrame,
    // Shows the latest picture, and where the view extends beyond it the picture of the whole mesh.
    show(camera, look) {
      const beyond = latest === null || !holds(latest.from.sight(), camera.sight());
      view.show([beyond ? whole : null, latest].filter((one) => one !== null), camera, look);
    },
    // Draws the camera's view at once.
    paint(camera, look) {
      stop();
      const now = begin(camera, look);
      draw(now, chunks.length);
      keep(now);
    },
    shows: (camera) => latest !== null && !latest.old && latest.from.sees(camera),
    start(camera, look) {
      stop();
      job = begin(camera, look);
    },
    // Starts a picture of the whole mesh, to be shown beyond the latest one, unless there is one.
    startWhole(camera, look) {
      if ((whole !== null && !whole.old) || holdsMesh(latest)) return;
      const far = camera.copy();
      far.fit();
      job = Object.assign(begin(far, look), { ofWhole: true });
    },
    stop,
    // Continues the picture that was started; returns true when one of the camera's view is
    // finished.
    step() {
      if (!draw(job, job.slice)) return false;
      const done = job;
      job = null;
      keep(done);
      return !done.ofWhole;
    },
  };
}
