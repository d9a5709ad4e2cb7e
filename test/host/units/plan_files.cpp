// PlanFiles by a whole client: what is asked of ArduPilot's files, word by word, and what an operation ends with.
#include <doctest/doctest.h>

#include "FilePilot.h"

using namespace mavmission;

namespace {

typedef FoundPilot Pilot;
constexpr int kSilent = FilePilot::kUnheard;
constexpr uint8_t kOpen = FilePilot::kOpen, kRead = FilePilot::kRead, kBurst = FilePilot::kBurst;
constexpr uint8_t kCreate = FilePilot::kCreate, kWrite = FilePilot::kWrite, kClose = FilePilot::kTerminate;
constexpr int kErrors[] = {FilePilot::kFail, FilePilot::kInvalidSession, FilePilot::kFileNotFound};
const std::string kCountRead = "open mission, read 0+10, close";

uint16_t behind(const FilePilot& pilot, int requests) { return static_cast<uint16_t>(pilot.sequence + requests); }

}  // namespace

TEST_CASE("a plan is written as a file, its header last, and read back") {
  Pilot pilot;
  CHECK((pilot.files.upload(FilePilot::sourceOf(kFourItems)) == Status::WaitingForAutopilot));
  CHECK_FALSE(pilot.files.isByFile());
  CHECK(pilot.how() == "Accepted by file, OurPlan: " + kFileWrittenAndRead);
  CHECK(pilot.client.itemsTotal() == 4);
  CHECK(pilot.client.itemsDone() == 4);
  CHECK(pilot.stored == 1);
  CHECK(pilot.header == Bytes{0x3D, 0x76, 0, 0, 0, 0, 0, 0, 5, 0});
  REQUIRE(pilot.plans[0].size() == 5);
  for (uint16_t i = 1; i < 5; ++i) CHECK(pilot.plans[0][i] == pilot.bytesOf(kFourItems[i - 1u], i));
  CHECK(pilot.says(5000) == "");
}

TEST_CASE("no frame ends with a zero that MAVLink 2 leaves out") {
  // The last item ends with a mission_type of 0, an autocontinue of 1.
  const FilePilot::Plan kEnds = {kFourItems[0], kFourItems[1], kFourItems[3]};
  for (long number = 1; number <= 3; ++number) {
    const FilePilot::Plan plan(kEnds.begin(), kEnds.begin() + number);
    Pilot pilot;
    pilot.sent.clear();
    pilot.upload(plan);
    CHECK((pilot.end() == Status::Accepted));
    CHECK(pilot.timesOf(110, 0).size() == 8);
    for (const SentFrame& frame : pilot.sent) {
      if (frame.messageId == 110) CHECK(frame.frame[9u + frame.frame[1]] != 0);
    }
    CHECK(pilot.itemAboard(static_cast<size_t>(number)).autocontinue == 1);
  }
}

TEST_CASE("the items that are written are told one write after the other, the last one when the plan is proven") {
  const FilePilot::Plan many = manyWaypoints(20);
  Pilot pilot;
  pilot.delayMs = 60;  // one write at a time
  pilot.upload(many);
  std::string done;
  uint16_t last = 0;
  for (int ms = 0; ms < 5000 && pilot.client.isBusy(); ++ms) {
    pilot.pass(1);
    if (pilot.client.itemsDone() != last) done += std::to_string(last = pilot.client.itemsDone()) + " ";
  }
  CHECK(done == "4 10 16 19 20 ");
  CHECK(pilot.client.itemsDone() == 20);
  CHECK((pilot.ended == Status::Accepted));
}

TEST_CASE("each request has a number of its own, and a repeat that of the request") {
  Pilot pilot;
  pilot.upload(kFourItems);
  std::string steps;
  uint16_t before = pilot.sequence;
  for (const char* words : {"create", "write 10", "write 0", "close", "open", "read", "burst", "close"}) {
    REQUIRE(pilot.passUntil(words));
    CHECK(pilot.session == static_cast<uint8_t>((1 * 31) ^ 191 ^ 0x5A));
    steps += std::to_string(static_cast<uint16_t>(pilot.sequence - before)) + " ";
    before = pilot.sequence;
  }
  // One is left out between two operations; the pieces of the burst and its end have each their own.
  CHECK(steps.substr(steps.find(' ')) == " 1 1 1 2 1 1 8 ");
  pilot.end();
  pilot.answering(kOpen, kSilent).verify(kFourItems);
  REQUIRE(pilot.passUntil("open"));
  before = pilot.sequence;
  REQUIRE(pilot.passUntil("open"));
  CHECK(pilot.sequence == before);
  pilot.answering().answering(kBurst, kSilent);
  REQUIRE(pilot.passUntil("burst"));
  before = pilot.sequence;
  REQUIRE(pilot.passUntil("burst"));
  CHECK(pilot.sequence == static_cast<uint16_t>(before + 8));  // a burst is given again with another number
}

