# SPDX-License-Identifier: Apache-2.0
"""Cells of points as exact text (.qcells), and what meshes keep of points.

    check_cells.py QUOIN
"""
import itertools
import json
import math
import struct
from fractions import Fraction

from check_alpha import alpha_values
from check_flow import components, critical_points, dot, minus
from clouds import CUBE, cloud, determinant, read_vtk, text_of
from command import REFUSED, USAGE, CommandTest, main


def number(word):
    """Digits alone and p/q are exact, all else is the nearest double."""
    if word == "-":
        return None
    return Fraction(float(word)) if set(word) & set(".eE") else Fraction(word)


class Cells:
    """A file read back, by its description alone: points, cells as (kind, parts), and columns by their names."""

    def __init__(self, text):
        self.lines = iter([line.split() for line in text.splitlines()])
        assert next(self.lines) == ["quoin-cells", "1"]
        keyword, dimension = next(self.lines)
        assert keyword == "coordinates"
        rows, self.of_point = self.table("point", "points", int(dimension))
        self.points = [tuple(map(number, row)) for row in rows]
        rows, self.of_cell = self.table("cell", "cells", 1)
        self.cells = [(row[0], row[1:]) for row in rows]
        self.cells = [(kind, list(map(int, parts)) if kind != "polyhedron" else
                       [(word[0] == "-", int(word[1:])) for word in parts]) for kind, parts in self.cells]
        assert next(self.lines) == ["end"] and next(self.lines, None) is None

    def table(self, of, keyword, first):
        columns = {}
        integers, numbers = next(self.lines), next(self.lines)
        assert integers[0] == of + "-integers" and numbers[0] == of + "-numbers"
        names = integers[1:] + numbers[1:]
        found, count = next(self.lines)
        assert found == keyword
        rows = []
        for _ in range(int(count)):
            row = next(self.lines)
            for name, word in zip(names, row[first:]):
                columns.setdefault(name, []).append(number(word))
            rows.append(row[:first] + row[first + len(names):])
        return rows, columns

    def of_kind(self, kind):
        return [i for i, (k, _) in enumerate(self.cells) if k == kind]

    def faces(self, cell):
        """The corners of the faces of a polyhedron, counterclockwise seen from outside."""
        return [self.cells[f][1][::-1] if is_turned else self.cells[f][1] for is_turned, f in self.cells[cell][1]]

    def volume(self, cell):
        """Of a polyhedron as a sum of cones, of a polygon as one of triangles."""
        kind, parts = self.cells[cell]
        if kind == "polygon":
            p = [self.points[v] for v in parts]
            return sum(p[k - 1][0] * p[k][1] - p[k - 1][1] * p[k][0] for k in range(len(p))) / 2
        return sum(determinant([self.points[v] for v in (f[0], f[k], f[k + 1])])
                   for f in self.faces(cell) for k in range(1, len(f) - 1)) / 6


def nearest_of(p, points, relative=0):
    """Exactly, or all whose squared distances are that near to the least one."""
    squares = {q: dot(minus(p, q), minus(p, q)) for q in points}
    most = min(squares.values()) * (1 + Fraction(relative))
    return {q for q, square in squares.items() if square <= most}


class CellsTest(CommandTest):
    def cells_of(self, command, points, *words):
        text = points if isinstance(points, str) else text_of(points)
        self.write("p.xyz", text)
        report = self.json_of(command, "p.xyz", *words, "-o", "p.qcells")
        return report, Cells(self.read("p.qcells").decode())

    def betti(self):
        return self.json_of("homology", "p.qcells")["betti"]["Q"]


