#include "Names.h"

#include <stddef.h>

#define MAVMISSION_NAME(name, text) #name,

const char* nameOf(mavmission::Status status) {
  static const char* const kNames[] = {MAVMISSION_STATUSES(MAVMISSION_NAME)};
  return kNames[static_cast<size_t>(status)];
}

const char* nameOf(mavmission::Aboard aboard) {
  static const char* const kNames[] = {MAVMISSION_ABOARD(MAVMISSION_NAME)};
  return kNames[static_cast<size_t>(aboard)];
}

const char* nameOf(mavmission::ItemField field) {
  static const char* const kNames[] = {MAVMISSION_FIELDS(MAVMISSION_NAME)};
  return kNames[static_cast<size_t>(field)];
}
