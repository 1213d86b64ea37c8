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


def unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return [c / length for c in v]


def cross(a, b):
    return [a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3] for i in range(3)]


def strip(cage, ring_a, ring_b):
    """Quads between two closed rings of the same size."""
    n = len(ring_a)
    for i in range(n):
        cage.faces.append((ring_a[i], ring_a[(i + 1) % n], ring_b[(i + 1) % n], ring_b[i]))


def link(name, centre, along, across, radius, long, wide):
    """A chain link: a tube around an oval that lies in the plane of `along` and `across`."""
    cage = Cage(name)
    normal = cross(along, across)
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


def knot():
    """A trefoil knot in a tube: one surface that shades itself over and over."""
    cage, around, across = Cage("knot"), 36, 6

    def centre(t):
        r = 1.0 + 0.42 * math.cos(3 * t)
        return (r * math.cos(2 * t), 0.42 * math.sin(3 * t), r * math.sin(2 * t))

    rings = []
    for i in range(around):
        t = 2 * math.pi * i / around
        here, before, after = centre(t), centre(t - 1e-3), centre(t + 1e-3)
        along = unit([after[k] - before[k] for k in range(3)])
        # Around the middle of the knot, not along the curve's bend: that frame closes without a twist.
        out = [here[0] - math.cos(2 * t), here[1], here[2] - math.sin(2 * t)]
        out = unit([out[k] - along[k] * sum(out[j] * along[j] for j in range(3)) for k in range(3)])
        side = cross(along, out)
        rings.append([cage.point(*(here[k] + 0.24 * (math.cos(a) * out[k] + math.sin(a) * side[k]) for k in range(3)))
                      for a in (2 * math.pi * j / across for j in range(across))])
    for i in range(around):
        strip(cage, rings[i], rings[(i + 1) % around])
    write("knot.obj", "A trefoil knot: self-shadow everywhere, no creases, every vertex regular.", [cage])


def ring():
    write("ring.obj", "One link of a chain, an oval in the plane of x and y.",
          [link("link", (0, 0, 0), (1, 0, 0), (0, 1, 0), 0.16, 0.62, 0.42)])


def plate(cage, outline, corners, hole, low, high, rim, edge):
    """A plate with a round hole: `outline` and `hole` are rings of as many points (x, z); `corners` are sharp."""
    n = len(outline)
    rings = [[cage.point(x, y, z) for x, z in ring] for ring, y in
             ((outline, low), (outline, high), (hole, high), (hole, low))]
    for a in range(4):
        strip(cage, rings[(a + 1) % 4], rings[a])
        for i in range(n):
            cage.crease(rings[a][i], rings[a][(i + 1) % n], rim)
    for i in corners:
        cage.crease(rings[0][i], rings[1][i], edge)


def circle(n, radius, phase=0.0):
    return [(radius * math.cos(2 * math.pi * i / n + phase), radius * math.sin(2 * math.pi * i / n + phase)) for i in range(n)]


def gear():
    cage, teeth = Cage("gear"), 12
    outline = []
    for i in range(teeth):
        for part, radius in ((-0.30, 0.80), (-0.17, 1.06), (0.17, 1.06), (0.30, 0.80)):
            a = 2 * math.pi * (i + part) / teeth
            outline.append((radius * math.cos(a), radius * math.sin(a)))
    hole = [(0.34 * x / math.hypot(x, z), 0.34 * z / math.hypot(x, z)) for x, z in outline]
    plate(cage, outline, range(4 * teeth), hole, 0.0, 0.3, 2.5, 2.5)
    write("gear.obj", "A gear of twelve teeth: semi-sharp creases, long thin quads, a bore that stays round.", [cage])


def nut():
    cage = Cage("nut")
    hexagon = []
    for i in range(6):
        a, b = (2 * math.pi * k / 6 for k in (i, i + 1))
        hexagon.append((math.cos(a), math.sin(a)))
        hexagon.append(((math.cos(a) + math.cos(b)) / 2, (math.sin(a) + math.sin(b)) / 2))
    plate(cage, [(0.5 * x, 0.5 * z) for x, z in hexagon], range(0, 12, 2), circle(12, 0.29), 0.0, 0.4, 2, 2.5)
    write("nut.obj", "A hexagonal nut: creases that meet in threes.", [cage])


