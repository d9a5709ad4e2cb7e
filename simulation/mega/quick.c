/* The common instructions, at some hundreds of millions of cycles a second.
 *
 * simavr's own decoder runs about fifty. So each word of flash is decoded once,
 * and what needs no peripheral is done here, on simavr's registers, flags and
 * memory. All else is left to simavr: rare instructions, and every access to a
 * register that a peripheral watches. Both must agree to the bit and the cycle;
 * mega_compare() runs them side by side.
 */
#include "mega.h"

#include <stdlib.h>
#include <string.h>

// clang-format off: a name a line would be a page
typedef enum {
  SLOW, NOP, MOVW, MULS, MULSU, MUL, CPC, SBC, ADD, CPSE, CP, SUB, ADC, AND, EOR, OR,
  MOV, CPI, SBCI, SUBI, ORI, ANDI, LDI, LDD_Y, LDD_Z, STD_Y, STD_Z, LDS, STS,
  LD_X, LD_X_INC, LD_DEC_X, LD_Y_INC, LD_DEC_Y, LD_Z_INC, LD_DEC_Z,
  ST_X, ST_X_INC, ST_DEC_X, ST_Y_INC, ST_DEC_Y, ST_Z_INC, ST_DEC_Z,
  LPM, LPM_INC, PUSH, POP, COM, NEG, SWAP, INC, ASR, LSR, ROR, DEC, BSET, BCLR,
  RET, IJMP, EIJMP, ICALL, EICALL, JMP, CALL, ADIW, SBIW, CBI, SBI, SBIC, SBIS, IN, OUT,
  RJMP, RCALL, BRBS, BRBC, SBRC, SBRS, BLD, BST
} code_t;
// clang-format on

struct decoded {
  uint8_t code;
  uint8_t d; /* destination register, bit of SREG, or bit number */
  int16_t k; /* source register, constant, displacement or address */
};

enum { X = 26, Y = 28, Z = 30, SPL = 0x5D };

static decoded_t make(code_t code, int d, int k) {
  return (decoded_t){.code = (uint8_t)code, .d = (uint8_t)d, .k = (int16_t)k};
}

static decoded_t decode_load_or_store(uint16_t word) {
  const int d = (word >> 4) & 31;
  const bool store = word & 0x0200;
  /* A pointer that is stepped and is the operand too: nothing says what happens. */
  const uint8_t pointers[16] = {[1] = Z, [2] = Z, [5] = Z, [9] = Y, [10] = Y, [13] = X, [14] = X};
  if (pointers[word & 15] != 0 && (d & ~1) == pointers[word & 15]) return make(SLOW, 0, 0);
  switch (word & 15) {
    case 0x0: return make(store ? STS : LDS, d, 0);
    case 0x1: return make(store ? ST_Z_INC : LD_Z_INC, d, 0);
    case 0x2: return make(store ? ST_DEC_Z : LD_DEC_Z, d, 0);
    case 0x4: return make(store ? SLOW : LPM, d, 0);
    case 0x5: return make(store ? SLOW : LPM_INC, d, 0);
    case 0x9: return make(store ? ST_Y_INC : LD_Y_INC, d, 0);
    case 0xA: return make(store ? ST_DEC_Y : LD_DEC_Y, d, 0);
    case 0xC: return make(store ? ST_X : LD_X, d, 0);
    case 0xD: return make(store ? ST_X_INC : LD_X_INC, d, 0);
    case 0xE: return make(store ? ST_DEC_X : LD_DEC_X, d, 0);
    case 0xF: return make(store ? PUSH : POP, d, 0);
    default: return make(SLOW, 0, 0);
  }
}

