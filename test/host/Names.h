// The names of the library's enumerators, as a test writes them: "NoAnswer".
#pragma once

#include "mavmission/base/ItemField.h"
#include "mavmission/base/Status.h"

const char* nameOf(mavmission::Status status);
const char* nameOf(mavmission::Aboard aboard);
const char* nameOf(mavmission::ItemField field);
