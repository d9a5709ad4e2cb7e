// For comparison, and to hold the models against: the strategies of a plain client on a computer that were tried with
// the real autopilots on a line that loses bytes.
//   0: an item for each request heard; COUNT again after 1.2 s (PX4: 1.0 s)
//   1: and 32 zero bytes before what is repeated; the last item again after 1 s without an answer
//   2: and three copies to a repeated request
//   3: and, unasked, the item again every 80 ms until the next request is heard
//   5: 3, in turns with the next item
// Each gives up 12 s after the last new request. ERROR to the last item counts as done from 1 on; other errors end it.
#include "PlainClient.h"

namespace {

class Strategy : public PlainClient {
 public:
  Strategy(Firmwares firmware, int number) : PlainClient(firmware), number_(number) {}

 private:
  static constexpr uint32_t kGivesUpMs = 12000, kLastAgainMs = 1000, kUnaskedMs = 80;
  static constexpr uint8_t kZeros = 32;
  static constexpr uint16_t kNobody = 0xFFFF;

  void hear(const Message& message, uint32_t nowMs) override {
    if (message.kind == Kind::Ack) return takeAck(message.number);
    const bool isNew = asked_ == kNobody || message.number > asked_;
    if (isNew) {
      asked_ = message.number;
      newMs_ = nowMs;
    }
    unasked_ = 0;
    sentMs_ = nowMs;
    const int copies = !isNew && number_ >= 2 ? 3 : 1;
    for (int copy = 0; copy < copies; ++copy) send(Kind::Item, message.number, !isNew && number_ >= 1 ? kZeros : 0);
    if (message.number + 1u == items().size()) isLastSent_ = true;
  }

  void takeAck(uint16_t result) {
    if (result == kAccepted && isLastSent_) return end("Accepted");
    if (result == kError && isLastSent_ && !isPx4() && number_ >= 1) return end("Accepted");
    if (result == kInvalidSequence || (result == kError && isPx4())) return;
    end("Refused");
  }

  void act(uint32_t nowMs) override {
    if (!hasBegun_) {
      hasBegun_ = true;
      newMs_ = sentMs_ = nowMs;
      return send(Kind::Count, static_cast<uint16_t>(items().size()));
    }
    if (nowMs - newMs_ >= kGivesUpMs) return end("TimedOut");
    if (asked_ == kNobody) {
      if (nowMs - sentMs_ < (isPx4() ? 1000u : 1200u)) return;
      sentMs_ = nowMs;
      return send(Kind::Count, static_cast<uint16_t>(items().size()), number_ >= 1 ? kZeros : 0);
    }
    const bool isLast = asked_ + 1u == items().size();
    if (number_ >= 3 ? nowMs - sentMs_ < kUnaskedMs : !isLast || number_ == 0 || nowMs - sentMs_ < kLastAgainMs) return;
    sentMs_ = nowMs;
    const bool isNext = number_ == 5 && !isLast && unasked_ % 2 == 1;
    ++unasked_;
    send(Kind::Item, static_cast<uint16_t>(asked_ + (isNext ? 1 : 0)), kZeros);
    if (isNext && asked_ + 2u == items().size()) isLastSent_ = true;
  }

  const int number_;
  uint32_t newMs_ = 0, sentMs_ = 0;
  uint16_t asked_ = kNobody;
  int unasked_ = 0;
  bool hasBegun_ = false, isLastSent_ = false;
};

}  // namespace

std::unique_ptr<Client> makeStrategy(Firmwares firmware, int number) {
  return std::unique_ptr<Client>(new Strategy(firmware, number));
}
