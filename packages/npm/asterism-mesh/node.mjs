// SPDX-License-Identifier: MIT
import { readFile } from 'node:fs/promises';
import { create } from './api.mjs';

export const { mesh, verify, certify, version } = await create(await readFile(new URL('./mesh.wasm', import.meta.url)));