TEST_CASE("six items are one write, and the next ones leave before its answer") {
  const FilePilot::Plan many = manyWaypoints(20);
  Pilot pilot;
  CHECK(pilot.upload(many).how() ==
        "Accepted by file, OurPlan: create mission, write 10+228, write 238+228, write 466+228, write 694+114, "
        "write 0+10, close, open mission, read 0+10, burst 10+38, close");
  CHECK(pilot.plans[0].size() == 21);
  CHECK(int32_t{pilot.itemAboard(20).x} == 100019);
  // One that a burst has lost is read by itself.
  pilot.lostItem = 7;
  CHECK(pilot.verify(many).how() ==
        "Verified by file, OurPlan: open mission, read 0+10, burst 10+38, read 276+38, close");
}

TEST_CASE("fences and rally points have files of their own; a fence of up to three items goes by items") {
  FilePilot::Plan corners(4, fenceInside(-35.3632621_deg, 149.1652374_deg, 4));
  for (int32_t i = 0; i < 4; ++i) corners[static_cast<size_t>(i)].x += 10000 * i;
  const FilePilot::Plan points = {rallyPoint(-35.3632621_deg, 149.1652374_deg, 20_m)};
  Pilot pilot;
  CHECK(pilot.upload(corners, PlanType::Fence).how() ==
        "Accepted by file, NotKnown: create fence, write 10+152, write 0+10, close, open fence, read 0+10, "
        "burst 10+38, close");
  CHECK(pilot.plans[1].size() == 4);
  CHECK(uint8_t{pilot.itemAboard(0).mission_type} == 1);
  CHECK(pilot.upload(points, PlanType::Rally).how() ==
        "Accepted by file, NotKnown: create rally, write 10+38, write 0+10, close, open rally, read 0+10, "
        "read 10+38, close");
  CHECK(pilot.plans[2].size() == 1);
  CHECK(Pilot().upload(kThreeCorners, PlanType::Fence).how() == "upload items");
  CHECK(Pilot().ensure(kThreeCorners, PlanType::Fence).how() == "read items");
}

TEST_CASE("what is aboard is verified, found, and found to be another plan") {
  Pilot pilot;
  pilot.has(kFourItems);
  CHECK(pilot.verify(kFourItems).how() == "Verified by file, OurPlan: " + kFileRead);
  CHECK(pilot.ensure(kFourItems).how() == "AlreadyAboard by file, OurPlan: " + kFileRead);
  CHECK(pilot.verify(kOneHigher).how() == "Differs item 2 Height by file, NotKnown: " + kFileRead);
  // Nothing is known of the next plan that is ensured, as soon as it is looked for.
  CHECK((pilot.verify(kFourItems).end() == Status::Verified));
  CHECK((pilot.ensure(kOneHigher).client.aboard() == Aboard::OurPlan));
  pilot.said();
  while (pilot.said() == "" && pilot.client.isBusy()) pilot.pass(1);
  CHECK((pilot.client.aboard() == Aboard::NotKnown));
  CHECK(pilot.how() == "Accepted by file, OurPlan: read 0+10, burst 10+38, close, " + kFileWrittenAndRead);
  CHECK(pilot.stored == 1);
  CHECK(pilot.verify(kTwoItems).how() == "Differs Count by file, NotKnown: " + kCountRead);
  // Our own plan that is not aboard any more is not known to be there.
  CHECK(pilot.upload(kFourItems).how() == "Accepted by file, OurPlan: " + kFileWrittenAndRead);
  CHECK(pilot.has(kOneHigher).verify(kFourItems).how() == "Differs item 2 Height by file, NotKnown: " + kFileRead);
}

