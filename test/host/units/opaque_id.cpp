#include "mavmission/transfer/OpaqueId.h"

#include <doctest/doctest.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <vector>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

struct Item {
  uint8_t frame, autocontinue;
  uint16_t command;
  uint8_t params[kPlaceBytes];
};

// An upload that PX4 acknowledged: what it held then, and the id that it gave it.
struct Recorded {
  uint32_t opaqueId;
  std::vector<Item> items;
};

uint32_t number(FILE* file, int bytes) {
  uint32_t value = 0;
  for (int i = 0; i < bytes; ++i) value |= static_cast<uint32_t>(fgetc(file)) << 8 * i;
  return value;
}

// test_host.py writes them from simulation/recordings/px4.
std::vector<Recorded> recordedUploads() {
  const char* path = getenv("MAVMISSION_UPLOADS");
  REQUIRE_MESSAGE(path != nullptr, "set MAVMISSION_UPLOADS, or run test_host.py, which does");
  FILE* file = fopen(path, "rb");
  REQUIRE(file != nullptr);
  std::vector<Recorded> uploads(number(file, 2));
  for (Recorded& upload : uploads) {
    upload.opaqueId = number(file, 4);
    upload.items.resize(number(file, 2));
    for (Item& item : upload.items) {
      item.frame = static_cast<uint8_t>(number(file, 1));
      item.command = static_cast<uint16_t>(number(file, 2));
      item.autocontinue = static_cast<uint8_t>(number(file, 1));
      REQUIRE(fread(item.params, 1, kPlaceBytes, file) == kPlaceBytes);
    }
  }
  fclose(file);
  return uploads;
}

uint32_t idOf(const std::vector<Item>& items) {
  OpaqueId id;
  id.begin();
  for (const Item& item : items) id.add(&item.frame, &item.command, &item.autocontinue, item.params);
  return id.value();
}

}  // namespace

TEST_CASE("the id of each recorded upload is the one that PX4 gave it") {
  const std::vector<Recorded> uploads = recordedUploads();
  CHECK(uploads.size() >= 5);
  for (const Recorded& upload : uploads) CHECK(idOf(upload.items) == upload.opaqueId);
}

TEST_CASE("one bit changed anywhere in a plan changes its id") {
  std::vector<Item> items = recordedUploads()[0].items;
  const uint32_t id = idOf(items);
  for (Item& item : items) {
    for (size_t byte = 0; byte < kPlaceBytes; ++byte) {
      item.params[byte] = static_cast<uint8_t>(item.params[byte] ^ 1);
      CHECK(idOf(items) != id);
      item.params[byte] = static_cast<uint8_t>(item.params[byte] ^ 1);
    }
    item.command = static_cast<uint16_t>(item.command ^ 0x100);
    CHECK(idOf(items) != id);
    item.command = static_cast<uint16_t>(item.command ^ 0x100);
  }
  CHECK(idOf(items) == id);
}

TEST_CASE("an empty plan has the id 0, and begin() forgets what was added") {
  OpaqueId id;
  id.begin();
  CHECK(id.value() == 0);
  const Item item = {3, 1, 16, {1}};
  id.add(&item.frame, &item.command, &item.autocontinue, item.params);
  CHECK(id.value() != 0);
  id.begin();
  CHECK(id.value() == 0);
}
