#!/usr/bin/env python3
"""Writes the meshes of these scenes into meshes/: surfaces of revolution, as rings of points.

Use: ./make_meshes.py
"""
import math
import os

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "meshes")


def ring(radius, height, count, centre=(0, 0)):
    """Points of a circle about the vertical; a single one where the radius is 0."""
    if radius == 0:
        return [(centre[0], height, centre[1])]
    angles = [2 * math.pi * i / count for i in range(count)]
    return [(centre[0] + radius * math.sin(a), height, centre[1] + radius * math.cos(a)) for a in angles]


def strip(lower, upper):
    """Triangles between two rings, each a list of point numbers; a ring of one point is a tip."""
    count = max(len(lower), len(upper))
    for i in range(count):
        j = (i + 1) % count
        if len(lower) > 1:
            yield lower[i], lower[j], upper[i % len(upper)]
        if len(upper) > 1:
            yield lower[j % len(lower)], upper[j], upper[i]


class Mesh:
    def __init__(self):
        self.points = []
        self.triangles = []

    def add_surface(self, profile, count, centre=(0, 0)):
        """Rings of (radius, height) from below to above; the outside is the front."""
        below = None
        for radius, height in profile:
            points = ring(radius, height, count, centre)
            numbers = list(range(len(self.points) + 1, len(self.points) + 1 + len(points)))
            self.points += points
            if below:
                self.triangles += strip(below, numbers)
            below = numbers

    def write(self, name, what):
        with open(os.path.join(FOLDER, name), "w") as file:
            file.write(f"# {what}; written by make_meshes.py\n")
            file.writelines(f"v {x:.6g} {y:.6g} {z:.6g}\n" for x, y, z in self.points)
            file.writelines(f"f {a} {b} {c}\n" for a, b, c in self.triangles)


def between(start, end, steps):
    """steps + 1 pairs on the straight line from start to end."""
    return [tuple(a + (b - a) * i / steps for a, b in zip(start, end)) for i in range(steps + 1)]


def main():
    cone = Mesh()
    cone.add_surface([(0, 0), (0.25, 0), (0, 0.5)], 48)
    cone.write("cone.obj", "a cone, closed, its tip upward")

    needles = Mesh()
    for column in range(-6, 7):
        for row in range(-6, 7):
            needles.add_surface([(0, 0), (0.008, 0), (0, 0.12)], 8, (0.05 * column, 0.05 * row))
    needles.write("needles.obj", "a bed of 169 needles")

    tube = Mesh()
    tube.add_surface(between((0.1, -0.4), (0.1, 0.4), 54), 42)
    tube.write("tube.obj", "an open tube of cloth along y")

    funnel = Mesh()
    funnel.add_surface(between((0.115, -0.35), (0.115, -0.1), 17)[:-1] + between((0.115, -0.1), (0.45, 0.2), 30), 64)
    funnel.write("funnel.obj", "a funnel of cloth, open at both ends")

    skirt = Mesh()
    skirt.add_surface(between((0.34, -0.5), (0.17, -0.08), 28)[:-1] + between((0.17, -0.08), (0.125, 0), 6), 80)
    skirt.write("skirt.obj", "a skirt, its waist at the origin's height")


if __name__ == "__main__":
    main()
