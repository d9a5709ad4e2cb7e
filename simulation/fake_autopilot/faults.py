"""What a test may order to go wrong inside the autopilot itself."""
import math
from collections.abc import Callable
from fnmatch import fnmatchcase
from typing import Any


class Faults:
    """Orders to misbehave. All are off until a test gives them.

    A *step* names a moment of a transfer: "count" (a MISSION_COUNT has arrived), an integer
    (that item has arrived), "end" (the last item has been taken), "list" (a
    MISSION_REQUEST_LIST has arrived), ("read", n) (item n is asked for), or "clear".
    """

    def __init__(self) -> None:
        self._refusals: dict = {}
        self._silent_from = math.inf
        self._silent_until = -math.inf
        self._silence_at_step: tuple[object, float] | None = None
        self._final_acks_to_swallow = 0
        self._final_ack_delay_s = 0.0
        self._requests_instead: dict[int, list[int]] = {}
        self._kept_back: list[list] = []  # [name, where, times]
        self.acks_every_item = False
        self.takes_only_float_items = False

    # -- orders -------------------------------------------------------------------------

    def refuse(self, result: int, step: str | int | tuple = "count",
               times: int | None = 1) -> None:
        """Answer `step` with MISSION_ACK(result), `times` times (None: always)."""
        self._refusals[step] = [result, math.inf if times is None else times]

    def fall_silent(self, from_time: float | None = None, step=None,
                    for_s: float = math.inf) -> None:
        """Neither hear nor speak, for for_s [s], from a time [s] or from a step on.

        The message of that step is the first one that is not heard.
        """
        if (from_time is None) == (step is None):
            raise ValueError("say when: give either from_time or step")
        if from_time is None:
            self._silence_at_step = (step, for_s)
        else:
            self._silent_from, self._silent_until = from_time, from_time + for_s

    def swallow_final_ack(self, times: int = 1) -> None:
        """Take the plan, and do not send the ACK that says so."""
        self._final_acks_to_swallow = times

    def keep_back(self, name: str, times: float = math.inf, where: Callable[[Any], bool] | None = None) -> None:
        """Do not send messages of this name (with * and ?), so often: they take no sequence number.

        A frame that the wire loses leaves a gap in the sequence numbers, by which the client sees that the line loses;
        a message that is kept back does not.
        """
        self._kept_back.append([name, where, times])

    def delay_final_ack(self, seconds: float) -> None:
        """Send every ACK that ends an upload this much later [s]."""
        self._final_ack_delay_s = seconds

    def request_instead(self, expected: int, *asked: int) -> None:
        """When item `expected` is due, ask for `asked` instead: one after the other, once."""
        self._requests_instead[expected] = list(asked)

    def ack_every_item(self) -> None:
        """Send ACK ACCEPTED after each item, as some old ground software does."""
        self.acks_every_item = True

    def take_only_float_items(self) -> None:
        """Answer every MISSION_ITEM_INT with ACK UNSUPPORTED."""
        self.takes_only_float_items = True

    # -- asked by the autopilot ---------------------------------------------------------

    def refusal(self, step) -> int | None:
        """The result ordered for this step, if any is left."""
        order = self._refusals.get(step)
        if order is None or order[1] <= 0:
            return None
        order[1] -= 1
        return order[0]

    def is_silent(self, now: float) -> bool:
        return self._silent_from <= now < self._silent_until

    def silence_begins(self, step, now: float) -> bool:
        """Whether the autopilot falls silent at this step; from then on it is silent."""
        if self._silence_at_step is None or self._silence_at_step[0] != step:
            return False
        self._silent_from, self._silent_until = now, now + self._silence_at_step[1]
        self._silence_at_step = None
        return True

    def final_ack(self) -> float | None:
        """How much later the final ACK goes out [s]; None if it is swallowed."""
        if self._final_acks_to_swallow > 0:
            self._final_acks_to_swallow -= 1
            return None
        return self._final_ack_delay_s

    def keeps_back(self, message) -> bool:
        for order in self._kept_back:
            name, where, times = order
            if times > 0 and fnmatchcase(message.get_type(), name) and (where is None or where(message)):
                order[2] -= 1
                return True
        return False

    def requested(self, expected: int) -> int:
        """The item to ask for when `expected` is due."""
        instead = self._requests_instead.get(expected)
        return instead.pop(0) if instead else expected
