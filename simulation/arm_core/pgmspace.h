// Flash that is memory like any other, by the words of AVR.
#pragma once

#include <stdint.h>
#include <string.h>

#define PROGMEM
#define PSTR(text) (text)

#define pgm_read_byte(address) (*reinterpret_cast<const uint8_t*>(address))
#define pgm_read_word(address) (*reinterpret_cast<const uint16_t*>(address))
#define pgm_read_dword(address) (*reinterpret_cast<const uint32_t*>(address))
#define pgm_read_float(address) (*reinterpret_cast<const float*>(address))
#define pgm_read_ptr(address) (*reinterpret_cast<const void* const*>(address))
#define memcpy_P(to, from, size) memcpy((to), (from), (size))
#define memcmp_P(a, b, size) memcmp((a), (b), (size))
#define strcmp_P(a, b) strcmp((a), (b))
#define strncmp_P(a, b, size) strncmp((a), (b), (size))
#define strlen_P(text) strlen((text))
#define strcpy_P(to, from) strcpy((to), (from))
