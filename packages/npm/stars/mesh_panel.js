// SPDX-License-Identifier: MIT
//
// The program's own mesher and auditor (asterism-mesh), in a worker so that the page answers meanwhile: meshes,
// files to save, and the judgement of what was refined here or is dropped. Where the module is not in the page, it
// says so.
import { shadesOf } from './view.js';

const GLUE = `
let mesher;
onmessage = async ({ data }) => {
  try {
    mesher ??= await create(data.module);
    const began = performance.now(), result = await mesher[data.name](...data.given);
    postMessage({ result, milliseconds: performance.now() - began });
  } catch (failure) {
    postMessage({ failure: failure.message });
  }
};`;

export class MeshPanel {
  constructor(page) {
    Object.assign(this, page);
    this.isThere = Boolean(this.element('mesher-module'));
    this.files = null;  // files of the last mesh, for saving
    this.build();
  }

  // --- The panel.

  make(name, properties = {}, ...children) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
  }
  button(id, text, does) {
    const made = this.make('button', { type: 'button', id, textContent: text });
    made.addEventListener('click', does);
    return made;
  }
  build() {
    const { make } = this, words = (text) => make('p', { className: 'soft', textContent: text }), parts = [];
    this.verdict = make('p', { id: 'mesh-verdict' });
    this.verdict.setAttribute('role', 'status');
    this.verdict.setAttribute('aria-live', 'polite');
    this.list = make('ul', { id: 'mesh-witnesses' });
    this.saves = make('div', { className: 'group', id: 'saves' });
    if (this.isThere) {
      this.size = make('input', { type: 'number', id: 'mesh-size', min: '0', step: 'any', value: '0.2', style: 'width:6em' });
      this.how = make('select', { id: 'mesh-how' }, ...[['fill', 'fill, then mend'], ['voronoi', 'Voronoi arcs'], ['darts', 'Poisson darts']].map(([value, textContent]) => make('option', { value, textContent })));
      parts.push(words('The program’s mesher and its auditor are in this page too. An edge is to be as long as the size, in the metric; without a size only stars and angles count.'),
        make('p', { className: 'setting' }, make('label', {}, 'Size ', this.size), make('label', {}, 'by ', this.how)),
        make('div', { className: 'group' }, this.button('mesh-it', 'Mesh and certify', () => this.mesh()), this.button('judge-it', 'Have what is refined here judged', () => this.judgeRefined()),
          this.button('leave-mesh', 'Back to the stars', () => this.leaveMesh())));
    } else parts.push(words('The mesher and its auditor (asterism-mesh) are not in this page: what is made here is not certified. Save it and ask the program: asterism certify stars.mesh'));
    parts.push(this.verdict, this.list, this.saves);
    if (this.isThere) parts.push(this.dropping());
    this.element('mesher').replaceChildren(...parts);
    this.offer(null);
  }
  dropping() {
    const input = this.make('input', { type: 'file', id: 'dropped', multiple: true });
    const zone = this.make('div', { id: 'drop' }, this.make('label', {}, 'Drop NAME.mesh, NAME.sol and NAME.certificate.json here to have them verified, or choose them: ', input));
    input.addEventListener('change', () => this.verifyFiles([...input.files]));
    zone.addEventListener('dragover', (event) => { event.preventDefault(); zone.className = 'over'; });
    zone.addEventListener('dragleave', () => { zone.className = ''; });
    zone.addEventListener('drop', (event) => { event.preventDefault(); zone.className = ''; this.verifyFiles([...event.dataTransfer.files]); });
    return zone;
  }
  offer(files) {
    this.files = files;
    this.saves.replaceChildren(...Object.keys(files ?? {}).map((name) => this.button(`save-${name}`, `Save ${name}`, () => this.save(name))));
  }
  save(name) {
    const link = this.make('a', { href: URL.createObjectURL(new Blob([this.files[name]])), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
  tell(badge, isGood, words, witnesses = []) {
    this.verdict.replaceChildren(this.make('span', { className: `badge ${isGood ? 'good' : 'bad'}`, textContent: badge }), ` ${words}`);
    this.list.replaceChildren(...witnesses.slice(0, 6).map((textContent) => this.make('li', { textContent })));
  }

  // --- The worker.

  async ask(name, ...given) {
    if (!this.worker) {
      const url = URL.createObjectURL(new Blob([this.element('mesher-script').textContent + GLUE], { type: 'text/javascript' }));
      this.worker = new Worker(url);
      this.module = await this.moduleOf('mesher-module');
    }
    this.verdict.textContent = 'At work ...';
    const { result, failure, milliseconds } = await new Promise((resolve) => {
      this.worker.onmessage = ({ data }) => resolve(data);
      this.worker.onerror = (event) => resolve({ failure: event.message });
      this.worker.postMessage({ module: this.module, name, given });
    });
    if (failure) throw new Error(failure);
    return { ...result, milliseconds };
  }
  async guarded(does) {
    if (this.isBusy) return;
    this.isBusy = true;
    try {
      await does();
    } catch (failure) {
      this.tell('refused', false, failure.message);
    }
    this.isBusy = false;
  }
  display({ sites, triangles }) {
    if (triangles.length) this.showMesh({ sites, triangles, shades: shadesOf(sites, triangles) });
  }

  mesh() {
    return this.guarded(async () => {
      const domain = this.domain(), metric = this.metric(), size = Number(this.size.value);
      if (!domain || !metric) throw new Error('this scene has no border, or no field: draw a polygon, or choose a scene with a square');
      if (this.size.value !== '' && !(size > 0)) throw new Error(`a size of ${this.size.value}`);
      const options = { angleBound: this.state.angleBound, refine: this.how.value, ...(this.size.value === '' ? {} : { size }) };
      const made = await this.ask('mesh', domain, metric, options);
      this.tell(made.certified ? 'certified' : 'not certified', made.certified,
        `${made.sites.length / 5} sites, ${made.triangles.length / 3} triangles, worst angle ${made.worstAngle.toFixed(2)}°, ${(made.milliseconds / 1000).toFixed(2)} s. ${made.certified ? '' : made.reason}`, made.witnesses);
      this.offer({ 'stars.mesh': made.files.mesh, 'stars.sol': made.files.solution, 'stars.certificate.json': made.files.certificate });
      this.display(made);
    });
  }
  judgeRefined() {
    return this.guarded(async () => {
      if (!this.state.set.boundary) throw new Error('there is no border: refine a step, or draw a polygon');
      const files = this.texts(), made = await this.ask('certify', files, { angleBound: this.state.angleBound });
      this.tell(made.certified ? 'certified' : 'not certified', made.certified,
        `The auditor, of ${made.sites.length / 5} sites and ${made.triangles.length / 3} triangles: worst angle ${made.worstAngle.toFixed(2)}°.`, made.witnesses);
      this.offer({ 'stars.mesh': files.mesh, 'stars.sol': files.solution, ...(made.certificate ? { 'stars.certificate.json': made.certificate } : {}) });
    });
  }
  verifyFiles(dropped) {
    return this.guarded(async () => {
      const find = (ending) => dropped.find(({ name }) => name.endsWith(ending)), mesh = find('.mesh'), solution = find('.sol'), certificate = find('.json');
      if (!mesh || !solution) throw new Error('takes NAME.mesh and NAME.sol together, and NAME.certificate.json if there is one');
      const files = { mesh: await mesh.text(), solution: await solution.text() };
      const made = certificate ? await this.ask('verify', { ...files, certificate: await certificate.text() }) : await this.ask('certify', files, { angleBound: this.state.angleBound });
      this.tell(made.certified ? 'certified' : 'refused', made.certified,
        `${mesh.name}${certificate ? ', by its certificate' : `, for ${this.state.angleBound}°, its domain what it covers`}: ${made.triangles.length / 3} triangles, worst angle ${made.worstAngle.toFixed(2)}°.`, made.witnesses);
      this.display(made);
    });
  }
  /** What was refined by the page's own steps may be saved, and judged. */
  refined(state, isDone) {
    if (!isDone) return;
    const files = this.texts();
    this.offer({ 'stars.mesh': files.mesh, 'stars.sol': files.solution });
    this.verdict.textContent = this.isThere ? 'Refined, and not judged yet.' : '';
    this.list.replaceChildren();
  }

  /** Medit's text formats; the fewest digits are the double again. */
  texts() {
    const { set } = this.state, { triangles } = set.agreement(), line = (...words) => words.join(' ');
    const edges = set.boundary.map((v, i) => line(v + 1, set.boundary[(i + 1) % set.boundary.length] + 1, 1));
    const mesh = ['MeshVersionFormatted 2', 'Dimension 2', 'Vertices', set.sites.length, ...set.sites.map(([x, y]) => line(x, y, 0)),
                  'Edges', edges.length, ...edges, 'Triangles', triangles.length, ...triangles.map((t) => line(...t.map((v) => v + 1), 1)), 'End', ''];
    const solution = ['MeshVersionFormatted 2', 'Dimension 2', 'SolAtVertices', set.sites.length, '1 3', ...set.sites.map((s) => line(...s.slice(2))), 'End', ''];
    return { mesh: mesh.join('\n'), solution: solution.join('\n') };
  }
}
