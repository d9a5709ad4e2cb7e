/* The serial ports, bit time by bit time, in place of simavr's.
 *
 * simavr 1.6 lets a byte take eleven bit times and queues 64 on the way in.
 * The USART of an ATmega takes ten, and holds two bytes beside the one that
 * is arriving: what comes while interrupts stay off too long is lost.
 */
#include "mega.h"

#include <stdlib.h>
#include <string.h>

/* UCSRnA */
enum { RXC = 0x80, TXC = 0x40, UDRE = 0x20, FE = 0x10, DOR = 0x08, U2X = 0x02, MPCM = 0x01 };
/* UCSRnB */
enum { RXCIE = 0x80, TXCIE = 0x40, UDRIE = 0x20, RXEN = 0x10, TXEN = 0x08 };

static uint8_t* ucsra(const usart_t* port) { return &port->mega->avr->data[port->chip->r_ucsra]; }

static uint8_t ucsrb(const usart_t* port) { return port->mega->avr->data[port->chip->r_ucsrb]; }

/* One bit [cycles]. */
static uint32_t bit_cycles(const usart_t* port) {
  const uint8_t* data = port->mega->avr->data;
  uint32_t divisor = 1u + data[port->chip->ubrrl.reg] + ((data[port->chip->ubrrh.reg] & 0x0Fu) << 8);
  return divisor * (*ucsra(port) & U2X ? 8 : 16);
}

/* Start, data, parity and stop bits of a frame. */
static uint32_t frame_bits(const usart_t* port) {
  uint8_t ucsrc = port->mega->avr->data[port->chip->r_ucsrc];
  uint32_t data_bits = 5u + ((ucsrc >> 1) & 3u);
  uint32_t parity_bits = ucsrc & 0x20 ? 1 : 0;
  uint32_t stop_bits = ucsrc & 0x08 ? 2 : 1;
  return 1u + data_bits + parity_bits + stop_bits;
}

/* So many bits at the peer's own rate [cycle / 65536]. */
static uint64_t peer_bits_q16(const usart_t* port, uint32_t bits) {
  if (port->peer_baud == 0) return (uint64_t)bit_cycles(port) * bits << 16;
  return ((uint64_t)port->mega->avr->frequency * bits << 16) / port->peer_baud;
}

/* Whether the peer's rate is so far from the Mega's that a byte is not understood. */
static bool rates_differ(const usart_t* port) {
  uint64_t own = (uint64_t)bit_cycles(port) << 16, peer = peer_bits_q16(port, 1);
  return (own > peer ? own - peer : peer - own) > own / 20;
}

static void schedule(mega_t* mega) {
  uint64_t earliest = NEVER;
  for (int n = 0; n < PORTS; n++) {
    const usart_t* port = &mega->ports[n];
    if (port->receive_at < earliest) earliest = port->receive_at;
    if (port->send_at < earliest) earliest = port->send_at;
    if (port->hear_at < earliest) earliest = port->hear_at;
    if (port->peer_hear_at < earliest) earliest = port->peer_hear_at;
  }
  mega->port_event = earliest;
}

static bool requests(const usart_t* port) { return (*ucsra(port) & ucsrb(port) & (RXC | TXC | UDRE)) != 0; }

/* Have the run loop look for a request before the next instruction. */
static void alert(const usart_t* port) {
  avr_t* avr = port->mega->avr;
  if (requests(port) && avr->sreg[S_I] && avr->interrupt_state == 0) {
    avr->interrupt_state = 1;
  }
}

/* --- to the Mega --- */

static uint64_t round_up(uint64_t q16) { return (q16 + 0xFFFFu) >> 16; }

static void expect_next(usart_t* port) {
  port->receive_at = NEVER;
  if (port->inbound_count == 0) return;
  uint64_t earliest = port->inbound[port->inbound_first].earliest << 16;
  if (earliest > port->line_free_q16) port->line_free_q16 = earliest;
  port->receive_at = round_up(port->line_free_q16);
}

static void buffer(usart_t* port, uint8_t byte) {
  port->buffer[port->buffered++] = byte;
  *ucsra(port) |= RXC;
}

/* A start bit was seen. */
static void begin_byte(usart_t* port) {
  if (!port->waiting) return;
  port->waiting = false; /* the shift register is needed for the new byte */
  port->lost++;
  *ucsra(port) |= DOR;
}

