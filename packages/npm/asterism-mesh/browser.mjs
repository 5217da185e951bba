// SPDX-License-Identifier: MIT
import { create } from './api.mjs';

const response = await fetch(new URL('./mesh.wasm', import.meta.url));
if (!response.ok) throw new Error(`asterism-mesh: ${response.url}: ${response.status} ${response.statusText}`);
export const { mesh, verify, certify, version } = await create(await response.arrayBuffer());

