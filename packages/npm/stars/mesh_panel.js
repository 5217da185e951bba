// SPDX-License-Identifier: MIT
//
// Meshes of the page's own refinement as files. The page has no auditor: it certifies nothing.
export class MeshPanel {
  constructor(page) {
    Object.assign(this, page);
    this.show(null);
  }

  show(refined) {
    const at = this.element('mesher'), words = document.createElement('p');
    words.className = 'soft';
    words.textContent = 'Draw a domain and refine it as the thesis does. The mesher and its auditor (asterism-mesh) are not in this page: '
      + 'what is made here is not certified. Save it and ask the program: asterism certify stars.mesh';
    const save = Object.assign(document.createElement('button'), { type: 'button', id: 'save-mesh', textContent: 'Save stars.mesh and stars.sol', disabled: !refined });
    save.addEventListener('click', () => this.save());
    at.replaceChildren(words, save);
  }
  refined(state, isDone) {
    this.show(isDone);
  }

  /** Medit's text formats; seventeen digits are the double again. */
  texts() {
    const { set } = this.state, { triangles } = set.agreement(), line = (...words) => words.join(' ');
    const edges = set.boundary.map((v, i) => line(v + 1, set.boundary[(i + 1) % set.boundary.length] + 1, 1));
    const mesh = ['MeshVersionFormatted 2', 'Dimension 2', 'Vertices', set.sites.length, ...set.sites.map(([x, y]) => line(x, y, 0)),
                  'Edges', edges.length, ...edges, 'Triangles', triangles.length, ...triangles.map((t) => line(...t.map((v) => v + 1), 1)), 'End', ''];
    const solution = ['MeshVersionFormatted 2', 'Dimension 2', 'SolAtVertices', set.sites.length, '1 3', ...set.sites.map((s) => line(...s.slice(2))), 'End', ''];
    return { mesh: mesh.join('\n'), solution: solution.join('\n') };
  }
  save() {
    const { mesh, solution } = this.texts();
    for (const [name, text] of [['stars.mesh', mesh], ['stars.sol', solution]]) {
      const link = Object.assign(document.createElement('a'), { href: URL.createObjectURL(new Blob([text])), download: name });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    }
  }
}
