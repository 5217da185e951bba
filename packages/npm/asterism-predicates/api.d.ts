// SPDX-License-Identifier: MIT
import type { Predicates } from './index.js';

/** Makes predicates of a compiled module or of the bytes of predicates.wasm: for pages that bring the
 * bytes along, for workers, and for instances with counters of their own. */
export declare function create(source: WebAssembly.Module | BufferSource): Promise<Predicates>;
/** Makes predicates of a compiled module, at once. Browsers may refuse that on the page's own thread. */
export declare function createSync(module: WebAssembly.Module): Predicates;