TEST_CASE("a plan is downloaded as a file, home apart, and what is known of the plan aboard stays") {
  Pilot pilot;
  pilot.upload(kFourItems).how();
  CHECK(pilot.download().how() == "Downloaded by file, OurPlan: " + kFileRead);
  CHECK(pilot.client.itemsDone() == 4);
  REQUIRE(pilot.taken.size() == 5);
  CHECK(pilot.taken[0].index == kHomeIndex);
  for (uint16_t i = 0; i < 4; ++i) {
    const MissionItem& item = pilot.taken[i + 1u].item;
    CHECK(pilot.taken[i + 1u].index == i);
    CHECK(pilot.bytesOf(item, i) == pilot.bytesOf(kFourItems[i], i));
  }
  pilot.takes = 2;
  CHECK(pilot.download().how() == "SinkFull item 1 by file, OurPlan: " + kFileRead);
  CHECK(pilot.download(3).how() == "SinkFull by file, OurPlan: " + kCountRead);
  CHECK(pilot.taken.empty());
}

TEST_CASE("what an item has of its own in a file is given, but not whether it is current, nor what another has left") {
  Pilot pilot;
  pilot.has(kFourItems);
  MissionItem item = kFourItems[1], left = kFourItems[3];
  item.current = 1;
  item.autocontinue = 0;
  left.x = 5;  // its command has no x, y and z: they are 0
  left.y = 6;
  left.z = 7;
  pilot.plans[0][4] = pilot.bytesOf(left, 4);
  CHECK((pilot.verify(kFourItems).end() == Status::Verified));
  pilot.plans[0][2] = pilot.bytesOf(item, 2);
  CHECK((pilot.download().end() == Status::Downloaded));
  item.current = 0;
  CHECK(pilot.bytesOf(pilot.taken[2].item, 0) == pilot.bytesOf(item, 0));
  CHECK(pilot.bytesOf(pilot.taken[4].item, 0) == pilot.bytesOf(kFourItems[3], 0));
}

TEST_CASE("PX4, a sink that is not always ready, and what cannot be in a file get the mission protocol") {
  CHECK(Pilot(ClientOnLine::kPx4).upload(kFourItems).how() == "upload items");
  CHECK(Pilot(ClientOnLine::kPx4).verify(kFourItems).how() == "read items");
  CHECK(Pilot(ClientOnLine::kPx4).ensure(kFourItems).how() == "read items");
  Pilot waiting;
  ItemSink slow = toFunction(FilePilot::take, &waiting);
  slow.isReady = [](void*) { return true; };
  waiting.files.download(slow);
  CHECK(waiting.how() == "read items");
  // A command that the library does not know, and more than 650 items, with home.
  const FilePilot::Plan unknown = {takeoff(20_m), anyCommandAt(31234, 1_deg, 2_deg, 20_m)};
  CHECK(Pilot().upload(unknown).how() == "upload items");
  CHECK(Pilot().ensure(unknown).how() == "read items");
  const FilePilot::Plan full = manyWaypoints(650), most = manyWaypoints(649);
  CHECK(Pilot().upload(full).how() == "upload items");
  CHECK(Pilot().upload(most).until("create").said() == "create mission");
}

TEST_CASE("on a link of MAVLink 1 no file is asked for, and there are no fences") {
  FilePilot pilot;
  pilot.version = 1;
  CHECK(pilot.settle().download(100, PlanType::Fence).how() == "NeedsMavlink2, NotKnown: ");
  pilot.pass(2000);
  CHECK((pilot.client.status() == Status::NeedsMavlink2));
  CHECK(pilot.download().how() == "read items");
}

TEST_CASE("a refusal leads to the mission protocol: of the first request, or since somebody else has the file") {
  for (int error : kErrors) {
    CHECK(Pilot().answering(kCreate, error).upload(kFourItems).how() == "create mission, upload items");
    CHECK(Pilot().answering(kOpen, error).verify(kFourItems).how() == "open mission, read items");
    CHECK(Pilot().answering(kOpen, error).ensure(kFourItems).how() == "open mission, read items");
  }
  const struct {
    uint8_t refused;
    const char* words;
  } kCases[] = {{kWrite, "create mission, write 10+190, upload items"},
                {kClose, "create mission, write 10+190, write 0+10, close, upload items"},
                {kRead, "open mission, read 0+10, read items"},
                {kBurst, "open mission, read 0+10, burst 10+38, read items"}};
  for (const auto& one : kCases) {
    const bool isUpload = one.refused == kWrite || one.refused == kClose;
    Pilot pilot;
    pilot.has(kFourItems).answering(one.refused, FilePilot::kInvalidSession);
    CHECK((isUpload ? pilot.upload(kFourItems) : pilot.verify(kFourItems)).how() == one.words);
    CHECK((pilot.client.aboard() == Aboard::NotKnown));
  }
  Pilot silent;  // twelve times no answer are a refusal, too
  REQUIRE(silent.answering(kCreate, kSilent).upload(kFourItems).passUntil("create"));
  const uint32_t firstMs = silent.nowMs();
  CHECK(silent.passUntil("upload items"));
  CHECK(silent.nowMs() - firstMs >= 7200);
  CHECK(silent.nowMs() - firstMs <= 7250);
}

