#include "FilePilot.h"

#include <stdexcept>

using mavmission::ItemSource;
using mavmission::PlanType;

FilePilot::FilePilot(uint8_t autopilot) : AnsweringPeer(autopilot), files(client), isPx4_(autopilot == kPx4) {}

std::string FilePilot::how() {
  ended = mavmission::Status::Idle;
  for (const uint32_t startMs = nowMs(); ended == mavmission::Status::Idle && nowMs() - startMs < 60000;) {
    const size_t before = said_.size();
    one();
    const bool isByItems = said_.size() > before && said_.back().find("items") != std::string::npos;
    if (isByItems && !servesItems) return said();
  }
  std::string text = nameOf(ended);
  const bool isItem = client.failedItem() != mavmission::MissionClient::kNoItem;
  if (isItem) text += " item " + std::to_string(client.failedItem());
  if (client.differingField() != mavmission::ItemField::None)
    text += std::string(" ") + nameOf(client.differingField());
  return text + (files.isByFile() ? " by file, " : ", ") + nameOf(client.aboard()) + ": " + said();
}

std::string FilePilot::says(uint32_t ms) {
  said();
  pass(ms);
  return said();
}

FilePilot& FilePilot::settle() {
  says(4000);
  return *this;
}

FilePilot& FilePilot::has(const Plan& plan) {
  plans[0].assign(1, home());
  for (const mavmission::MissionItem& item : plan) {
    plans[0].push_back(bytesOf(item, static_cast<uint16_t>(plans[0].size())));
  }
  return *this;
}

FilePilot& FilePilot::armed(bool isAllowed) {
  baseMode = 128 | 1;
  beat();
  client.allowWhileArmed(isAllowed);
  return *this;
}

FilePilot& FilePilot::losing() {
  for (int frames = 0; frames < 100; ++frames) {
    lose(3);
    beat();
    pass(5);
  }
  return *this;
}

FilePilot& FilePilot::download(uint16_t limit, PlanType ofType) {
  taken.clear();
  files.download(mavmission::toFunction(take, this, limit), ofType);
  return *this;
}

FilePilot& FilePilot::until(const std::string& words) {
  if (!passUntil(words)) throw std::runtime_error("never said: " + words);
  return *this;
}

Bytes FilePilot::bytesOf(mavmission::MissionItem item, uint16_t seq) const {
  for (float* number : {&item.param1, &item.param2, &item.param3, &item.param4}) {
    if (*number != *number) *number = 0;
  }
  Bytes bytes = itemParts(seq, item, static_cast<mavmission::PlanType>(type)).payload;
  bytes[offsetof(mavlink_mission_item_int_t, target_component)] = 1;
  return bytes;
}

mavlink_mission_item_int_t FilePilot::itemAboard(size_t number) const {
  return messageIn<mavlink_mission_item_int_t>(plans[type].at(number));
}

Bytes FilePilot::home() const { return bytesOf(homeItem(), 0); }

void FilePilot::beat() {
  FrameParts parts = heartbeatParts(isPx4_ ? kPx4 : kArduPilot, baseMode);
  parts.version = version;
  hear(parts);
}

void FilePilot::reply(uint16_t number, uint8_t inSession, uint8_t opcode, uint8_t requested, uint32_t offset,
                      const Bytes& data, bool isComplete) {
  mavmission::detail::FileFrame frame = mavmission::detail::FileFrame();
  frame.system = 1;
  frame.component = 191;
  frame.sequence = number;
  frame.session = inSession;
  frame.opcode = opcode;
  frame.size = static_cast<uint8_t>(data.size());
  frame.requested = requested;
  frame.isBurstComplete = isComplete;
  frame.offset = offset;
  Bytes payload = ::bytesOf(frame);
  payload.resize(frame.kHead);
  hear(FrameParts(MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL, payload + data));
}

void FilePilot::replyIn(uint32_t ms, uint16_t number, uint8_t opcode, uint8_t requested, uint32_t offset,
                        const Bytes& data) {
  const uint8_t inSession = session;
  in(ms, [=] { reply(number, inSession, opcode, requested, offset, data); });
}

void FilePilot::one() {
  if (nowMs() % 1000 == 0) beat();
  passDue();
  const size_t before = sent.size();
  run(1);
  for (size_t i = before; i < sent.size(); ++i) {
    const Bytes payload = sent[i].payload;
    switch (sent[i].messageId) {
      case 110: react(payload); break;
      case kRequestList: giveCount(); break;
      case kCount: takeItem(0, payload[0]); break;
      case kItemInt: takeItem(static_cast<uint16_t>(payload[28] + 1), itemsToTake_); break;
      case kRequest:
      case kRequestInt: giveItem(payload[0]); break;
      default: break;
    }
  }
}

void FilePilot::giveCount() {
  say(files.isByFile() ? "prove items" : "read items");
  isFirst_ = true;
  if (servesItems) hear(countParts(static_cast<uint16_t>(plans[0].size() + tooMany)));
}

void FilePilot::giveItem(uint8_t number) {
  if (isFirst_ && number != 0) said_.back() += " from " + std::to_string(number);
  isFirst_ = false;
  if (!servesItems || number >= plans[0].size()) return;
  mavlink_mission_item_int_t item = itemAboard(number);
  if (number == damaged) item.z += 1;
  item.target_system = 1;
  item.target_component = 191;
  hear(FrameParts(kItemInt, item, 38));
}

void FilePilot::takeItem(uint16_t number, uint16_t items) {
  if (number == 0) {
    itemsToTake_ = items;
    say("upload items");
  }
  if (!servesItems || takenAs == kSilent) return;
  damaged = 0;
  tooMany = 0;
  hear(number == items ? ackParts(static_cast<uint8_t>(takenAs), 1, 191, 0, nameOfPlan) : requestParts(number));
}

