#!/usr/bin/env python3
"""Writes shell.obj: a ball with a round opening below, of a pole and 9 rings of 12 points.

It has the 109 points and 204 triangles of the paper's Fig. 8, which no closed surface has: one of 109 points has
2 * 109 - 4 = 214. With one opening of 12 edges it has 12 fewer than 2 * 109 - 2.
Use: ./make_shell.py > shell.obj
"""
import math

RADIUS = 0.2  # metres
RINGS = 9
SEGMENTS = 12
OPENING = 30  # degrees from the lower pole to the rim


def points():
    """The rim is at y = 0."""
    rim = RADIUS * math.cos(math.radians(OPENING))
    yield 0.0, rim + RADIUS, 0.0
    for ring in range(1, RINGS + 1):
        polar = math.radians(180 - OPENING) * ring / RINGS
        for step in range(SEGMENTS):
            # Every other ring is turned by half a segment, for triangles of better shape.
            angle = 2 * math.pi * (step + ring % 2 / 2) / SEGMENTS
            yield (RADIUS * math.sin(polar) * math.cos(angle), rim + RADIUS * math.cos(polar),
                   -RADIUS * math.sin(polar) * math.sin(angle))


def point_number(ring, step):
    """Counted from 1, as OBJ does."""
    return 2 + (ring - 1) * SEGMENTS + step % SEGMENTS


def triangles():
    for step in range(SEGMENTS):
        yield 1, point_number(1, step), point_number(1, step + 1)
    for ring in range(1, RINGS):
        for step in range(SEGMENTS):
            upper, lower = step, step + ring % 2  # the lower point half a segment on
            yield point_number(ring, upper), point_number(ring + 1, lower), point_number(ring, upper + 1)
            yield point_number(ring, upper), point_number(ring + 1, lower - 1), point_number(ring + 1, lower)


def main():
    print("# A ball of radius 0.2 m with an opening, made by make_shell.py")
    for x, y, z in points():
        print(f"v {x:.6f} {y:.6f} {z:.6f}")
    for corners in triangles():
        print("f " + " ".join(str(corner) for corner in corners))


if __name__ == "__main__":
    main()
