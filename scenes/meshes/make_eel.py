#!/usr/bin/env python3
"""Writes eel.glb: a tube that is skinned to a chain of joints, and an animation, "swim", that bends them.

Use: ./make_eel.py
"""
import json
import math
import os
import struct

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "eel.glb")
LENGTH, THICKEST = 0.8, 0.06  # m
RINGS, SIDES, JOINTS = 33, 12, 6
SECONDS, KEYS_A_SECOND = 4, 12


def radius_at(s):
    """s: from 0 at the tail to 1 at the head."""
    return THICKEST * (math.sin(math.pi * (0.05 + 0.9 * s)) ** 0.6) * (0.45 + 0.55 * s)


def points():
    result = [(0, 0, -LENGTH / 2)]
    for r in range(RINGS):
        s = r / (RINGS - 1)
        z = LENGTH * (s - 0.5) * 0.96
        for k in range(SIDES):
            angle = 2 * math.pi * k / SIDES
            result.append((radius_at(s) * math.sin(angle), 0.8 * radius_at(s) * math.cos(angle), z))
    return result + [(0, 0, LENGTH / 2)]


def triangles():
    last = 1 + RINGS * SIDES
    ring = lambda r, k: 1 + r * SIDES + k % SIDES
    for k in range(SIDES):
        yield 0, ring(0, k), ring(0, k + 1)
        yield last, ring(RINGS - 1, k + 1), ring(RINGS - 1, k)
        for r in range(RINGS - 1):
            yield ring(r, k), ring(r + 1, k), ring(r + 1, k + 1)
            yield ring(r, k), ring(r + 1, k + 1), ring(r, k + 1)


def joint_z(j):
    return LENGTH * (j / JOINTS - 0.5)


def weights(z):
    """The two joints about z, and their shares."""
    place = (z / LENGTH + 0.5) * JOINTS - 0.5
    first = min(max(math.floor(place), 0), JOINTS - 1)
    second = min(first + 1, JOINTS - 1)
    share = min(max(place - first, 0), 1)
    return (first, second, 0, 0), (1 - share, share, 0, 0)


def turn(j, time):
    """Of a joint about the vertical, as a quaternion: a wave that runs from head to tail, and grows at first."""
    if j == 0:
        return 0, 0, 0, 1
    strength = min(time / 1.0, 1)
    angle = strength * 0.35 * math.sin(2 * math.pi * (0.75 * time + j / JOINTS))
    return 0, math.sin(angle / 2), 0, math.cos(angle / 2)


class Glb:
    def __init__(self):
        self.views, self.accessors, self.bytes = [], [], b""

    def add(self, rows, kind, component, code, bounds=False):
        """Returns the number of an accessor of these rows."""
        data = b"".join(struct.pack("<" + code * len(row), *row) for row in rows)
        data += b"\0" * (-len(data) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)})
        self.bytes += data
        accessor = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(rows), "type": kind}
        if bounds:
            accessor["min"] = [min(row[k] for row in rows) for k in range(len(rows[0]))]
            accessor["max"] = [max(row[k] for row in rows) for k in range(len(rows[0]))]
        self.accessors.append(accessor)
        return len(self.accessors) - 1


FLOAT, BYTE, SHORT = 5126, 5121, 5123


def main():
    glb = Glb()
    surface = points()
    shares = [weights(p[2]) for p in surface]
    primitive = {
        "attributes": {
            "POSITION": glb.add(surface, "VEC3", FLOAT, "f", True),
            "JOINTS_0": glb.add([s[0] for s in shares], "VEC4", BYTE, "B"),
            "WEIGHTS_0": glb.add([s[1] for s in shares], "VEC4", FLOAT, "f"),
        },
        "indices": glb.add([(i,) for t in triangles() for i in t], "SCALAR", SHORT, "H"),
    }
    inverse = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -joint_z(j), 1) for j in range(JOINTS)]
    skin = {"joints": list(range(JOINTS)), "inverseBindMatrices": glb.add(inverse, "MAT4", FLOAT, "f")}
    nodes = []
    for j in range(JOINTS):
        nodes.append({"name": f"joint{j}", "translation": [0, 0, joint_z(j) - (joint_z(j - 1) if j else 0)]})
        if j + 1 < JOINTS:
            nodes[j]["children"] = [j + 1]
    nodes.append({"name": "eel", "mesh": 0, "skin": 0})
    times = [i / KEYS_A_SECOND for i in range(SECONDS * KEYS_A_SECOND + 1)]
    time = glb.add([(t,) for t in times], "SCALAR", FLOAT, "f", True)
    samplers, channels = [], []
    for j in range(1, JOINTS):
        samplers.append({"input": time, "output": glb.add([turn(j, t) for t in times], "VEC4", FLOAT, "f")})
        channels.append({"sampler": len(samplers) - 1, "target": {"node": j, "path": "rotation"}})
    document = {
        "asset": {"version": "2.0", "generator": "make_eel.py"},
        "scene": 0,
        "scenes": [{"nodes": [0, JOINTS]}],
        "nodes": nodes,
        "meshes": [{"primitives": [primitive]}],
        "skins": [skin],
        "animations": [{"name": "swim", "samplers": samplers, "channels": channels}],
        "accessors": glb.accessors,
        "bufferViews": glb.views,
        "buffers": [{"byteLength": len(glb.bytes)}],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with open(FILE, "wb") as file:
        file.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(glb.bytes)))
        file.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(glb.bytes), 0x004E4942) + glb.bytes)


if __name__ == "__main__":
    main()
