"""Vehicles that move as their servos say: simple, and enough for an autopilot's estimator and its controllers.

Each is given the servos' pulses [us] and a time step, and holds what its sensors and its place are then. Axes are
north, east, down, and in the body forward, right, down. A force is one for each kilogram [m/s2].
"""

from __future__ import annotations

import math

GRAVITY = 9.80665
STANDS_M = 2.5  # below it the throttle stick of a copter is down
GRIPS_S, LEVELS_S = 0.05, 0.2  # so long wheels slip to the side, and so long it stands as it has come down
Vector = list[float]


def rotation(q: Vector) -> list[Vector]:
    """The matrix from the body's axes to the earth's."""
    w, x, y, z = q
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def clipped(number: float, least: float, most: float) -> float:
    return min(max(number, least), most)


class Vehicle:
    """At rest, on the ground, and looks to the north."""

    STICK = 1500

    def __init__(self) -> None:
        self.time = 0.0  # [s]
        self.position, self.velocity = [0.0] * 3, [0.0] * 3  # [m, m/s], from home
        self.turning, self.force = [0.0] * 3, [0.0, 0.0, -GRAVITY]  # in the body: gyro [rad/s], accelerometer
        self.quaternion = [1.0, 0.0, 0.0, 0.0]

    def step(self, pulses: tuple[int, ...], dt: float) -> None:
        self.time += dt
        force = self.push(pulses, dt)
        if self.position[2] >= 0.0 and max(self.velocity[2], self.outside(force)[2] + GRAVITY) > 0.0:
            self.stand(dt)
        else:
            self.fly(force, dt)

    def push(self, pulses: tuple[int, ...], dt: float) -> Vector:
        """Its force in the air, in the body; and `turning` becomes what the servos make of it."""
        raise NotImplementedError

    def stand(self, dt: float) -> None:
        """Where the ground holds it."""
        self.velocity = [0.0] * 3
        self.roll(0.0, 0.0, dt)

    def throttle_stick(self) -> int:
        """[us], as somebody at the sticks would hold it; the others are in the middle."""
        return self.STICK

    def inside(self, vector: Vector) -> Vector:
        """In the body's axes, what is in the earth's."""
        matrix = rotation(self.quaternion)
        return [sum(matrix[axis][way] * vector[axis] for axis in range(3)) for way in range(3)]

    def outside(self, vector: Vector) -> Vector:
        """In the earth's axes, what is in the body's."""
        return [sum(one * other for one, other in zip(row, vector, strict=True)) for row in rotation(self.quaternion)]

    def fly(self, force: Vector, dt: float) -> None:
        earth = self.outside(force)
        earth[2] += GRAVITY
        self.force = force
        w, x, y, z = self.quaternion
        p, q, r = (one * dt / 2 for one in self.turning)
        turned = [w - x * p - y * q - z * r, x + w * p + y * r - z * q,
                  y + w * q + z * p - x * r, z + w * r + x * q - y * p]  # fmt: skip
        length = math.hypot(*turned)
        self.quaternion = [one / length for one in turned]
        for axis in range(3):
            self.position[axis] += self.velocity[axis] * dt + earth[axis] * dt * dt / 2
            self.velocity[axis] += earth[axis] * dt

    def roll(self, ahead: float, turns: float, dt: float) -> None:
        """On wheels, which push ahead, and turn [rad/m]."""
        speed, slip, _ = self.inside(self.velocity)
        pitched, rolled, upright = self.inside([0.0, 0.0, 1.0])
        self.turning = [-rolled / LEVELS_S, pitched / LEVELS_S, turns * speed]
        self.fly([ahead - pitched * GRAVITY, -slip / GRIPS_S - rolled * GRAVITY, -upright * GRAVITY], dt)
        self.position[2] = self.velocity[2] = 0.0


class Copter(Vehicle):
    """Four motors in an X, numbered as ArduPilot and PX4 do."""

    MOTORS = ((-1, 1, 1), (1, -1, 1), (1, 1, -1), (-1, -1, -1))  # what the thrust of each does to roll, pitch and yaw
    HOVERS = 0.35  # at this share of the thrust of all
    TORQUE = (60.0, 60.0, 8.0)  # [rad/s2] for a difference of the whole thrust
    TURN_DRAG = (4.0, 4.0, 2.0)  # [1/s]
    DRAG = 0.25  # [1/s]
    SPOOLS_S = 0.02

    def __init__(self) -> None:
        super().__init__()
        self.thrust = [0.0] * 4

    def throttle_stick(self) -> int:
        return 1500 if -self.position[2] > STANDS_M else 1000

    def push(self, pulses: tuple[int, ...], dt: float) -> Vector:
        share = min(1.0, dt / self.SPOOLS_S)
        for number in range(4):
            self.thrust[number] += (clipped((pulses[number] - 1000) / 1000, 0.0, 1.0) - self.thrust[number]) * share
        for axis in range(3):
            torque = sum(way[axis] * one for way, one in zip(self.MOTORS, self.thrust, strict=True)) / 4
            self.turning[axis] += (torque * self.TORQUE[axis] - self.TURN_DRAG[axis] * self.turning[axis]) * dt
        ahead, aside, down = (-self.DRAG * one for one in self.inside(self.velocity))
        return [ahead, aside, down - sum(self.thrust) / 4 * GRAVITY / self.HOVERS]


