// SPDX-License-Identifier: MIT
//
// The functions of node.mjs for require(): they are asynchronous, and so is loading the module.
'use strict';
for (const name of ['mesh', 'verify', 'certify'])
  exports[name] = async (...given) => (await import('./node.mjs'))[name](...given);
