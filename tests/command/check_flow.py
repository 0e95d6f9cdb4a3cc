# SPDX-License-Identifier: Apache-2.0
"""flow.

    check_flow.py QUOIN
"""
import itertools
import math
import random
import statistics
import unittest
import xml.etree.ElementTree as ElementTree
from fractions import Fraction

from check_points import CUBE, cloud, determinant, read_vtk, text_of
from command import REFUSED, USAGE, CommandTest, main
from pages import PageTest


def solve(rows, right):
    """Of linear equations with one solution."""
    m = [list(map(Fraction, r)) + [Fraction(b)] for r, b in zip(rows, right)]
    for i in range(len(m)):
        pivot = next(k for k in range(i, len(m)) if m[k][i] != 0)
        m[i], m[pivot] = m[pivot], m[i]
        m[i] = [x / m[i][i] for x in m[i]]
        for k in range(len(m)):
            if k != i:
                m[k] = [a - m[k][i] * b for a, b in zip(m[k], m[i])]
    return [r[-1] for r in m]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [Fraction(x) - Fraction(y) for x, y in zip(a, b)]


def critical_points(points, dimension=3):
    """By definition, in general position: index and squared distance, of simplices with their centre inside and no other
    point in the closed ball. Of a plane they have dimension 2."""
    found = []
    for size in range(1, dimension + 2):
        for simplex in itertools.combinations(points, size):
            sides = [minus(p, simplex[0]) for p in simplex[1:]]
            weights = solve([[2 * dot(a, b) for b in sides] for a in sides], [dot(a, a) for a in sides])
            weights = [1 - sum(weights)] + weights
            if any(w <= 0 for w in weights):
                continue
            centre = [sum(w * Fraction(p[k]) for w, p in zip(weights, simplex)) for k in range(3)]
            square = dot(minus(centre, simplex[0]), minus(centre, simplex[0]))
            if all(p in simplex or dot(minus(p, centre), minus(p, centre)) > square for p in points):
                found.append((size - 1, square))
    return found


def counts(found, most=None):
    return [sum(1 for i, square in found if i == index and (most is None or square <= most)) for index in range(4)]


def components(points, distance):
    left = set(points)
    number = 0
    while left:
        number += 1
        open_ones = [left.pop()]
        while open_ones:
            p = open_ones.pop()
            near = [q for q in left if dot(minus(p, q), minus(p, q)) <= 4 * Fraction(distance) ** 2]
            left.difference_update(near)
            open_ones += near
    return number


def torus(around, along):
    source = random.Random(3)
    points = []
    for i, j in itertools.product(range(around), range(along)):
        a = 2 * math.pi * (i + 0.3 * source.random()) / around
        b = 2 * math.pi * (j + 0.3 * source.random()) / along
        points.append(((3 + math.cos(b)) * math.cos(a), (3 + math.cos(b)) * math.sin(a), math.sin(b)))
    return points


FACE_CENTRES = [tuple(side if i == axis else 0.5 for i in range(3)) for axis in range(3) for side in (0, 1)]


def total(distribution):
    return sum(value * count for value, count in enumerate(distribution["frequencies"]))


def volume_of_polyhedron(points, cell):
    """Of triangles, counterclockwise from outside."""
    six, at = 0, 1
    for _ in range(cell[0]):
        assert cell[at] == 3
        six += determinant([points[i] for i in cell[at + 1:at + 4]])
        at += 4
    assert at == len(cell)
    return six / 6


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def area(triangle):
    p, q, r = triangle
    return math.hypot(*cross(minus(q, p), minus(r, p))) / 2


def is_in_triangle(point, triangle, within=1e-5):
    """Up to roundings of single precision."""
    p, q, r = triangle
    normal = cross(minus(q, p), minus(r, p))
    length = math.hypot(*normal)
    if length == 0 or abs(dot(normal, minus(point, p))) > within * length:
        return False
    return all(dot(cross(normal, minus(b, a)), minus(point, a)) > -within * length * math.hypot(*minus(b, a)) for a, b in ((p, q), (q, r), (r, p)))


class FlowPage:
    """What a page of the flow says."""

    def __init__(self, header, array):
        self.header = header
        self.values = array(header["values"])
        self.counts = {c["name"]: [array(r["at"]) for r in c["rows"]] for c in header["counts"]}
        pairs = array(header["pairs"])
        self.pairs = list(zip(pairs[0::3], pairs[1::3], pairs[2::3]))
        links = array(header["links"]) if "links" in header else []
        self.onward = {}
        for a, b in zip(links[0::2], links[1::2]):
            self.onward.setdefault(a, []).append(b)
        raw = array(header["points"])
        if header["points"]["type"] == "f32":
            raw = [header["center"][i % 3] + header["scale"] * x for i, x in enumerate(raw)]
        near = array(header["nearPoints"]) if "nearPoints" in header else []
        raw = list(raw) + [header["center"][i % 3] + header["scale"] * x for i, x in enumerate(near)]
        self.points = list(zip(raw[0::3], raw[1::3], raw[2::3]))
        self.layers = {}
        for layer in header["layers"]:
            width = {"points": 1, "segments": 2, "triangles": 3}[layer["kind"]]
            flat = array(layer["vertices"])
            vertices = [flat[i:i + width] for i in range(0, len(flat), width)]
            shown = array(layer["shown"]) if "shown" in layer else [len(vertices)] * len(self.values)
            begin = [next(v for v, n in enumerate(shown) if n > i) for i in range(len(vertices))]
            owners = array(layer["owners"]) if "owners" in layer else [None] * len(vertices)
            self.layers[layer["name"]] = list(zip(owners, begin, vertices))

    def begins(self, name):
        return {owner: begin for owner, begin, _ in self.layers[name]}

    def ends_of_ways(self, saddle):
        """The owners in which ways from a saddle end."""
        ends = []
        for at in self.onward.get(saddle, []):
            while at in self.onward:
                self.one(self.onward[at])
                at = self.onward[at][0]
            ends.append(at)
        return ends

    @staticmethod
    def one(links):
        assert len(links) == 1, links