TEST_CASE("a file that falls silent ends the operation, and what is aboard is what was before") {
  const auto ends = [](FilePilot& pilot) {
    const std::string how = pilot.how();
    return how.substr(0, how.find(':'));
  };
  Pilot writing;  // the first item is home, and so none that has failed
  CHECK(ends(writing.answering(kWrite, kSilent).upload(kFourItems)) == "TimedOut by file, AsBefore");
  CHECK(writing.stored == 0);
  CHECK(ends(Pilot().answering(kClose, kSilent).upload(kFourItems)) == "Unconfirmed by file, NotKnown");
  for (uint8_t opcode : {kRead, kBurst}) {
    CHECK(ends(Pilot().has(kFourItems).answering(opcode, kSilent).verify(kFourItems)) == "TimedOut by file, NotKnown");
    CHECK(ends(Pilot().answering(opcode, kSilent).upload(kFourItems)) == "Unconfirmed by file, NotKnown");
  }
  Pilot closing;  // the answer to the closing of what was read is not waited for long
  CHECK((closing.has(kFourItems).answering(kClose, kSilent).verify(kFourItems).end() == Status::Verified));
  CHECK(closing.tookMs < 400);
}

TEST_CASE("another plan that is read back is one that differs") {
  CHECK(Pilot().upload(kFourItems).until("open").has(kOneHigher).how() ==
        "Differs item 2 Height by file, NotKnown: " + kFileWrittenAndRead);
}

TEST_CASE("an armed ArduPilot is asked how many items it has, and gets no file that is shorter") {
  CHECK(Pilot().has(kOneHigher).armed().wait(1000).upload(kFourItems).how() ==
        "Accepted by file, OurPlan: " + kCountRead + ", " + kFileWrittenAndRead);
  CHECK(Pilot().has(kOneHigher).armed().wait(1000).upload(kTwoItems).how() == kCountRead + ", upload items");
  CHECK(Pilot().answering(kOpen, FilePilot::kFileNotFound).armed().wait(1000).upload(kFourItems).how() ==
        "open mission, upload items");
  CHECK(Pilot().armed(false).wait(1000).upload(kFourItems).how() == "Armed, NotKnown: ");
}

TEST_CASE("ArduPilot that is armed while its plan is written gets no header, and no plan unless that is allowed") {
  CHECK(Pilot().upload(kFourItems).until("write 10").armed(false).how() ==
        "Armed by file, AsBefore: create mission, write 10+190");
  Pilot pilot;
  pilot.client.allowWhileArmed(true);
  CHECK(pilot.upload(kFourItems).until("write 10").armed().how() == "create mission, write 10+190, upload items");
}

TEST_CASE("an armed ArduPilot keeps its plan from ensure(), which looks at it by the mission protocol") {
  CHECK(Pilot().armed().wait(1000).ensure(kFourItems).how() == "read items");
  Pilot looking, writing, refusing;  // when it is armed
  for (FilePilot* pilot : {&looking, &writing, &refusing}) {
    pilot->has(kOneHigher).client.allowWhileArmed(true);
    if (pilot == &refusing) pilot->answering(kWrite, FilePilot::kInvalidSession);
    CHECK((pilot->ensure(kFourItems).until(pilot == &looking ? "burst" : "write 10").armed().end() == Status::Armed));
    CHECK(pilot->stored == 0);
  }
}