bool FilePilot::take(void* context, uint16_t index, const mavmission::MissionItem& item) {
  FilePilot& self = *static_cast<FilePilot*>(context);
  if (self.taken.size() == self.takes) return false;
  self.taken.push_back({index, item});
  return true;
}

ItemSource FilePilot::sourceOf(const Plan& plan) {
  return mavmission::inRam(plan.data(), static_cast<uint32_t>(plan.size()));
}

void FilePilot::react(const Bytes& request) {
  const mavmission::detail::FileFrame frame = messageIn<mavmission::detail::FileFrame>(request);
  sequence = frame.sequence;
  session = frame.session;
  const uint8_t opcode = frame.opcode, size = frame.size;
  const uint32_t offset = frame.offset;
  const Bytes data(request.begin() + 15, request.begin() + 15 + size);
  const std::string range = std::to_string(offset) + "+" + std::to_string(size);
  std::string words;
  switch (opcode) {
    case kTerminate: words = "close"; break;
    case kOpen: words = "open " + fileOf(data); break;
    case kCreate: words = "create " + fileOf(data); break;
    case kRead: words = "read " + range; break;
    case kBurst: words = "burst " + range; break;
    case kWrite: words = "write " + range; break;
    default: words = "?";
  }
  const bool isClean = (frame.network | frame.requested | frame.isBurstComplete | frame.padding) == 0;
  if (frame.system != 1 || frame.component != 1 || !isClean) words += " !";
  if (opcode == kOpen || opcode == kCreate) type = data[9] == 'm' ? 0 : data[9] == 'f' ? 1 : 2;
  say(words);
  const int result = resultOf(opcode);
  if (result == kUnheard) return;
  const uint16_t number = static_cast<uint16_t>(sequence + 1);
  if (result > 0) return replyIn(delayMs, number, 129, opcode, offset, {static_cast<uint8_t>(result)});
  Bytes answer;
  switch (opcode) {
    case kOpen: answer = {0, 0, 0, 0}; break;
    case kCreate: written_.clear(); break;
    case kWrite:
      if (written_.size() < offset + size) written_.resize(offset + size);
      std::copy(data.begin(), data.end(), written_.begin() + static_cast<long>(offset));
      break;
    case kTerminate: store(); break;
    case kRead: answer = part(offset, size); break;
    case kBurst:
      if (result != kSilent) burst(number, offset);
      return;
    default: break;
  }
  if (result != kSilent) replyIn(delayMs, number, 128, opcode, offset, answer);
}

std::string FilePilot::fileOf(const Bytes& path) {
  const std::string text(path.begin(), path.end());
  for (const char* name : {"mission", "fence", "rally"}) {
    if (text == std::string("@MISSION/") + name + ".dat") return name;
  }
  return text;
}

Bytes FilePilot::file() const {
  const std::vector<Bytes>& aboard = plans[type];
  Bytes whole = {
      0x3D, 0x76, type, 0, 0, 0, 0, 0, static_cast<uint8_t>(aboard.size()), static_cast<uint8_t>(aboard.size() >> 8)};
  for (const Bytes& item : aboard) whole = whole + item;
  return whole;
}

Bytes FilePilot::part(uint32_t offset, uint8_t size) const {
  const Bytes whole = file();
  if (offset >= whole.size()) return Bytes();
  const size_t end = offset + size < whole.size() ? offset + size : whole.size();
  return Bytes(whole.begin() + static_cast<long>(offset), whole.begin() + static_cast<long>(end));
}

void FilePilot::burst(uint16_t number, uint32_t offset) {
  uint32_t ms = delayMs;
  const size_t end = file().size();
  for (; offset < end; offset += 38, ms += 5) {
    if (offset != 10u + 38u * lostItem) replyIn(ms, number, 128, kBurst, offset, part(offset, 38));
    ++number;
  }
  lostItem = 0xFFFF;
  replyIn(ms, number, 129, kBurst, offset, {6});  // MAV_FTP_ERR_EOF
}

void FilePilot::store() {
  if (written_.size() < 10 || written_[0] != 0x3D || written_[1] != 0x76) return;
  std::vector<Bytes>& aboard = plans[type];
  aboard.clear();
  for (size_t at = 10; at + 38 <= written_.size(); at += 38) {
    aboard.push_back(Bytes(written_.begin() + static_cast<long>(at), written_.begin() + static_cast<long>(at) + 38));
  }
  if (type == 0 && !aboard.empty()) aboard[0] = home();  // its own, whatever is given
  header.assign(written_.begin(), written_.begin() + 10);
  ++stored;
  written_.clear();
}

namespace {

using namespace mavmission;

FilePilot::Plan planOf(Metres height) {
  return {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
          waypoint(-35.3642621_deg, 149.1662374_deg, height), returnToLaunch()};
}

}  // namespace

const FilePilot::Plan kFourItems = planOf(30_m), kOneHigher = planOf(31_m),
                      kTwoItems(kFourItems.begin(), kFourItems.begin() + 2);
const FilePilot::Plan kThreeCorners = {fenceInside(-35.3632621_deg, 149.1652374_deg, 3),
                                       fenceInside(-35.3642621_deg, 149.1652374_deg, 3),
                                       fenceInside(-35.3642621_deg, 149.1662374_deg, 3)};

FilePilot::Plan manyWaypoints(int number) {
  FilePilot::Plan plan;
  for (int i = 0; i < number; ++i) {
    plan.push_back(waypoint(Degrees::fromE7(100000 + i), Degrees::fromE7(200000 + i), 20_m));
  }
  return plan;
}
