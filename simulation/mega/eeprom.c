/* The time that a byte of EEPROM takes: simavr's is there at once. (Data sheet,
 * "EEPROM Data Memory": 3.4 ms, in which EEPE is set and no other is begun.) */
#include "mega.h"

#include <string.h>

#include <simavr/sim_io.h>
#include <simavr/sim_time.h>

enum { WRITE_US = 3400 };

static avr_cycle_count_t written(avr_t* avr, avr_cycle_count_t when, void* param) {
  mega_t* mega = param;
  (void)when;
  avr_regbit_clear(avr, mega->eeprom->eepe);
  mega->eeprom_address = -1;
  return 0;
}

static void control(avr_t* avr, avr_io_addr_t address, uint8_t value, void* param) {
  mega_t* mega = param;
  avr_eeprom_t* eeprom = mega->eeprom;
  const uint8_t enable = (uint8_t)(1u << eeprom->eepe.bit);
  if (mega->eeprom_address >= 0) { /* one at a time; EEPE stays as it is */
    avr->data[address] = (uint8_t)(value | enable);
    return;
  }
  const bool begins = (value & enable) != 0 && avr_regbit_get(avr, eeprom->eempe);
  mega->eeprom_control(avr, address, value, mega->eeprom_param);
  if (!begins) return;
  mega->eeprom_address = avr->data[eeprom->r_eearl] | avr->data[eeprom->r_eearh] << 8;
  avr_regbit_set(avr, eeprom->eepe);
  avr_cycle_timer_register_usec(avr, WRITE_US, written, mega);
}

void eeprom_attach(mega_t* mega) {
  avr_t* avr = mega->avr;
  mega->eeprom_address = -1;
  for (avr_io_t* io = avr->io_port; io != NULL; io = io->next) {
    if (strcmp(io->kind, "eeprom") != 0) continue;
    mega->eeprom = (avr_eeprom_t*)io;
    const avr_io_addr_t at = AVR_DATA_TO_IO(mega->eeprom->r_eecr);
    mega->eeprom_control = avr->io[at].w.c;
    mega->eeprom_param = avr->io[at].w.param;
    avr->io[at].w.c = control;
    avr->io[at].w.param = mega;
  }
}

/* The address of the byte that is being written, or -1. */
int mega_eeprom_writing(const mega_t* mega) { return mega->eeprom_address; }
