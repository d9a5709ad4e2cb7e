"""What a serial port of the simulated Mega can be connected to, in words; simulation/mega/ends.py makes them."""

FORMS = """\
  pty                     a new pseudo-terminal; its path is printed
  tcp:HOST:PORT           connects, again and again if need be
  tcp-listen:PORT         waits for one client at a time
  udp:HOST:PORT           sends there, and hears whoever answers
  udp-listen:PORT         answers whoever sent last
  /dev/NAME[@BAUD]        a serial device, at 57600 unless told
  none                    a cable with nothing at its end"""