/* A byte is complete. */
static void end_byte(usart_t* port, uint8_t byte, bool whole) {
  if (!(ucsrb(port) & RXEN)) {
    port->unheard++;
    return;
  }
  if (!whole) *ucsra(port) |= FE;
  if (port->buffered < sizeof port->buffer) {
    buffer(port, byte);
    alert(port);
  } else {
    port->shift = byte;
    port->waiting = true;
  }
}

static uint64_t next_decision(const ear_t* ear, uint64_t bit_q16) {
  uint64_t next = ear_next(ear, bit_q16);
  return next == EAR_NEVER ? NEVER : round_up(next);
}

static void start_bit(usart_t* port) {
  port->arriving = true;
  port->frame_q16 = peer_bits_q16(port, frame_bits(port));
  port->receive_at = round_up(port->line_free_q16 + port->frame_q16);
  port->overheard = rates_differ(port);
  if (!port->overheard) {
    begin_byte(port);
    return;
  }
  ear_feed(&port->ear, (spoken_t){.start = port->line_free_q16,
                                  .bit = peer_bits_q16(port, 1),
                                  .byte = port->inbound[port->inbound_first].byte});
  port->hear_at = next_decision(&port->ear, (uint64_t)bit_cycles(port) << 16);
}

static void stop_bit(usart_t* port) {
  uint8_t byte = port->inbound[port->inbound_first].byte;
  port->inbound_first = (port->inbound_first + 1) % port->inbound_room;
  port->inbound_count--;
  port->arriving = false;
  port->line_free_q16 += port->frame_q16;
  expect_next(port);
  if (!port->overheard) end_byte(port, byte, true);
}

static void hear(usart_t* port) {
  uint64_t bit = (uint64_t)bit_cycles(port) << 16;
  heard_t heard;
  bool started, ended;
  do {
    ended = ear_hear(&port->ear, port->mega->avr->cycle << 16, bit, &heard, &started);
    if (started) begin_byte(port);
    if (ended) end_byte(port, heard.byte, heard.whole);
  } while (ended);
  port->hear_at = next_decision(&port->ear, bit);
}

static uint8_t read_udr(avr_t* avr, avr_io_addr_t address, void* context) {
  usart_t* port = context;
  if (port->buffered > 0) {
    avr->data[address] = port->buffer[0];
    port->buffer[0] = port->buffer[1];
    port->buffered--;
    *ucsra(port) &= (uint8_t) ~(DOR | FE);
    if (port->waiting) {
      port->waiting = false;
      buffer(port, port->shift);
    }
    if (port->buffered == 0) *ucsra(port) &= (uint8_t)~RXC;
  }
  return avr->data[address];
}

/* --- from the Mega --- */

static void begin_sending(usart_t* port, outbound_t byte, uint64_t at) {
  port->sending = true;
  port->leaving = byte;
  port->send_at = at + (uint64_t)bit_cycles(port) * frame_bits(port);
  port->leaving_overheard = rates_differ(port);
  if (!port->leaving_overheard) return;
  ear_feed(
      &port->peer_ear,
      (spoken_t){.start = at << 16, .bit = (uint64_t)bit_cycles(port) << 16, .tag = byte.written, .byte = byte.byte});
  port->peer_hear_at = next_decision(&port->peer_ear, peer_bits_q16(port, 1));
}

static void log_sent(usart_t* port, outbound_t byte) {
  if (port->sent_count == port->sent_room) {
    port->sent_room = port->sent_room ? 2 * port->sent_room : 256;
    port->sent = realloc(port->sent, port->sent_room * sizeof *port->sent);
    if (port->sent == NULL) abort();
  }
  port->sent[port->sent_count++] = byte;
  port->mega->sent_on |= 1u << (port - port->mega->ports);
}

static void hear_as_peer(usart_t* port) {
  uint64_t bit = peer_bits_q16(port, 1);
  heard_t heard;
  bool started;
  while (ear_hear(&port->peer_ear, port->mega->avr->cycle << 16, bit, &heard, &started)) {
    log_sent(port, (outbound_t){.written = heard.tag, .left = round_up(heard.at), .byte = heard.byte});
  }
  port->peer_hear_at = next_decision(&port->peer_ear, bit);
}

