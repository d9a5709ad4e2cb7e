/* The run loop of the simulated Mega. */
#include "mega.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <simavr/avr_timer.h>

enum { REACHED = 0, SENT = 1, CRASHED = 2, HALTED = 3 };
enum {
  ADDRESSES = 0x10000, /* that an AVR can name: registers, I/O, RAM and what is beyond */
  LARGEST_PAGE = 256   /* of flash [bytes] */
};
enum { POWER_ON = 0, EXTERNAL = 1, WATCHDOG = 2 };

static void keep_complaint(avr_t* avr, const int level, const char* format, va_list arguments) {
  if (avr == NULL || level > LOG_ERROR) return;
  mega_t* mega = avr->custom.data;
  if (mega == NULL || mega->error[0] != '\0') return;
  vsnprintf(mega->error, sizeof mega->error, format, arguments);
}

static void start(mega_t* mega, int cause) {
  avr_t* avr = mega->avr;
  /* simavr clears fewer I/O registers than the 2560 has. */
  memset(avr->data + 32, 0, avr->ioend + 1u - 32u);
  avr_reset(avr);
  avr->run_cycle_limit = 1;
  avr->run_cycle_count = 1;
  if (cause == POWER_ON) avr_regbit_set(avr, avr->reset_flags.porf);
  if (cause == EXTERNAL) avr_regbit_set(avr, avr->reset_flags.extrf);
  for (int n = 0; n < PORTS; n++) usart_reset(&mega->ports[n]);
  mega->asleep = false;
  mega->idle.pc = IDLE_ANYWHERE;
  idle_forget(mega);
  mega->eeprom_address = -1;
  if (mega->measure != NULL) measure_reset(mega);
}

/* simavr complains of a store beyond RAM, and then makes it: into whatever this
 * process has there. And it erases a page of flash from where Z points, wherever
 * in the page that is. Give it room for both. */
static void contain_stray_stores(avr_t* avr) {
  avr->data = realloc(avr->data, ADDRESSES);
  avr->flash = realloc(avr->flash, avr->flashend + 1u + LARGEST_PAGE);
  if (avr->data == NULL || avr->flash == NULL) abort();
  memset(avr->data + avr->ramend + 1, 0, ADDRESSES - (avr->ramend + 1u));
  memset(avr->flash + avr->flashend + 1, 0xFF, LARGEST_PAGE);
}

mega_t* mega_new(const char* mcu, uint32_t hz) {
  avr_global_logger_set(keep_complaint);
  avr_t* avr = avr_make_mcu_by_name(mcu);
  if (avr == NULL) return NULL;
  mega_t* mega = calloc(1, sizeof *mega);
  if (mega == NULL) abort();
  mega->avr = avr;
  avr->custom.data = mega;
  avr_init(avr);
  contain_stray_stores(avr);
  avr->frequency = hz;
  mega->call_bytes = avr->address_size;
  mega->lowest_sp = avr->ramend;
  usart_attach(mega);
  eeprom_attach(mega);
  idle_attach(mega);
  /* SRAM holds noise at power-on; firmware must not count on zeros. */
  uint32_t noise = 2463534242u;
  for (uint32_t at = avr->ioend + 1u; at <= avr->ramend; at++) {
    noise ^= noise << 13;
    noise ^= noise >> 17;
    noise ^= noise << 5;
    avr->data[at] = (uint8_t)noise;
  }
  start(mega, POWER_ON);
  return mega;
}

void mega_free(mega_t* mega) {
  for (int n = 0; n < PORTS; n++) usart_free(&mega->ports[n]);
  measure_free(mega);
  free(mega->decoded);
  avr_terminate(mega->avr);
  free(mega->avr);
  free(mega);
}

void mega_reset(mega_t* mega) {
  mega->resets++;
  start(mega, EXTERNAL);
}

/* -1 if the code does not fit the flash. */
int mega_load(mega_t* mega, const uint8_t* code, uint32_t size, uint32_t address) {
  avr_t* avr = mega->avr;
  if (address > avr->flashend || size > avr->flashend + 1 - address) return -1;
  memcpy(avr->flash + address, code, size);
  free(mega->decoded);
  mega->decoded = NULL;
  idle_forget(mega);
  if (avr->codeend < address + size) avr->codeend = address + size;
  return 0;
}

static int eeprom(mega_t* mega, uint32_t ioctl, uint32_t address, uint32_t size, uint8_t* bytes) {
  if ((uint64_t)address + size > mega->avr->e2end + 1u) return -1;
  avr_eeprom_desc_t range = {.ee = bytes, .offset = (uint16_t)address, .size = size};
  avr_ioctl(mega->avr, ioctl, &range); /* answers -1 when all is well */
  return 0;
}

int mega_eeprom_read(mega_t* mega, uint32_t address, uint32_t size, uint8_t* to) {
  return eeprom(mega, AVR_IOCTL_EEPROM_GET, address, size, to);
}

