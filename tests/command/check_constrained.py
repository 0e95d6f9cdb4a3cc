# SPDX-License-Identifier: Apache-2.0
"""The command constrained.

    check_constrained.py QUOIN
"""
import random
import unittest
import xml.etree.ElementTree as ElementTree
from fractions import Fraction

from clouds import cloud, read_vtk, text_of
from command import FILE_TROUBLE, REFUSED, USAGE, CommandTest, main

FRAME = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 3 1, 3 3, 1 3, 1 1))"
CROSSING = "MULTILINESTRING ((0 0, 1 1), (0 1, 1 -1))"  # in (1/3, 1/3)


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def in_circle(a, b, c, d):
    """Positive where d is inside of the circle of three counterclockwise points."""
    rows = [(p[0] - d[0], p[1] - d[1]) for p in (a, b, c)]
    (ax, ay), (bx, by), (cx, cy) = rows
    sa, sb, sc = (x * x + y * y for x, y in rows)
    return ax * (by * sc - sb * cy) - ay * (bx * sc - sb * cx) + sa * (bx * cy - by * cx)


def hull_area(points):
    """Twice it."""
    chains = []
    for order in (sorted(set(points)), sorted(set(points), reverse=True)):
        chain = []
        for p in order:
            while len(chain) > 1 and turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chains.append(chain)
    ring = chains[0][:-1] + chains[1][:-1]
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1]))


def lines_of(segments):
    return "MULTILINESTRING (" + ", ".join(f"({a[0]!r} {a[1]!r}, {b[0]!r} {b[1]!r})" for a, b in segments) + ")"


def ring_of(points):
    return "POLYGON ((" + ", ".join(f"{x!r} {y!r}" for x, y in points + points[:1]) + "))"


def exact(word):
    """Decimals are doubles, integers and fractions themselves."""
    return Fraction(float(word)) if any(c in word for c in ".e") else Fraction(word)


class Cells:
    """What an exact text says: places, triangles and pieces with domain, depth and segment."""

    def __init__(self, text):
        lines = text.splitlines()
        assert lines[:2] == ["quoin-cells 1", "coordinates 2"] and lines[-1] == "end"
        at = next(i for i, line in enumerate(lines) if line.startswith("points "))
        count = int(lines[at].split()[1])
        rows = [line.split() for line in lines[at + 1:at + 1 + count]]
        self.places = [(exact(r[0]), exact(r[1])) for r in rows]
        self.constructed = [r[2] == "1" for r in rows]
        at = next(i for i, line in enumerate(lines) if line.startswith("cells "))
        self.triangles, self.pieces = [], []
        for line in lines[at + 1:at + 1 + int(lines[at].split()[1])]:
            words = line.split()
            corners = tuple(map(int, words[4:]))
            if len(corners) == 3:
                assert words[3] == "-"
                self.triangles.append((corners, int(words[1]), int(words[2])))
            else:
                self.pieces.append((corners, int(words[1]), int(words[2]), int(words[3])))

    def area(self, chosen=lambda depth: True):
        return sum(turn(*(self.places[v] for v in corners)) for corners, _, depth in self.triangles if chosen(depth)) / 2


