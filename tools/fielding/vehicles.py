"""Vehicles that move as their servos say: simple, and enough for an autopilot's estimator and its controllers.

Each is given the servos' pulses [us] and a time step, and holds what its sensors and its place are then. Axes are
north, east, down, and in the body forward, right, down.
"""

from __future__ import annotations

import math

GRAVITY = 9.80665
STANDS_M = 2.5  # below it the throttle stick of a copter is down
Vector = list[float]


def rotation(q: Vector) -> list[Vector]:
    """The matrix from the body's axes to the earth's."""
    w, x, y, z = q
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


class Vehicle:
    """At rest, on the ground, and looks to the north."""

    def __init__(self) -> None:
        self.time = 0.0  # [s]
        self.position, self.velocity = [0.0] * 3, [0.0] * 3  # [m, m/s], from home
        self.turning, self.force = [0.0] * 3, [0.0, 0.0, -GRAVITY]  # in the body: gyro [rad/s], accelerometer [m/s2]
        self.quaternion = [1.0, 0.0, 0.0, 0.0]

    def step(self, pulses: tuple[int, ...], dt: float) -> None:
        """It stays where it is, if it is no vehicle of those below."""
        self.time += dt

    def throttle_stick(self) -> int:
        """[us], as somebody at the sticks would hold it; the others are in the middle."""
        return 1500

    def turn(self, dt: float) -> None:
        w, x, y, z = self.quaternion
        p, q, r = (one * dt / 2 for one in self.turning)
        turned = [
            w - x * p - y * q - z * r,
            x + w * p + y * r - z * q,
            y + w * q + z * p - x * r,
            z + w * r + x * q - y * p,
        ]
        length = math.sqrt(sum(one * one for one in turned))
        self.quaternion = [one / length for one in turned]

    def move(self, acceleration: Vector, dt: float) -> None:
        """[m/s2], to the north, east and down."""
        for axis in range(3):
            self.position[axis] += self.velocity[axis] * dt + acceleration[axis] * dt * dt / 2
            self.velocity[axis] += acceleration[axis] * dt


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

    def step(self, pulses: tuple[int, ...], dt: float) -> None:
        self.time += dt
        share = min(1.0, dt / self.SPOOLS_S)
        for number in range(4):
            wanted = min(max((pulses[number] - 1000) / 1000, 0.0), 1.0)
            self.thrust[number] += (wanted - self.thrust[number]) * share
        lift = sum(self.thrust) / 4 * GRAVITY / self.HOVERS
        for axis in range(3):
            torque = sum(way[axis] * one for way, one in zip(self.MOTORS, self.thrust, strict=True)) / 4
            self.turning[axis] += (torque * self.TORQUE[axis] - self.TURN_DRAG[axis] * self.turning[axis]) * dt
        self.turn(dt)
        matrix = rotation(self.quaternion)
        drag = [-self.DRAG * one for one in self.velocity]
        earth = [-lift * matrix[axis][2] + drag[axis] for axis in range(3)]
        if self.position[2] >= 0.0 and earth[2] + GRAVITY >= 0.0:  # it stands
            yaw = math.atan2(matrix[1][0], matrix[0][0])
            self.quaternion = [math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2)]
            self.turning, self.velocity, self.position[2] = [0.0] * 3, [0.0] * 3, 0.0
            self.force = [0.0, 0.0, -GRAVITY]
            return
        self.move([earth[0], earth[1], earth[2] + GRAVITY], dt)
        self.force = [sum(matrix[axis][way] * earth[axis] for axis in range(3)) for way in range(3)]


class Rover(Vehicle):
    """Steered by its front wheels, with servo 1, and driven by servo 3."""

    FASTEST = 6.0  # [m/s]
    SLOWS_S = 0.7
    TURNS = 0.3  # [rad/m], at the most

    def step(self, pulses: tuple[int, ...], dt: float) -> None:
        self.time += dt
        steered, driven = ((pulses[number] or 1500) / 500 - 3 for number in (0, 2))
        ahead = rotation(self.quaternion)
        speed = sum(ahead[axis][0] * self.velocity[axis] for axis in range(2))
        speed += (driven * self.FASTEST - speed) * dt / self.SLOWS_S
        self.turning[2] = steered * self.TURNS * speed
        self.turn(dt)
        matrix = rotation(self.quaternion)
        earth = [(matrix[axis][0] * speed - self.velocity[axis]) / dt for axis in range(2)]
        self.force = [*(matrix[0][way] * earth[0] + matrix[1][way] * earth[1] for way in range(2)), -GRAVITY]
        self.move([*earth, 0.0], dt)


VEHICLES: dict[str, type[Vehicle]] = {"arducopter": Copter, "ardurover": Rover, "arduplane": Vehicle}
