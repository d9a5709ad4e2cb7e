#include "Script.h"

#include <stdio.h>

#include <sstream>
#include <stdexcept>

Events::Iterator& Events::Iterator::operator++() {
  if (!event_->isKnown) throw std::invalid_argument("there is no event \"" + event_->what + "\"");
  ++event_;
  return *this;
}

Events eventsOf(const std::string& script) {
  std::vector<Event> events;
  std::istringstream words(script);
  for (std::string word; std::getline(words >> std::ws, word, ',');) {
    if (word.empty()) continue;
    const size_t digits = word.find_first_of("0123456789");
    unsigned first = 0, last = 0;
    const int numbers = digits == std::string::npos ? 0 : sscanf(word.c_str() + digits, "%u to %u", &first, &last);
    if (numbers != 2) last = first;
    const std::string what = word.substr(0, numbers == 0 ? digits : digits - 1);
    for (unsigned number = first; number <= last; ++number) events.push_back(Event{what, number, false});
  }
  return Events(events);
}

std::string times(unsigned count, const std::string& script) {
  std::string all;
  while (count-- != 0) all += script + ", ";
  return all;
}

std::string Transcript::Entry::text() const {
  std::string text = ms == 0 ? what : std::to_string(ms) + " " + what;
  if (isNumbered) text += " " + std::to_string(first);
  if (last != first) text += " to " + std::to_string(last);
  return text;
}

void Transcript::note(const std::string& what, uint32_t ms) { entries_.push_back(Entry{what, ms, false, 0, 0}); }

void Transcript::note(const std::string& what, uint32_t ms, uint32_t number) {
  Entry* before = entries_.empty() ? nullptr : &entries_.back();
  if (before != nullptr && before->isNumbered && before->what == what && before->ms + ms == 0 &&
      number == before->last + 1) {
    before->last = number;
  } else {
    entries_.push_back(Entry{what, ms, true, number, number});
  }
}

std::string Transcript::text() const {
  std::string text;
  for (size_t at = 0; at < entries_.size();) {
    const std::string one = entries_[at].text();
    size_t end = at + 1;
    while (end < entries_.size() && entries_[end].text() == one) ++end;
    if (at != 0) text += ", ";
    text += one;
    if (end != at + 1) text += " (" + std::to_string(end - at) + " times)";
    at = end;
  }
  return text;
}

std::string Player::plays(const std::string& script) {
  said_ = Transcript();
  spokeMs_ = elapsedMs_;
  for (const Event& event : eventsOf(script)) {
    if (event.is("line full") || event.is("line free")) isFull_ = event.is("line full");
    leave();
    if (event.is("wait")) pass(event.number);
    if (event.is("silence")) pass(60000);
    if (event.is("sleep")) sleep(event.number);
    if (event.is("lossy")) pace.noteLoss();
    happens(event);
    leave();
    if (status_ == mavmission::Status::Transferring) continue;
    note(nameOf(status_));
    break;
  }
  return said_.text();
}

std::string Player::ends(const std::string& script) {
  plays(script);
  return status_ == mavmission::Status::Transferring ? "goes on" : nameOf(status_);
}

void Player::pass(uint32_t ms) {
  for (; ms != 0 && status_ == mavmission::Status::Transferring; --ms) {
    ++elapsedMs_;
    status_ = onTime();
    leave();
  }
}

uint32_t Player::sinceSpoken() {
  const uint32_t ms = elapsedMs_ - spokeMs_;
  spokeMs_ = elapsedMs_;
  return ms;
}
