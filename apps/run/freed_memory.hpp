// SPDX-License-Identifier: MIT
//
// Gives memory that is freed back to the system, where its C library can be told to.
#pragma once

namespace asterism::apps {

// Has blocks of 128 kilobytes or more given back as soon as they are freed. By itself the C library
// stops doing so after the first ones, and the parts of a run, each of which needs blocks of other
// sizes, then hold what no part uses any more: a tenth of all at a million triangles.
void give_back_large_blocks();

// Keeps blocks of up to four megabytes for the next ones instead: a page that is asked for anew
// takes the system one to ten microseconds, which is 4 % of the time for a mesh of 100,000
// triangles, where what is held in vain is little. For as long as the run is small: then
// give_back_large_blocks() again.
void keep_freed_blocks();

// Gives back what is free among small blocks, as far as it fills pages. Takes milliseconds.
void give_back_small_blocks();

}  // namespace asterism::apps