int mega_eeprom_write(mega_t* mega, uint32_t address, uint32_t size, uint8_t* from) {
  return eeprom(mega, AVR_IOCTL_EEPROM_SET, address, size, from);
}

int mega_read(mega_t* mega, uint32_t address, uint32_t size, uint8_t* to) {
  if ((uint64_t)address + size > mega->avr->ramend + 1u) return -1;
  memcpy(to, mega->avr->data + address, size);
  return 0;
}

int mega_write(mega_t* mega, uint32_t address, uint32_t size, const uint8_t* from) {
  if ((uint64_t)address + size > mega->avr->ramend + 1u) return -1;
  memcpy(mega->avr->data + address, from, size);
  idle_forget(mega);
  return 0;
}

static uint64_t next_event(const mega_t* mega) {
  const avr_cycle_timer_slot_t* timer = mega->avr->cycle_timers.timer;
  uint64_t at = timer != NULL ? timer->when : NEVER;
  return at < mega->port_event ? at : mega->port_event;
}

/* simavr has no phase-correct PWM, in which the Arduino core puts all timers
 * but timer 0 for analogWrite(). It would have each overflow every 64 cycles,
 * for nothing: stop those. */
static void stop_unmodelled_timers(avr_t* avr) {
  for (avr_io_t* io = avr->io_port; io != NULL; io = io->next) {
    if (strcmp(io->kind, "timer") != 0) continue;
    avr_timer_t* timer = (avr_timer_t*)io;
    if (timer->mode.kind != avr_timer_wgm_none || timer->tov_cycles == 0) continue;
    timer->tov_cycles = 0;
    for (int n = 0; n < AVR_TIMER_COMP_COUNT; n++) timer->comp[n].comp_cycles = 0;
    avr_cycle_timer_slot_t* slot = avr->cycle_timers.timer;
    while (slot != NULL) {
      avr_cycle_timer_slot_t* after = slot->next;
      if (slot->param == timer) avr_cycle_timer_cancel(avr, slot->timer, timer);
      slot = after;
    }
  }
}

static void events(mega_t* mega) {
  avr_t* avr = mega->avr;
  idle_event(mega);
  if (avr->cycle >= mega->port_event) usart_events(mega);
  avr_cycle_timer_process(avr);
  stop_unmodelled_timers(avr);
  /* The vectors' own `pending` bits say enough; this queue would overflow. */
  avr->interrupts.pending.read = avr->interrupts.pending.write;
  if (avr->run != avr_callback_run_raw) { /* simavr's watchdog asks for a reset */
    mega->resets++;
    start(mega, WATCHDOG);
  }
}

/* The peripheral other than a port that asks for the lowest vector. */
static avr_int_vector_t* peripheral_request(avr_t* avr) {
  avr_int_vector_t* lowest = NULL;
  for (int n = 0; n < avr->interrupts.vector_count; n++) {
    avr_int_vector_t* vector = avr->interrupts.vector[n];
    if (vector->pending && avr_regbit_get(avr, vector->enable) && (lowest == NULL || vector->vector < lowest->vector)) {
      lowest = vector;
    }
  }
  return lowest;
}

static void interrupts(mega_t* mega) {
  avr_t* avr = mega->avr;
  if (!avr->sreg[S_I]) {
    avr->interrupt_state = 0;
    return;
  }
  /* simavr sets -2 as the I flag rises; one more instruction runs first. */
  if (avr->interrupt_state < 0 && ++avr->interrupt_state < 0) return;
  avr->interrupt_state = 0;

  usart_t* port = NULL;
  uint8_t number = usart_request(mega, &port);
  avr_int_vector_t* vector = peripheral_request(avr);
  if (vector != NULL && (number == 0 || vector->vector < number)) {
    number = vector->vector;
    port = NULL;
  }
  if (number == 0) return;

  idle_forget(mega);
  uint64_t before = avr->cycle;
  _avr_push_addr(avr, avr->pc);
  avr_sreg_set(avr, S_I, 0);
  avr->pc = (avr_flashaddr_t)number * avr->vector_size;
  /* The response takes two cycles and a push of the return address, and
   * as long again out of sleep. */
  uint8_t response = mega->call_bytes + 2;
  avr->cycle += mega->asleep ? 2u * response : response;
  mega->asleep = false;
  avr->state = cpu_Running;
  if (port != NULL)
    usart_acknowledge(port, number);
  else
    avr_clear_interrupt(avr, vector);
  if (stack_pointer(avr) < mega->lowest_sp) mega->lowest_sp = stack_pointer(avr);
  if (mega->measure != NULL) measure_interrupt(mega, before);
}

static void sleep_until(mega_t* mega, uint64_t until) {
  avr_t* avr = mega->avr;
  mega->asleep = true;
  uint64_t wake = next_event(mega);
  if (wake > until) wake = until;
  if (wake <= avr->cycle) return;
  mega->slept += wake - avr->cycle;
  if (mega->measure != NULL) measure_sleep(mega, wake - avr->cycle);
  avr->cycle = wake;
}

