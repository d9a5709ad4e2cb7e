/* A Mega in lock step: simavr's core and peripherals, run to an exact cycle.
 *
 * One idea to a file:
 *   mega.c     the run loop: instructions, sleep, interrupts, resets
 *   quick.c    the common instructions, faster than simavr has them
 *   idle.c     a loop that waits, without its rounds
 *   compare.c  each of those instructions, beside simavr's own
 *   eeprom.c   the time that a byte of EEPROM takes
 *   usart.c    the serial ports as the data sheet has them, two bytes deep
 *   ear.c      what a receiver hears of a sender at another baud rate
 *   measure.c  cycles per function, counted while the firmware runs
 *
 * Every time is a count of CPU cycles since power-on.
 */
#ifndef MEGA_H
#define MEGA_H

#include <stdbool.h>
#include <stdint.h>

#include <simavr/avr_eeprom.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_core.h>

#include "ear.h"

#define NEVER UINT64_MAX
#define PORTS 4

typedef struct mega mega_t;
typedef struct measure measure_t;
typedef struct decoded decoded_t;

/* A byte on its way to the Mega; its start bit goes out at `earliest` [cycle]
 * or when the line is free, whichever is later. */
typedef struct {
  uint64_t earliest;
  uint8_t byte;
} inbound_t;

/* A byte that the firmware sent, as its peer heard it. */
typedef struct {
  uint64_t written; /* the store to UDR [cycle] */
  uint64_t left;    /* the end of its stop bit [cycle] */
  uint8_t byte;
} outbound_t;

typedef struct {
  mega_t* mega;
  avr_uart_t* chip; /* register addresses and vectors; NULL: no such port */

  inbound_t* inbound;
  uint32_t inbound_first, inbound_count, inbound_room;
  uint32_t peer_baud;     /* 0: exactly the Mega's own rate */
  uint64_t line_free_q16; /* the end of the last stop bit [cycle / 65536] */
  uint64_t frame_q16;     /* the length of the arriving frame [cycle / 65536] */
  uint64_t receive_at;    /* the next start or end of a frame [cycle] */
  bool arriving;
  bool overheard; /* the arriving frame is at another rate: it goes to the ear */
  ear_t ear;
  uint64_t hear_at; /* the next decision of the ear [cycle] */
  uint8_t buffer[2];
  uint8_t buffered;
  bool waiting; /* a third byte, complete, in the shift register */
  uint8_t shift;
  uint64_t lost;    /* overwritten in the shift register */
  uint64_t unheard; /* arrived while the receiver was off */

  bool sending;
  outbound_t leaving;
  uint64_t send_at; /* the end of the leaving byte's stop bit [cycle] */
  bool leaving_overheard;
  ear_t peer_ear;
  uint64_t peer_hear_at;
  bool queued;
  outbound_t next;
  outbound_t* sent;
  uint32_t sent_count, sent_room;
} usart_t;

enum { IDLE_STORES = 512, IDLE_REGISTERS = 512 };
#define IDLE_ANYWHERE UINT32_MAX

/* What a store replaced. */
typedef struct {
  uint16_t at;
  uint8_t was;
} replaced_t;

typedef struct {
  uint32_t pc;             /* the word at which a round was found, where it is looked for; or IDLE_ANYWHERE */
  uint32_t events_without; /* since that was last come to */
  bool watches;            /* what follows is a state that was at the word `at` */
  uint32_t at;
  uint64_t cycle;
  uint8_t registers[32];
  uint8_t sreg[8];
  uint16_t sp;
  uint8_t rampz;
  uint32_t visits, renewed_after;
  uint32_t count;
  replaced_t stores[IDLE_STORES];
  bool is_pin[IDLE_REGISTERS], is_settled[IDLE_REGISTERS]; /* by the address of a register */
  uint32_t round;
  uint32_t noted_in[0x10000]; /* the round in which a store there was last noted */
} idle_t;

struct mega {
  avr_t* avr;
  usart_t ports[PORTS];
  uint64_t port_event; /* the earliest event of all the ports [cycle] */
  uint32_t sent_on;    /* bit n: a byte left port n since the run began */
  bool asleep;
  uint64_t slept; /* [cycles] */
  uint32_t resets;
  uint16_t lowest_sp;
  uint8_t call_bytes; /* bytes of a return address */
  avr_eeprom_t* eeprom;
  avr_io_write_t eeprom_control; /* simavr's own write to EECR */
  void* eeprom_param;
  int eeprom_address; /* of the byte that is being written, or -1 */
  bool plain;         /* leave every instruction to simavr */
  decoded_t* decoded;
  char error[160];
  idle_t idle;
  bool harmless; /* what is left to simavr changes nothing by which a round could differ from the one before */
  measure_t* measure;
};

/* usart.c */
void usart_attach(mega_t* mega);
void usart_reset(usart_t* port);
void usart_events(mega_t* mega);
/* The lowest requesting vector, or 0; *port is whose it is. */
uint8_t usart_request(mega_t* mega, usart_t** port);
void usart_acknowledge(usart_t* port, uint8_t vector);
void usart_free(usart_t* port);

/* eeprom.c */
void eeprom_attach(mega_t* mega);

/* quick.c */
void quick_decode(mega_t* mega);
void quick_decode_at(mega_t* mega, uint32_t word);
bool quick_run(mega_t* mega, uint64_t until);

/* idle.c */
void idle_attach(mega_t* mega);
void idle_forget(mega_t* mega);
void idle_event(mega_t* mega);
void idle_store(mega_t* mega, uint16_t at);
bool idle_may_read(const mega_t* mega, uint16_t at);
bool idle_may_write(const mega_t* mega, uint16_t at, uint8_t value);
uint64_t idle_visit(mega_t* mega, uint32_t pc, uint64_t cycle, uint64_t until);

/* measure.c */
void measure_step(mega_t* mega, uint32_t pc, uint16_t opcode, uint64_t before);
void measure_interrupt(mega_t* mega, uint64_t before);
void measure_sleep(mega_t* mega, uint64_t cycles);
void measure_reset(mega_t* mega);
void measure_free(mega_t* mega);

/* OUT SPH,r and OUT SREG,r: between them and OUT SPL,r the stack pointer is
 * half old and half new, and means nothing. */
static inline bool leaves_stack_pointer_torn(uint16_t opcode) {
  return (opcode & 0xFE0F) == 0xBE0E || (opcode & 0xFE0F) == 0xBE0F;
}

static inline uint16_t stack_pointer(const avr_t* avr) { return (uint16_t)(avr->data[R_SPL] | avr->data[R_SPH] << 8); }

#endif