class Delaunay(CellsTest):
    def test_what_vtk_holds(self):
        for points in (cloud(25, 3), cloud(30, 2), cloud(60, 3, grid=3), [(i, i, i) for i in range(4)], [(1, 2)]):
            report, exact = self.cells_of("delaunay", points)
            self.run_quoin("delaunay", "p.xyz", "-o", "p.vtk")
            vertices, cells, arrays = read_vtk(self.read("p.vtk").decode())
            d = len(points[0])
            self.assertEqual(exact.points, [tuple(map(Fraction, v[:d])) for v in vertices])
            self.assertEqual([parts for _, parts in exact.cells], [parts for _, parts in cells])
            self.assertEqual(exact.of_point, {k: arrays[k] for k in ("input", "multiplicity")})
            self.assertEqual(exact.of_cell["delone_cell"], arrays["delone_cell"])
            self.assertEqual(self.betti(), [1] + [0] * report["dimension"])

    def test_delone_cells(self):
        for points in (cloud(25, 3), CUBE, cloud(70, 3, grid=4), cloud(40, 2, grid=4), [(*p, 3) for p in cloud(40, 2, grid=4)]):
            _, simplices = self.cells_of("delaunay", points)
            report, exact = self.cells_of("delaunay", points, "--delone")
            flat = report["dimension"] == 2
            cells = exact.of_kind("polygon" if flat else "polyhedron")
            self.assertEqual(len(cells), report["delone_cells"])
            self.assertEqual(self.betti(), [1] + [0] * report["dimension"])
            on_cells = []
            for c in cells:
                corners = set(exact.cells[c][1]) if flat else {v for f in exact.faces(c) for v in f}
                on_cells.append(frozenset(corners))
                for face in [] if flat else exact.faces(c):
                    a, b, c3 = (exact.points[v] for v in face[:3])
                    for v in corners:
                        turn = determinant([minus(q, exact.points[v]) for q in (a, b, c3)])
                        self.assertEqual(turn == 0, v in face)
                        self.assertGreaterEqual(turn, 0)
            merged = {}
            for (_, corners), label in zip(simplices.cells, simplices.of_cell["delone_cell"]):
                merged.setdefault(label, set()).update(corners)
            self.assertEqual(set(on_cells), {frozenset(c) for c in merged.values()})
            self.run_quoin("delaunay", "p.xyz", "--delone", "-o", "p.vtk", "-o", "p.off")
            kinds = {t for t, _ in read_vtk(self.read("p.vtk").decode())[1]}
            self.assertEqual(kinds, {7 if flat else 42})
            if not flat:
                self.assertEqual(self.json_of("homology", "p.off")["betti"]["Q"], [1, 0, 1])
                inside = sum(abs(exact.volume(c)) for c in cells)
                self.assertEqual(inside, sum(exact.volume(c) for c in cells))
                self.assertAlmostEqual(self.info("p.off")["volume"], float(inside))
        self.run_quoin("delaunay", "p.xyz", "--delone", "--weighted", code=USAGE)
        self.run_quoin("delaunay", "p.xyz", "--delone", "-o", "p.html", code=None)
        self.assertFalse((self.folder / "p.html").exists())

    def test_weights_and_doubles_of_all_sizes(self):
        points = [(0.1, 1e-300, 1e300, -0.0), (5e-324, 0.2, 3, 1), (9007199254740993, 7, 0.3, 0.5), (1, 2, 3, 4)]
        _, exact = self.cells_of("delaunay", points, "--weighted")
        inputs = [int(i) for i in exact.of_point["input"]]
        self.assertEqual(exact.points, [tuple(map(Fraction, map(float, points[i][:3]))) for i in inputs])
        self.assertEqual(exact.of_point["weight"], [Fraction(points[i][3]) for i in inputs])


