// Reads a word that lies as many bytes from where words lie as there are arguments.
#include <stdint.h>
#include <stdio.h>

alignas(4) static uint8_t bytes[8] = {1, 2, 3, 4, 5, 6, 7, 8};

int main(int count, char**) {
  const uint32_t* volatile place = reinterpret_cast<const uint32_t*>(bytes + count - 1);
  printf("%u", static_cast<unsigned>(*place));
}
