// SPDX-License-Identifier: MIT
// Has nothing of its own: a united build reads the headers of the test programs for it first.
