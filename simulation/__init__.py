"""The simulated world: an Arduino Mega, autopilots, and the line between them, in simulated time.

    from simulation.bench import Bench

mega/ is the board, fake_autopilot/ the other end, wire.py the line, and recordings/ what real autopilots said. A bench
(bench.py, service.py, doctor.py, quiet.py) joins them around a sketch of sketches/. Tools and tests stand on this
package; it imports neither.
"""
