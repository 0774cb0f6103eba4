#include "core/memory.h"

#include <malloc.h>

namespace drape {

void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // bytes; the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

}  // namespace drape