TEST_CASE("a file that may have been left open before a reset is made unusable, and closed, and then left alone") {
  CHECK(FilePilot().says(6000) == "write 0+10, close");
  CHECK(FilePilot().answering(kWrite, kSilent).answering(kClose, kSilent).says(20000) ==
        "write 0+10, write 0+10, write 0+10, write 0+10, write 0+10");
  CHECK(FilePilot().armed(false).says(6000) == "");
  CHECK(FilePilot(ClientOnLine::kPx4).says(6000) == "");
  CHECK(FilePilot().answering(kWrite, FilePilot::kInvalidSession).says(6000) == "write 0+10");
  CHECK(FilePilot().answering(kWrite, FilePilot::kFileNotFound).says(6000) == "write 0+10");
  CHECK(FilePilot().answering(kWrite, FilePilot::kFail).says(6000) == "write 0+10, close");  // it is open for reading
}

TEST_CASE("a file that an operation has left open is closed with a heartbeat, until that is answered") {
  Pilot pilot;
  pilot.upload(kFourItems).until("write 10").cancel().answering(kClose, kSilent).wait(100);
  CHECK(pilot.says(10000) == "close, close, close, close, close, close, close, close, close, close");
  CHECK(pilot.answering().says(3000) == "close");
  CHECK(pilot.stored == 0);
  // All the same when the autopilot is armed by now.
  CHECK(Pilot().upload(kFourItems).until("write 10").cancel().armed(false).says(3100) == "close");
  // An opening that is not answered may have been carried out: it is closed, five times at most.
  Pilot silent;
  silent.answering(kCreate, kSilent).answering(kClose, kSilent).upload(kFourItems).until("create").cancel();
  CHECK(silent.says(12000) == "close, close, close, close, close");
  // A plan that is complete in its file is not stored by the closing.
  Pilot complete;
  complete.upload(kFourItems).until("write 0+10").cancel();
  CHECK((complete.client.aboard() == Aboard::NotKnown));
  CHECK(complete.wait(100).says(5000) == "write 0+10, close");
  CHECK(complete.stored == 0);
}

TEST_CASE("a source that gives no item ends the upload, and names that item") {
  const auto read = [](void* context, uint16_t index, MissionItem& item) {
    uint16_t& reads = *static_cast<uint16_t*>(context);
    if (index == 2 && ++reads > 1) return false;
    item = kFourItems[index];
    return true;
  };
  uint16_t reads = 0;
  Pilot pilot;
  pilot.files.upload(fromFunction(read, 4, &reads));
  CHECK(pilot.how() == "SourceRefused item 2 by file, AsBefore: create mission");
}

TEST_CASE("an operation is refused while another one runs, and a plan that cannot be meant at once") {
  Pilot pilot;
  const ItemSource plan = FilePilot::sourceOf(kFourItems);
  pilot.files.verify(plan);
  CHECK((pilot.files.verify(plan) == Status::Busy));
  CHECK((pilot.files.upload(plan) == Status::Busy));
  CHECK((pilot.files.ensure(plan) == Status::Busy));
  CHECK((pilot.files.download(toFunction(FilePilot::take, &pilot)) == Status::Busy));
  pilot.how();
  const FilePilot::Plan wrong = {takeoff(20_m), waypoint(91_deg, 0_deg, 20_m)};
  CHECK(pilot.upload(wrong).how() == "BadLatitude item 1, NotKnown: ");
  CHECK(pilot.ensure(wrong).how() == "BadLatitude item 1, NotKnown: ");
}

TEST_CASE("an operation ends with its time, and a reading when its file is closed") {
  const auto tookMs = [](uint8_t unheard, uint16_t limitS, bool isUpload) {
    Pilot pilot;
    pilot.has(kFourItems).answering(unheard, kSilent).client.setOperationTimeout(limitS);
    isUpload ? pilot.upload(kFourItems) : pilot.verify(kFourItems);
    CHECK((pilot.end() == Status::TookTooLong));
    return pilot.tookMs;
  };
  CHECK(tookMs(kWrite, 3, true) < 5000);
  CHECK(tookMs(kOpen, 1, false) < 3000);
  Pilot pilot;
  pilot.has(kFourItems).answering(kBurst, kSilent).client.setOperationTimeout(1);
  CHECK((pilot.verify(kFourItems).until("close").end() == Status::TookTooLong));
  CHECK(pilot.tookMs < 20);
}