static void finish_sending(usart_t* port) {
  if (!port->leaving_overheard) {
    outbound_t byte = port->leaving;
    byte.left = port->send_at;
    log_sent(port, byte);
  }
  if (port->queued) {
    port->queued = false;
    begin_sending(port, port->next, port->send_at);
    *ucsra(port) |= UDRE;
  } else {
    port->sending = false;
    port->send_at = NEVER;
    *ucsra(port) |= TXC;
  }
  alert(port);
}

static void write_udr(avr_t* avr, avr_io_addr_t address, uint8_t value, void* context) {
  (void)address; /* what is written and what is read are two registers */
  usart_t* port = context;
  if (!(ucsrb(port) & TXEN) || port->queued) return;
  outbound_t byte = {.written = avr->cycle, .byte = value};
  if (port->sending) {
    port->queued = true;
    port->next = byte;
    *ucsra(port) &= (uint8_t)~UDRE;
  } else {
    begin_sending(port, byte, avr->cycle);
    schedule(port->mega);
  }
}

/* --- control --- */

static void write_ucsra(avr_t* avr, avr_io_addr_t address, uint8_t value, void* context) {
  (void)context;
  uint8_t flags = avr->data[address] & (RXC | TXC | UDRE | FE | DOR);
  if (value & TXC) flags &= (uint8_t)~TXC;
  avr->data[address] = flags | (value & (U2X | MPCM));
}

static void write_ucsrb(avr_t* avr, avr_io_addr_t address, uint8_t value, void* context) {
  usart_t* port = context;
  avr->data[address] = value;
  if (!(value & RXEN)) {
    port->buffered = 0;
    port->waiting = false;
    *ucsra(port) &= (uint8_t) ~(RXC | DOR | FE);
  }
  alert(port);
}

void usart_reset(usart_t* port) {
  if (port->chip == NULL) return;
  avr_t* avr = port->mega->avr;
  *ucsra(port) = UDRE;
  avr->data[port->chip->r_ucsrc] = 0x06; /* 8 data bits, 1 stop bit */
  port->buffered = 0;
  port->waiting = false;
  port->sending = false;
  port->queued = false;
  port->send_at = NEVER;
  schedule(port->mega); /* the peer goes on sending, reset or not */
}

void usart_events(mega_t* mega) {
  uint64_t now = mega->avr->cycle;
  for (int n = 0; n < PORTS; n++) {
    usart_t* port = &mega->ports[n];
    if (port->chip == NULL) continue;
    while (port->send_at <= now) finish_sending(port);
    while (port->receive_at <= now) {
      if (port->arriving)
        stop_bit(port);
      else
        start_bit(port);
    }
    if (port->hear_at <= now) hear(port);
    if (port->peer_hear_at <= now) hear_as_peer(port);
  }
  schedule(mega);
}

uint8_t usart_request(mega_t* mega, usart_t** whose) {
  uint8_t lowest = 0;
  for (int n = 0; n < PORTS; n++) {
    usart_t* port = &mega->ports[n];
    if (port->chip == NULL || !requests(port)) continue;
    uint8_t asking = *ucsra(port) & ucsrb(port);
    uint8_t vector = asking & RXC    ? port->chip->rxc.vector
                     : asking & UDRE ? port->chip->udrc.vector
                                     : port->chip->txc.vector;
    if (lowest != 0 && vector > lowest) continue;
    lowest = vector;
    *whose = port;
  }
  return lowest;
}

/* RXC and UDRE last until UDR is read or written; TXC is cleared by its vector. */
void usart_acknowledge(usart_t* port, uint8_t vector) {
  if (vector == port->chip->txc.vector) *ucsra(port) &= (uint8_t)~TXC;
}