def turned(name, profile, segments, creases):
    """A turned solid: rings (radius, y) from bottom to top, closed by n-gons; `creases` {ring: sharpness}."""
    cage = Cage(name)
    rings = [[cage.point(x, y, z) for x, z in circle(segments, r)] for r, y in profile]
    for a, b in zip(rings, rings[1:]):
        strip(cage, b, a)
    cage.faces.append(tuple(rings[0]))
    cage.faces.append(tuple(reversed(rings[-1])))
    for k, sharpness in creases.items():
        for i in range(segments):
            cage.crease(rings[k][i], rings[k][(i + 1) % segments], sharpness)
    return cage


def figures():
    pawn = [(0.40, 0.0), (0.42, 0.10), (0.30, 0.20), (0.20, 0.34), (0.15, 0.62), (0.24, 0.72), (0.15, 0.76),
            (0.27, 0.90), (0.25, 1.12), (0.10, 1.22)]
    write("pawn.obj", "A pawn, turned: n-gons at both ends.", [turned("pawn", pawn, 8, {0: 3, 1: 1.5, 5: 1.5})])
    cone = [(0.42, 0.0), (0.42, 0.08), (0.10, 1.05), (0.05, 1.12)]
    write("cone.obj", "A cone with a rounded tip.", [turned("cone", cone, 8, {0: 3, 1: 2})])
    drum = [(0.36, 0.0), (0.40, 0.06), (0.33, 0.36), (0.40, 0.66), (0.36, 0.72)]
    write("drum.obj", "A waisted drum.", [turned("drum", drum, 8, {0: 3, 4: 3})])


def bolt():
    cage = turned("bolt", [(0.46, 0.0), (0.46, 0.30), (0.26, 0.30), (0.25, 1.20), (0.20, 1.26)], 12,
                  {0: 2.5, 1: 2.5, 2: 2.5, 3: 2, 4: 2})
    for i in range(12):  # a hexagonal head on a round shaft
        for level in (0, 12):
            x, y, z = cage.points[level + i]
            flat = math.cos(math.pi / 6) if i % 2 else 1.0
            cage.points[level + i] = (x * flat, y, z * flat)
        if i % 2 == 0:
            cage.crease(i, 12 + i, 2.5)
    write("bolt.obj", "A bolt that stands on its hexagonal head.", [cage])


def lantern():
    """A pierced shell: a barrel of 16 by 6 cells, some of them windows, given a thickness."""
    cage, n, thick = Cage("lantern"), 16, 0.07
    profile = [(0.42, 0.0), (0.62, 0.22), (0.74, 0.5), (0.76, 0.8), (0.70, 1.1), (0.52, 1.36), (0.30, 1.5)]
    shells = []
    for inward in (0, thick):
        shells.append([[cage.point(x, y, z) for x, z in circle(n, r - inward)] for r, y in profile])
    cells = {(i, j) for i in range(n) for j in range(len(profile) - 1) if i % 2 or j in (0, 3, 5)}
    for i, j in sorted(cells):
        k = (i + 1) % n
        outer, inner = shells
        cage.faces.append((outer[j + 1][i], outer[j + 1][k], outer[j][k], outer[j][i]))
        cage.faces.append((inner[j][i], inner[j][k], inner[j + 1][k], inner[j + 1][i]))
        for (di, dj), (a, b) in (((1, 0), ((k, j), (k, j + 1))), ((-1, 0), ((i, j + 1), (i, j))),
                                 ((0, 1), ((k, j + 1), (i, j + 1))), ((0, -1), ((i, j), (k, j)))):
            if ((i + di) % n, j + dj) in cells:
                continue
            (ai, aj), (bi, bj) = a, b
            cage.faces.append((outer[aj][ai], outer[bj][bi], inner[bj][bi], inner[aj][ai]))
    write("lantern.obj", "A pierced lantern: a shell full of holes for a light within.", [cage])


if __name__ == "__main__":
    OUT.mkdir(exist_ok=True)
    links()
    bracket()
    cup()
    star()
    knot()
    ring()
    gear()
    nut()
    bolt()
    figures()
    lantern()