TEST_CASE("answers with another session, to other components, or to older requests are none") {
  Pilot pilot;
  pilot.answering(kOpen, kSilent).has(kFourItems).verify(kFourItems).until("open");
  const uint16_t number = behind(pilot, 1);
  pilot.reply(number, static_cast<uint8_t>(pilot.session + 1), 128, kOpen, 0, {0, 0, 0, 0});
  pilot.reply(static_cast<uint16_t>(number - 2), pilot.session, 128, kOpen, 0, {0, 0, 0, 0});
  pilot.reply(static_cast<uint16_t>(number - 3), pilot.session, 129, kOpen, 0, {10});
  CHECK(pilot.says(300) == "");
  pilot.reply(number, pilot.session, 128, kOpen, 0, {0, 0, 0, 0});
  CHECK(pilot.says(50) == "read 0+10, burst 10+38, close");
}

TEST_CASE("a header of another file, or of another plan, is none") {
  const Bytes kHeaders[] = {
      {0x3E, 0x76, 0, 0, 0, 0, 0, 0, 5, 0}, {0x3D, 0x77, 0, 0, 0, 0, 0, 0, 5, 0}, {0x3D, 0x76, 1, 0, 0, 0, 0, 0, 5, 0}};
  for (const Bytes& header : kHeaders) {
    Pilot pilot;
    pilot.has(kFourItems).answering(kRead, kSilent).verify(kFourItems).until("read");
    pilot.reply(behind(pilot, 1), pilot.session, 128, kRead, 0, header);
    CHECK(pilot.says(200) == "");
    CHECK(pilot.passUntil("read 0+10", 300));
  }
}

TEST_CASE("a piece that is no item, or none of the file, is not taken") {
  Pilot pilot;
  pilot.has(kFourItems).answering(kBurst, kSilent).verify(kFourItems).until("burst");
  const uint16_t number = behind(pilot, 1);
  const Bytes& first = pilot.plans[0][1];  // would be another item
  pilot.reply(number, pilot.session, 128, kBurst, 11, first);
  pilot.reply(number, pilot.session, 128, kBurst, 10 + 38 * 65536u, first);
  pilot.reply(number, pilot.session, 128, kBurst, 10, Bytes(first.begin(), first.begin() + 37));
  pilot.pass(20);
  CHECK(pilot.client.itemsDone() == 0);
  for (uint16_t i = 0; i < 5; ++i) {
    pilot.reply(static_cast<uint16_t>(number + i), pilot.session, 128, kBurst, 10u + 38u * i, pilot.plans[0][i]);
  }
  CHECK((pilot.end(200) == Status::Verified));
}

TEST_CASE("where the file is lost in the middle, a download goes on by items, and a comparison begins anew") {
  for (bool isCompared : {false, true}) {
    Pilot pilot;
    pilot.serving().has(kFourItems).answering(kBurst, kSilent);
    (isCompared ? pilot.verify(kFourItems) : pilot.download()).until("burst");
    for (uint16_t i = 0; i < 3; ++i) {
      pilot.reply(behind(pilot, 1 + i), pilot.session, 128, kBurst, 10u + 38u * i, pilot.plans[0][i]);
      pilot.pass(5);
    }
    pilot.refuse(behind(pilot, 4), kBurst, FilePilot::kInvalidSession);
    CHECK(pilot.how() == std::string(isCompared ? "Verified, OurPlan" : "Downloaded, NotKnown") +
                             ": open mission, read 0+10, burst 10+38, read items" + (isCompared ? "" : " from 3"));
    CHECK(pilot.taken.size() == (isCompared ? 0 : 5));
  }
}

TEST_CASE("an autopilot without files is asked for all items, and so is one that does not answer twelve times") {
  Pilot px4(ClientOnLine::kPx4), silent;
  CHECK(px4.serving().has(kFourItems).download().how() == "Downloaded, NotKnown: read items");
  CHECK(silent.serving().has(kFourItems).answering(kOpen, kSilent).download().until("read items").said() ==
        "open mission, open mission, open mission, open mission, open mission, open mission, open mission, "
        "open mission, open mission, open mission, open mission, open mission, read items");
  CHECK(silent.how() == "Downloaded, NotKnown: ");
}

TEST_CASE("a late refusal of an opening whose repeat was taken, and one of the closing, change nothing") {
  Pilot pilot;
  pilot.once[kOpen] = kSilent;
  pilot.has(kFourItems).answering(kClose, FilePilot::kFail).answering(kBurst, kSilent).verify(kFourItems);
  pilot.until("burst").refuse(behind(pilot, -1), kOpen, FilePilot::kFail);
  CHECK(pilot.wait(20).answering(kBurst, 0).how() ==
        "Verified by file, OurPlan: open mission, open mission, read 0+10, burst 10+38, burst 10+38, close");
}
