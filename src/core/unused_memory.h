#pragma once

namespace cambrian {

// Gives memory that was freed back to the system, where the C library can (glibc). It takes about
// a millisecond. A program that runs for days calls it at times, because memory between what is
// still in use is not given back by itself.
void release_unused_memory();

}  // namespace cambrian