def check_values(test, page, expected, factor):
    """Those of the same points, scaled."""
    test.assertEqual(len(page.values), len(expected.values))
    for found, before in zip(page.values, expected.values):
        try:
            value = float(Fraction(before) * Fraction(factor) ** 2)
        except OverflowError:
            value = math.inf
        if value > 1e-290:
            test.assertTrue(found == value or abs(found - value) < 1e-12 * value, (found, value))


class Pages(PageTest):
    def flow_page(self, *words, stdin):
        return FlowPage(*self.page("flow", "-", *words, stdin=stdin))

    def test_at_every_distance_it_has_the_critical_points_and_the_shape(self):
        for seed in range(2):
            points = cloud(11, 3, seed=seed)
            found = critical_points(points)
            page = self.flow_page(stdin=text_of(points))
            squares = sorted({square for _, square in found})
            self.assertEqual(len(page.values), len(squares))
            for at, square in enumerate(squares):
                self.assertAlmostEqual(page.values[at], float(square))
                self.assertEqual([row[at] for row in page.counts["Critical points"]], counts(found, square))
                betti = [row[at] for row in page.counts["Betti numbers"]]
                self.assertEqual(betti[0] - betti[1] + betti[2], sum((-1) ** i for i, s in found if s <= square))
                for degree in range(3):
                    self.assertEqual(betti[degree], sum(1 for d, b, e in page.pairs if d == degree and b <= at < e))
            for name, index in (("Points (index 0)", 0), ("Midpoints (index 1)", 1), ("Saddles (index 2)", 2), ("Maxima (index 3)", 3)):
                self.assertEqual(sorted(float(s) for i, s in found if i == index),
                                 sorted(float(squares[begin]) for _, begin, _ in page.layers[name]))

    def test_degenerate_points(self):
        for points in (CUBE, cloud(60, 3, grid=4), [(x, y, z) for x in range(4) for y in range(4) for z in range(3)]):
            text = text_of(points)
            page = self.flow_page(stdin=text)
            self.assertEqual(sorted(set(page.values)), list(page.values))
            for at in range(0, len(page.values), 3):
                # Squares of these are short fractions, their roots not: a distance between this and the next.
                above = page.values[at + 1] if at + 1 < len(page.values) else page.values[at] + 1
                distance = math.sqrt((page.values[at] + above) / 2)
                shape = self.json_of("flow", "-", "--shape", repr(distance), stdin=text)["shape"]
                self.assertEqual([row[at] for row in page.counts["Critical points"]], shape["critical"])
                self.assertEqual([row[at] for row in page.counts["Betti numbers"]], shape["betti_numbers"])
                alive = [sum(1 for d, b, e in page.pairs if d == k and b <= at < e) for k in range(3)]
                self.assertEqual(alive, shape["betti_numbers"])

    def test_saddles_own_surfaces_and_ways(self):
        text = text_of(cloud(60, 3, seed=4))
        report = self.json_of("flow", "-", "--stable", "2", "--unstable", "2", stdin=text)
        page = self.flow_page("--stable", "2", "--unstable", "2", stdin=text)
        self.assertNotIn("Edges (stable 1)", page.layers)
        saddles, maxima = page.begins("Saddles (index 2)"), page.begins("Maxima (index 3)")
        surfaces = page.layers["Surfaces (stable 2)"]
        self.assertEqual(len(surfaces), report["stable"]["triangles"])
        self.assertEqual({owner for owner, _, _ in surfaces}, set(saddles))
        self.assertTrue(all(begin == saddles[owner] for owner, begin, _ in surfaces))
        ends = [end for saddle in saddles for end in page.ends_of_ways(saddle)]
        at_maxima = [end for end in ends if end in maxima]
        self.assertEqual(2 * len(saddles) - len(at_maxima), report["unstable"]["to_infinity"])
        for owner, begin, _ in page.layers["Ways (unstable 2)"]:
            if owner in saddles:
                self.assertEqual(begin, saddles[owner])
        for saddle in saddles:
            self.assertTrue(all(maxima.get(end, len(page.values)) > saddles[saddle] for end in page.ends_of_ways(saddle)))
        edges = self.flow_page("--stable", "1", stdin=text)
        self.assertEqual(edges.begins("Edges (stable 1)"), edges.begins("Midpoints (index 1)"))
        self.assertNotIn("Surfaces (stable 2)", edges.layers)

    def test_sheets_and_walls(self):
        text = text_of(cloud(60, 3, seed=4))
        page = self.flow_page("--unstable", "1", stdin=text)
        sheets = page.layers["Sheets (unstable 1)"]
        self.assertGreater(len(sheets), 100)
        self.assertTrue(all(begin == 0 for _, begin, _ in sheets))
        self.assertEqual(len({owner for owner, _, _ in sheets}), 1)  # hidden together
        told = [value for name, value in page.header["facts"] if name == "Sheets (unstable 1)"]
        self.assertIn("far beyond the points", told[0])
        report = self.json_of("flow", "-", "--stable", "3", stdin=text)["stable"]
        page = self.flow_page("--stable", "3", stdin=text)
        self.assertEqual(len(page.layers["Walls of regions (stable 3)"]), report["triangles"])

    def test_single_sheets_are_those_together(self):
        text = text_of(cloud(40, 3, seed=8))
        page = self.flow_page("--unstable", "1", stdin=text)
        together, each = page.layers["Sheets (unstable 1)"], page.layers["Single sheets (unstable 1)"]
        places = {owner: page.points[at[0]] for owner, _, at in page.layers["Midpoints (index 1)"]}
        begins = page.begins("Midpoints (index 1)")
        self.assertNotIn(together[0][0], begins)
        self.assertTrue(all(begins[owner] == begin for owner, begin, _ in each))
        self.assertEqual([begin for _, begin, _ in each], sorted(begin for _, begin, _ in each))
        triangles = {}
        for owner, _, corners in each:
            triangles.setdefault(owner, []).append([page.points[i] for i in corners])
        # Of a midpoint inside the sheet has the whole Voronoi facet around it; near the hull that reaches to infinity.
        inside = [owner for owner in triangles if all(0.35 < x < 0.65 for x in places[owner])]
        self.assertGreater(len(inside), 3)
        for owner in inside:
            self.assertTrue(any(is_in_triangle(places[owner], t) for t in triangles[owner]))
        self.assertGreater(len(triangles), 20)
        source = random.Random(1)
        all_each = [t for list_ in triangles.values() for t in list_]
        all_together = [[page.points[i] for i in corners] for _, _, corners in together]
        for some, others in ((all_together, all_each), (all_each, all_together)):
            # Of slivers the rounding of single precision is larger than they are.
            for t in source.sample([t for t in some if area(t) > 1e-4], 60):
                centre = tuple(sum(c) / 3 for c in zip(*t))
                self.assertTrue(any(is_in_triangle(centre, other) for other in others))
        area_of_all = sum(map(area, all_together))
        for list_ in triangles.values():
            self.assertLess(sum(map(area, list_)), area_of_all * (1 + 1e-5))
        self.assertGreater(sum(map(area, all_each)), area_of_all)

    def test_voids_are_as_deep_as_simplification_says(self):
        text = text_of(cloud(80, 3, seed=2))
        page = self.flow_page(stdin=text)
        depths = [math.sqrt(page.values[e]) - math.sqrt(page.values[b]) for d, b, e in page.pairs if d == 2]
        for within in (0, 0.003, 0.02, 0.05):
            page = self.flow_page("--simplify", repr(within), stdin=text)
            left = sum(1 for depth in depths if depth > within)
            self.assertEqual(len(page.layers["Maxima that stay (index 3)"]), left)
            self.assertEqual(len(page.layers["Maxima that were joined (index 3)"]), len(depths) - left)

    def test_what_is_asked_for(self):
        text = text_of(torus(20, 9))
        report = self.json_of("flow", "-", "--reconstruct", stdin=text)["solid"]
        page = self.flow_page("--reconstruct", stdin=text)
        self.assertEqual(len(page.layers["Surface of the solid"]), report["triangles"])
        self.assertEqual(len({owner for owner, _, _ in page.layers["Surface of the solid"]}), report["wall_saddles"])
        self.assertEqual(len(page.layers["Maxima inside (index 3)"]), report["maxima_inside"])
        self.assertEqual(page.header["value"], len(page.values) - 1)
        page = self.flow_page("--shape", "0.4", stdin=text)
        at = page.header["value"]
        self.assertTrue(page.values[at] <= 0.4 ** 2 < page.values[at + 1])
        shape = self.json_of("flow", "-", "--shape", "0.4", stdin=text)["shape"]
        self.assertEqual([row[at] for row in page.counts["Betti numbers"]], shape["betti_numbers"])

    def test_medial_points_have_layers_of_their_own(self):
        text = text_of(torus(20, 9))
        told = self.json_of("flow", "-", "--separate", stdin=text)["separation"]
        page = self.flow_page("--separate", stdin=text)
        for index, name in ((1, "Midpoints"), (2, "Saddles"), (3, "Maxima")):
            self.assertEqual(len(page.layers[f"{name} (index {index}, medial)"]), told["medial"][index])
            self.assertEqual(len(page.layers[f"{name} (index {index}, surface)"]), told["surface"][index])

    def test_extremes_and_refusals(self):
        self.flow_page(stdin=text_of(CUBE))  # skips where there are no pages
        self.run_quoin("flow", "-", "--stable", "2", "--unstable", "2", "-o", "x.html", "-o", "x.vtk", stdin=text_of(CUBE), code=USAGE)
        points = cloud(30, 3, seed=5)
        expected = self.flow_page(stdin=text_of(points))
        for factor in (2.0 ** 135, 2.0 ** 200, 2.0 ** 300, 2.0 ** 400, 2.0 ** 900, 2.0 ** -200, 2.0 ** -400, 2.0 ** -900):
            page = self.flow_page(stdin=text_of([tuple(c * factor for c in p) for p in points]))
            check_values(self, page, expected, factor)
            self.assertEqual(page.counts, expected.counts)
            self.assertEqual({name: len(list_) for name, list_ in page.layers.items()},
                             {name: len(list_) for name, list_ in expected.layers.items()})
        self.write("c.xyz", text_of(cloud(2000, 3)))
        self.run_quoin("flow", "c.xyz", "--memory", "4", "-q")
        done = self.run_quoin("flow", "c.xyz", "--memory", "4", "-o", "x.html", code=REFUSED)
        self.assertIn("more than --memory", done.stderr)
        self.run_quoin("alpha", "c.xyz", "--memory", "6", "-q")
        done = self.run_quoin("alpha", "c.xyz", "--memory", "6", "-o", "x.html", code=REFUSED)
        self.assertIn("more than --memory", done.stderr)


