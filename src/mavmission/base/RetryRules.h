// Every timeout and every number of attempts, one constant for each rule. docs/design/retries.md has each of them in
// words, with its source; a test compares the two. A class has the rules that it keeps as its base.
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

// How long a link counts as lossy, and when what has not been answered is sent again on it.
struct PaceRules {
  static constexpr uint8_t kLossyS = 10;        // after the last loss the link counts as lossy
  static constexpr uint8_t kLeastMs = 50;       // from a message to its repeat on a lossy link, at least
  static constexpr uint16_t kQuickMs = 500;     // a question whose rule is less than this: after half of that
  static constexpr uint16_t kMostMs = 1500;     // longer round trips are not reckoned with
  static constexpr uint16_t kRepeatedMs = 500;  // a request that is repeated later than this after its answer says so
  static constexpr uint8_t kMostWaitMs = 100;
  static constexpr uint8_t kSameRequestMs = 50;  // a request that comes again within this time is not answered again
  static constexpr uint8_t kPatience = 4;        // from a message to its repeat, in round trips, at least
  static constexpr uint8_t kHurry = 8;           // repeats in a round trip, at the most, on a lossy link
  static constexpr uint8_t kFrameTimes = 5;      // the same, in the times that the line takes for a frame
  static constexpr uint8_t kHaste = 4;           // so many times as often, at the most, what does no harm twice
  static constexpr uint8_t kLossyTries = 250;    // of a question there, before it is given up
};

struct LinkRules {
  static constexpr uint16_t kHeartbeatMs = 1000;  // ours
  // The receive buffer was last seen empty so long ago: what is read now may be too old for an order; or so old that
  // the aircraft may be somebody else's by now.
  static constexpr uint8_t kOldMs = 200;
  static constexpr uint16_t kBlindMs = 600;
};

struct UploadRules {
  static constexpr uint16_t kRepeatMs = 1500;    // from MISSION_COUNT, or from the last item, to its repeat
  static constexpr uint16_t kCountingMs = 7500;  // to the first request, repeats of COUNT included
  static constexpr uint8_t kBusyTries = 5;      // MISSION_COUNT, to a PX4 that is busy with an earlier transfer of ours
  static constexpr uint16_t kPassiveMs = 8500;  // to the next item's request
  static constexpr uint16_t kLateRequestMs = 500;  // for an older item: within this time of a newer one it is late
  static constexpr uint16_t kLateErrorMs = 2500;   // an ERROR so long after a new request answers nothing from before
  static constexpr uint16_t kRoomMs = 700;         // after eight repeats in a row, for an unknown server's own timeout
  static constexpr uint8_t kCopies = 4;  // of an item to PX4 on a lossy link; then it and the next one in turn
  static constexpr uint16_t kConfirmingMs = 9000;  // from the last item's request to the end, repeats included
};

struct DownloadRules {
  static constexpr uint8_t kListTries = 5;        // MISSION_REQUEST_LIST
  static constexpr uint16_t kListMs = 1500;       // to MISSION_COUNT
  static constexpr uint8_t kHastyTries = 64;      // of a question on a lossy link: then it is repeated less often
  static constexpr uint8_t kOtherTries = 2;       // of it, before another number of items is believed in a read-back
  static constexpr uint8_t kItemTries = 8;        // MISSION_REQUEST_INT, for each item
  static constexpr uint8_t kUnderWay = 5;         // requests before the first is answered, where each is
  static constexpr uint16_t kItemMs = 250;        // to the item
  static constexpr uint8_t kMostAnew = 4;         // readings that begin anew, since the autopilot has ended one
  static constexpr uint16_t kCopyMs = 400;        // between two messages of such a reading
  static constexpr uint8_t kNewRequestTries = 2;  // then MISSION_REQUEST, to an autopilot that may be old
};

