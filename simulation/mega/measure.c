/* Cycles per function and per address, while the firmware runs. */
#include "mega.h"

#include <stdlib.h>
#include <string.h>

enum { DEEPEST_CALL = 128, DEEPEST_INTERRUPT = 32, RETI = 0x9518 };

typedef struct {
  uint64_t count;
  uint64_t cycles;          /* of the completed outermost calls */
  uint64_t cycles_in_isr;   /* of these, in interrupt routines that broke in */
  uint64_t longest;         /* one call, interrupt routines included */
  uint64_t longest_without; /* one call, without them */
  uint32_t open;            /* calls under way */
} watch_t;

typedef struct {
  uint32_t watch;
  uint16_t sp;
  uint8_t depth; /* of interrupts at the call */
  uint64_t at;
  uint64_t isr_at;
} call_t;

struct measure {
  uint64_t* by_word; /* cycles at each word of flash */
  uint8_t* entry;    /* per word: number of the watch that begins there, plus 1 */
  watch_t watches[255];
  uint32_t watch_count;
  call_t calls[DEEPEST_CALL];
  uint32_t call_count;
  uint8_t depth;
  uint64_t deeper_than[DEEPEST_INTERRUPT]; /* cycles spent above that depth */
};

static measure_t* measuring(mega_t* mega) {
  if (mega->measure == NULL) {
    uint32_t words = (mega->avr->flashend + 1) / 2;
    measure_t* measure = calloc(1, sizeof *measure);
    if (measure == NULL) abort();
    measure->by_word = calloc(words, sizeof *measure->by_word);
    measure->entry = calloc(words, sizeof *measure->entry);
    if (measure->by_word == NULL || measure->entry == NULL) abort();
    mega->measure = measure;
  }
  return mega->measure;
}

static void spend(measure_t* measure, uint64_t cycles) {
  for (uint8_t depth = 0; depth < measure->depth; depth++) {
    measure->deeper_than[depth] += cycles;
  }
}

static void enter(mega_t* mega, uint32_t watch) {
  measure_t* measure = mega->measure;
  uint16_t sp = stack_pointer(mega->avr);
  if (measure->call_count > 0) {
    const call_t* last = &measure->calls[measure->call_count - 1];
    /* A loop back to the first instruction is not a call. */
    if (last->watch == watch && last->sp == sp && last->depth == measure->depth) return;
  }
  if (measure->call_count == DEEPEST_CALL) return;
  measure->watches[watch].count++;
  measure->watches[watch].open++;
  measure->calls[measure->call_count++] = (call_t){
      .watch = watch,
      .sp = sp,
      .depth = measure->depth,
      .at = mega->avr->cycle,
      .isr_at = measure->deeper_than[measure->depth],
  };
}

static void leave(mega_t* mega) {
  measure_t* measure = mega->measure;
  call_t call = measure->calls[--measure->call_count];
  watch_t* watch = &measure->watches[call.watch];
  if (--watch->open > 0) return; /* the outermost call of a recursion counts */
  uint64_t cycles = mega->avr->cycle - call.at;
  uint64_t in_isr = measure->deeper_than[call.depth] - call.isr_at;
  watch->cycles += cycles;
  watch->cycles_in_isr += in_isr;
  if (cycles > watch->longest) watch->longest = cycles;
  if (cycles - in_isr > watch->longest_without) watch->longest_without = cycles - in_isr;
}

void measure_step(mega_t* mega, uint32_t pc, uint16_t opcode, uint64_t before) {
  measure_t* measure = mega->measure;
  avr_t* avr = mega->avr;
  uint64_t cycles = avr->cycle - before;
  measure->by_word[pc / 2] += cycles;
  spend(measure, cycles);
  if (opcode == RETI && measure->depth > 0) measure->depth--;
  if (leaves_stack_pointer_torn(opcode)) return;
  /* A call is over when its return address is off the stack. */
  while (measure->call_count > 0 &&
         stack_pointer(avr) >= measure->calls[measure->call_count - 1].sp + mega->call_bytes) {
    leave(mega);
  }
  uint8_t entry = avr->pc <= avr->flashend ? measure->entry[avr->pc / 2] : 0;
  if (entry != 0) enter(mega, entry - 1u);
}

void measure_interrupt(mega_t* mega, uint64_t before) {
  measure_t* measure = mega->measure;
  uint64_t cycles = mega->avr->cycle - before;
  if (measure->depth < DEEPEST_INTERRUPT - 1) measure->depth++;
  spend(measure, cycles);
  measure->by_word[mega->avr->pc / 2] += cycles;
}

void measure_sleep(mega_t* mega, uint64_t cycles) { spend(mega->measure, cycles); }

void measure_reset(mega_t* mega) {
  measure_t* measure = mega->measure;
  measure->call_count = 0;
  measure->depth = 0;
  for (uint32_t n = 0; n < measure->watch_count; n++) measure->watches[n].open = 0;
}

void measure_free(mega_t* mega) {
  if (mega->measure == NULL) return;
  free(mega->measure->by_word);
  free(mega->measure->entry);
  free(mega->measure);
  mega->measure = NULL;
}

/* Count cycles by address from now on. */
void mega_profile(mega_t* mega) {
  measure_t* measure = measuring(mega);
  uint32_t words = (mega->avr->flashend + 1) / 2;
  memset(measure->by_word, 0, words * sizeof *measure->by_word);
}

void mega_take_profile(mega_t* mega, uint64_t* by_word) {
  uint32_t words = (mega->avr->flashend + 1) / 2;
  memcpy(by_word, measuring(mega)->by_word, words * sizeof *by_word);
}

uint32_t mega_flash_words(const mega_t* mega) { return (mega->avr->flashend + 1) / 2; }

/* Watch the calls of the function at a byte address: its number, or -1. */
int mega_watch(mega_t* mega, uint32_t address) {
  measure_t* measure = measuring(mega);
  if (address > mega->avr->flashend) return -1;
  if (measure->entry[address / 2] != 0) return measure->entry[address / 2] - 1;
  if (measure->watch_count == 255) return -1;
  measure->entry[address / 2] = (uint8_t)++measure->watch_count;
  return (int)measure->watch_count - 1;
}

void mega_watched(mega_t* mega, int watch, uint64_t figures[5]) {
  const watch_t* seen = &measuring(mega)->watches[watch];
  figures[0] = seen->count;
  figures[1] = seen->cycles;
  figures[2] = seen->cycles_in_isr;
  figures[3] = seen->longest;
  figures[4] = seen->longest_without;
}

void mega_forget_watch(mega_t* mega, int watch) {
  uint32_t open = measuring(mega)->watches[watch].open;
  measuring(mega)->watches[watch] = (watch_t){.open = open};
}
