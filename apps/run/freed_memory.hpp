// SPDX-License-Identifier: MIT
//
// Gives freed memory back to the system, where the C library can be configured to do that.
#pragma once

namespace asterism::apps {

// Makes the C library give back blocks of 128 kilobytes or more as soon as they are freed. By
// default it stops doing so after the first ones, and the phases of a run, each of which needs
// blocks of other sizes, then keep memory that no phase uses any more: a tenth of all at a million
// triangles.
void give_back_large_blocks();

// Keeps all freed blocks for the next ones instead: a page that is requested anew takes the system
// one to ten microseconds. A pass of an adaptation with 100,000 vertices then has two fifths of the
// page faults, half of the system's time, which was a tenth of all, and 7 % more memory. The next
// two megabytes of small blocks are in one large page: 500 vertices have 380 page faults in all for
// 605. For small runs, and for local changes of meshes of any size, which need blocks of the same
// sizes again and again; other large runs call give_back_large_blocks() again.
void keep_freed_blocks();
// True from keep_freed_blocks() until give_back_large_blocks() is called.
bool keeps_freed_blocks();

// Gives back free small blocks where they fill whole pages. Takes milliseconds.
void give_back_small_blocks();

}  // namespace asterism::apps
