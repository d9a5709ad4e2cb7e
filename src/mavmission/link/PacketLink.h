// A line over packets: UDP, ESP-NOW, LoRa.
#pragma once

#include <Arduino.h>
#include <stdint.h>

namespace mavmission {

// A line over packets, such as UDP, ESP-NOW or LoRa: each packet contains one or several whole frames, so a lost packet
// loses only these frames. It is the base class of UdpLink (MavMissionUdp.h), and of a class that the sketch defines
// with sendPacket() and with available(), read() and peek(), which give the bytes of the received packets, one after
// the other (docs/radio.md has one).
//
// Frames are cut by their lengths, as the guide's "Packet Serialization" has them: MAVLink 1 and 2, with a signature or
// without. Bytes between frames are left out, such as the zeros that the client writes before a repeat. No function
// waits or allocates memory: the buffer belongs to the sketch or to the derived class.
class PacketLink : public Stream {
 public:
  // The longest frame that MAVLink has: 10 bytes of header, 255 of payload, checksum, signature [bytes]. A client sends
  // no more than 50, or 63 where it signs; PlanFiles 263, and a message of the sketch's own 12 more than its payload.
  static constexpr uint16_t kLongestFrame = 280;

  // The number of bytes that write() takes now: the room in the buffer.
  int availableForWrite() override;
  // Takes a byte; returns 0 if there is no room for it. With the last byte of a frame the packet is sent, if the radio
  // is free.
  size_t write(uint8_t byte) override;
  size_t write(const uint8_t* bytes, size_t size) override;
  using Print::write;
  // Sends the whole frames that wait for the radio, if it is free now; it does not wait. To be called in loop() by a
  // sketch whose radio is not always free; the client's update() does it while it has more to send.
  void flush();

  // Packets that were given to the radio; and what was not sent: packets that it did not take, and frames that are
  // longer than a packet.
  uint16_t packetsSent() const { return packetsSent_; }
  uint16_t unsent() const { return unsent_; }

 protected:
  // `buffer`: of `size` bytes, the longest packet that the radio takes; it must live as long as this.
  PacketLink(uint8_t* buffer, uint16_t size) : buffer_(buffer), size_(size) {}
  ~PacketLink() = default;

  // Sends a packet of whole frames, without waiting; false if it could not be sent. Called only while isFree() is true.
  virtual bool sendPacket(const uint8_t* bytes, uint16_t size) = 0;
  // False while the radio still sends the last packet. Meanwhile frames are collected, as many as a packet takes.
  virtual bool isFree() { return true; }

 private:
  uint8_t* const buffer_;
  const uint16_t size_;
  uint16_t length_ = 0;  // bytes in the buffer
  uint16_t whole_ = 0;   // of them those of whole frames, which are first
  uint16_t skip_ = 0;    // bytes to come of a frame that is longer than a packet
  uint16_t packetsSent_ = 0;
  uint16_t unsent_ = 0;
};

}  // namespace mavmission
