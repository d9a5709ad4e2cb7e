#include "Print.h"

namespace arduino {

size_t Print::write(const uint8_t* bytes, size_t size) {
  size_t written = 0;
  while (written < size && write(bytes[written]) == 1) ++written;
  return written;
}

size_t Print::print(unsigned long number, int base) {
  char digits[33];
  char* first = digits + sizeof(digits) - 1;
  *first = '\0';
  do {
    const unsigned digit = static_cast<unsigned>(number % static_cast<unsigned long>(base));
    *--first = static_cast<char>(digit < 10 ? '0' + digit : 'A' + digit - 10);
    number /= static_cast<unsigned long>(base);
  } while (number != 0);
  return write(first);
}

size_t Print::print(long number, int base) {
  if (number >= 0 || base != DEC) return print(static_cast<unsigned long>(number), base);
  return print('-') + print(0 - static_cast<unsigned long>(number), base);
}

size_t Print::print(double number, int decimals) {
  size_t size = 0;
  if (number < 0) {
    size += print('-');
    number = -number;
  }
  double step = 1;
  for (int i = 0; i < decimals; ++i) step *= 10;
  const unsigned long scaled = static_cast<unsigned long>(number * step + 0.5);
  unsigned long place = static_cast<unsigned long>(step);
  size += print(scaled / place);
  if (decimals > 0) size += print('.');
  for (unsigned long rest = scaled % place; place > 1; rest %= place) {
    place /= 10;
    size += print(static_cast<char>('0' + rest / place));
  }
  return size;
}

}  // namespace arduino