static decoded_t decode_one_operand(uint16_t word) {
  const int d = (word >> 4) & 31;
  if (word == 0x9508) return make(RET, 0, 0);
  if (word == 0x9409) return make(IJMP, 0, 0);
  if (word == 0x9509) return make(ICALL, 0, 0);
  if (word == 0x9419) return make(EIJMP, 0, 0);
  if (word == 0x9519) return make(EICALL, 0, 0);
  if ((word & 0xFF8F) == 0x9408) return make(BSET, (word >> 4) & 7, 0);
  if ((word & 0xFF8F) == 0x9488) return make(BCLR, (word >> 4) & 7, 0);
  switch (word & 15) {
    case 0x0: return make(COM, d, 0);
    case 0x1: return make(NEG, d, 0);
    case 0x2: return make(SWAP, d, 0);
    case 0x3: return make(INC, d, 0);
    case 0x5: return make(ASR, d, 0);
    case 0x6: return make(LSR, d, 0);
    case 0x7: return make(ROR, d, 0);
    case 0xA: return make(DEC, d, 0);
    /* k: the upper bits of the address; they are 0 below 128 KB. */
    case 0xC:
    case 0xD: return make(JMP, 0, word & 0x01F1);
    case 0xE:
    case 0xF: return make(CALL, 0, word & 0x01F1);
    default: return make(SLOW, 0, 0);
  }
}

static decoded_t decode(uint16_t word) {
  const int d = (word >> 4) & 31;
  const int r = (word & 15) | ((word >> 5) & 16);
  const int high = 16 + ((word >> 4) & 15);
  const int constant = (word & 15) | ((word >> 4) & 0xF0);
  const int offset = (word & 7) | ((word >> 7) & 0x18) | ((word >> 8) & 0x20);
  const int io = 32 + ((word & 15) | ((word >> 5) & 0x30));
  const int low_io = 32 + ((word >> 3) & 31);
  static const uint8_t two_registers[16] = {SLOW, CPC, SBC, ADD, CPSE, CP, SUB, ADC, AND, EOR, OR, MOV};
  switch (word >> 12) {
    case 0x0:
      if (word == 0) return make(NOP, 0, 0);
      if ((word & 0x0F00) == 0x0100) return make(MOVW, 2 * ((word >> 4) & 15), 2 * (word & 15));
      if ((word & 0x0F00) == 0x0200) return make(MULS, high, 16 + (word & 15));
      if ((word & 0x0F88) == 0x0300) return make(MULSU, 16 + ((word >> 4) & 7), 16 + (word & 7));
      if ((word & 0x0F00) == 0x0300) return make(SLOW, 0, 0);
      return make(two_registers[word >> 10], d, r);
    case 0x1:
    case 0x2: return make(two_registers[word >> 10], d, r);
    case 0x3: return make(CPI, high, constant);
    case 0x4: return make(SBCI, high, constant);
    case 0x5: return make(SUBI, high, constant);
    case 0x6: return make(ORI, high, constant);
    case 0x7: return make(ANDI, high, constant);
    case 0xE: return make(LDI, high, constant);
    case 0x8:
    case 0xA:
      if (word & 0x0200) return make(word & 8 ? STD_Y : STD_Z, d, offset);
      return make(word & 8 ? LDD_Y : LDD_Z, d, offset);
    case 0x9: break;
    case 0xB: return make(word & 0x0800 ? OUT : IN, d, io);
    case 0xC: return make(RJMP, 0, (int16_t)(word << 4) >> 4);
    case 0xD: return make(RCALL, 0, (int16_t)(word << 4) >> 4);
    default: /* 0xF */
      if (!(word & 0x0800)) {
        return make(word & 0x0400 ? BRBC : BRBS, word & 7, (int16_t)(word << 6) >> 9);
      }
      if (word & 8) return make(SLOW, 0, 0);
      if (!(word & 0x0400)) return make(word & 0x0200 ? BST : BLD, word & 7, d);
      return make(word & 0x0200 ? SBRS : SBRC, word & 7, d);
  }
  switch ((word >> 8) & 15) {
    case 0x0:
    case 0x1:
    case 0x2:
    case 0x3: return decode_load_or_store(word);
    case 0x4:
    case 0x5: return decode_one_operand(word);
    case 0x6:
    case 0x7: return make(word & 0x0100 ? SBIW : ADIW, 24 + ((word >> 3) & 6), (word & 15) | ((word >> 2) & 0x30));
    case 0x8: return make(CBI, word & 7, low_io);
    case 0x9: return make(SBIC, word & 7, low_io);
    case 0xA: return make(SBI, word & 7, low_io);
    case 0xB: return make(SBIS, word & 7, low_io);
    default: return make(MUL, d, r);
  }
}

