// The names of the library's enumerators, as a test writes them: "NoAnswer".
#pragma once

#include "mavmission/base/ItemField.h"
#include "mavmission/base/Status.h"

const char* nameOf(mavmission::Status status);
const char* nameOf(mavmission::Aboard aboard);
const char* nameOf(mavmission::ItemField field);

// MAV_MISSION_RESULT, in words.
constexpr const char* kMissionResults[] = {
    "accepted",  "error",           "unsupported frame", "unsupported",      "no space",
    "invalid",   "invalid param 1", "invalid param 2",   "invalid param 3",  "invalid param 4",
    "invalid x", "invalid y",       "invalid param 7",   "invalid sequence", "denied",
    "cancelled"};