class Voronoi(CellsTest):
    def test_corners_are_nearest_to_their_sites(self):
        for points in (cloud(20, 3), cloud(30, 2), cloud(60, 3, grid=4), [p for p in itertools.product(range(3), repeat=2)],
                       [(x, y, z) for x, y, z in itertools.product(range(3), repeat=3) if x + y + z < 6]):
            report, exact = self.cells_of("voronoi", points)
            d = len(points[0])
            sites = [tuple(map(Fraction, p)) for p in points]
            size = exact.of_cell["volume" if d == 3 else "area"]
            dimensions = [0, 0, 0, 0]
            for c, (kind, parts) in enumerate(exact.cells):
                corners = {v for f in exact.faces(c) for v in f} if kind == "polyhedron" else set(parts)
                dimensions[{"simplex": len(corners) - 1, "polygon": 2, "polyhedron": 3}[kind]] += 1
                for name in ("input", "neighbour"):
                    site = exact.of_cell[name][c]
                    for v in corners if site is not None else ():
                        at = exact.points[v]
                        squares = [dot(minus(at, q), minus(at, q)) for q in sites]
                        self.assertEqual(squares[int(site)], min(squares))
                if kind == ("polyhedron" if d == 3 else "polygon"):
                    self.assertGreater(size[c], 0)
                    self.assertEqual(size[c], exact.volume(c))
                else:
                    self.assertIsNone(size[c])
            self.assertEqual(dimensions[0], report["vertices"])
            self.assertEqual(dimensions[d], report["bounded_cells"])
            # All bounded faces of a diagram can be drawn together to a point.
            self.assertEqual(self.betti(), [1] + [0] * max(k for k in range(4) if dimensions[k] > 0))

    def test_corners_have_the_least_power_of_their_sites(self):
        # Weights that are squares of distances, up to one, lift the points near a plane: many are in faces of cells.
        for points, near_plane in ((cloud(25, 3), False), (cloud(30, 2), False), (cloud(40, 2, grid=4), True),
                                   (list(itertools.product(range(4), repeat=3)), True)):
            points = sorted(set(points))
            weights = [k * k % 7 - 3 if not near_plane else sum(c * c for c in p) - abs(p[0] - 1)
                       for k, p in enumerate(points)]
            report, exact = self.cells_of("voronoi", [p + (w,) for p, w in zip(points, weights)], "--weighted")
            sites = [(tuple(map(Fraction, p)), Fraction(w)) for p, w in zip(points, weights)]
            size = exact.of_cell["volume" if len(points[0]) == 3 else "area"]
            whole = "polyhedron" if len(points[0]) == 3 else "polygon"
            for c, (kind, parts) in enumerate(exact.cells):
                corners = {v for f in exact.faces(c) for v in f} if kind == "polyhedron" else set(parts)
                for name in ("input", "neighbour"):
                    site = exact.of_cell[name][c]
                    for v in corners if site is not None else ():
                        powers = [dot(minus(exact.points[v], q), minus(exact.points[v], q)) - w for q, w in sites]
                        self.assertEqual(powers[int(site)], min(powers))
                if kind == whole:
                    self.assertGreater(size[c], 0)
                    self.assertEqual(size[c], exact.volume(c))
            self.assertEqual(len(exact.of_kind(whole)), report["bounded_cells"])
            self.assertEqual(report["bounded_cells"] + report["infinite_cells"] + report["hidden"], len(points))

    def test_without_vertices(self):
        for points in ([(0, 0, 0), (1, 0, 0)], [(0, 0), (1, 1), (2, 2)], [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]):
            _, exact = self.cells_of("voronoi", points)
            self.assertEqual((exact.points, exact.cells), ([], []))
            self.run_quoin("homology", "p.qcells", code=REFUSED)


class Alpha(CellsTest):
    def test_values_are_exact(self):
        points = cloud(12, 2)
        _, exact = self.cells_of("alpha", points)
        expected = alpha_values([tuple(map(Fraction, p)) for p in points])
        inputs = [int(i) for i in exact.of_point["input"]]
        found = {tuple(sorted(inputs[v] for v in parts)): value
                 for (_, parts), value in zip(exact.cells, exact.of_cell["value"])}
        self.assertEqual(found, expected)
        self.assertEqual(exact.of_cell["value"], sorted(exact.of_cell["value"]))

    def test_persistence_is_that_of_the_text(self):
        for points, words in ((cloud(30, 3), []), (cloud(80, 3, grid=4), []), (cloud(40, 3), ["--plane"]),
                              (cloud(25, 4), ["--weighted"])):
            self.cells_of("alpha", points, *words)
            self.run_quoin("alpha", "p.xyz", "--exact", *words, "-o", "p.txt")
            report = self.json_of("persistence", "p.qcells")
            self.assertEqual(report, self.json_of("persistence", "p.txt"))
            self.assertEqual(report, self.json_of("persistence", "-", stdin=self.read("p.qcells").decode()))

    def test_complexes_and_graphs(self):
        points = cloud(40, 3)
        report, _ = self.cells_of("alpha", points, "--value", "1/50")
        self.assertEqual(self.betti(), (report["shape"]["betti"] + [0])[:len(self.betti())])
        report, exact = self.cells_of("alpha", points, "--graph", "spanning-tree")
        self.assertEqual(len(exact.cells), 39)
        for (_, (a, b)), square in zip(exact.cells, exact.of_cell["square_length"]):
            between = minus(exact.points[a], exact.points[b])
            self.assertEqual(square, dot(between, between))
        self.assertEqual(self.betti(), [1, 0])


