/* A receiver on a line whose sender has a rate of its own.
 *
 * It does what an 8N1 receiver does: waits for a falling edge, looks half a
 * bit later whether that was a start bit, samples the middle of each of its
 * own bits, and waits for the next falling edge. So at another rate it hears
 * other bytes, more of them or fewer, as a real one does.
 */
#ifndef EAR_H
#define EAR_H

#include <stdbool.h>
#include <stdint.h>

#define EAR_NEVER UINT64_MAX

/* A byte on the line: start bit, eight data bits, stop bit. Times are in
 * 1/65536 of a cycle. */
typedef struct {
  uint64_t start, bit;
  uint64_t tag; /* of the caller's: handed back with what is heard */
  uint8_t byte;
} spoken_t;

typedef struct {
  spoken_t* spoken; /* what may still be looked at, oldest first */
  uint32_t first, count, room;
  uint64_t ready; /* a start bit may begin from here on */
  uint64_t start; /* of the byte that is being heard */
  uint64_t bit;   /* the receiver's, when that began */
  bool hearing;
} ear_t;

typedef struct {
  uint64_t at; /* the middle of the stop bit */
  uint64_t tag;
  uint8_t byte;
  bool whole; /* false: no stop bit, a framing error */
} heard_t;

/* A byte begins on the line. In their order. */
void ear_feed(ear_t* ear, spoken_t spoken);

/* When something will be decided, if nothing else is spoken before. */
uint64_t ear_next(const ear_t* ear, uint64_t bit);

/* Goes on to `now`, which nothing that is fed later may precede. Returns true
 * with a byte that was heard; to be called until it returns false. `bit`: of
 * the receiver. `started`: set if a start bit was seen. */
bool ear_hear(ear_t* ear, uint64_t now, uint64_t bit, heard_t* heard, bool* started);

void ear_free(ear_t* ear);

#endif
