"""A simulated Arduino Mega that runs real firmware, in lock step with its peers.

    from simulation.mega import Mega
    mega = Mega("build/firmware/sketch.elf")
    mega.serial(1).send(b"\\xfd...")
    mega.run_ms(100)
    mega.serial(1).sent()      # [Sent(byte=..., written=..., left=...), ...]

Time is counted in CPU cycles from power-on, 16 to a microsecond. Two runs of
the same firmware with the same input are equal to the cycle.
"""

from .image import BadImage, Image, NoSuchSymbol
from .measured import Calls, Profile
from .mega import Crashed, Mega
from .serial import Sent, SerialPort

__all__ = ["BadImage", "Calls", "Crashed", "Image", "Mega", "NoSuchSymbol", "Profile", "Sent", "SerialPort"]