def tilted(points):
    """In the plane z = x + 2 y, exactly: coordinates are whole, or of few digits."""
    return [(x, y, x + 2 * y) for x, y in points]


def flat_cloud(count, seed, grid=None):
    return [p[:2] for p in cloud(count, 3, seed=seed, grid=grid)]


class FlatPages(PageTest):
    """Of points of one plane, line or place."""

    def flow_page(self, *words, stdin):
        return FlowPage(*self.page("flow", "-", *words, stdin=stdin))

    def check_every_distance(self, text, most_dimension):
        page = self.flow_page(stdin=text)
        self.assertEqual(sorted(set(page.values)), list(page.values))
        self.assertEqual(len(page.counts["Critical points"]), most_dimension + 1)
        for at in range(0, len(page.values), 1 + len(page.values) // 12):
            above = page.values[at + 1] if at + 1 < len(page.values) else page.values[at] + 1
            distance = math.sqrt((page.values[at] + above) / 2)
            shape = self.json_of("flow", "-", "--shape", repr(distance), stdin=text)["shape"]
            self.assertEqual([row[at] for row in page.counts["Critical points"]], shape["critical"][:most_dimension + 1])
            degrees = max(1, most_dimension)
            self.assertEqual([row[at] for row in page.counts["Betti numbers"]], shape["betti_numbers"][:degrees])
            alive = [sum(1 for d, b, e in page.pairs if d == k and b <= at < e) for k in range(3)]
            self.assertEqual(alive, shape["betti_numbers"])
        return page

    def test_at_every_distance_it_has_the_critical_points_and_the_shape(self):
        grid = [(x, y) for x in range(4) for y in range(5)]
        for points in (flat_cloud(40, 1), flat_cloud(60, 2, grid=6), grid, [(0, 0), (3, 0), (0, 4)],
                       [(-4, 0), (4, 0), (0, 2), (0, -10)]):
            in_the_plane = self.check_every_distance(text_of(points), 2)
            flat = self.check_every_distance(text_of([(x, y, 7) for x, y in points]), 2)
            self.assertEqual((in_the_plane.counts, in_the_plane.pairs, in_the_plane.onward),
                             (flat.counts, flat.pairs, flat.onward))
        self.check_every_distance(text_of(tilted(flat_cloud(40, 3, grid=16))), 2)
        self.check_every_distance(text_of([(x, x, x) for x in (0, 1, 3, 3, 4.5, 9)]), 1)
        self.check_every_distance("0 0\n3 4\n", 1)
        self.check_every_distance("1 2 3\n1 2 3\n", 0)

    def test_definition(self):
        points = [(x, y, 0) for x, y in flat_cloud(14, 5)]
        found = [(index, float(square)) for index, square in critical_points(points, 2)]
        page = self.flow_page(stdin=text_of(points))
        for name, index in (("Points (index 0)", 0), ("Midpoints (index 1)", 1), ("Maxima (index 2)", 2)):
            written = sorted(page.values[begin] for _, begin, _ in page.layers[name])
            for a, b in itertools.zip_longest(written, sorted(s for i, s in found if i == index)):
                self.assertAlmostEqual(a, b)

    def test_midpoints_own_edges_and_ways_and_maxima_surfaces(self):
        text = text_of(flat_cloud(80, 4))
        stable = self.json_of("flow", "-", "--stable", "2", stdin=text)["stable"]
        unstable = self.json_of("flow", "-", "--unstable", "1", stdin=text)["unstable"]
        page = self.flow_page(stdin=text)
        midpoints, maxima = page.begins("Midpoints (index 1)"), page.begins("Maxima (index 2)")
        self.assertFalse(set(midpoints) & set(maxima))
        self.assertEqual(page.begins("Edges (stable 1)"), midpoints)
        surfaces = page.layers["Surfaces (stable 2)"]
        self.assertEqual((len(surfaces), {owner for owner, _, _ in surfaces}), (stable["triangles"], set(maxima)))
        self.assertTrue(all(begin == maxima[owner] for owner, begin, _ in surfaces))
        ends = {m: page.ends_of_ways(m) for m in midpoints}
        at_maxima = sum(1 for of_one in ends.values() for end in of_one if end in maxima)
        self.assertEqual(2 * len(midpoints) - at_maxima, unstable["to_infinity"])
        for midpoint, of_one in ends.items():
            self.assertTrue(all(maxima[end] > midpoints[midpoint] for end in of_one if end in maxima))
        # Without ways, midpoints still lead to the maxima beside them.
        edges = self.flow_page("--stable", "1", stdin=text)
        self.assertEqual(edges.layers["Edges (stable 1)"], page.layers["Edges (stable 1)"])
        self.assertNotIn("Surfaces (stable 2)", edges.layers)
        self.assertNotIn("Ways (unstable 1)", edges.layers)
        for midpoint, of_one in ends.items():
            self.assertEqual(sorted(edges.onward.get(midpoint, [])), sorted(end for end in of_one if end in maxima))

    def test_ways_are_along_voronoi_edges_and_end_a_little_outside(self):
        points = tilted([(x / 1024, y / 1024) for x, y in flat_cloud(50, 6, grid=1024)])
        header, array = self.page("flow", "-", "--unstable", "1", stdin=text_of(points))
        page = FlowPage(header, array)
        self.assertNotIn("Edges (stable 1)", page.layers)
        near = array(header["nearPoints"])
        places = points + [[c + header["scale"] * near[i + k] for k, c in enumerate(header["center"])]
                           for i in range(0, len(near), 3)]
        low, high = ([f(p[k] for p in points) for k in range(3)] for f in (min, max))
        margin = max(b - a for a, b in zip(low, high)) / 8 + 1e-5
        ways = page.layers["Ways (unstable 1)"]
        for _, _, (a, b) in ways:
            for part in (0.25, 0.75):
                at = [(1 - part) * x + part * y for x, y in zip(places[a], places[b])]
                first, second = sorted(math.dist(at, p) for p in points)[:2]
                self.assertAlmostEqual(first, second, delta=1e-5)
                self.assertAlmostEqual(at[0] + 2 * at[1], at[2], delta=1e-5)
                self.assertTrue(all(low[k] - margin <= at[k] <= high[k] + margin for k in range(3)))
        self.assertTrue(any(places[b][2] > high[2] for _, _, (_, b) in ways))

    def test_what_is_asked_for(self):
        text = text_of(flat_cloud(60, 7))
        for words in (["--stable", "3"], ["--simplify", "0.1"], ["--reconstruct"], ["--unstable", "2"]):
            page = self.flow_page(*words, stdin=text)
            self.assertEqual(set(page.layers), {"Points (index 0)", "Midpoints (index 1)", "Maxima (index 2)"})
            self.assertIn("Not in this page", dict(map(tuple, page.header["facts"])))
        page = self.flow_page("--shape", "0.1", stdin=text)
        at = page.header["value"]
        self.assertTrue(page.values[at] <= 0.1 ** 2 < page.values[at + 1])
        page = self.flow_page("--shape", "1e400", stdin=text)
        self.assertEqual(page.header["value"], len(page.values) - 1)

    def test_extremes_and_memory(self):
        points = flat_cloud(30, 8)
        expected = self.flow_page(stdin=text_of(points))
        for factor in (2.0 ** 110, 2.0 ** 300, 2.0 ** 400, 2.0 ** 1000, 2.0 ** -140, 2.0 ** -400, 2.0 ** -900):
            page = self.flow_page(stdin=text_of([tuple(c * factor for c in p) for p in points]))
            check_values(self, page, expected, factor)
            self.assertEqual(page.counts, expected.counts)
            self.assertEqual({name: len(list_) for name, list_ in page.layers.items()},
                             {name: len(list_) for name, list_ in expected.layers.items()})
        self.write("c.xyz", text_of(flat_cloud(2000, 9)))
        self.run_quoin("flow", "c.xyz", "--memory", "4", "-q")
        done = self.run_quoin("flow", "c.xyz", "--memory", "4", "-o", "x.html", code=REFUSED)
        self.assertIn("more than --memory", done.stderr)


class Flow(CommandTest):
    def test_counts_are_those_of_the_definition(self):
        for seed in range(3):
            points = cloud(11, 3, seed=seed)
            found = critical_points(points)
            report = self.json_of("flow", "-", "-o", "c.vtk", stdin=text_of(points))
            self.assertEqual((report["critical"], report["euler_characteristic"]), (counts(found), 1))
            _, cells, arrays = read_vtk(self.read("c.vtk").decode())
            self.assertEqual({t for t, _ in cells}, {1})
            written = sorted(zip(map(int, arrays["index"]), arrays["distance"]))
            for (index, distance), (i, square) in zip(written, sorted((i, float(s)) for i, s in found)):
                self.assertEqual(index, i)
                self.assertAlmostEqual(distance, math.sqrt(square))
            for distance in (0.1, 0.2, 0.3, 0.4):
                shape = self.json_of("flow", "-", "--shape", repr(distance), stdin=text_of(points))["shape"]
                self.assertEqual(shape["critical"], counts(found, Fraction(distance) ** 2))
                betti = shape["betti_numbers"]
                self.assertEqual(betti[0], components(points, distance))
                self.assertEqual(betti[0] - betti[1] + betti[2], shape["euler_characteristic"])

    def test_degenerate_points(self):
        cube = text_of(CUBE)
        report = self.json_of("flow", "-", "--stable", "2", "--unstable", "2", stdin=cube + cube)
        self.assertEqual((report["points"], report["distinct"], report["critical"]), (16, 8, [8, 12, 6, 1]))
        self.assertEqual((report["stable"]["triangles"], report["stable"]["depth"]["most"]), (48, 1))
        self.assertEqual((report["unstable"]["segments"]["count"], report["unstable"]["to_infinity"]), (12, 6))
        for points in (cloud(60, 3, grid=4), [(x, y, z) for x in range(4) for y in range(4) for z in range(3)]):
            self.assertEqual(self.json_of("flow", "-", stdin=text_of(points))["euler_characteristic"], 1)
        self.assertEqual(self.json_of("flow", "-", stdin=text_of(CUBE + FACE_CENTRES))["stationary_regular"], 12)
        self.assertEqual(self.json_of("flow", "-", "--plane", stdin=cube)["critical"], [4, 4, 1, 0])

    def test_sheets_and_surfaces_have_the_same_pairs(self):
        points = text_of(cloud(60, 3, seed=4))
        sheets = self.json_of("flow", "-", "--unstable", "1", stdin=points)
        surfaces = self.json_of("flow", "-", "--stable", "2", stdin=points)
        unstable, stable = sheets["unstable"], surfaces["stable"]
        self.assertEqual(unstable["sheets"], sheets["critical"][1])
        self.assertEqual((unstable["flagged"], stable["flagged"]), ({}, {}))
        self.assertEqual(total(unstable["saddles"]), stable["depth"]["count"])
        for report in (unstable, stable):
            self.assertEqual(set(report["filters"]), {"starts", "comparisons", "exits", "landings"})
            self.assertTrue(all(f["undecided"] <= f["calls"] for f in report["filters"].values()))
        for distribution in (unstable["parts"], unstable["voronoi_vertices"], stable["depth"]):
            self.check_distribution(distribution)
        cube = self.json_of("flow", "-", "--unstable", "1", stdin=text_of(CUBE))["unstable"]
        self.assertEqual((cube["sheets"], cube["pieces"], cube["to_infinity"]), (12, 12, 12))
        self.assertEqual((cube["parts"]["mean"], cube["saddles"]["mean"], cube["voronoi_vertices"]["mean"]), (2, 2, 1))

    def check_distribution(self, distribution):
        values = [v for v, count in enumerate(distribution["frequencies"]) for _ in range(count)]
        self.assertEqual((distribution["count"], distribution["most"]), (len(values), max(values)))
        self.assertAlmostEqual(distribution["mean"], statistics.mean(values))
        self.assertAlmostEqual(distribution["deviation"], statistics.pstdev(values))
        self.assertEqual(distribution["median"], statistics.median_low(values))
        self.assertEqual(distribution["mode"], min(statistics.multimode(values)))

    def test_regions(self):
        lattice = text_of([(x, y, z) for x in range(3) for y in range(4) for z in range(5)])
        report = self.json_of("flow", "-", "--stable", "3", "-o", "l.vtk", "-o", "l.off", stdin=lattice)["stable"]
        self.assertEqual((report["regions"], report["wall_saddles"]["mean"], report["triangles"]), (24, 6, 8 * 98))
        self.assertEqual((report["voronoi_vertices"]["mean"], report["inner_saddles"]), (1, 0))
        points, cells, arrays = read_vtk(self.read("l.vtk").decode())
        self.assertEqual([t for t, _ in cells], [42] * 24)
        self.assertEqual(sorted(arrays["number"]), list(range(24)))
        self.assertEqual(set(arrays["walls"]), {6})
        for _, cell in cells:
            self.assertAlmostEqual(volume_of_polyhedron(points, cell), 1)
        self.assertEqual(self.read("l.off").decode().split("\n")[1].split()[1], str(8 * 98))
        # The walls of all regions are around what flows to no maximum.
        points = text_of(cloud(60, 3, seed=4))
        report = self.json_of("flow", "-", "--stable", "3", "-o", "r.vtk", stdin=points)
        self.assertEqual(report["stable"]["regions"], report["critical"][3])
        places, cells, _ = read_vtk(self.read("r.vtk").decode())
        self.assertTrue(all(volume_of_polyhedron(places, cell) > 0 for _, cell in cells))

    def test_points_of_a_plane_or_line(self):
        for text, expected in (("1 2 3\n", [1, 0, 0, 0]), ("0 0 0\n2 0 0\n5 0 0\n", [3, 2, 0, 0]),
                               ("0 0\n1 0\n0 1\n1 1\n", [4, 4, 1, 0]), ("0 0 0\n1 0 1\n0 1 0\n1 1 1\n", [4, 4, 1, 0])):
            for words in ([], ["--stable", "1"], ["--stable", "2"], ["--stable", "3"], ["--unstable", "1"],
                          ["--unstable", "2"], ["--shape", "9"], ["--simplify", "0"], ["--reconstruct"]):
                report = self.json_of("flow", "-", *words, "-o", "p.vtk", "-o", "p.off", stdin=text)
                self.assertEqual((report["critical"], report["euler_characteristic"]), (expected, 1))
                if "--unstable" in words and expected[2] == 0:
                    infinite = 2 * expected[1] if words[1] == "1" else 0
                    self.assertEqual(report["unstable"]["to_infinity"], infinite)
                if words == ["--shape", "9"]:
                    self.assertEqual(report["shape"]["betti_numbers"], [1, 0, 0])
        kite = "-4 0\n4 0\n0 2\n0 -10\n"
        for text in (kite, kite.replace("\n", " 7\n"), "-4 0 0\n4 0 0\n0 0 2\n0 0 -10\n"):
            report = self.json_of("flow", "-", "--stable", "2", "-o", "k.vtk", stdin=text)
            self.assertEqual((report["stable"]["triangles"], report["stable"]["depth"]["frequencies"]), (10, [0, 2, 2]))
            self.assertEqual(len(read_vtk(self.read("k.vtk").decode())[1]), 10)
            report = self.json_of("flow", "-", "--unstable", "1", "-o", "k.vtk", stdin=text)["unstable"]
            self.assertEqual((report["segments"]["frequencies"], report["to_infinity"]), ([0, 6, 2], 4))
            points, cells, _ = read_vtk(self.read("k.vtk").decode())
            self.assertEqual([t for t, _ in cells], [3] * 5)
            self.assertIn(-4.2, {c for p in points for c in p})
        # Discs about the corners of a square, from when they touch until they fill it.
        square = "0 0\n2 0\n0 2\n2 2\n"
        for distance, betti in ((0.9, [4, 0, 0]), (1, [1, 1, 0]), (1.4, [1, 1, 0]), (1.5, [1, 0, 0])):
            report = self.json_of("flow", "-", "--shape", repr(distance), "-o", "s.off", stdin=square)["shape"]
            self.assertEqual(report["betti_numbers"], betti)
        right = self.json_of("flow", "-", "--unstable", "1", stdin="0 0\n3 0\n0 4\n")
        self.assertEqual(right["stationary_regular"], 1)
        self.assertEqual(right["unstable"]["flagged"], {"passed_regular_point": [0, 1]})

    def test_histograms(self):
        self.write("c.xyz", text_of(cloud(40, 3)))
        for words, titles in ((["--stable", "2"], ["nS2"]), (["--unstable", "2"], ["nU2", "nWCC"]),
                              (["--unstable", "1"], ["Parts of Voronoi edges"]), (["--stable", "3"], ["Voronoi vertices"]),
                              (["--stable", "2", "--unstable", "2"], ["nS2", "nU2", "nWCC"])):
            self.run_quoin("flow", "c.xyz", *words, "-o", "h.svg")
            svg = self.read("h.svg").decode()
            self.assertEqual(ElementTree.fromstring(svg).tag, "{http://www.w3.org/2000/svg}svg")
            for title in titles:
                self.assertIn(title, svg)
        done = self.run_quoin("flow", "c.xyz", "--stable", "2", "-o", "-", "--format", "svg")
        self.assertTrue(done.stdout.startswith("<svg"))

    def test_flagged_manifolds_are_listed(self):
        points = [(-4, 0, 0), (4, 0, 0), (0, 2, 1), (0, 2, -1), (0, -10, 0)]
        report = self.json_of("flow", "-", "--stable", "2", stdin=text_of(points))["stable"]
        self.assertEqual((report["with_voronoi_vertex"], report["with_solid_part"]), (1, 1))
        self.assertEqual(report["flagged"]["with_voronoi_vertex"], report["flagged"]["with_solid_part"])
        report = self.json_of("flow", "-", "--unstable", "2", stdin=text_of(points))["unstable"]
        self.assertEqual((report["end_in_saddle"], len(report["flagged"]["end_in_saddle"])), (2, 2))

    def test_what_is_written(self):
        self.write("c.xyz", text_of(CUBE))
        for words, kinds in ((["--stable", "1"], {3: 12}), (["--stable", "2"], {5: 48}), (["--unstable", "2"], {3: 6}),
                             (["--shape", "0.6"], {3: 12}), (["--shape", "0.8"], {3: 12, 5: 48}),
                             (["--simplify", "0"], {5: 48})):
            self.run_quoin("flow", "c.xyz", *words, "-o", "c.vtk")
            _, cells, arrays = read_vtk(self.read("c.vtk").decode())
            found = {t: sum(1 for kind, _ in cells if kind == t) for t, _ in cells}
            self.assertEqual(found, kinds, words)
            self.assertEqual(len(arrays["number"]), len(cells))
        self.write("r.xyz", text_of(cloud(60, 3, seed=4)))
        done = self.run_quoin("flow", "r.xyz", "--unstable", "1", "-o", "s.vtk", "-o", "s.off")
        self.assertIn("reach to infinity and are not written", done.stderr)
        _, cells, arrays = read_vtk(self.read("s.vtk").decode())
        self.assertEqual({t for t, _ in cells}, {7})
        self.assertEqual((set(arrays["index"]), len(arrays["distance"])), ({1}, len(cells)))
        self.assertEqual(self.read("s.off").decode().split("\n")[1].split()[1], str(len(cells)))
        done = self.run_quoin("flow", "c.xyz", "--stable", "1", "-o", "c.off")
        self.assertIn("no faces", done.stderr)

    def test_shallow_maxima(self):
        self.write("r.xyz", text_of(cloud(200, 3)))
        maxima = self.json_of("flow", "r.xyz")["critical"][3]
        before = maxima
        for within in (0, 0.001, 0.01, 0.1):
            left = self.json_of("flow", "r.xyz", "--simplify", repr(within))["simplified"]["maxima"]
            self.assertLessEqual(left, before)
            before = left
        self.assertEqual(self.json_of("flow", "r.xyz", "--simplify", "0")["simplified"]["maxima"], maxima)
        self.assertLess(before, maxima)

    def test_a_torus_is_found_again(self):
        self.write("t.xyz", text_of(torus(40, 15)))
        report = self.json_of("flow", "t.xyz", "--reconstruct", "-o", "t.off", "-o", "t.vtk")["solid"]
        solid = self.json_of("info", "t.off")
        self.assertEqual((solid["closed"], solid["manifold"], solid["components"]), (True, True, 1))
        self.assertAlmostEqual(solid["volume"], 2 * math.pi ** 2 * 3, delta=4)
        self.assertEqual(len(read_vtk(self.read("t.vtk").decode())[1]), report["triangles"])
        lines = self.read("t.off").decode().split("\n")
        vertices, faces = map(int, lines[1].split()[:2])
        self.assertEqual((faces, 2 * vertices), (report["triangles"], faces))
        self.assertEqual(self.json_of("flow", "t.xyz", "--reconstruct", "--ratio", "0")["solid"]["maxima_inside"], 0)

    def test_medial_points_of_a_torus(self):
        self.write("t.xyz", text_of(torus(60, 24)))
        report = self.json_of("flow", "t.xyz", "--separate", "-o", "t.vtk")
        told = report["separation"]
        self.assertEqual([a + b for a, b in zip(told["surface"], told["medial"])], report["critical"])
        self.assertEqual(told["medial"][0], 0)
        self.assertGreater(min(told["medial"][2:]), 0)
        self.assertEqual((told["medial"][1], told["disputed"]), (0, [0, 0, 0, 0]))
        text = self.read("t.vtk").decode()
        self.assertIn("medial", text)
        solid = self.json_of("flow", "t.xyz", "--separate", "--reconstruct", "-o", "t.off")["solid"]
        self.assertEqual((solid["parts_of_space"], solid["unclear_saddles"]), (2, 0))
        mesh = self.json_of("info", "t.off")
        self.assertEqual((mesh["closed"], mesh["manifold"], mesh["components"]), (True, True, 1))
        self.assertAlmostEqual(mesh["volume"], 2 * math.pi ** 2 * 3, delta=3)
        self.run_quoin("flow", "t.xyz", "--separate", "--reconstruct", "--ratio", "0.5", code=USAGE)
        flat = self.json_of("flow", "-", "--separate", stdin="0 0 0\n1 0 0\n0 1 0\n")
        self.assertNotIn("separation", flat)
        self.assertIn("not separated", flat["warnings"][0])

    def test_all_at_once(self):
        self.write("c.xyz", text_of(cloud(40, 3, seed=6)))
        asked = [["--stable", "2"], ["--unstable", "2"], ["--shape", "0.2"], ["--simplify", "0.01"], ["--reconstruct"]]
        together = self.json_of("flow", "c.xyz", *[word for words in asked for word in words])
        for words, name in zip(asked, ("stable", "unstable", "shape", "simplified", "solid")):
            self.assertEqual(together[name], self.json_of("flow", "c.xyz", *words)[name])
        edges = self.json_of("flow", "c.xyz", "--stable", "1")
        self.assertEqual(edges["stable"], {"edges": edges["critical"][1], "flagged": {}})
        self.json_of("flow", "c.xyz", "--stable", "2", "--unstable", "1", "-o", "c.svg")

    def test_mistakes(self):
        self.write("c.xyz", text_of(CUBE))
        for mistake in (["--stable", "4"], ["--unstable", "3"], ["--shape", "-1"], ["--shape", "nan"], ["--ratio", "0.3"],
                        ["--simplify", "x"], ["--reconstruct", "--ratio", "2"], ["--reconstruct", "--shape", "1", "-o", "x.vtk"],
                        ["--stable", "2", "--unstable", "2", "-o", "x.vtk"], ["-o", "x.stl"], ["-o", "x.svg"]):
            self.run_quoin("flow", "c.xyz", *mistake, code=USAGE)
        self.assertIn("more than --memory", self.run_quoin("flow", "c.xyz", "--memory", "0.001", code=REFUSED).stderr)

    def test_order_and_extremes(self):
        points = cloud(40, 3, seed=5)
        shuffled = points[:]
        random.Random(1).shuffle(shuffled)
        found, again = [read_vtk(self.run_quoin("flow", "-", "--stable", "2", "-o", "-", stdin=text_of(given)).stdout)
                        for given in (points, shuffled)]
        places = [[given[int(i)] if i >= 0 else None for i in arrays.pop("input")]
                  for given, (_, _, arrays) in ((points, found), (shuffled, again))]
        self.assertEqual((places[0], found), (places[1], again))
        expected = self.json_of("flow", "-", "--unstable", "2", stdin=text_of(points))
        for factor in (2.0 ** 900, 2.0 ** -900):
            scaled = [tuple(c * factor for c in p) for p in points]
            found = self.json_of("flow", "-", "--unstable", "2", stdin=text_of(scaled))
            self.assertEqual((found["critical"], found["unstable"]["segments"]),
                             (expected["critical"], expected["unstable"]["segments"]))


if __name__ == "__main__":
    main()
