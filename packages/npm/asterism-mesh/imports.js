// SPDX-License-Identifier: MIT
//
// Tells Emscripten's linker which function the module takes from whoever makes an instance (asterism-mesh's
// api.mjs): the metric at places. Nothing of this file is in the module.
mergeInto(LibraryManager.library, { metric() {} });