class Constrained(CommandTest):
    def cells(self, *words, stdin=None):
        self.run_quoin("constrained", *words, "-o", "c.qcells", "-q", stdin=stdin)
        return Cells(self.read("c.qcells").decode())

    def check_triangulation(self, cells, segments):
        """By definition: counterclockwise triangles fill the hull, pieces are edges and make up the segments, and other
        edges are locally Delaunay."""
        places = cells.places
        self.assertEqual(2 * cells.area(), hull_area(places))
        apex = {}
        for corners, _, _ in cells.triangles:
            self.assertGreater(turn(*(places[v] for v in corners)), 0)
            for i in range(3):
                apex[corners[i], corners[(i + 1) % 3]] = corners[(i + 2) % 3]
        pieces = {frozenset(ends): segment for ends, _, _, segment in cells.pieces}
        self.assertEqual(len(pieces), len(cells.pieces))
        for (a, b), c in apex.items():
            d = apex.get((b, a))
            if d is not None and frozenset((a, b)) not in pieces:
                self.assertLessEqual(in_circle(places[a], places[b], places[c], places[d]), 0)
        for ends in pieces:
            a, b = ends
            self.assertTrue((a, b) in apex or (b, a) in apex)
        number = {p: i for i, p in enumerate(places)}
        for p, q in segments:
            p, q = (tuple(map(Fraction, x)) for x in (p, q))
            along = [(max((x[0] - p[0]) * (q[0] - p[0]) + (x[1] - p[1]) * (q[1] - p[1]), 0), number[x]) for x in places
                     if turn(p, q, x) == 0 and min(p, q) <= x <= max(p, q)]
            chain = [v for _, v in sorted(along)]
            self.assertEqual((places[chain[0]], places[chain[-1]]), (p, q))
            for a, b in zip(chain, chain[1:]):
                self.assertIn(frozenset((a, b)), pieces)
        for ends, segment in pieces.items():
            p, q = (tuple(map(Fraction, x)) for x in segments[segment])
            self.assertTrue(all(turn(p, q, places[v]) == 0 for v in ends))

    def test_a_frame(self):
        report = self.json_of("constrained", FRAME)
        self.assertEqual({k: v for k, v in report.items() if k != "warnings"},
                         {"points": 8, "distinct": 8, "constructed_points": 0, "segments": 8, "pieces": 8, "dimension": 2,
                          "triangles": 10, "inside_triangles": 8, "domains": 2, "largest_depth": 2})
        cells = self.cells(FRAME)
        self.assertEqual([cells.area(lambda depth, d=d: depth == d) for d in range(3)], [0, 12, 4])
        inside = self.cells(FRAME, "--inside")
        self.assertEqual((inside.area(), len(inside.triangles), len(inside.places), len(inside.pieces)), (12, 8, 8, 8))
        self.assertEqual(self.json_of("homology", "c.qcells")["betti"]["Q"][:2], [1, 1])
        # Rings may run either way, and an island is inside again.
        island = "MULTIPOLYGON (((0 0, 0 9, 9 9, 9 0, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1)), ((3 3, 6 3, 6 6, 3 6, 3 3)))"
        self.assertEqual(self.cells(island, "--inside").area(), 81 - 49 + 9)

    def test_crossings_are_exact(self):
        cells = self.cells(CROSSING)
        third = (Fraction(1, 3), Fraction(1, 3))
        self.assertEqual([p for p, made in zip(cells.places, cells.constructed) if made], [third])
        self.check_triangulation(cells, [((0, 0), (1, 1)), ((0, 1), (1, -1))])
        report = self.json_of("constrained", CROSSING, "-o", "c.vtk", "-o", "c.qcells")
        self.assertEqual((report["constructed_points"], report["pieces"]), (1, 4))
        self.assertEqual((report["rounding"]["points"], report["rounding"]["turned_triangles"]), (1, 0))
        moved = abs(Fraction(1 / 3) - Fraction(1, 3))
        self.assertTrue(moved <= report["rounding"]["max_displacement"] <= moved * (1 + Fraction(1, 2 ** 50)))
        self.assertIn("no doubles", report["warnings"][0])
        self.assertNotIn("rounding", self.json_of("constrained", CROSSING, "-o", "c.qcells"))
        self.assertEqual(self.json_of("constrained", CROSSING, "-o", "c.qcells")["warnings"], [])

    def test_any_segments(self):
        for seed in range(12):
            source = random.Random(seed)
            grid = (3, 5, 8, None)[seed % 4]
            number = (lambda g=grid: source.randrange(g)) if grid else source.random
            segments = []
            while len(segments) < 12:
                a, b = ((number(), number()) for _ in range(2))
                if a != b:
                    segments.append((a, b))
            points = [(number(), number()) for _ in range(6)]
            self.write("p.xyz", text_of(points))
            cells = self.cells(lines_of(segments), "--points", "p.xyz")
            self.assertTrue({tuple(map(Fraction, p)) for p in points} <= set(cells.places))
            self.check_triangulation(cells, segments)

    def test_depth_is_of_the_parity_of_crossings(self):
        for seed in range(4):
            ring = cloud(9, 2, seed=seed)
            exact = [tuple(map(Fraction, p)) for p in ring]
            cells = self.cells(ring_of(ring))
            for corners, domain, depth in cells.triangles:
                x, y = (sum(cells.places[v][k] for v in corners) / 3 for k in range(2))
                crossings = sum(1 for a, b in zip(exact, exact[1:] + exact[:1])
                                if (a[1] > y) != (b[1] > y) and x < a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1]))
                self.assertEqual(depth % 2, crossings % 2)
                self.assertEqual(domain == 0, depth == 0)
            report = self.json_of("constrained", ring_of(ring))
            self.assertEqual(report["domains"], len({d for _, d, _ in cells.triangles if d > 0}))
            self.assertEqual(report["inside_triangles"], sum(1 for _, _, depth in cells.triangles if depth % 2))
            self.assertEqual(report["largest_depth"], max(depth for _, _, depth in cells.triangles))

    def test_chains_that_end_enclose_nothing(self):
        done = self.run_quoin("constrained", "LINESTRING (0 0, 4 0, 4 4, 0 4)", "--inside", "-o", "c.qcells")
        self.assertIn("enclose nothing", done.stderr)
        self.assertEqual(Cells(self.read("c.qcells").decode()).triangles, [])
        slit = self.cells("GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)), LINESTRING (1 1, 2 3))", "--inside")
        self.assertEqual((slit.area(), len(slit.pieces)), (16, 5))

    def test_the_order_does_not_matter(self):
        source = random.Random(5)
        segments = [tuple((source.random(), source.random()) for _ in range(2)) for _ in range(15)]
        self.run_quoin("constrained", lines_of(segments), "-o", "a.vtk", "-o", "a.off", "-q")
        source.shuffle(segments)
        first, second = segments[:7], [(b, a) for a, b in segments[7:]]
        self.run_quoin("constrained", lines_of(first), lines_of(second), "--threads", "1", "-o", "b.vtk", "-o", "b.off", "-q")
        self.assertEqual(self.read("a.vtk").split(b"\n")[2:], self.read("b.vtk").split(b"\n")[2:])
        self.assertEqual(self.read("a.off"), self.read("b.off"))

    def test_rounding_that_turns_triangles_over_is_told(self):
        source = random.Random(2)
        number = lambda: 1 + source.randrange(6) * 2.0 ** -52
        segments = [((number(), number()), (number(), number())) for _ in range(20)]
        segments = [(a, b) for a, b in segments if a != b]
        self.check_triangulation(self.cells(lines_of(segments)), segments)
        report = self.json_of("constrained", lines_of(segments), "-o", "c.vtk")
        places, cells, _ = read_vtk(self.read("c.vtk").decode())
        turned = sum(1 for kind, corners in cells if kind == 5
                     and turn(*(tuple(map(Fraction, places[v])) for v in corners)) <= 0)
        self.assertGreater(turned, 0)
        self.assertEqual(report["rounding"]["turned_triangles"], turned)
        self.assertIn("inside out", report["warnings"][1])

    def test_what_is_written(self):
        self.write("p.xyz", "2 2\n-1 2\n")
        words = ("constrained", FRAME, "--points", "p.xyz")
        self.run_quoin(*words, "-o", "c.vtk", "-o", "c.ply", "-o", "c.obj", "-o", "c.off", "-o", "c.svg", "--labels")
        report = self.json_of(*words)
        places, cells, arrays = read_vtk(self.read("c.vtk").decode())
        self.assertEqual((len(places), len(cells)), (10, report["triangles"] + 8))
        self.assertEqual([t for t, _ in cells], [5] * report["triangles"] + [3] * 8)
        self.assertEqual(set(arrays), {"constructed", "domain", "depth", "piece"})
        self.assertEqual(list(map(int, arrays["piece"])), [int(t == 3) for t, _ in cells])
        self.assertEqual(sum(1 for (t, _), d in zip(cells, arrays["depth"]) if t == 5 and d == 1), report["inside_triangles"])
        for name in ("c.ply", "c.obj", "c.off"):
            mesh = self.json_of("delaunay", name)
            self.assertEqual((mesh["points"], mesh["dimension"]), (10, 2))
        self.assertEqual(self.read("c.off").decode().split("\n")[1].split()[:2], ["10", str(report["triangles"])])
        svg = self.read("c.svg").decode()
        self.assertEqual(ElementTree.fromstring(svg).tag, "{http://www.w3.org/2000/svg}svg")
        self.assertIn("Domain", svg)
        self.assertTrue(self.run_quoin(*words, "-o", "-").stdout.startswith("<svg"))
        self.assertTrue(self.run_quoin(*words, "-o", "-", "--format", "vtk").stdout.startswith("# vtk"))
        done = self.run_quoin(*words, "-o", "c.html", code=None)
        if "was not built" not in done.stderr:
            self.assertEqual(done.returncode, 0)
            self.assertIn(b"Triangle 0", self.read("c.html"))
        # Of what is inside, its own points alone.
        self.run_quoin(*words, "--inside", "-o", "c.off")
        self.assertEqual(self.read("c.off").decode().split("\n")[1].split()[:2], ["8", "8"])

    def test_drawings_and_points(self):
        self.write("d.wkt", FRAME)
        self.write("d.svg", '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 H4 V4 H0 Z M1 1 V3 H3 V1 Z"/></svg>')
        self.write("d.geojson", '{"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]], [[1,1],[3,1],[3,3],[1,3],[1,1]]]}')
        expected = self.json_of("constrained", "d.wkt")
        for name in ("d.svg", "d.geojson"):
            self.assertEqual(self.json_of("constrained", name), expected)
        self.assertEqual(self.json_of("constrained", "-", stdin=FRAME), expected)
        self.write("p.xyz", "0 0 5\n9 9 1\n")
        report = self.json_of("constrained", "d.wkt", "--points", "p.xyz")
        self.assertEqual((report["points"], report["distinct"]), (10, 9))
        self.assertIn("third coordinate", report["warnings"][0])
        self.assertEqual(self.json_of("constrained", "POINT (1 1)", "--points", "-", stdin="0 0\n5 1\n2 7\n")["triangles"], 3)
        # Twice the same, and along one another.
        self.assertEqual(self.json_of("constrained", FRAME, "d.wkt")["pieces"], 8)
        self.assertEqual(self.json_of("constrained", "LINESTRING (0 0, 9 0)", "LINESTRING (3 0, 6 0, 6 1)")["pieces"], 4)
        # What spans no plane has edges alone.
        flat = self.json_of("constrained", "LINESTRING (0 0, 2 2)", "LINESTRING (1 1, 5 5)", "-o", "l.vtk", "-o", "l.svg")
        self.assertEqual((flat["dimension"], flat["triangles"], flat["pieces"]), (1, 0, 3))
        self.assertIn("one line", flat["warnings"][0])
        self.assertEqual([t for t, _ in read_vtk(self.read("l.vtk").decode())[1]], [3, 3, 3])
        self.assertEqual(self.json_of("constrained", "POINT (1 1)")["dimension"], 0)

    def test_arcs(self):
        disc = "CURVEPOLYGON (CIRCULARSTRING (-1 0, 1 0, -1 0))"
        self.assertIn("--flatten", self.run_quoin("constrained", disc, code=REFUSED).stderr)
        coarse, fine = (float(self.cells(disc, "--flatten", d, "--inside").area()) for d in ("0.1", "0.0001"))
        self.assertTrue(2 < coarse < fine < 3.141593)
        self.assertAlmostEqual(fine, 3.14159, delta=0.001)

    def test_mistakes_and_refusals(self):
        for words in (["-o", "x.stl"], ["-o", "x.wkt"], ["-o", "x.qarr"], ["-o", "x"], ["-o", "-", "--format", "stl"],
                      ["--format", "svg"], ["--flatten", "0"], ["--flatten", "nan"], ["--inside", "--weighted"]):
            self.run_quoin("constrained", "missing.wkt", *words, code=USAGE)
        self.run_quoin("constrained", code=USAGE)
        self.run_quoin("constrained", "-", "--points", "-", stdin="", code=USAGE)
        self.run_quoin("constrained", "missing.wkt", code=FILE_TROUBLE)
        self.run_quoin("constrained", FRAME, "--points", "missing.xyz", code=FILE_TROUBLE)
        self.run_quoin("constrained", FRAME, "-o", "no/such.vtk", code=FILE_TROUBLE)
        self.run_quoin("arrange", FRAME, "-o", "a.qarr")
        for words, text in ((["a.qarr"], "exact arrangements"), (["POLYGON ((0 0, 1 0"], "WKT argument 1"),
                            (["POLYGON ((0 0, 1 0, 0 0))"], "WKT argument 1"), (["LINESTRING (0 0, 0 0)"], "length"),
                            (["POINT EMPTY"], "nothing to triangulate"), (["LINESTRING (0 0, nan 1)"], "nan"),
                            ([FRAME, "--points", "a.qarr"], "a.qarr"), ([FRAME, "--points", "rubbish.off"], "rubbish.off")):
            self.assertIn(text, self.run_quoin("constrained", *words, code=REFUSED).stderr, words)


if __name__ == "__main__":
    main()
