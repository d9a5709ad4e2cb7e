#include "ear.h"

#include <stdlib.h>
#include <string.h>

static const spoken_t* spoken_at(const ear_t* ear, uint32_t n) { return &ear->spoken[ear->first + n]; }

static uint64_t end_of(const spoken_t* spoken) { return spoken->start + 10 * spoken->bit; }

/* Bit n of a byte on the line, the start bit being 0; high but for what it says. */
static bool level_of(const spoken_t* spoken, uint64_t n) { return n > 8 || (n > 0 && (spoken->byte >> (n - 1) & 1)); }

static bool level(const ear_t* ear, uint64_t at) {
  for (uint32_t n = ear->count; n-- > 0;) {
    const spoken_t* spoken = spoken_at(ear, n);
    if (at < spoken->start) continue;
    return level_of(spoken, (at - spoken->start) / spoken->bit);
  }
  return true;
}

static const spoken_t* byte_at(const ear_t* ear, uint64_t at) {
  const spoken_t* found = NULL;
  for (uint32_t n = 0; n < ear->count && spoken_at(ear, n)->start <= at; n++) found = spoken_at(ear, n);
  return found;
}

/* The first fall from high to low that is not before `from`. */
static uint64_t fall(const ear_t* ear, uint64_t from) {
  for (uint32_t n = 0; n < ear->count; n++) {
    const spoken_t* spoken = spoken_at(ear, n);
    if (end_of(spoken) <= from) continue;
    for (uint64_t bit = 0; bit < 9; bit++) {
      uint64_t at = spoken->start + bit * spoken->bit;
      bool was_high = bit == 0 || level_of(spoken, bit - 1);
      if (at >= from && was_high && !level_of(spoken, bit)) return at;
    }
  }
  return EAR_NEVER;
}

static void forget_before(ear_t* ear, uint64_t time) {
  while (ear->count > 0 && end_of(spoken_at(ear, 0)) <= time) {
    ear->first++;
    ear->count--;
  }
}

void ear_feed(ear_t* ear, spoken_t spoken) {
  if (ear->first + ear->count == ear->room) {
    if (ear->first > ear->count) {
      memmove(ear->spoken, ear->spoken + ear->first, ear->count * sizeof *ear->spoken);
      ear->first = 0;
    } else {
      ear->room = ear->room ? 2 * ear->room : 64;
      ear->spoken = realloc(ear->spoken, ear->room * sizeof *ear->spoken);
      if (ear->spoken == NULL) abort();
    }
  }
  ear->spoken[ear->first + ear->count++] = spoken;
}

uint64_t ear_next(const ear_t* ear, uint64_t bit) {
  if (ear->hearing) return ear->start + 9 * ear->bit + ear->bit / 2;
  uint64_t start = fall(ear, ear->ready);
  return start == EAR_NEVER ? EAR_NEVER : start + bit / 2;
}

bool ear_hear(ear_t* ear, uint64_t now, uint64_t bit, heard_t* heard, bool* started) {
  *started = false;
  while (!ear->hearing) {
    forget_before(ear, ear->ready);
    uint64_t start = fall(ear, ear->ready);
    if (start == EAR_NEVER || start + bit / 2 > now) return false;
    if (level(ear, start + bit / 2)) { /* too short: no start bit */
      ear->ready = start + bit / 2;
      continue;
    }
    ear->start = start;
    ear->bit = bit;
    ear->hearing = true;
    *started = true;
  }
  uint64_t last = ear->start + 9 * ear->bit + ear->bit / 2;
  if (last > now) return false;
  heard->at = last;
  heard->byte = 0;
  for (unsigned n = 1; n <= 8; n++) {
    heard->byte |= (uint8_t)(level(ear, ear->start + n * ear->bit + ear->bit / 2) << (n - 1));
  }
  heard->whole = level(ear, last);
  heard->tag = byte_at(ear, ear->start)->tag;
  ear->hearing = false;
  ear->ready = last;
  return true;
}

void ear_free(ear_t* ear) {
  free(ear->spoken);
  *ear = (ear_t){0};
}
