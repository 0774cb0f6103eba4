#!/usr/bin/env python3
"""Writes round_cloth.obj: a flat disc, its front upward, of rings whose points lie about as far apart as they do.

Ring k has 6 k points, so that neighbouring rings share nearly equilateral triangles.
Use: ./make_round_cloth.py > round_cloth.obj
"""
import math

RADIUS = 0.7  # metres
RINGS = 22  # 1 + 3 * 22 * 23 = 1519 points


def ring_start(ring):
    """The number of a ring's first point, counted from 1 as OBJ does; ring 0 is the centre."""
    return 1 if ring == 0 else 2 + 3 * ring * (ring - 1)


def point_number(ring, step):
    return ring_start(ring) + (step % (6 * ring) if ring else 0)


def points():
    yield 0.0, 0.0
    for ring in range(1, RINGS + 1):
        for step in range(6 * ring):
            angle = 2 * math.pi * step / (6 * ring)
            distance = RADIUS * ring / RINGS
            yield distance * math.cos(angle), -distance * math.sin(angle)


def triangles():
    """Each sixth of a ring is a strip between ring - 1 steps inside and ring steps outside."""
    for ring in range(1, RINGS + 1):
        for sector in range(6):
            for step in range(ring):
                inner, outer = sector * (ring - 1) + step, sector * ring + step
                yield point_number(ring, outer), point_number(ring, outer + 1), point_number(ring - 1, inner)
                if step + 1 < ring:
                    yield (point_number(ring - 1, inner), point_number(ring, outer + 1),
                           point_number(ring - 1, inner + 1))


def main():
    print("# A disc of radius 0.7 m, made by make_round_cloth.py")
    for x, z in points():
        print(f"v {x:.6f} 0 {z:.6f}")
    for x, z in points():
        print(f"vt {0.5 + x / (2 * RADIUS):.6f} {0.5 + z / (2 * RADIUS):.6f}")
    for corners in triangles():
        print("f " + " ".join(f"{corner}/{corner}" for corner in corners))


if __name__ == "__main__":
    main()