void quick_decode_at(mega_t* mega, uint32_t n) {
  const uint8_t* flash = mega->avr->flash;
  mega->decoded[n] = decode((uint16_t)(flash[2 * n] | flash[2 * n + 1] << 8));
}

void quick_decode(mega_t* mega) {
  const uint32_t words = (mega->avr->flashend + 1) / 2;
  if (mega->decoded == NULL) mega->decoded = malloc(words * sizeof *mega->decoded);
  if (mega->decoded == NULL) abort();
  for (uint32_t n = 0; n < words; n++) quick_decode_at(mega, n);
}

/* --- flags --- */

static inline void set_zns(uint8_t* sreg, uint8_t result) {
  sreg[S_Z] = result == 0;
  sreg[S_N] = result >> 7;
  sreg[S_S] = sreg[S_N] ^ sreg[S_V];
}

static inline uint8_t add(uint8_t* sreg, uint8_t d, uint8_t r, uint8_t carry) {
  const uint8_t result = (uint8_t)(d + r + carry);
  const uint8_t carries = (uint8_t)((d & r) | (r & ~result) | (~result & d));
  sreg[S_H] = (carries >> 3) & 1;
  sreg[S_C] = carries >> 7;
  sreg[S_V] = (uint8_t)((d & r & ~result) | (~d & ~r & result)) >> 7;
  set_zns(sreg, result);
  return result;
}

static inline uint8_t subtract(uint8_t* sreg, uint8_t d, uint8_t r, uint8_t carry) {
  const uint8_t result = (uint8_t)(d - r - carry);
  const uint8_t borrows = (uint8_t)((~d & r) | (r & result) | (result & ~d));
  sreg[S_H] = (borrows >> 3) & 1;
  sreg[S_C] = borrows >> 7;
  sreg[S_V] = (uint8_t)((d & ~r & ~result) | (~d & r & result)) >> 7;
  set_zns(sreg, result);
  return result;
}

/* With carry, Z stays only if it was set: it speaks for all the bytes. */
static inline uint8_t subtract_on(uint8_t* sreg, uint8_t d, uint8_t r) {
  const uint8_t zero = sreg[S_Z];
  const uint8_t result = subtract(sreg, d, r, sreg[S_C]);
  sreg[S_Z] &= zero;
  return result;
}

static inline uint8_t logic(uint8_t* sreg, uint8_t result) {
  sreg[S_V] = 0;
  set_zns(sreg, result);
  return result;
}

static inline uint8_t shift_right(uint8_t* sreg, uint8_t d, uint8_t top) {
  const uint8_t result = (uint8_t)((d >> 1) | top);
  sreg[S_C] = d & 1;
  sreg[S_V] = (result >> 7) ^ sreg[S_C];
  set_zns(sreg, result);
  return result;
}

static inline void multiplied(uint8_t* data, uint8_t* sreg, uint16_t product) {
  data[0] = (uint8_t)product;
  data[1] = (uint8_t)(product >> 8);
  sreg[S_C] = product >> 15;
  sreg[S_Z] = product == 0;
}

static inline uint16_t pair(const uint8_t* data, int low) { return (uint16_t)(data[low] | data[low + 1] << 8); }

static inline void set_pair(uint8_t* data, int low, uint16_t value) {
  data[low] = (uint8_t)value;
  data[low + 1] = (uint8_t)(value >> 8);
}

