// The port of what transfers a plan in its own way. A file of its own, since only PlanFiles does.
#include "PlanPort.h"

#include "../link/Messages.h"
#include "MissionClient.h"
#include "Reading.h"
#include "Uploading.h"

namespace mavmission {
namespace detail {

PlanPort& Port::plans() { return static_cast<Client&>(*this); }

PlanFiles& PlanPort::filesOf(const Client& client) { return *client.reading_.files; }
PlanFiles& PlanPort::proverOf(const Client& client) { return *client.reading_.prover; }

// --- Beginning

Status PlanPort::startVerifying(const ItemSource& plan, PlanType type, Port::Step operation, PlanFiles& files) {
  Client& client = static_cast<Client&>(*this);
  if (type == PlanType::All) return client.refuseType();
  client.setPlanToVerify(plan, type);
  client.startOperation(operation);
  client.reading_.files = &files;
  client.reading_.take = Client::ReadingPlan::compare;
  client.state_.isCompared = true;
  client.state_.itemsTotal = client.plan_.count();
  if (client.state_.tooLong) return client.refuse(Status::TooManyItems);
  return client.status();
}

Status PlanPort::startDownloading(const ItemSink& sink, PlanType type, Port::Step operation, PlanFiles& files) {
  Client& client = static_cast<Client&>(*this);
  if (type == PlanType::All) return client.refuseType();
  client.state_.type = type;
  const Status status = client.startOperation(operation);
  client.reading_.files = &files;
  client.reading_.take = Client::ReadingPlan::store;
  client.state_.isCompared = false;
  client.reading_.sink = sink;
  return status;
}

void PlanPort::goOnBy(Port::Step operation, PlanFiles& files) {
  Client& client = static_cast<Client&>(*this);
  client.reading_.files = &files;
  client.state_.operation = operation;
}

// --- The plan

PlanType PlanPort::planType() const { return static_cast<const Client&>(*this).state_.type; }

WirePlan& PlanPort::plan() { return static_cast<Client&>(*this).plan_; }

void PlanPort::nowAboard(Aboard what) {
  Client& client = static_cast<Client&>(*this);
  client.setOfPlan(true);
  client.setAboard(what);
}

// --- Reading

bool PlanPort::isCompared() const { return static_cast<const Client&>(*this).state_.isCompared; }

bool PlanPort::mayWaitForSink() const {
  const Client& client = static_cast<const Client&>(*this);
  return !client.state_.isCompared && client.reading_.sink.isReady != nullptr;
}

void PlanPort::keepTimeFree(bool isKept) { static_cast<Client&>(*this).state_.readsHalf = isKept; }

bool PlanPort::isOtherCount(const FrameParser& frame) const {
  typedef mavlink_mission_count_t Count;
  const Client& client = static_cast<const Client&>(*this);
  const bool isCount = frame.messageId() == MAVLINK_MSG_ID_MISSION_COUNT &&
                       client.reading_.transfer.expectsAnswer(DownloadTransfer::State::Listing) &&
                       frame.payloadByte(offsetof(Count, mission_type)) == static_cast<uint8_t>(client.state_.type);
  // An empty plan may have a count of 1: home.
  return isCount && client.plan_.count() != 0 && frame.payloadWord(offsetof(Count, count)) != client.plan_.wireCount();
}

Status PlanPort::takeItem(uint16_t wireItem, MissionItem& item) {
  Client& client = static_cast<Client&>(*this);
  const Status taken = client.reading_.take(client, wireItem, item);
  if (taken != Status::Checking && taken != Status::Transferring) noteFailed(wireItem);
  return taken;
}

Status PlanPort::compare(uint16_t wireItem, MissionItem& item) {
  return Client::ReadingPlan::compare(static_cast<Client&>(*this), wireItem, item);
}

void PlanPort::progress(uint16_t wireItems) {
  Client& client = static_cast<Client&>(*this);
  const uint16_t items = client.plan_.numbers().ownCount(wireItems);
  if (!client.state_.proving && items != 0) client.report(items);
}

void PlanPort::forgetFailed() {
  Client& client = static_cast<Client&>(*this);
  client.session_.field = ItemField::None;
  client.state_.failedItem = Port::kNoItem;
}

void PlanPort::endAsOurs(Status status) {
  Client& client = static_cast<Client&>(*this);
  client.setAboard(Aboard::OurPlan);
  if (status == Status::Accepted) client.noteAccepted();
  if (client.state_.type == PlanType::Mission) client.known_.planId = 0;
  client.report(client.state_.itemsTotal);
  client.end(status);
}

// --- Within an upload

void PlanPort::beginComparing(Port::Step operation, PlanFiles& files) {
  Client& client = static_cast<Client&>(*this);
  goOnBy(operation, files);
  client.state_.proving = true;  // no progress is reported for it
  client.state_.mayBeRefused = false;
  client.reading_.take = Client::ReadingPlan::compare;
  client.state_.isCompared = true;
}

void PlanPort::endComparing() { static_cast<Client&>(*this).state_.proving = false; }

void PlanPort::noteWhole() { static_cast<Client&>(*this).state_.lastResult = MAV_MISSION_ACCEPTED; }

// --- Going over to the mission protocol

void PlanPort::uploadByItems(uint16_t nowMs) {
  Client& client = static_cast<Client&>(*this);
  client.state_.operation = Client::Uploading::step;
  client.beginSeconds(nowMs);
  Client::Uploading::begin(client, nowMs);
}

void PlanPort::proveInAnyCase() {
  Client& client = static_cast<Client&>(*this);
  endComparing();
  client.session_.proof = static_cast<uint8_t>(Readback::Always);
  forgetFailed();
  keepTimeFree(false);
}

void PlanPort::readByItems(uint16_t first, uint16_t nowMs) {
  Client& client = static_cast<Client&>(*this);
  client.state_.operation = Client::ReadingPlan::step;
  client.reading_.transfer.begin(nowMs);
  client.reading_.transfer.skipTo(first);
}

void PlanPort::proveByItems(Port::Step operation, TakeItem take, PlanFiles& prover, uint16_t nowMs) {
  Client& client = static_cast<Client&>(*this);
  client.reading_.prover = &prover;
  client.reading_.take = take;
  client.state_.operation = operation;
  client.reading_.transfer.begin(nowMs);
}

void PlanPort::readOnByItems(const FrameParser* frame, uint16_t nowMs) {
  Client::ReadingPlan::readOn(static_cast<Client&>(*this), frame, nowMs);
}

}  // namespace detail
}  // namespace mavmission
