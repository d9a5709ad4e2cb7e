"""What a serial port of the simulated Mega can be connected to, in words; simulation/mega/ends.py makes them."""

FORMS = """\
  pty                     a new pseudo-terminal; its path is printed
  tcp:HOST:PORT           connects to a server, and tries again until it can
  tcp-listen:PORT         is a server for one client at a time
  udp:HOST:PORT           sends to this address, and receives from everybody who answers
  udp-listen:PORT         receives, and sends to the one who has sent last
  /dev/NAME[@BAUD]        a serial device (default: 57600 baud)
  none                    not connected"""
