// What newlib's std::random_device would take its numbers from; the units have numbers of their own.
#include <stddef.h>

extern "C" int getentropy(void*, size_t) { return -1; }
