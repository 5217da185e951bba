// SPDX-License-Identifier: MIT
import type { Domain, Mesher } from './index.js';

/** Makes the functions over a compiled module or the bytes of mesh.wasm: for pages that bring the bytes along, and
 * for workers. */
export declare function create(source: WebAssembly.Module | BufferSource): Promise<Mesher>;
/** A domain given in numbers as a text in Triangle's .poly format. */
export declare function polyOf(domain: Exclude<Domain, string>): string;