/* --- memory --- */

/* RAM, or a register that no peripheral watches. */
static inline bool plain_to_read(const avr_t* avr, uint16_t at) {
  if (at > avr->ioend) return at <= avr->ramend;
  if (at < 32) return true;
  const int io = AVR_DATA_TO_IO(at);
  return at != R_SREG && io < MAX_IOs && avr->io[io].r.c == NULL && avr->io[io].irq == NULL;
}

static inline bool plain_to_write(const avr_t* avr, uint16_t at) {
  if (at > avr->ioend) return at <= avr->ramend;
  if (at < 32) return false; /* simavr takes it for a fault */
  const int io = AVR_DATA_TO_IO(at);
  return at != R_SREG && io < MAX_IOs && avr->io[io].w.c == NULL && avr->io[io].irq == NULL;
}

static inline bool two_words(const uint8_t* flash, uint32_t pc) {
  const uint16_t word = (uint16_t)(flash[2 * pc] | flash[2 * pc + 1] << 8);
  return (word & 0xFE0E) == 0x940C || (word & 0xFE0E) == 0x940E || (word & 0xFC0F) == 0x9000;
}

/* Run until the cycle (or a little beyond), until an interrupt may have to be
 * served, or up to an instruction that is simavr's: false only for that. */
bool quick_run(mega_t* mega, uint64_t until) {
  avr_t* const avr = mega->avr;
  uint8_t* const data = avr->data;
  uint8_t* const sreg = avr->sreg;
  const uint8_t* const flash = avr->flash;
  const decoded_t* const decoded = mega->decoded;
  const uint8_t call_bytes = mega->call_bytes;
  const uint32_t last_word = avr->flashend / 2; /* also the mask that wraps the counter */
  uint64_t cycle = avr->cycle;
  uint32_t pc = avr->pc / 2;
  bool slow = pc > last_word;

#define WORD_AFTER (flash[2 * pc + 2] | (uint32_t)flash[2 * pc + 3] << 8)
#define LEAVE_TO_SIMAVR \
  {                     \
    slow = true;        \
    goto out;           \
  }
#define NOTE(at) \
  if (mega->idle.watches) idle_store(mega, (uint16_t)(at))
#define READ(address, into)                     \
  {                                             \
    const uint16_t at = (address);              \
    if (!plain_to_read(avr, at)) {              \
      mega->harmless = idle_may_read(mega, at); \
      LEAVE_TO_SIMAVR;                          \
    }                                           \
    (into) = data[at];                          \
  }
#define WRITE(address, value)                             \
  {                                                       \
    const uint16_t at = (address);                        \
    if (!plain_to_write(avr, at)) {                       \
      mega->harmless = idle_may_write(mega, at, (value)); \
      LEAVE_TO_SIMAVR;                                    \
    }                                                     \
    NOTE(at);                                             \
    data[at] = (value);                                   \
  }
#define SKIP_IF(condition)            \
  {                                   \
    if (condition) {                  \
      if (two_words(flash, pc + 1)) { \
        pc++;                         \
        cycle++;                      \
      }                               \
      pc++;                           \
      cycle++;                        \
    }                                 \
  }
#define PUSH_PC(next)                                                                     \
  {                                                                                       \
    const uint16_t sp = pair(data, SPL);                                                  \
    const uint32_t back = (next);                                                         \
    if (sp > avr->ramend || sp - call_bytes < avr->ioend) LEAVE_TO_SIMAVR;                \
    for (uint8_t n = 0; n < call_bytes; n++) NOTE(sp - n);                                \
    data[sp] = (uint8_t)back;                                                             \
    data[sp - 1] = (uint8_t)(back >> 8);                                                  \
    if (call_bytes == 3) data[sp - 2] = (uint8_t)(back >> 16);                            \
    set_pair(data, SPL, (uint16_t)(sp - call_bytes));                                     \
    if (sp - call_bytes < mega->lowest_sp) mega->lowest_sp = (uint16_t)(sp - call_bytes); \
  }

  while (cycle < until && !slow) {
    const decoded_t now = decoded[pc];
    const uint8_t d = now.d;
    const int k = now.k;
    bool went_back = false;
    switch ((code_t)now.code) {
      case SLOW: LEAVE_TO_SIMAVR;
      case NOP: break;
      case MOVW:
        data[d] = data[k];
        data[d + 1] = data[k + 1];
        break;
      case MULS:
        multiplied(data, sreg, (uint16_t)((int8_t)data[d] * (int8_t)data[k]));
        cycle++;
        break;
      case MULSU:
        multiplied(data, sreg, (uint16_t)((int8_t)data[d] * data[k]));
        cycle++;
        break;
      case MUL:
        multiplied(data, sreg, (uint16_t)(data[d] * data[k]));
        cycle++;
        break;
      case CPC: subtract_on(sreg, data[d], data[k]); break;
      case SBC: data[d] = subtract_on(sreg, data[d], data[k]); break;
      case ADD: data[d] = add(sreg, data[d], data[k], 0); break;
      case CPSE: SKIP_IF(data[d] == data[k]); break;
      case CP: subtract(sreg, data[d], data[k], 0); break;
      case SUB: data[d] = subtract(sreg, data[d], data[k], 0); break;
      case ADC: data[d] = add(sreg, data[d], data[k], sreg[S_C]); break;
      case AND: data[d] = logic(sreg, data[d] & data[k]); break;
      case EOR: data[d] = logic(sreg, data[d] ^ data[k]); break;
      case OR: data[d] = logic(sreg, data[d] | data[k]); break;
      case MOV: data[d] = data[k]; break;
      case CPI: subtract(sreg, data[d], (uint8_t)k, 0); break;
      case SBCI: data[d] = subtract_on(sreg, data[d], (uint8_t)k); break;
      case SUBI: data[d] = subtract(sreg, data[d], (uint8_t)k, 0); break;
      case ORI: data[d] = logic(sreg, data[d] | (uint8_t)k); break;
      case ANDI: data[d] = logic(sreg, data[d] & (uint8_t)k); break;
      case LDI: data[d] = (uint8_t)k; break;

      case LDD_Y:
        READ(pair(data, Y) + k, data[d]);
        cycle++;
        break;
      case LDD_Z:
        READ(pair(data, Z) + k, data[d]);
        cycle++;
        break;
      case STD_Y:
        WRITE(pair(data, Y) + k, data[d]);
        cycle++;
        break;
      case STD_Z:
        WRITE(pair(data, Z) + k, data[d]);
        cycle++;
        break;
      case LDS:
        READ(WORD_AFTER, data[d]);
        pc++;
        cycle++;
        break;
      case STS:
        WRITE(WORD_AFTER, data[d]);
        pc++;
        cycle++;
        break;
#define LOAD(low, before, after)                             \
  {                                                          \
    const uint16_t p = (uint16_t)(pair(data, low) - before); \
    uint8_t byte;                                            \
    READ(p, byte);                                           \
    set_pair(data, low, (uint16_t)(p + after));              \
    data[d] = byte;                                          \
    cycle++;                                                 \
  }
#define STORE(low, before, after)                            \
  {                                                          \
    const uint16_t p = (uint16_t)(pair(data, low) - before); \
    WRITE(p, data[d]);                                       \
    set_pair(data, low, (uint16_t)(p + after));              \
    cycle++;                                                 \
  }
      case LD_X: LOAD(X, 0, 0); break;
      case LD_X_INC: LOAD(X, 0, 1); break;
      case LD_DEC_X: LOAD(X, 1, 0); break;
      case LD_Y_INC: LOAD(Y, 0, 1); break;
      case LD_DEC_Y: LOAD(Y, 1, 0); break;
      case LD_Z_INC: LOAD(Z, 0, 1); break;
      case LD_DEC_Z: LOAD(Z, 1, 0); break;
      case ST_X: STORE(X, 0, 0); break;
      case ST_X_INC: STORE(X, 0, 1); break;
      case ST_DEC_X: STORE(X, 1, 0); break;
      case ST_Y_INC: STORE(Y, 0, 1); break;
      case ST_DEC_Y: STORE(Y, 1, 0); break;
      case ST_Z_INC: STORE(Z, 0, 1); break;
      case ST_DEC_Z: STORE(Z, 1, 0); break;
      case LPM:
        if (pair(data, Z) > avr->flashend) LEAVE_TO_SIMAVR;
        data[d] = flash[pair(data, Z)];
        cycle += 2;
        break;
      case LPM_INC: {
        const uint16_t z = pair(data, Z);
        if (z > avr->flashend) LEAVE_TO_SIMAVR;
        set_pair(data, Z, (uint16_t)(z + 1));
        data[d] = flash[z];
        cycle += 2;
        break;
      }
      case PUSH: {
        const uint16_t sp = pair(data, SPL);
        if (sp > avr->ramend || sp <= avr->ioend) LEAVE_TO_SIMAVR;
        NOTE(sp);
        data[sp] = data[d];
        set_pair(data, SPL, (uint16_t)(sp - 1));
        if (sp - 1 < mega->lowest_sp) mega->lowest_sp = (uint16_t)(sp - 1);
        cycle++;
        break;
      }
      case POP: {
        const uint16_t sp = pair(data, SPL);
        if (sp >= avr->ramend || sp < avr->ioend) LEAVE_TO_SIMAVR;
        data[d] = data[sp + 1];
        set_pair(data, SPL, (uint16_t)(sp + 1));
        cycle++;
        break;
      }

      case COM:
        sreg[S_C] = 1;
        data[d] = logic(sreg, (uint8_t)~data[d]);
        break;
      case NEG: data[d] = subtract(sreg, 0, data[d], 0); break;
      case SWAP: data[d] = (uint8_t)(data[d] >> 4 | data[d] << 4); break;
      case INC:
        sreg[S_V] = ++data[d] == 0x80;
        set_zns(sreg, data[d]);
        break;
      case DEC:
        sreg[S_V] = --data[d] == 0x7F;
        set_zns(sreg, data[d]);
        break;
      case ASR: data[d] = shift_right(sreg, data[d], data[d] & 0x80); break;
      case LSR: data[d] = shift_right(sreg, data[d], 0); break;
      case ROR: data[d] = shift_right(sreg, data[d], (uint8_t)(sreg[S_C] << 7)); break;
      case BSET: avr_sreg_set(avr, d, 1); break;
      case BCLR: avr_sreg_set(avr, d, 0); break;
      case BLD: data[k] = (uint8_t)((data[k] & ~(1 << d)) | sreg[S_T] << d); break;
      case BST: sreg[S_T] = (data[k] >> d) & 1; break;
      case ADIW: {
        const uint16_t before = pair(data, d), after = (uint16_t)(before + k);
        set_pair(data, d, after);
        sreg[S_V] = (uint16_t)(~before & after) >> 15;
        sreg[S_C] = (uint16_t)(before & ~after) >> 15;
        set_zns(sreg, after >> 8);
        sreg[S_Z] = after == 0;
        cycle++;
        break;
      }
      case SBIW: {
        const uint16_t before = pair(data, d), after = (uint16_t)(before - k);
        set_pair(data, d, after);
        sreg[S_V] = (uint16_t)(before & ~after) >> 15;
        sreg[S_C] = (uint16_t)(~before & after) >> 15;
        set_zns(sreg, after >> 8);
        sreg[S_Z] = after == 0;
        cycle++;
        break;
      }

      case CBI:
        WRITE(k, data[at] & (uint8_t) ~(1 << d));
        cycle++;
        break;
      case SBI:
        WRITE(k, data[at] | (uint8_t)(1 << d));
        cycle++;
        break;
      case SBIC: {
        uint8_t byte;
        READ(k, byte);
        SKIP_IF(!(byte >> d & 1));
        break;
      }
      case SBIS: {
        uint8_t byte;
        READ(k, byte);
        SKIP_IF(byte >> d & 1);
        break;
      }
      case IN:
        if (k == R_SREG) {
          uint8_t byte = 0;
          for (int bit = 0; bit < 8; bit++) byte |= (uint8_t)(sreg[bit] << bit);
          data[R_SREG] = byte;
          data[d] = byte;
        } else {
          READ(k, data[d]);
        }
        break;
      case OUT:
        if (k == R_SREG) {
          data[R_SREG] = data[d];
          for (int bit = 0; bit < 8; bit++) avr_sreg_set(avr, bit, (data[d] >> bit) & 1);
        } else {
          WRITE(k, data[d]);
          if (k == SPL && pair(data, SPL) < mega->lowest_sp) mega->lowest_sp = pair(data, SPL);
        }
        break;

      case SBRC: SKIP_IF(!(data[k] >> d & 1)); break;
      case SBRS: SKIP_IF(data[k] >> d & 1); break;
      case BRBS:
        if (sreg[d]) {
          pc += (uint32_t)k;
          cycle++;
          went_back = k < 0;
        }
        break;
      case BRBC:
        if (!sreg[d]) {
          pc += (uint32_t)k;
          cycle++;
          went_back = k < 0;
        }
        break;
      case RJMP:
        pc += (uint32_t)k;
        cycle++;
        went_back = k < 0;
        break;
      case JMP:
        if (k || WORD_AFTER > last_word) LEAVE_TO_SIMAVR;
        went_back = WORD_AFTER < pc;
        pc = WORD_AFTER - 1;
        cycle += 2;
        break;
      case EIJMP:
        if (avr->eind == 0 || data[avr->eind] != 0) LEAVE_TO_SIMAVR;
        /* fall through */
      case IJMP:
        if (pair(data, Z) > last_word) LEAVE_TO_SIMAVR;
        pc = pair(data, Z) - 1u;
        cycle++;
        break;
      case RCALL:
        PUSH_PC(pc + 1);
        pc += (uint32_t)k;
        cycle += call_bytes;
        break;
      case EICALL:
        if (avr->eind == 0 || data[avr->eind] != 0) LEAVE_TO_SIMAVR;
        /* fall through */
      case ICALL:
        if (pair(data, Z) > last_word) LEAVE_TO_SIMAVR;
        PUSH_PC(pc + 1);
        pc = pair(data, Z) - 1u;
        cycle += call_bytes;
        break;
      case CALL:
        if (k || WORD_AFTER > last_word) LEAVE_TO_SIMAVR;
        PUSH_PC(pc + 2);
        pc = WORD_AFTER - 1;
        cycle += call_bytes + 1u;
        break;
      case RET: {
        const uint16_t sp = pair(data, SPL);
        if (sp + call_bytes > avr->ramend || sp < avr->ioend) LEAVE_TO_SIMAVR;
        uint32_t back = 0;
        for (int n = 1; n <= call_bytes; n++) back = back << 8 | data[sp + n];
        if (back > last_word) LEAVE_TO_SIMAVR;
        set_pair(data, SPL, (uint16_t)(sp + call_bytes));
        pc = back - 1;
        cycle += call_bytes + 1u;
        break;
      }
    }
    pc = (pc + 1) & last_word;
    cycle++;
    if (went_back && (mega->idle.pc == pc || mega->idle.pc == IDLE_ANYWHERE)) {
      cycle = idle_visit(mega, pc, cycle, until);
    }
    if (avr->interrupt_state != 0) break;
  }
out:
  avr->cycle = cycle;
  avr->pc = 2 * pc;
  return !slow;
}