static void take_over(usart_t* port, avr_uart_t* chip) {
  avr_t* avr = port->mega->avr;
  port->chip = chip;
  port->receive_at = NEVER;
  port->send_at = NEVER;
  chip->io.reset = NULL;
  const avr_io_addr_t used[] = {chip->r_udr,   chip->r_ucsra,   chip->r_ucsrb,
                                chip->r_ucsrc, chip->ubrrl.reg, chip->ubrrh.reg};
  for (size_t n = 0; n < sizeof used / sizeof used[0]; n++) {
    memset(&avr->io[AVR_DATA_TO_IO(used[n])], 0, sizeof avr->io[0]);
  }
  avr->io[AVR_DATA_TO_IO(chip->r_udr)].r.c = read_udr;
  avr->io[AVR_DATA_TO_IO(chip->r_udr)].r.param = port;
  avr->io[AVR_DATA_TO_IO(chip->r_udr)].w.c = write_udr;
  avr->io[AVR_DATA_TO_IO(chip->r_udr)].w.param = port;
  avr->io[AVR_DATA_TO_IO(chip->r_ucsra)].w.c = write_ucsra;
  avr->io[AVR_DATA_TO_IO(chip->r_ucsra)].w.param = port;
  avr->io[AVR_DATA_TO_IO(chip->r_ucsrb)].w.c = write_ucsrb;
  avr->io[AVR_DATA_TO_IO(chip->r_ucsrb)].w.param = port;
}

void usart_attach(mega_t* mega) {
  for (int n = 0; n < PORTS; n++) {
    mega->ports[n] =
        (usart_t){.mega = mega, .receive_at = NEVER, .send_at = NEVER, .hear_at = NEVER, .peer_hear_at = NEVER};
  }
  mega->port_event = NEVER;
  for (avr_io_t* io = mega->avr->io_port; io != NULL; io = io->next) {
    if (strcmp(io->kind, "uart") != 0) continue;
    avr_uart_t* chip = (avr_uart_t*)io;
    int n = chip->name - '0';
    if (n >= 0 && n < PORTS) take_over(&mega->ports[n], chip);
  }
}

void usart_free(usart_t* port) {
  free(port->inbound);
  free(port->sent);
  ear_free(&port->ear);
  ear_free(&port->peer_ear);
}

/* --- what the peer does --- */

bool mega_has_port(const mega_t* mega, int n) { return n >= 0 && n < PORTS && mega->ports[n].chip != NULL; }

static void make_room(usart_t* port, uint32_t count) {
  uint32_t room = port->inbound_room ? port->inbound_room : 256;
  while (room < port->inbound_count + count) room *= 2;
  if (room == port->inbound_room) return;
  inbound_t* queue = malloc(room * sizeof *queue);
  if (queue == NULL) abort();
  for (uint32_t n = 0; n < port->inbound_count; n++) {
    queue[n] = port->inbound[(port->inbound_first + n) % port->inbound_room];
  }
  free(port->inbound);
  port->inbound = queue;
  port->inbound_first = 0;
  port->inbound_room = room;
}

/* Queue bytes; the first start bit goes out at the cycle or when the line is free. */
void mega_send(mega_t* mega, int n, const uint8_t* bytes, uint32_t count, uint64_t at) {
  usart_t* port = &mega->ports[n];
  if (at < mega->avr->cycle) at = mega->avr->cycle;
  make_room(port, count);
  for (uint32_t i = 0; i < count; i++) {
    uint32_t slot = (port->inbound_first + port->inbound_count) % port->inbound_room;
    port->inbound[slot] = (inbound_t){.earliest = at, .byte = bytes[i]};
    port->inbound_count++;
  }
  if (!port->arriving) expect_next(port);
  schedule(mega);
}

uint32_t mega_unsent(const mega_t* mega, int n) { return mega->ports[n].inbound_count; }
/* Where it is counted how many bytes wait to be taken. */
const uint32_t* mega_sent_count(const mega_t* mega, int n) { return &mega->ports[n].sent_count; }
uint64_t mega_lost(const mega_t* mega, int n) { return mega->ports[n].lost; }
uint64_t mega_unheard(const mega_t* mega, int n) { return mega->ports[n].unheard; }
bool mega_listens(const mega_t* mega, int n) { return (ucsrb(&mega->ports[n]) & RXEN) != 0; }
uint32_t mega_bit_cycles(const mega_t* mega, int n) { return bit_cycles(&mega->ports[n]); }

void mega_set_peer_baud(mega_t* mega, int n, uint32_t baud) { mega->ports[n].peer_baud = baud; }

/* Hand over the log of sent bytes and begin a new one. */
void mega_take_sent(mega_t* mega, int n, outbound_t* to) {
  usart_t* port = &mega->ports[n];
  if (port->sent_count != 0) memcpy(to, port->sent, port->sent_count * sizeof *to);
  port->sent_count = 0;
}
