"""The smallest client there can be: it speaks to a fake autopilot directly, without a wire.

It is for trying out the fakes themselves. It never asks again, and expects every answer at
once.
"""
from simulation.fake_autopilot import MISSION, FakeAutopilot, Item, mavlink
from simulation.fake_autopilot.items import item_float_message, item_int_message

# What an autopilot sends without being asked.
UNASKED = ("HEARTBEAT", "MISSION_CURRENT", "MISSION_ITEM_REACHED", "TIMESYNC", "PARAM_VALUE",
           "ATTITUDE")
ANSWER_WITHIN_S = 0.050


class PlainClient:
    """Sends messages to a fake at a time of its own, which only goes forward."""

    def __init__(self, fake: FakeAutopilot, address: tuple[int, int] = (255, 190),
                 target: tuple[int, int] = (1, 1), mavlink_version: int = 2,
                 now: float = 1.0) -> None:
        self.fake = fake
        self.target = target
        self.now = now  # [s]
        self._version = mavlink_version
        self._packer = mavlink.MAVLink(None, *address)
        fake.run(now)

    def send(self, message) -> None:
        """Send without waiting."""
        self.fake.receive(message.pack(self._packer, force_mavlink1=self._version == 1),
                          self.now)

    def wait(self, seconds: float) -> list:
        """Let time pass. What the fake said meanwhile, without what it says anyway."""
        before = len(self.fake.log)
        self.now += seconds
        self.fake.run(self.now)
        return [entry.message for entry in self.fake.log[before:]
                if entry.direction == "<" and entry.message.get_type() not in UNASKED]

    def say(self, message, wait_s: float = ANSWER_WITHIN_S) -> list:
        """Send, and wait for what is said to it."""
        self.send(message)
        return self.wait(wait_s)

    def ask(self, message, wait_s: float = ANSWER_WITHIN_S):
        """Send, and return the one mission message that answers."""
        answers = [answer for answer in self.say(message, wait_s)
                   if answer.get_type().startswith("MISSION_")]
        assert len(answers) == 1, answers
        return answers[0]

    def count(self, count: int, mission_type: int = MISSION):
        return mavlink.MAVLink_mission_count_message(*self.target, count, mission_type)

    def item(self, item: Item, seq: int, mission_type: int = MISSION):
        return item_int_message(item, self.target, seq, mission_type)

    def float_item(self, item: Item, seq: int, mission_type: int = MISSION):
        """`item` with x and y in degrees."""
        return item_float_message(item, self.target, seq, mission_type)

    def ack(self, result: int, mission_type: int = MISSION):
        return mavlink.MAVLink_mission_ack_message(*self.target, result, mission_type)

    def request_list(self, mission_type: int = MISSION):
        return mavlink.MAVLink_mission_request_list_message(*self.target, mission_type)

    def request_int(self, seq: int, mission_type: int = MISSION):
        return mavlink.MAVLink_mission_request_int_message(*self.target, seq, mission_type)

    def clear_all(self, mission_type: int = MISSION):
        return mavlink.MAVLink_mission_clear_all_message(*self.target, mission_type)

    def command(self, command: int, *params: float, confirmation: int = 0):
        filled = [*params, *[0.0] * (7 - len(params))]
        return mavlink.MAVLink_command_long_message(
            *self.target, command, confirmation, *filled)

    def upload(self, items: list[Item], mission_type: int = MISSION) -> int:
        """The MAV_MISSION_RESULT of the upload."""
        answer = self.ask(self.count(len(items), mission_type))
        while answer.get_type().startswith("MISSION_REQUEST"):
            answer = self.ask(self.item(items[answer.seq], answer.seq, mission_type))
        assert answer.get_type() == "MISSION_ACK", answer
        return answer.type

    def download(self, mission_type: int = MISSION) -> list[Item]:
        """The items aboard, read one by one."""
        count = self.ask(self.request_list(mission_type)).count
        items = [Item.of(self.ask(self.request_int(seq, mission_type))) for seq in range(count)]
        self.send(self.ack(mavlink.MAV_MISSION_ACCEPTED, mission_type))
        return items
