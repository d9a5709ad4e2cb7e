// The MissionClient of bench.cpp and service.cpp, its plan, and the words that both have.
#pragma once

#include "ClientTalk.h"
#include "Line.h"

using namespace mavmission;
using namespace mavmission::detail;

static const uint8_t kPlanItems = 60;

extern "C" {
MissionItem benchPlan[kPlanItems] FROM_OUTSIDE;
}

Line line(Serial1);
MissionClient client(line);

static ItemSource plan = emptyPlan();

static void tellProgress(uint16_t done, uint16_t total) {
  tell(F("progress"), done);
  Serial.print(' ');
  Serial.println(total);
}

ACTION(ram) { plan = inRam(benchPlan, numbers[0]); }
ACTION(empty) { plan = emptyPlan(); }
ACTION(cancel) { client.cancel(); }
ACTION(ids) { client.setSourceIds(numbers[0], numbers[1]); }
ACTION(talk) { client.setTargetIds(numbers[0], numbers[1]); }
ACTION(speak) { client.setMavlinkVersion(static_cast<MavlinkVersion>(numbers[0])); }
ACTION(armed) { client.allowWhileArmed(numbers[0]); }
ACTION(raw) { client.useRawNumbering(numbers[0]); }
ACTION(waiting) { client.setAutopilotTimeout(numbers[0]); }
ACTION(limit) { client.setOperationTimeout(numbers[0]); }
ACTION(backoff) { client.retryWhenBusy(numbers[0]); }
ACTION(stall) { setStall(numbers); }
ACTION(counters) { tellCounters(client.counters()); }
ACTION(room) { line.setRoom(numbers[0]); }
ACTION(blocked) {
  tell(F("blocked"), line.blocked());
  Serial.println();
}

#define WORDS_OF_CLIENT                                                                                            \
  WORD(ram), WORD(empty), WORD(cancel), WORD(ids), WORD(talk), WORD(speak), WORD(armed), WORD(raw), WORD(waiting), \
      WORD(limit), WORD(backoff), WORD(stall), WORD(counters), WORD(room), WORD(blocked)
