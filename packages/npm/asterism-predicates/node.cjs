// SPDX-License-Identifier: MIT
'use strict';
const { readFileSync } = require('node:fs');
const { join } = require('node:path');
const { createSync } = require('./api.cjs');

module.exports = createSync(new WebAssembly.Module(readFileSync(join(__dirname, 'predicates.wasm'))));
