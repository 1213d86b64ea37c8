#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the control cages of our example scenes into cages/. Run it from anywhere; y is up."""
import math
import pathlib

OUT = pathlib.Path(__file__).resolve().parent / "cages"


class Cage:
    """One object: positions, faces (0-based, outward), creases {(a, b): sharpness}."""

    def __init__(self, name):
        self.name, self.points, self.faces, self.creases = name, [], [], {}

    def point(self, *p):
        self.points.append(p)
        return len(self.points) - 1

    def crease(self, a, b, sharpness):
        self.creases[min(a, b), max(a, b)] = sharpness


def write(file, comment, cages):
    lines = ["# SPDX-License-Identifier: Apache-2.0", f"# {comment}"]
    tags, first = [], 0
    for cage in cages:
        lines.append(f"o {cage.name}")
        lines += ["v " + " ".join(f"{c:.6g}" for c in p) for p in cage.points]
        lines += ["f " + " ".join(str(v + first + 1) for v in f) for f in cage.faces]
        tags += [f"t crease 2/1/0 {a + first} {b + first} {s:g}" for (a, b), s in sorted(cage.creases.items())]
        first += len(cage.points)
    (OUT / file).write_text("\n".join(lines + tags) + "\n")


def strip(cage, ring_a, ring_b):
    """Quads between two closed rings of the same size."""
    n = len(ring_a)
    for i in range(n):
        cage.faces.append((ring_a[i], ring_a[(i + 1) % n], ring_b[(i + 1) % n], ring_b[i]))


def link(name, centre, along, across, radius, long, wide):
    """A chain link: a tube around an oval that lies in the plane of `along` and `across`."""
    cage = Cage(name)
    normal = [along[(i + 1) % 3] * across[(i + 2) % 3] - along[(i + 2) % 3] * across[(i + 1) % 3] for i in range(3)]
    rings = []
    for i in range(10):
        a = 2 * math.pi * i / 10
        out = [math.cos(a) * along[k] + math.sin(a) * across[k] for k in range(3)]
        middle = [centre[k] + long * math.cos(a) * along[k] + wide * math.sin(a) * across[k] for k in range(3)]
        ring = []
        for j in range(5):
            b = 2 * math.pi * j / 5
            ring.append(cage.point(*(middle[k] + radius * (math.cos(b) * out[k] + math.sin(b) * normal[k]) for k in range(3))))
        rings.append(ring)
    for i in range(10):
        strip(cage, rings[(i + 1) % 10], rings[i])
    return cage


def links():
    flat = link("lying", (-0.75, 0.27, 0), (1, 0, 0), (0, 0, 1), 0.27, 1.15, 0.75)
    c, s = math.cos(0.9), math.sin(0.9)
    tilted = link("leaning", (0.72, 0.62, 0), (0.95, 0.31, 0), (-0.31 * s, 0.95 * s, c), 0.25, 1.1, 0.72)
    write("links.obj", "Two interlocked links of a chain: self-shadowing across objects, no creases.", [flat, tilted])


