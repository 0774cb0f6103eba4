#!/usr/bin/env python3
"""Writes walker.yaml: colliders of a figure of capsules that walks on the spot, with keyframes for every frame.

Legs swing from the hips, and knees bend while a leg comes forward; the hips rise and fall with the steps.
Use: ./make_walker.py > walker.yaml
"""
import math

FRAMES = 150
FRAMES_A_CYCLE = 36
STAND = 30  # frames until the first step, so that the skirt comes to rest
HIP = 0.92
THIGH, SHIN = 0.40, 0.40
HALF_WIDTH = 0.085


def blend(frame):
    """From 0 to 1 between standing and walking."""
    share = min(max((frame - STAND) / 20, 0), 1)
    return share * share * (3 - 2 * share)


def pose(frame):
    """The hips' height, and thigh and shin angles (radians, forward positive) of the left and the right leg."""
    phase = 2 * math.pi * (frame - STAND) / FRAMES_A_CYCLE
    legs = []
    for offset in (0, math.pi):
        swing = math.sin(phase + offset)
        knee = max(0, math.cos(phase + offset))  # bent while the thigh goes forward
        legs.append((blend(frame) * (0.5 * swing + 0.1 * knee), blend(frame) * (0.5 * swing - 0.9 * knee)))
    return HIP + 0.015 * blend(frame) * math.cos(2 * phase), legs


def capsule(name, radius, length, places):
    """places: of each frame its centre and its angle about x in radians."""
    x, y, z = places[0][0]
    moves = ", ".join(f"[{f}, [{p[0] - x:.4f}, {p[1] - y:.4f}, {p[2] - z:.4f}]]" for f, (p, _) in enumerate(places))
    print(f"  {name}:")
    print(f"    capsule: {{radius: {radius}, length: {length}}}")
    print(f"    place: {{at: [{x:.4f}, {y:.4f}, {z:.4f}]}}")
    print("    animate:")
    print(f"      translate: [{moves}]")
    if any(angle != 0 for _, angle in places):
        turns = ", ".join(f"[{f}, {math.degrees(angle):.3f}]" for f, (_, angle) in enumerate(places))
        print(f"      rotate_x: [{turns}]")
    print('    look: {color: "#cbb8a4"}')


def along(start, length, angle):
    """Down from start, turned forward (+z) by angle."""
    return (start[0], start[1] - length * math.cos(angle), start[2] + length * math.sin(angle))


def main():
    poses = [pose(frame) for frame in range(FRAMES + 1)]
    print("# A figure of capsules that walks on the spot; written by make_walker.py.")
    print("version: 1")
    print("colliders:")
    capsule("hips", 0.11, 0.1, [((0, hip + 0.06, 0), 0) for hip, _ in poses])
    capsule("chest", 0.115, 0.3, [((0, hip + 0.32, 0), 0) for hip, _ in poses])
    capsule("head", 0.09, 0.05, [((0, hip + 0.72, 0), 0) for hip, _ in poses])
    for side, (name, sign) in enumerate((("left", 1), ("right", -1))):
        thighs, shins = [], []
        for hip, legs in poses:
            thigh, shin = legs[side]
            joint = (sign * HALF_WIDTH, hip, 0)
            knee = along(joint, THIGH, thigh)
            thighs.append((along(joint, THIGH / 2, thigh), -thigh))
            shins.append((along(knee, SHIN / 2, shin), -shin))
        capsule(f"{name}_thigh", 0.07, THIGH, thighs)
        capsule(f"{name}_shin", 0.05, SHIN, shins)


if __name__ == "__main__":
    main()
