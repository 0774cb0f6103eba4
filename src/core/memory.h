#pragma once

namespace drape {

// Keeps memory that is given back for the next time: each step asks for about as much as the last one gave
// back, and the system would have to clear its pages anew. Once, when a program starts.
void keep_freed_memory();

}  // namespace drape