static uint16_t opcode_at(const avr_t* avr, uint32_t pc) {
  return (uint16_t)(avr->flash[pc] | avr->flash[pc + 1] << 8);
}

/* Whether LPM, ELPM or SPM is about to use flash that the chip does not have: simavr would. */
static bool is_beyond_flash(const avr_t* avr, uint16_t opcode) {
  const bool spm = opcode == 0x95E8;
  const bool elpm = opcode == 0x95D8 || (opcode & 0xFE0E) == 0x9006;
  const bool lpm = opcode == 0x95C8 || (opcode & 0xFE0E) == 0x9004;
  if (!spm && !elpm && !lpm) return false;
  uint32_t z = avr->data[R_ZL] | (uint32_t)avr->data[R_ZH] << 8;
  if (elpm || (spm && avr->rampz)) z |= (uint32_t)avr->data[avr->rampz] << 16;
  return z > avr->flashend;
}

/* Whether it changes registers alone, by registers and flash alone: LPM and ELPM. */
static bool only_reads_flash(uint16_t opcode) {
  return opcode == 0x95D8 || opcode == 0x95C8 || (opcode & 0xFE0E) == 0x9006 || (opcode & 0xFE0E) == 0x9004;
}

/* One instruction of simavr's. */
static void step(mega_t* mega) {
  avr_t* avr = mega->avr;
  bool astray = avr->pc > avr->flashend;
  uint16_t opcode = astray ? 0 : opcode_at(avr, avr->pc);
  const char* why = astray                         ? "it jumped beyond the flash"
                    : opcode == 0xFFFF             ? "it ran into erased flash"
                    : is_beyond_flash(avr, opcode) ? "it used flash beyond the end"
                                                   : NULL;
  if (why != NULL) {
    snprintf(mega->error, sizeof mega->error, "%s", why);
    avr->state = cpu_Crashed;
    return;
  }
  if (!mega->harmless && !only_reads_flash(opcode)) idle_forget(mega);
  mega->harmless = false;
  avr->pc = avr_run_one(avr);
  uint16_t sp = stack_pointer(avr);
  if (sp < mega->lowest_sp && !leaves_stack_pointer_torn(opcode)) mega->lowest_sp = sp;
  if ((opcode & 0xFFEF) == 0x95E8) quick_decode(mega); /* SPM: the flash is not what it was */
}

/* Instructions up to the cycle, or to the next that a peripheral may notice. */
static void instructions(mega_t* mega, uint64_t until) {
  mega->asleep = false;
  if (mega->plain || !quick_run(mega, until)) step(mega);
}

static void measured_instruction(mega_t* mega) {
  avr_t* avr = mega->avr;
  uint32_t pc = avr->pc;
  uint64_t before = avr->cycle;
  instructions(mega, before + 1);
  if (pc > avr->flashend) return; /* a jump astray: no word to count it at */
  measure_step(mega, pc, opcode_at(avr, pc), before);
}

/* Run until the cycle, or until a byte has left a port whose bit is set. */
int mega_run(mega_t* mega, uint64_t until, uint32_t stop_on) {
  avr_t* avr = mega->avr;
  if (mega->decoded == NULL) quick_decode(mega);
  mega->sent_on = 0;
  while (avr->cycle < until) {
    if (avr->state == cpu_Running) {
      uint64_t event = next_event(mega);
      if (mega->measure != NULL)
        measured_instruction(mega);
      else
        instructions(mega, event < until ? event : until);
    } else if (avr->state == cpu_Sleeping) {
      /* With a request pending it only passes through sleep. */
      if (avr->interrupt_state == 0) sleep_until(mega, until);
    } else {
      return CRASHED;
    }
    if (avr->cycle >= next_event(mega)) events(mega);
    if (avr->interrupt_state != 0) interrupts(mega);
    if (mega->sent_on & stop_on) return SENT;
  }
  if (avr->state == cpu_Sleeping && !avr->sreg[S_I]) return HALTED;
  return REACHED;
}

/* Leave every instruction to simavr: slow, and otherwise the same. */
void mega_set_plain(mega_t* mega, bool plain) { mega->plain = plain; }

/* Where the count of cycles is: to look there is cheaper than to call. */
const uint64_t* mega_clock(const mega_t* mega) { return &mega->avr->cycle; }
uint64_t mega_slept(const mega_t* mega) { return mega->slept; }
uint32_t mega_resets(const mega_t* mega) { return mega->resets; }
uint32_t mega_pc(const mega_t* mega) { return mega->avr->pc; }
uint32_t mega_ram_end(const mega_t* mega) { return mega->avr->ramend; }
const char* mega_error(const mega_t* mega) { return mega->error; }

/* From the top of RAM to the lowest stack pointer seen [bytes]. */
uint32_t mega_deepest_stack(const mega_t* mega) { return mega->avr->ramend - mega->lowest_sp; }

void mega_forget_stack(mega_t* mega) { mega->lowest_sp = stack_pointer(mega->avr); }