class Flow(CellsTest):
    def test_critical_points_are_exact(self):
        points = cloud(11, 3, seed=4)
        _, exact = self.cells_of("flow", points)
        found = sorted(zip(exact.of_cell["index"], exact.of_cell["square_distance"]))
        self.assertEqual(found, sorted(critical_points(points)))
        for (_, (v,)), index, square in zip(exact.cells, exact.of_cell["index"], exact.of_cell["square_distance"]):
            squares = sorted(dot(minus(exact.points[v], p), minus(exact.points[v], p)) for p in points)
            self.assertEqual(squares[:int(index) + 1], [square] * (int(index) + 1))

    def test_shapes_have_the_components_and_tunnels_that_are_reported(self):
        points = cloud(40, 3)
        for distance in (0.05, 0.12, 0.18, 0.3):
            report, exact = self.cells_of("flow", points, "--shape", str(distance))
            betti = report["shape"]["betti_numbers"]
            self.assertEqual(betti[0], components(points, distance))
            self.assertEqual((self.betti() + [0])[:2], betti[:2])
            self.assertLessEqual(max(exact.of_cell["square_distance"]), Fraction(distance) ** 2)
        _, exact = self.cells_of("flow", CUBE, "--stable", "2")
        self.assertEqual((len(exact.cells), len(exact.points)), (48, 8 + 12 + 6))
        self.assertIn((Fraction(1, 2), Fraction(1, 2), Fraction(0)), exact.points)
        _, exact = self.cells_of("flow", points, "--stable", "1")
        self.assertEqual({len(parts) for _, parts in exact.cells}, {2})
        self.assertEqual(self.betti()[0], 1)

    def test_ways_are_on_voronoi_edges_and_facets(self):
        for points in (cloud(25, 3, seed=7), cloud(40, 3, seed=8, grid=5)):
            _, exact = self.cells_of("flow", points, "--unstable", "2", "-o", "p.vtk")
            self.check_beside_vtk(exact)
            for p in exact.points:
                squares = sorted(dot(minus(p, q), minus(p, q)) for q in set(points))
                self.assertEqual(squares[0], squares[1])
            # Both ends of a segment have two nearest points in common: it is in their facet.
            nearest = [nearest_of(p, points) for p in exact.points]
            for kind, (a, b) in exact.cells:
                self.assertEqual(kind, "simplex")
                self.assertGreaterEqual(len(nearest[a] & nearest[b]), 2)

    def test_sheets_are_convex_pieces_of_voronoi_facets(self):
        for points in (cloud(20, 3, seed=7), cloud(30, 3, seed=8, grid=4)):
            report, exact = self.cells_of("flow", points, "--unstable", "1", "-o", "p.vtk")
            self.check_beside_vtk(exact)
            nearest = [nearest_of(p, points) for p in exact.points]
            for kind, corners in exact.cells:
                self.assertEqual(kind, "polygon")
                a, b = sorted(set.intersection(*(nearest[v] for v in corners)))[:2]
                corners = [exact.points[v] for v in corners]
                sides = [minus(q, p) for p, q in zip(corners, corners[1:] + corners[:1])]
                turns = [determinant([minus(b, a), s, t]) for s, t in zip(sides, sides[1:] + sides[:1])]
                self.assertEqual(len({turn > 0 for turn in turns if turn != 0}), 1)
            self.assertEqual(set(exact.of_cell["index"]), {1})
            self.assertTrue(any("reach to infinity" in w for w in report["warnings"]))

    def check_beside_vtk(self, exact):
        """The same cells, in the same order, with places that are rounded there."""
        points, cells, arrays = read_vtk(self.read("p.vtk").decode())
        self.assertEqual(exact.of_cell["number"], arrays["number"])
        for (_, corners), (_, exact_corners) in zip(cells, exact.cells, strict=True):
            for v, w in zip(corners, exact_corners, strict=True):
                for x, y in zip(points[v], exact.points[w]):
                    self.assertAlmostEqual(x, float(y), delta=1e-5 * max(1, max(map(abs, points[v]))))

    def test_shapes_of_points_of_a_plane(self):
        points = [(x, y, 7) for x in range(6) for y in range(6) if (x * y) % 4 != 1]
        for distance in ("0.4", "0.5", "0.75", "1.25"):
            report, exact = self.cells_of("flow", points, "--shape", distance)
            betti = report["shape"]["betti_numbers"]
            self.assertEqual(betti[0], components(points, float(distance)))
            self.assertEqual((self.betti() + [0])[:2], betti[:2])
            self.assertEqual({p[2] for p in exact.points}, {7})
            self.assertLessEqual(max(exact.of_cell["square_distance"]), Fraction(distance) ** 2)