// Plans as files.
struct FileRules {
  static constexpr uint8_t kOpenTries = 12;       // of opening a file, before FTP is taken for switched off
  static constexpr uint16_t kOpenMs = 600;        // to the answer
  static constexpr uint8_t kPieceTries = 8;       // of any other request
  static constexpr uint16_t kPieceMs = 250;       // to what was read, or between two pieces of a burst
  static constexpr uint16_t kWriteMs = 1000;      // to the answer to what was written, and to the closing
  static constexpr uint8_t kLossyOpenTries = 90;  // of each, on a lossy link
  static constexpr uint8_t kLossyTries = 250;
  static constexpr uint8_t kMostLost = 8;        // a burst of which more than 1 of 8 pieces is lost is the last
  static constexpr uint8_t kFewItems = 8;        // after such a burst more than these are read item by item
  static constexpr uint8_t kQuickMs = 40;        // a second write is sent before the answer, if the last came so soon
  static constexpr uint8_t kUnsureClosings = 5;  // of a file of which it is not known whether it is open
};

struct ClearRules {
  static constexpr uint8_t kTries = 5;
  static constexpr uint16_t kAnswerMs = 1500;
};

struct CommandRules {
  static constexpr uint8_t kTries = 5;
  static constexpr uint8_t kLossyTries = 100;   // on a lossy link
  static constexpr uint8_t kAcceptedTries = 7;  // an attempt that was accepted counts for as many there
  static constexpr uint16_t kAnswerMs = 1500;
  static constexpr uint16_t kProgressMs = 5000;  // after IN_PROGRESS, and for a command that is sent only once
  static constexpr uint8_t kLateAnswersS = 20;   // after a command ended, answers to its repeats are expected
  static constexpr uint16_t kNextAnswerMs = kAnswerMs + 100;  // from one of these answers to the next
  // An order that changes the mode, or arms.
  static constexpr uint8_t kFreshMs = 20;          // from a heartbeat to the order that leaves right after it
  static constexpr uint8_t kAskMs = 100;           // from a request for a heartbeat to the next
  static constexpr uint8_t kMostAsks = 75;         // requests without a heartbeat, before it is given up
  static constexpr uint8_t kMostUrgentAsks = 125;  // the same while somebody's mode may be undone
  static constexpr uint8_t kLateAsks = 3;          // requests that may still be answered when a heartbeat has come
  static constexpr uint8_t kRestoreTries = 40;     // of setting a mode again that an order has undone
  static constexpr uint16_t kUnderWayMs = 400;     // an order that has left may not have arrived yet
};

// Commands that a listener sends beside an operation: TelemetryPause, MissionFollower and the listeners of telemetry.
struct IntervalRules {
  static constexpr uint8_t kTries = 5;
  static constexpr uint16_t kAnswerMs = 1500;
  static constexpr uint16_t kRestartMs = 2500;  // a gap between two heartbeats: the autopilot may have restarted
};

struct FollowRules {
  // In heartbeats of the autopilot, one a second: without MISSION_CURRENT before it is requested, and from one request
  // to the next.
  static constexpr uint8_t kSilence = 3, kFirstPause = 2, kLongestPause = 64;
  // How often MISSION_CURRENT may name another plan after an answer to the client before it is believed.
  static constexpr uint8_t kPatience = 3;
  // So many items may have been left behind from one MISSION_CURRENT to the next.
  static constexpr uint8_t kMostBehind = 8;
  // For how many heartbeats after its acceptance ArduPilot's text about an upload of ours is expected.
  static constexpr uint8_t kText = 3;
};

// Reading and setting a parameter; attempts and waits are those of a command.
struct ParameterRules {
  static constexpr uint8_t kOtherS = 2;  // another value than the one that was set is believed after this time
};

// Commands that come to a Payload.
struct PayloadRules {
  static constexpr uint16_t kProgressMs = 1000;  // from IN_PROGRESS to the next one
  static constexpr uint16_t kRepeatsMs = 5000;   // a command that is repeated within this time is not carried out again
};

struct BackOffRules {
  static constexpr uint8_t kFirstS = 1;  // pause before the second COUNT; then twice the last one
  static constexpr uint8_t kMostS = 8;
};

struct FenceRules {
  static constexpr uint8_t kSettleS = 1;  // from the acceptance of a short fence to its read-back
};

struct StartRules {
  static constexpr uint8_t kAutoTriesS = 15;      // AUTO on a rover: the time for all attempts
  static constexpr uint16_t kAutoAgainMs = 1000;  // from a refusal of AUTO to the next attempt
  static constexpr uint16_t kConfirmMs = 7500;    // for what the autopilot sends by itself, once a second
};

