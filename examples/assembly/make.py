#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the assemblies of this directory: OBJ files, an object for each part, a group for each convex piece of it.

    python3 examples/assembly/make.py [DIRECTORY]

All coordinates are integers, so that every example is what it says exactly.
"""
import itertools
import math
import os
import sys
from fractions import Fraction

OCTAGON = [(2, -1), (2, 1), (1, 2), (-1, 2), (-2, 1), (-2, -1), (-1, -2), (1, -2)]


# Convex pieces as lists of vertices; facets are found anew, so that pieces need no orientation.


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def primitive(v):
    divisor = math.gcd(*v)
    return tuple(x // divisor for x in v)


def facets(points):
    """The facets of the hull of a few points, counterclockwise seen from outside."""
    found = {}
    for a, b, c in itertools.combinations(range(len(points)), 3):
        normal = cross(minus(points[b], points[a]), minus(points[c], points[a]))
        if normal == (0, 0, 0):
            continue
        normal = primitive(normal)
        for n in (normal, tuple(-x for x in normal)):
            level = dot(n, points[a])
            sides = [dot(n, p) - level for p in points]
            if max(sides) == 0:
                found[n] = [i for i, side in enumerate(sides) if side == 0]
    return [ring_around(points, corners, normal) for normal, corners in sorted(found.items())]


def ring_around(points, corners, normal):
    """Corners of a convex polygon in order; corners inside an edge are left out."""
    ring = [min(corners, key=lambda i: points[i])]
    while True:
        at = points[ring[-1]]
        following = None
        for i in corners:
            if i == ring[-1]:
                continue
            if following is None:
                following = i
                continue
            u, v = minus(points[following], at), minus(points[i], at)
            turn = dot(normal, cross(u, v))
            if turn < 0 or (turn == 0 and dot(v, v) > dot(u, u)):
                following = i
        if following == ring[0]:
            return ring
        ring.append(following)


def box(low, high):
    return [tuple(corner) for corner in itertools.product(*zip(low, high))]


def prism(polygon, low, high):
    return [(x, y, z) for z in (low, high) for x, y in polygon]


def moved(pieces, by):
    return [[tuple(x + d for x, d in zip(p, by)) for p in piece] for piece in pieces]


def octagon(size, center=(0, 0)):
    """Integer corners at (2, 1) size and the like."""
    return [(size * x + center[0], size * y + center[1]) for x, y in OCTAGON]


def clipped(polygon, a, b):
    """What of a convex polygon is on the right of the line from a to b."""
    def side(p):
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])

    result = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        if side(p) <= 0:
            result.append(p)
        if side(p) * side(q) < 0:
            t = Fraction(side(p), side(p) - side(q))
            point = tuple(Fraction(x) + t * (y - x) for x, y in zip(p, q))
            assert all(x.denominator == 1 for x in point), "corners are to be integers"
            result.append(tuple(int(x) for x in point))
    return result


def plate_with_hole(outline, hole, low, high):
    """What is beyond each edge of the hole: pieces that overlap in its corners."""
    pieces = []
    for a, b in zip(hole, hole[1:] + hole[:1]):
        piece = clipped(outline, a, b)
        if len(piece) > 2:
            pieces.append(prism(piece, low, high))
    return pieces


def rectangle(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


# Assemblies: lists of (name, pieces).


def split_star():
    """The puzzle of Coffin: the first stellation of the rhombic dodecahedron in six equal parts."""
    red = [[(0, 0, 0), (0, 0, 2), (1, 1, 1), (1, -1, 1), (-1, 1, 1), (-1, -1, 1)],
           [(2, 0, 2), (0, 0, 2), (1, 1, 1), (2, 0, 0), (1, -1, 1)],
           [(-2, 0, 2), (0, 0, 2), (-1, 1, 1), (-2, 0, 0), (-1, -1, 1)]]

    def half_turn(p):
        return (p[0], -p[1], -p[2])

    def turned(p, times):
        for _ in range(times):
            p = (p[2], p[0], p[1])
        return p

    names = [("red", "green"), ("yellow", "turquoise"), ("purple", "blue")]
    parts = []
    for times, (front, back) in enumerate(names):
        parts.append((front, [[turned(p, times) for p in piece] for piece in red]))
        parts.append((back, [[turned(half_turn(p), times) for p in piece] for piece in red]))
    return parts


def peg(has_floor):
    block = [box((1, -2, 0), (2, 2, 2)), box((-2, -2, 0), (-1, 2, 2)), box((-1, 1, 0), (1, 2, 2)),
             box((-1, -2, 0), (1, -1, 2))]
    if has_floor:
        block.append(box((-2, -2, -1), (2, 2, 0)))
    return [("peg", [box((-1, -1, 0), (1, 1, 2))]), ("block", block)]


def hooks():
    """Two hooks through one another, which no single translation parts, though each can begin to move."""
    first = [box((0, 0, -1), (10, 2, 1)), box((0, 0, -1), (2, 8, 1)), box((0, 6, -1), (10, 8, 1)),
             box((8, 4, -1), (10, 8, 1))]
    second = [box((4, 3, -4), (6, 5, 4)), box((-6, 3, 2), (6, 5, 4)), box((-6, 3, -4), (6, 5, -2)),
              box((-6, 3, 0), (-4, 5, 4))]
    return [("first", first), ("second", second)]


def stack(count):
    return [(f"box_{i + 1:02}", [box((0, 0, i), (2, 2, i + 1))]) for i in range(count)]


# The sticks of the burr, of 6 by 2 by 2 cells, two along each axis: which of the 16 cells between their ends they keep.
BURR = ["#.#.#...#...#.#.",
    "####.#..##...###",
    "#.###...#...#.#.",
    ".#.#.#.#.#...#.#",
    "#.#.####.##.#.#.",
    "################"]


def burr():
    """Six pieces of which only the key, the last one, can move first."""
    parts = []
    for k, kept in enumerate(BURR):
        axis, side = divmod(k, 2)
        cells = []
        bits = iter(kept)
        across = (0, 1) if side else (-2, -1)
        for a in range(-3, 3):
            for b in (-1, 0):
                for c in across:
                    if a in (-3, 2) or next(bits) == "#":
                        cell = [0, 0, 0]
                        cell[axis], cell[(axis + 1) % 3], cell[(axis + 2) % 3] = a, b, c
                        cells.append(tuple(cell))
        name = "key" if k == 5 else f"stick_{'xyz'[axis]}{side + 1}"
        parts.append((name, boxes_of(set(cells))))
    return parts


def boxes_of(cells):
    """Boxes that cover cells of side 1, each as large as it grows along z, y and x."""
    rest, pieces = set(cells), []
    while rest:
        low = min(rest)
        size = [1, 1, 1]
        for axis in (2, 1, 0):
            while True:
                grown = list(size)
                grown[axis] += 1
                inside = {tuple(l + d for l, d in zip(low, step)) for step in itertools.product(*map(range, grown))}
                if not inside <= cells:
                    break
                size = grown
        rest -= {tuple(l + d for l, d in zip(low, step)) for step in itertools.product(*map(range, size))}
        pieces.append(box(low, tuple(l + d for l, d in zip(low, size))))
    return pieces


def bracket():
    """A plate, a bracket on it, two bolts through both, and a nut on each."""
    plate, foot = [], []
    bolts, nuts = [], []
    for k, x in enumerate((-10, 10)):
        outline = rectangle(min(0, 2 * x), -8, max(0, 2 * x), 8)
        hole = octagon(2, (x, 0))
        plate += plate_with_hole(outline, hole, 0, 3)
        foot += plate_with_hole(outline, hole, 3, 6)
        bolts.append((f"bolt_{k + 1}", [prism(octagon(2, (x, 0)), -6, 6), prism(octagon(3, (x, 0)), 6, 9)]))
        nut_outline = rectangle(x - 6, -6, x + 6, 6)
        nuts.append((f"nut_{k + 1}", plate_with_hole(nut_outline, hole, -4, 0)))
    upright = box((-20, 8, 3), (20, 11, 24))
    return [("plate", plate), ("bracket", foot + [upright])] + bolts + nuts


def gearbox():
    """Thirty parts: two shafts with what sits on them between a base and a cover, held by four bolts and two caps."""
    height = 44
    base, cover = [], []
    parts = []
    rings = [("bearing", 4, 4), ("spacer", 3, 2), ("gear", 6, 4), ("spacer", 3, 6), ("wheel", 5, 4), ("spacer", 3, 4),
             ("pinion", 4, 6), ("spacer", 3, 2), ("disc", 5, 4), ("bearing", 4, 4)]
    for side, x in (("left", -14), ("right", 14)):
        outline = rectangle(min(0, 2 * x), -14, max(0, 2 * x), 14)
        shaft_hole = octagon(2, (x, 0))
        base += plate_with_hole(outline, shaft_hole, 0, 4)
        cover += plate_with_hole(outline, shaft_hole, height, height + 4)
        parts.append((f"shaft_{side}", [prism(octagon(2, (x, 0)), 0, height + 6)]))
        z = 4
        for k, (name, size, thickness) in enumerate(rings):
            parts.append((f"{name}_{side}_{k + 1}", plate_with_hole(octagon(size, (x, 0)), shaft_hole, z, z + thickness)))
            z += thickness
        assert z == height
        parts.append((f"cap_{side}", plate_with_hole(octagon(3, (x, 0)), shaft_hole, height + 4, height + 6)
                      + [prism(octagon(3, (x, 0)), height + 6, height + 8)]))
    walls = []
    corners = [(-32, -18), (32, -18), (32, 18), (-32, 18)]
    for k, (x, y) in enumerate(corners):
        hole = octagon(1, (x, y))
        lug = rectangle(x - 4, y - 4, x + 4, y + 4)
        base += plate_with_hole(lug, hole, 0, 4)
        cover += plate_with_hole(lug, hole, height, height + 4)
        walls.append((f"bolt_{k + 1}", [prism(hole, 0, height + 4), prism(octagon(2, (x, y)), height + 4, height + 7)]))
    for low, high, into in ((0, 4, base), (height, height + 4, cover)):
        into.append(box((-28, 14, low), (28, 22, high)))
        into.append(box((-28, -22, low), (28, -14, high)))
    return [("base", base)] + parts + [("cover", cover)] + walls


def write(path, parts):
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write("# SPDX-License-Identifier: Apache-2.0\n# Made by make.py.\n")
        first = 1
        for name, pieces in parts:
            out.write(f"o {name}\n")
            for k, piece in enumerate(pieces):
                if len(pieces) > 1:
                    out.write(f"g piece_{k + 1}\n")
                points = sorted(set(piece))
                for p in points:
                    out.write("v {} {} {}\n".format(*p))
                for ring in facets(points):
                    out.write("f " + " ".join(str(first + i) for i in ring) + "\n")
                first += len(points)


def main():
    directory = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    for name, parts in (("split_star", split_star()), ("peg_blind", peg(True)), ("peg_through", peg(False)),
                        ("hooks", hooks()), ("burr", burr()), ("stack", stack(10)), ("bracket", bracket()), ("gearbox", gearbox())):
        write(os.path.join(directory, name + ".obj"), parts)


if __name__ == "__main__":
    main()
