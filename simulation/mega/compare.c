/* Every instruction word, from a random state, by quick.c and by simavr. */
#include "mega.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  uint64_t cycle;
  uint32_t pc;
  int8_t interrupt_state;
  uint8_t sreg[8];
  uint8_t data[65536];
} state_t;

static void keep(const avr_t* avr, state_t* state) {
  state->cycle = avr->cycle;
  state->pc = avr->pc;
  state->interrupt_state = avr->interrupt_state;
  memcpy(state->sreg, avr->sreg, sizeof state->sreg);
  memcpy(state->data, avr->data, avr->ramend + 1u);
}

static void restore(avr_t* avr, const state_t* state) {
  avr->cycle = state->cycle;
  avr->pc = state->pc;
  avr->interrupt_state = state->interrupt_state;
  avr->state = cpu_Running;
  memcpy(avr->sreg, state->sreg, sizeof state->sreg);
  memcpy(avr->data, state->data, avr->ramend + 1u);
}

static uint32_t next(uint32_t* random) {
  *random ^= *random << 13;
  *random ^= *random >> 17;
  *random ^= *random << 5;
  return *random;
}

static void disturb(avr_t* avr, uint32_t* random) {
  for (int n = 0; n < 32; n++) {
    /* Ends of the range and equal registers meet the flags' corners. */
    const uint8_t corners[] = {0x00, 0x01, 0x7F, 0x80, 0xFF};
    uint32_t pick = next(random);
    avr->data[n] = pick & 0x300 ? (uint8_t)pick : corners[(pick >> 16) % sizeof corners];
  }
  /* Pointers into RAM, more often than not. */
  for (int low = 26; low < 32; low += 2) {
    if (next(random) & 3) avr->data[low + 1] = (uint8_t)(3 + next(random) % 5);
  }
  for (int bit = 0; bit < 8; bit++) avr->sreg[bit] = next(random) & 1;
  avr->interrupt_state = 0;
  uint16_t sp = (uint16_t)(avr->ioend + 64u + next(random) % 256u);
  avr->data[R_SPL] = (uint8_t)sp;
  avr->data[R_SPH] = (uint8_t)(sp >> 8);
}

/* Run all instruction words from random states. The count of those that quick.c
 * took; or -1 with, in `complaint`, the first that came out otherwise. */
int mega_compare(mega_t* mega, uint32_t seed, uint32_t rounds, char* complaint, uint32_t room) {
  avr_t* avr = mega->avr;
  state_t* start = calloc(1, sizeof *start);
  state_t* quick = calloc(1, sizeof *quick);
  state_t* slow = calloc(1, sizeof *slow);
  if (start == NULL || quick == NULL || slow == NULL) abort();
  if (mega->decoded == NULL) quick_decode(mega);
  uint32_t random = seed | 1;
  int taken = 0;
  int result = 0;
  for (uint32_t round = 0; round < rounds && result >= 0; round++) {
    for (uint32_t word = 0; word < 65536 && result >= 0; word++) {
      /* A second word for LDS, CALL...: an address in RAM, or two-word to skip. */
      uint32_t after = next(&random) & 1 ? 0x0300 + next(&random) % 0x300 : 0x9000;
      const uint8_t code[] = {(uint8_t)word, (uint8_t)(word >> 8), (uint8_t)after, (uint8_t)(after >> 8), 0, 0, 0, 0};
      avr->pc = 0x1000;
      memcpy(avr->flash + avr->pc, code, sizeof code);
      disturb(avr, &random);
      keep(avr, start);
      quick_decode_at(mega, avr->pc / 2);
      if (!quick_run(mega, avr->cycle + 1)) {
        restore(avr, start);
        continue;
      }
      taken++;
      keep(avr, quick);
      restore(avr, start);
      avr->pc = avr_run_one(avr);
      keep(avr, slow);
      restore(avr, start);
      const char* what = quick->cycle != slow->cycle                              ? "cycles"
                         : quick->pc != slow->pc                                  ? "the program counter"
                         : quick->interrupt_state != slow->interrupt_state        ? "interrupts"
                         : memcmp(quick->sreg, slow->sreg, 8) != 0                ? "flags"
                         : memcmp(quick->data, slow->data, avr->ramend + 1u) != 0 ? "memory"
                                                                                  : NULL;
      if (what == NULL) continue;
      snprintf(complaint, room, "%04x %04x differs in %s (%d and %d cycles)", word, after, what,
               (int)(quick->cycle - start->cycle), (int)(slow->cycle - start->cycle));
      result = -1;
    }
  }
  free(start);
  free(quick);
  free(slow);
  return result < 0 ? -1 : taken;
}
