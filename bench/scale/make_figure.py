#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes figure.obj beside itself: a four-legged cage of about 1,450 quads, the size of the figures that animators model.

The body is a set of boxes on a lattice; its skin are the sides between inside and outside, so that the cage is closed and
manifold by construction (checked below). The lattice is bent a little, so that no two faces are alike.
"""
import math
import pathlib

# Boxes: lowest cell, size. x across, y up, z from tail to nose.
BOXES = [
    ((3, 9, 4), (7, 7, 19)),  # trunk
    ((4, 15, 21), (5, 5, 4)),  # neck
    ((3, 18, 23), (7, 5, 6)),  # head
    ((4, 18, 29), (5, 3, 3)),  # snout
    ((3, 23, 24), (1, 6, 1)),  # ears
    ((9, 23, 24), (1, 6, 1)),
    ((3, 0, 5), (2, 9, 3)),  # legs
    ((8, 0, 5), (2, 9, 3)),
    ((3, 0, 18), (2, 9, 3)),
    ((8, 0, 18), (2, 9, 3)),
    ((6, 13, -12), (1, 1, 16)),  # tail
    ((6, 13, -13), (1, 8, 1)),
]
# The corners of a cell's sides, each seen from outside counter-clockwise.
SIDES = {
    (-1, 0, 0): [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)],
    (1, 0, 0): [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
    (0, -1, 0): [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
    (0, 1, 0): [(0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)],
    (0, 0, -1): [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)],
    (0, 0, 1): [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
}


def cells():
    inside = set()
    for (x, y, z), (w, h, d) in BOXES:
        inside.update((i, j, k) for i in range(x, x + w) for j in range(y, y + h) for k in range(z, z + d))
    return inside


def bent(x, y, z):
    """The lattice point in space."""
    swell = 1 + 0.25 * math.sin(math.pi * min(max((z - 4) / 19, 0), 1)) * (0.3 if y < 9 else 1)
    return ((x - 6.5) * swell + 0.3 * math.sin(0.7 * z), y + 0.4 * math.cos(0.5 * z) * (y / 9 if y < 9 else 1), z + 0.2 * math.sin(0.9 * y))


def main():
    inside = cells()
    number, faces = {}, []
    for x, y, z in sorted(inside):
        for (dx, dy, dz), corners in SIDES.items():
            if (x + dx, y + dy, z + dz) not in inside:
                faces.append([number.setdefault((x + a, y + b, z + c), len(number) + 1) for a, b, c in corners])
    edges = {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            edges[a, b] = edges.get((a, b), 0) + 1
    assert all(n == 1 and edges.get((b, a)) == 1 for (a, b), n in edges.items()), "not a closed manifold"
    out = pathlib.Path(__file__).resolve().parent / "figure.obj"
    with out.open("w") as f:
        f.write(f"# A four-legged figure, {len(faces)} quads (bench/scale/make_figure.py).\n")
        for point in number:
            f.write("v %.5f %.5f %.5f\n" % bent(*point))
        for face in faces:
            f.write("f %d %d %d %d\n" % tuple(face))
    print(f"{out.name}: {len(number)} vertices, {len(faces)} faces")


if __name__ == "__main__":
    main()
