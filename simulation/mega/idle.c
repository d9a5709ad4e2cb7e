/* A loop that waits, without its rounds.
 *
 * A sketch with nothing to do goes round and round, until time or a byte changes
 * something. If registers, flags and memory are at a jump backwards what they
 * were at the same one before, and nothing but registers and memory was used in
 * between, then every further round is the same, to the cycle, up to the next
 * event. So as many as fit before it are left out.
 *
 * To find a round of any length, the state that is compared with is renewed
 * after 1, 2, 4, 8... jumps. What a store replaced since then is noted once for
 * each address: then memory is the same if each of those is.
 */
#include "mega.h"

#include <string.h>

#include <simavr/avr_ioport.h>
#include <simavr/avr_timer.h>

enum { PATIENCE = 64 /* events without the jump at which a round was found */ };

void idle_attach(mega_t* mega) {
  idle_t* idle = &mega->idle;
  for (avr_io_t* io = mega->avr->io_port; io != NULL; io = io->next) {
    if (strcmp(io->kind, "port") == 0) {
      const avr_ioport_t* port = (avr_ioport_t*)io;
      idle->is_pin[port->r_pin] = true;
      idle->is_settled[port->r_port] = true;
    }
    if (strcmp(io->kind, "timer") != 0) continue;
    const avr_timer_t* timer = (avr_timer_t*)io;
    for (int n = 0; n < 4; n++) {
      idle->is_settled[timer->wgm[n].reg] = true;
      idle->is_settled[timer->cs[n].reg] = true;
    }
  }
}

/* A pin gives what it gave before. */
bool idle_may_read(const mega_t* mega, uint16_t at) { return at < IDLE_REGISTERS && mega->idle.is_pin[at]; }

/* A timer takes no notice of the mode that it has, which digitalRead() sets each time, nor a port of its level. */
bool idle_may_write(const mega_t* mega, uint16_t at, uint8_t value) {
  return at < IDLE_REGISTERS && mega->idle.is_settled[at] && mega->avr->data[at] == value;
}

void idle_forget(mega_t* mega) {
  idle_t* idle = &mega->idle;
  idle->watches = false;
  idle->visits = 0;
  idle->renewed_after = 1;
}

void idle_event(mega_t* mega) {
  idle_forget(mega);
  if (mega->idle.pc != IDLE_ANYWHERE && ++mega->idle.events_without >= PATIENCE) mega->idle.pc = IDLE_ANYWHERE;
}

void idle_store(mega_t* mega, uint16_t at) {
  idle_t* idle = &mega->idle;
  if (at == R_SPL || at == R_SPH) return; /* kept beside the registers */
  if (idle->noted_in[at] == idle->round) return;
  idle->noted_in[at] = idle->round;
  if (idle->count == IDLE_STORES) {
    idle->watches = false; /* it does more than wait */
    return;
  }
  idle->stores[idle->count++] = (replaced_t){.at = at, .was = mega->avr->data[at]};
}

static void keep(mega_t* mega, uint32_t pc, uint64_t cycle) {
  const avr_t* avr = mega->avr;
  idle_t* idle = &mega->idle;
  if (++idle->round == 0) {
    memset(idle->noted_in, 0, sizeof idle->noted_in);
    idle->round = 1;
  }
  idle->watches = true;
  idle->at = pc;
  idle->cycle = cycle;
  idle->count = 0;
  memcpy(idle->registers, avr->data, sizeof idle->registers);
  memcpy(idle->sreg, avr->sreg, sizeof idle->sreg);
  idle->sp = stack_pointer(avr);
  idle->rampz = avr->data[avr->rampz];
}

static bool same(const mega_t* mega) {
  const avr_t* avr = mega->avr;
  const idle_t* idle = &mega->idle;
  if (idle->sp != stack_pointer(avr) || idle->rampz != avr->data[avr->rampz]) return false;
  if (memcmp(idle->registers, avr->data, sizeof idle->registers) != 0) return false;
  if (memcmp(idle->sreg, avr->sreg, sizeof idle->sreg) != 0) return false;
  for (uint32_t n = 0; n < idle->count; n++) {
    if (avr->data[idle->stores[n].at] != idle->stores[n].was) return false;
  }
  return true;
}

/* At the end of a jump backwards: the cycle from which to go on. */
uint64_t idle_visit(mega_t* mega, uint32_t pc, uint64_t cycle, uint64_t until) {
  idle_t* idle = &mega->idle;
  if (mega->avr->interrupt_state != 0) return cycle;
  idle->events_without = 0;
  if (idle->watches && idle->at == pc && same(mega)) {
    const uint64_t length = cycle - idle->cycle;
    idle->pc = pc;
    if (until > cycle) cycle += (until - cycle) / length * length;
    idle->cycle = cycle;
    return cycle;
  }
  if (++idle->visits < idle->renewed_after) return cycle;
  idle->visits = 0;
  idle->renewed_after *= 2;
  keep(mega, pc, cycle);
  return cycle;
}