class Rover(Vehicle):
    """Steered by its front wheels, with servo 1, and driven by servo 3."""

    FASTEST = 6.0  # [m/s]
    SLOWS_S = 0.7
    TURNS = 0.3  # [rad/m], at the most

    def push(self, pulses: tuple[int, ...], dt: float) -> Vector:
        self.steered, self.driven = ((pulses[number] or 1500) / 500 - 3 for number in (0, 2))
        return [0.0] * 3

    def stand(self, dt: float) -> None:
        self.roll((self.driven * self.FASTEST - self.inside(self.velocity)[0]) / self.SLOWS_S,
                  self.steered * self.TURNS, dt)  # fmt: skip


class Plane(Vehicle):
    """A wing with a propeller: ailerons on servo 1, elevator on 2, throttle on 3, rudder and nose wheel on 4."""

    STICK = 1000  # where the sticks have it, it glides down
    CRUISES = 12.0  # [m/s], at which the wing that is not tilted against its way carries it
    LIFTS, STALLS = 8.0, 2.2  # [1/rad]; by so much more with each tilt, up to so many times
    THRUST, DRAG = 5.0, 0.6  # [m/s2]; of the body at that speed, and as much of the lift
    SLIPS = 8.0  # [m/s2 for each rad] that the body is held by the air from its side
    TURNS, RESPONDS = 2.3, 8.0  # [rad/s, 1/s], at that speed
    TAIL = (0.0, -0.5, 4.0)  # so much it turns into its way, beside what the rudders do
    BRAKES, STEERS = 1.5, 0.1  # [m/s2, rad/m], on the ground

    def push(self, pulses: tuple[int, ...], dt: float) -> Vector:
        aileron, elevator, self.rudder = ((pulses[number] or 1500) / 500 - 3 for number in (0, 1, 3))
        ahead, aside, down = self.inside(self.velocity)
        share = math.hypot(ahead, aside, down) / self.CRUISES
        tilt, slip = (clipped(math.atan2(one, max(ahead, 1.0)), -0.5, 0.5) for one in (down, aside))
        for axis, moved, off in zip(range(3), (aileron, elevator, self.rudder), (0.0, tilt, slip), strict=True):
            wanted = self.TURNS * share * (moved + self.TAIL[axis] * off)
            self.turning[axis] += (wanted - self.turning[axis]) * min(1.0, self.RESPONDS * share * dt)
        lift = clipped(1 + tilt * self.LIFTS, -1.0, self.STALLS)
        lifted, dragged = GRAVITY * lift * share**2, self.DRAG * (1 + lift**2) * share**2
        self.pulled = self.THRUST * clipped((pulses[2] - 1100) / 800, 0.0, 1.0) - dragged + lifted * tilt
        return [self.pulled, -self.SLIPS * slip * share**2, -lifted - dragged * tilt]

    def stand(self, dt: float) -> None:
        braked = self.BRAKES * clipped(self.inside(self.velocity)[0], -1.0, 1.0)
        self.roll(self.pulled - braked, self.rudder * self.STEERS, dt)


class QuadPlane(Copter, Plane):
    """A plane that four motors can carry, on servos 5 to 8."""

    def push(self, pulses: tuple[int, ...], dt: float) -> Vector:
        carried = Copter.push(self, pulses[4:], dt)
        return [one + other for one, other in zip(carried, Plane.push(self, pulses, dt), strict=True)]


class Submarine(Vehicle):
    """It floats, and nobody moves it."""

    def push(self, pulses: tuple[int, ...], dt: float) -> Vector:
        return [0.0, 0.0, -GRAVITY]


VEHICLES: dict[str, type[Vehicle]] = {
    "arducopter": Copter, "ardurover": Rover, "arduplane": Plane, "quadplane": QuadPlane, "ardusub": Submarine,
    "px4": Copter}  # fmt: skip