struct SteerRules {
  static constexpr uint16_t kConfirmMs = 7500;   // for the heartbeat that shows the mode, and for the target
  static constexpr uint8_t kLandedS = 20;        // for the answer whether it flies, on a lossy link, too
  static constexpr uint8_t kTakeOffS = 15;       // from the acceptance of a takeoff until it has left the ground
  static constexpr uint16_t kAskAgainMs = 1000;  // from PX4's answer that it has not, to the next question
  static constexpr uint8_t kFreshS = 3;          // how old a position may be
  static constexpr uint8_t kTopS = 8;            // how old, where HOLD after PX4's takeoff waits for the next one
  static constexpr uint8_t kForgetS = 20;        // without a heartbeat: then the sketch's own mode is anybody's
  // In heartbeats of the autopilot, one a second: how long ago it may have named a target for another one to be waited
  // for.
  static constexpr uint8_t kTargetBeats = 5;
};

struct StandardModeRules {
  static constexpr uint8_t kConfirmS = 5;       // a mode that was accepted must be shown within this time
  static constexpr uint16_t kAskAgainMs = 250;  // the pause before the autopilot is asked again for its mode
};

struct TargetRules {
  static constexpr uint16_t kEveryMs = 200;     // from one target of a MovingTarget to the next
  static constexpr uint16_t kLeadMs = 1000;     // PX4: targets before OFFBOARD is set
  static constexpr uint16_t kTimeoutMs = 1000;  // the sketch must have renewed its target within this time
  // When the autopilot has not been heard for so long, a heartbeat is waited for.
  static constexpr uint16_t kBlindMs = LinkRules::kBlindMs;
  static constexpr uint16_t kQuietMs = 300;   // when nothing has been heard for so long, a heartbeat is asked for
  static constexpr uint8_t kAskMs = 100;      // and so much later again
  static constexpr uint16_t kBrakeMs = 2000;  // a VelocityTarget that ends is a velocity of 0 for so long
};

struct ClientRules {
  static constexpr uint8_t kOrderWaitS = 10;       // for the autopilot, of a command, where the sketch sets no limit
  static constexpr uint8_t kTickMs = 2;            // seconds, heartbeats and silence are looked at once in this time
  static constexpr uint16_t kCopyMs = 400;         // a copy of a message, which the line has made, may still arrive
  static constexpr uint16_t kLateMs = 1600;        // a message that was sent again may still be answered
  static constexpr uint16_t kLeftoversMs = 10000;  // an earlier transfer may still be answered
  // The default limit for a whole operation [s].
  static uint16_t defaultLimitS(uint16_t count) { return count < 32000 ? 120 + 2 * count : 0xFFFF; }
};

// A Flight.
struct FlightRules {
  static constexpr uint16_t kReadyS = 300;         // from its beginning until it must have been armed
  static constexpr uint16_t kReadyAgainMs = 5000;  // from a refusal on the ground to the next attempt
  // From an upload that was acknowledged without a proof to the next one, which late answers to it can no longer
  // disturb.
  static constexpr uint16_t kProvenAgainMs = ClientRules::kLeftoversMs + 1000;
  static constexpr uint16_t kOrderAgainMs = 1000;     // from a refusal in the air to the next attempt
  static constexpr uint16_t kLossySilenceMs = 10000;  // without a heartbeat, on the ground and on a lossy link
  static constexpr uint8_t kOrderTries = 30;          // of an order in the air
  // In heartbeats, one a second: without MISSION_CURRENT that says that a return is the plan's own; and from the end of
  // a rover's plan to its disarming.
  static constexpr uint8_t kUnclearBeats = 5, kArrivedBeats = 3;
};

struct FinderRules {
  static constexpr uint16_t kLostMs = 5000;     // without a heartbeat of the autopilot
  static constexpr uint16_t kForgetMs = 15000;  // after that loss: what the autopilot has shown is forgotten
  static constexpr uint16_t kSettleMs = 1200;   // a second autopilot on the line is heard within this time
};

struct ParserRules {
  static constexpr uint8_t kSilenceMs = 20;  // an unfinished frame is given up
};

struct StreamRules {
  static constexpr uint8_t kNotImplementedMs = 100;  // without room: availableForWrite() is not implemented
};

}  // namespace detail
}  // namespace mavmission