class Reading(CellsTest):
    def test_streams_and_comments(self):
        self.cells_of("delaunay", CUBE, "--delone")
        text = self.read("p.qcells").decode()
        self.write("c.txt", text.replace("\n", "  # more\r\n"))
        self.assertEqual(self.json_of("homology", "c.txt")["betti"]["Q"], [1, 0, 0, 0])
        self.assertEqual(self.json_of("homology", "-", stdin="# cells\n\n" + text)["betti"]["Q"], [1, 0, 0, 0])
        done = self.run_quoin("delaunay", "p.xyz", "--delone", "-q", "-o", "-", "--format", "qcells")
        self.assertEqual(done.stdout, text)

    def test_mistakes_are_refused_with_their_line(self):
        self.cells_of("delaunay", CUBE)
        self.assertIn("'value'", self.run_quoin("persistence", "p.qcells", code=REFUSED).stderr)
        text = self.read("p.qcells").decode()
        for old, new, where in (("quoin-cells 1", "quoin-cells 2", ":1:"), ("\nend\n", "\n", "'end'"),
                                ("points 8", "points 88888888", ":5:"), ("simplex", "cube", "'cube'")):
            self.write("bad.qcells", text.replace(old, new, 1))
            self.assertIn(where, self.run_quoin("homology", "bad.qcells", code=REFUSED).stderr)
        self.write("bad.qcells", "OFF\n")
        self.assertIn("quoin-cells", self.run_quoin("homology", "bad.qcells", code=REFUSED).stderr)
        self.run_quoin("homology", "missing.qcells", code=None)
        self.run_quoin("union", "a.off", "b.off", "-o", "u.qcells", code=USAGE)