def bracket():
    """An angle bracket of unit blocks: sharp where a workshop would leave it so, with a round hole in each plate."""
    cage = Cage("bracket")
    blocks = {(x, y, 0) for x in range(5) for y in range(5)} | {(x, 0, z) for x in range(5) for z in range(5)}
    blocks -= {(2, 3, 0), (2, 0, 3)}
    holes = {(2, 3, 0), (2, 0, 3)}
    index, sides = {}, {}

    def vertex(p):
        if p not in index:
            index[p] = cage.point(*(0.4 * c for c in p))
        return index[p]

    steps = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    for x, y, z in sorted(blocks):
        for d in steps:
            if (x + d[0], y + d[1], z + d[2]) in blocks:
                continue
            axis = next(k for k in range(3) if d[k])
            u, v = [0, 0, 0], [0, 0, 0]
            u[(axis + 1) % 3], v[(axis + 2) % 3] = 1, 1
            base = [x, y, z]
            base[axis] += 1 if d[axis] > 0 else 0
            corners = [tuple(base[k] + a * u[k] + b * v[k] for k in range(3)) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            if d[axis] < 0:
                corners.reverse()
            face = tuple(vertex(c) for c in corners)
            cage.faces.append(face)
            in_hole = (x + d[0], y + d[1], z + d[2]) in holes
            for i in range(4):
                sides.setdefault(tuple(sorted((face[i], face[(i + 1) % 4]))), []).append((d, in_hole))
    for (a, b), ((d0, h0), (d1, h1)) in sides.items():
        if d0 != d1 and not (h0 and h1):  # an edge between two directions; those inside a hole stay smooth
            cage.crease(a, b, 1.5 if h0 or h1 else 3)
    write("bracket.obj", "An angle bracket: semi-sharp creases, two holes that subdivision rounds.", [cage])


def cup():
    """A thin cup: one closed surface of inner and outer wall, 12-gons for bottoms, and a handle bridged to the wall."""
    cage, n = Cage("cup"), 12
    profile = [(0.42, 0.0), (0.58, 0.04), (0.66, 0.30), (0.69, 0.62), (0.71, 0.92), (0.74, 1.22), (0.69, 1.22),
               (0.66, 0.92), (0.62, 0.30), (0.50, 0.12)]
    rings = [[cage.point(r * math.cos(2 * math.pi * i / n), y, r * math.sin(2 * math.pi * i / n)) for i in range(n)]
             for r, y in profile]
    for a, b in zip(rings, rings[1:]):
        strip(cage, b, a)
    cage.faces.append(tuple(rings[0]))
    cage.faces.append(tuple(reversed(rings[-1])))
    for ring in (rings[5], rings[6]):
        for i in range(n):
            cage.crease(ring[i], ring[(i + 1) % n], 1.5)

    def take(low):
        """Removes the wall's quad above ring `low` at segment 0 and returns its corners."""
        quad = (rings[low + 1][0], rings[low + 1][1], rings[low][1], rings[low][0])
        cage.faces.remove(quad)
        return quad

    # Corners of a section: (upper, z small), (upper, z large), (lower, z large), (lower, z small).
    top, bottom = take(4), take(2)
    turn = math.pi / n
    sections = [top]
    for r, y, tilt in ((1.02, 1.08, 0.35), (1.24, 0.86, 1.3), (1.20, 0.56, 1.9), (0.98, 0.40, 2.7)):
        section = []
        for up, side in ((1, -1), (1, 1), (-1, 1), (-1, -1)):
            radius, z = r + 0.075 * up * math.sin(tilt), 0.10 * side
            y_here = y + 0.075 * up * math.cos(tilt)
            section.append(cage.point(radius * math.cos(turn) - z * math.sin(turn), y_here,
                                      radius * math.sin(turn) + z * math.cos(turn)))
        sections.append(tuple(section))
    # At its lower end the tube has turned over: what was above is below.
    sections.append((bottom[3], bottom[2], bottom[1], bottom[0]))
    for a, b in zip(sections, sections[1:]):
        strip(cage, a, b)
    write("cup.obj", "A thin cup with a handle: thin walls, n-gons, semi-sharp rim.", [cage])


def star():
    """A star whose two poles have a valence of 18; it stands on two of its points."""
    cage, points = Cage("star"), 9
    tips = 2 * points
    ring = []
    for i in range(tips):
        a = 2 * math.pi * (i + 0.5) / tips + math.pi / 2
        r = 1.0 if i % 2 == 0 else 0.42
        ring.append(cage.point(r * math.cos(a), r * math.sin(a), 0))
    front, back = cage.point(0, 0, 0.34), cage.point(0, 0, -0.34)
    for i in range(tips):
        cage.faces.append((front, ring[i], ring[(i + 1) % tips]))
        cage.faces.append((back, ring[(i + 1) % tips], ring[i]))
        cage.crease(ring[i], ring[(i + 1) % tips], 2)
    write("star.obj", "A star: poles of valence 18, triangles, a semi-sharp rim.", [cage])


if __name__ == "__main__":
    OUT.mkdir(exist_ok=True)
    links()
    bracket()
    cup()
    star()