class FlowOfKnownPoints(CellsTest):
    """Points that are given keep what is known of them; those made on surfaces have the mean of what surrounds them."""

    def write_points(self, points):
        self.known = {p: (*n, i % 256, 3 * i % 256, 7, i / 4)
                      for i, (p, n) in enumerate(zip(points, cloud(len(points), 3, seed=2)))}
        self.write("p.csv", "x,y,z,nx,ny,nz,r,g,b,intensity\n" + text_of([p + k for p, k in self.known.items()], ","))
        self.inputs = list(self.known)

    def check_mean(self, inputs, known):
        """Rounded once, colours to one of 255."""
        rows = [self.known[p] for p in inputs]
        for k, value in enumerate(known):
            mean = sum(Fraction(row[k]) for row in rows) / len(rows)
            self.assertEqual(round(value) if 3 <= k < 6 else value, math.floor(mean + Fraction(1, 2)) if 3 <= k < 6 else float(mean))

    def check_vtk(self, triangles):
        points, cells, arrays = read_vtk(self.read("f.vtk").decode())
        around = [set() for _ in points]
        for _, corners in cells if triangles else []:
            for v in corners:
                around[v] |= {int(arrays["input"][w]) for w in corners if arrays["input"][w] >= 0}
        made = 0
        for v, p in enumerate(points):
            known = (*arrays["normal"][v], *[255 * c for c in arrays["color"][v][:3]], arrays["intensity"][v])
            given = int(arrays["input"][v])
            if given >= 0:
                self.assertEqual(p, self.inputs[given])
                self.check_mean([p], known)
            else:
                made += 1
                nearest = nearest_of(p, self.inputs, 1e-9)
                self.check_mean([self.inputs[i] for i in around[v]] if triangles else nearest, known)
                self.assertLessEqual({self.inputs[i] for i in around[v]}, nearest)
        return made

    def test_grids(self):
        self.write_points(cloud(30, 3, seed=3))
        for words, triangles, has_made in (([], False, True), (["--stable", "1"], False, False), (["--stable", "2"], True, True),
                                           (["--simplify", "0.01"], True, True)):
            self.run_quoin("flow", "p.csv", *words, "-o", "f.vtk")
            self.assertEqual(self.check_vtk(triangles) > 0, has_made, words)

    def test_points_of_a_plane(self):
        self.write_points(sorted({(x, y, 2.0) for x, y in cloud(40, 2, seed=3, grid=9)}))
        self.run_quoin("flow", "p.csv", "-o", "f.vtk")
        self.assertGreater(self.check_vtk(False), 0)
        self.run_quoin("flow", "p.csv", "--stable", "2", "-o", "f.vtk")
        self.assertGreater(self.check_vtk(True), 0)

    def test_exact_text_and_meshes(self):
        self.write_points(cloud(30, 3, seed=3))
        for words in ([], ["--stable", "2"], ["--shape", "0.3"], ["--stable", "1"]):
            self.run_quoin("flow", "p.csv", *words, "-o", "f.qcells")
            exact = Cells(self.read("f.qcells").decode())
            given = 0
            for v, number in enumerate(exact.of_point["input"]):
                known = [exact.of_point[name][v] for name in "nx ny nz red green blue intensity".split()]
                nearest = nearest_of(exact.points[v], self.inputs)
                if number is not None:
                    given += 1
                    self.assertEqual(exact.points[v], self.inputs[int(number)])
                if number is not None or not words:
                    self.check_mean(nearest, known)
            self.assertTrue(0 < given < len(exact.points) or words == ["--stable", "1"], words)
        self.run_quoin("flow", "p.csv", "--stable", "2", "-o", "f.ply", "-o", "f.vtk")
        points, _, arrays = read_vtk(self.read("f.vtk").decode())
        header, body = self.read("f.ply").split(b"end_header\n", 1)
        self.assertIn(f"element vertex {len(points)}\n", header.decode())
        for v, p in enumerate(points):
            x = struct.unpack_from("<6d4Bd", body, 60 * v)
            self.assertEqual((x[:3], x[3:6], x[10]), (p, arrays["normal"][v], arrays["intensity"][v]))
            self.assertEqual(x[6:10], tuple(round(255 * c) for c in arrays["color"][v]))

    def test_what_is_away_from_points_has_nothing_of_theirs(self):
        self.write_points(cloud(20, 3, seed=3))
        for index in ("1", "2"):
            report = self.json_of("flow", "p.csv", "--unstable", index, "-o", "f.vtk", "-o", "f.qcells")
            self.assertEqual(len([w for w in report["warnings"] if "those are of points" in w]), 3)
            self.assertNotIn("normal", read_vtk(self.read("f.vtk").decode())[2])
            self.assertEqual(set(Cells(self.read("f.qcells").decode()).of_point), {"input"})


class Meshes(CellsTest):
    def test_what_is_known_of_points_stays(self):
        rows = [(*p, *n, i % 256, 3 * i % 256, 7, i / 4) for i, (p, n) in enumerate(zip(cloud(60, 3), cloud(60, 3, seed=2)))]
        self.write("p.csv", "x,y,z,nx,ny,nz,r,g,b,intensity\n" + text_of(rows, ","))
        for words in (["delaunay"], ["delaunay", "--plane"], ["delaunay", "--delone"], ["alpha", "--radius", "0.2"]):
            self.run_quoin(words[0], "p.csv", *words[1:], "-o", "p.ply")
            header, body = self.read("p.ply").split(b"end_header\n", 1)
            names = [line.split()[2] for line in header.decode().splitlines() if line.startswith("property")]
            self.assertEqual(names[:11], "x y z nx ny nz red green blue alpha intensity".split())
            count = int(header.decode().split("element vertex ")[1].split()[0])
            self.assertGreater(count, 3)
            for k in range(count):
                x = struct.unpack_from("<6d4Bd", body, 60 * k)
                self.assertIn((*x[:9], x[10]), rows)
                self.assertEqual(x[9], 255)
            report = json.loads(self.run_quoin(words[0], "p.csv", *words[1:], "-o", "p.obj", "-o", "p.off", "--json").stdout)
            self.assertEqual(len([w for w in report["warnings"] if "holds no" in w]), 4)
            self.assertEqual(self.read("p.obj").decode().count("\nvn "), count)
            # Out and in again nothing is lost.
            if words == ["delaunay", "--plane"]:
                self.run_quoin("delaunay", "p.ply", "--plane", "-o", "again.ply")
                self.assertEqual(sorted(self.read("again.ply")), sorted(self.read("p.ply")))


if __name__ == "__main__":
    main()
