# SPDX-License-Identifier: Apache-2.0
"""alpha.

    check_alpha.py QUOIN
"""
import itertools
import math
import random
from fractions import Fraction

from clouds import CUBE, cloud, read_vtk, text_of
from command import FILE_TROUBLE, REFUSED, USAGE, CommandTest, main
from pages import PageTest


def exact(points):
    return [tuple(Fraction(c) for c in p) for p in points]


def square(p, q):
    return sum((a - b) ** 2 for a, b in zip(p, q))


def circle(corners):
    """Centre and squared radius of the smallest circle through one to three points of the plane, None if collinear."""
    if len(corners) < 3:
        centre = tuple(sum(c) / len(corners) for c in zip(*corners))
        return centre, square(centre, corners[0])
    (ax, ay), (bx, by), (cx, cy) = corners
    bx, by, cx, cy = bx - ax, by - ay, cx - ax, cy - ay
    d = 2 * (bx * cy - by * cx)
    if d == 0:
        return None
    b, c = bx * bx + by * by, cx * cx + cy * cy
    x, y = (cy * b - by * c) / d, (bx * c - cx * b) / d
    return (ax + x, ay + y), x * x + y * y


def alpha_values(points):
    """For each simplex that has one, the least squared radius of an empty circle through it."""
    values = {}
    for size in (1, 2, 3):
        for corners in itertools.combinations(range(len(points)), size):
            found = circle([points[i] for i in corners])
            if found is None or any(square(found[0], q) < found[1] for q in points):
                continue
            for k in range(1, size + 1):
                for face in itertools.combinations(corners, k):
                    values[face] = min(values.get(face, found[1]), found[1])
    return values


def read_filtration(text):
    lines = [line.split() for line in text.splitlines() if not line.startswith("#")]
    return [(words[0], tuple(sorted(map(int, words[1:])))) for words in lines]


class Values(CommandTest):
    def test_a_cube(self):
        self.write("c.xyz", text_of(CUBE))
        report = self.json_of("alpha", "c.xyz", "--values", "--exact")
        self.assertEqual((report["points"], report["distinct"], report["dimension"], report["critical_values"]),
                         (8, 8, 3, 4))
        self.assertEqual((report["values"], report["exact_values"]), ([0, 0.25, 0.5, 0.75], ["0", "1/4", "1/2", "3/4"]))
        self.assertEqual((report["shape"]["betti"], report["shape"]["pieces"]), ([1, 0, 0], 1))
        self.assertNotIn("value", report)
        self.assertNotIn("-0", self.run_quoin("alpha", "c.xyz", "--values").stdout)
        for words, betti, pieces in ((["--value", "0"], [8, 0, 0], 0), (["--value", "0.25"], [1, 5, 0], 0),
                                     (["--radius", ".5"], [1, 5, 0], 0), (["--value", "1/2"], [1, 0, 1], 0),
                                     (["--value", "0.7499"], [1, 0, 1], 0), (["--value", "3/4"], [1, 0, 0], 1),
                                     (["--pieces", "7"], [1, 0, 0], 1)):
            report = self.json_of("alpha", "c.xyz", *words)
            self.assertEqual((report["shape"]["betti"], report["shape"]["pieces"]), (betti, pieces), words)
        self.assertEqual((report["value"], report["exact_value"]), (0.75, "3/4"))
        self.assertAlmostEqual(report["radius"], math.sqrt(0.75))
        shape = self.json_of("alpha", "c.xyz", "--value", "1/4")["shape"]
        self.assertEqual((shape["simplices"], shape["singular"], shape["regular"], shape["interior"]),
                         ([8, 12, 0, 0], [0, 12, 0, 0], [8, 0, 0, 0], [0, 0, 0, 0]))
        text = self.run_quoin("alpha", "c.xyz", "--value", "1/2", "--values", "--exact").stdout
        self.assertIn("value 0.75 = 3/4\n", text)
        self.assertRegex(text, r"betti +\[1,0,1\]\n")

    def test_values_by_definition(self):
        for points in (cloud(12, 2, seed=5), cloud(14, 2, seed=6, grid=4)):
            self.run_quoin("alpha", "-", "-o", "f.txt", "--exact", stdin=text_of(points))
            found = read_filtration(self.read("f.txt").decode())
            expected = alpha_values(exact(points))
            for value, simplex in found:
                self.assertEqual(Fraction(value), expected[simplex], simplex)
            order = [(Fraction(value), len(simplex)) for value, simplex in found]
            self.assertEqual(order, sorted(order))
            self.run_quoin("alpha", "-", "-o", "r.txt", stdin=text_of(points))
            rounded = read_filtration(self.read("r.txt").decode())
            self.assertEqual([(float(Fraction(v)), s) for v, s in found], [(float(v), s) for v, s in rounded])

    def test_filtrations_are_read_by_others(self):
        points = cloud(40, 3, seed=8, grid=5)
        for words in ([], ["--exact"]):
            self.run_quoin("alpha", "-", "-o", "f.txt", *words, stdin=text_of(points))
            report = self.json_of("persistence", "f.txt")
            self.assertEqual((report["essential"], report["warnings"]), ([1, 0, 0, 0], []))
        for value in ("1/4", "0.5", "1.5", "2"):
            shape = self.json_of("alpha", "-", "--value", value, "-o", "f.txt", stdin=text_of(points))["shape"]
            part = read_filtration(self.read("f.txt").decode())
            text = "".join(" ".join(map(str, simplex)) + "\n" for _, simplex in part)
            report = self.json_of("homology", "-", stdin=text)
            self.assertEqual(shape["simplices"][:len(report["simplices"])], report["simplices"])
            betti = report["betti"]["Q"] + [0, 0]
            self.assertEqual(shape["betti"], betti[:3])
            self.assertEqual(shape["euler_characteristic"], report["euler_characteristic"])

    def test_order_and_equal_points_do_not_matter(self):
        points = cloud(30, 3, seed=2, grid=4)
        expected = None
        for seed in range(3):
            random.Random(seed).shuffle(points)
            report = self.json_of("alpha", "-", "--radius", "0.9", "--values", "--exact", stdin=text_of(points))
            expected = expected or report
            self.assertEqual(report, expected)
        self.assertLess(expected["distinct"], 30)

    def test_flat_clouds(self):
        for text, dimension, betti, values in (("1 2 3\n1 2 3\n", 0, [1, 0, 0], [0]),
                                               ("0 0 0\n4 0 0\n1 0 0\n", 1, [1, 0, 0], [0, 0.25, 2.25]),
                                               ("0 0 1\n2 0 1\n0 2 1\n2 2 1\n", 2, [1, 0, 0], [0, 1, 2]),
                                               ("7 7\n", 0, [1, 0, 0], [0]), ("0 0\n3 0\n", 1, [1, 0, 0], [0, 2.25])):
            report = self.json_of("alpha", "-", "--values", "-o", "f.vtk", "-o", "f.txt", "--pieces", "1", stdin=text)
            self.assertEqual((report["dimension"], report["shape"]["betti"], report["values"]), (dimension, betti, values))
            self.assertEqual(len(report["warnings"]), 1)

    def test_far_and_near(self):
        for scale in (1e-150, 1e150):
            points = [tuple(c * scale for c in p) for p in CUBE]
            report = self.json_of("alpha", "-", "--pieces", "1", stdin=text_of(points))
            self.assertEqual((report["critical_values"], report["shape"]["pieces"]), (4, 1))
        huge = text_of([tuple(c * 1e300 for c in p) for p in CUBE])
        self.assertEqual(self.json_of("alpha", "-", "--values", stdin=huge)["values"], [0, None, None, None])
        self.assertIn("--exact", self.run_quoin("alpha", "-", "-o", "-", "--format", "txt", stdin=huge, code=REFUSED).stderr)
        self.assertIn("h.vtk: a number 'value'", self.run_quoin("alpha", "-", "-o", "h.vtk", stdin=huge, code=REFUSED).stderr)
        self.run_quoin("alpha", "-", "--exact", "-o", "h.txt", stdin=huge)
        self.assertEqual(self.json_of("persistence", "h.txt")["essential"], [1, 0, 0, 0])


class Weights(CommandTest):
    def test_equal_weights_move_values(self):
        points = cloud(20, 3, seed=3, grid=8)
        plain = self.json_of("alpha", "-", "--values", "--exact", stdin=text_of(points))
        same = self.json_of("alpha", "-", "--weighted", "--values", "--exact", stdin=text_of([p + (2,) for p in points]))
        self.assertEqual([Fraction(v) - 2 for v in plain["exact_values"]], [Fraction(v) for v in same["exact_values"]])
        self.assertEqual((same["simplices"], same["hidden"]), (plain["simplices"], 0))
        self.assertEqual(self.json_of("alpha", "-", "--weighted", "--value", "-2", stdin=text_of(
            [p + (2,) for p in points]))["shape"]["betti"], [plain["distinct"], 0, 0])

    def test_hidden_points_and_balls(self):
        points = [(0, 0, 4), (3, 0, 4), (1.5, 0, -9), (100, 0, 0)]
        report = self.json_of("alpha", "-", "--weighted", "--value", "0", "-o", "w.vtk", stdin=text_of(points))
        self.assertEqual((report["hidden"], report["vertices"], report["shape"]["betti"]), (1, 3, [2, 0, 0]))
        report = self.json_of("alpha", "-", "--weighted", "--values", stdin=text_of(points[:2] + [(0, 4, 4)]))
        self.assertEqual(report["values"], [-4, -1.75, 0, 2.25])


class Persistence(CommandTest):
    def test_is_that_of_the_filtration(self):
        for points, words in ((cloud(40, 3, seed=8, grid=5), []), (cloud(60, 2, seed=9), []),
                              (cloud(30, 3, seed=7, grid=6), ["--prime", "3"])):
            self.run_quoin("alpha", "-", "--exact", "-o", "f.txt", stdin=text_of(points))
            expected = self.json_of("persistence", "f.txt", *words)
            found = self.json_of("alpha", "-", "--persistence", "--exact", *words, stdin=text_of(points))
            for key in ("prime", "pairs", "essential", "intervals"):
                self.assertEqual(found[key], expected[key], key)
            self.assertNotIn("shape", found)
            self.assertEqual([[None if e is None else float(Fraction(e)) for e in i] for i in found["exact_intervals"][0]],
                             found["intervals"][0])

    def test_says_what_doubles_do_not_tell(self):
        tiny = text_of([tuple(c * 1e-300 for c in p) for p in CUBE])
        done = self.run_quoin("alpha", "-", "-o", "t.txt", stdin=tiny)
        self.assertIn("3 values are the same doubles as the ones before", done.stderr)
        self.assertIn("different values with one nearest double", self.run_quoin("alpha", "-", "--persistence", stdin=tiny).stderr)
        exact = self.run_quoin("alpha", "-", "--exact", "-o", "t.txt", stdin=tiny)
        self.assertEqual(exact.stderr, "")
        self.assertEqual(self.json_of("persistence", "t.txt")["pairs"], [8, 5, 1, 0])
        huge = text_of([tuple(c * 1e300 for c in p) for p in CUBE])
        self.assertIn("beyond the largest double", self.run_quoin("alpha", "-", "--persistence", stdin=huge).stderr)

    def test_drawings_and_text(self):
        self.write("c.xyz", text_of(CUBE))
        done = self.run_quoin("alpha", "c.xyz", "--persistence", "-o", "d.svg")
        self.assertIn("degree 1: 5 intervals\n  0.25 to 0.5\n", done.stdout)
        self.assertIn(b">birth<", self.read("d.svg"))
        self.run_quoin("alpha", "c.xyz", "--persistence", "--barcode", "-o", "b.svg")
        self.assertIn(b'class="bar d2"', self.read("b.svg"))
        text = self.run_quoin("alpha", "c.xyz", "--persistence", "--exact").stdout
        self.assertIn("degree 2: 1 intervals\n  1/2 to 3/4\n", text)
        self.assertEqual(self.run_quoin("alpha", "c.xyz", "--persistence", "-o", "-").stdout.encode(), self.read("d.svg"))


class Outputs(CommandTest):
    def two_cubes(self):
        return CUBE + [(20 + 2 * x, 2 * y, 2 * z) for x, y, z in CUBE]

    def test_boundaries(self):
        self.write("t.xyz", text_of(self.two_cubes()))
        for ending in ("off", "ply", "obj"):
            report = self.json_of("alpha", "t.xyz", "--pieces", "2", "-o", f"t.{ending}")
            self.assertEqual((report["value"], report["shape"]["pieces"]), (3, 2))
            info = self.info(f"t.{ending}")
            self.assertEqual((info["volume"], info["components"], info["vertices"]), (9, 2, 16))
        self.run_quoin("alpha", "t.xyz", "-o", "hull.off")
        self.run_quoin("hull", "hull.off", "-o", "again.off")
        self.assertEqual(self.info("hull.off")["volume"], self.info("again.off")["volume"])
        self.json_of("alpha", "t.xyz", "--value", "1/2", "-o", "s.off")
        self.assertEqual(self.read("s.off").split()[1:3], [b"8", b"12"])  # squares of the small one, two triangles each
        report = self.json_of("alpha", "t.xyz", "--value", "0", "-o", "n.off")
        self.assertIn("no faces", report["warnings"][0])

    def test_the_plane(self):
        points = [(x, y) for x in range(4) for y in range(4) if (x, y) not in ((1, 1), (1, 2), (2, 1), (2, 2))]
        report = self.json_of("alpha", "-", "--value", "0.5", "-o", "p.off", stdin=text_of(points))
        self.assertEqual((report["shape"]["betti"], report["shape"]["simplices"][:2]), ([1, 1, 0], [12, 16]))
        report = self.json_of("alpha", "-", "-o", "p.off", "-o", "p.vtk", stdin=text_of(points))
        self.assertAlmostEqual(self.json_of("info", "p.off", code=REFUSED)["area"], 9)
        vertices, cells, arrays = read_vtk(self.read("p.vtk").decode())
        self.assertEqual((len(vertices), {t for t, _ in cells}, len(arrays["value"])), (12, {5}, len(cells)))
        heights = text_of([p + (p[0] * p[1],) for p in points])
        report = self.json_of("alpha", "-", "--plane", "-o", "h.vtk", stdin=heights)
        self.assertEqual((report["coordinates"], report["dimension"]), (2, 2))
        self.assertEqual({v[2] for v in read_vtk(self.read("h.vtk").decode())[0]}, {v[0] * v[1] for v in points})

    def test_grids_have_what_is_a_face_of_nothing(self):
        points = CUBE + [(5, 0, 0), (5, 1, 0), (5, 0, 1), (9, 9, 9), (0, 0, 0)]
        self.write("g.xyz", text_of(points))
        self.run_quoin("alpha", "g.xyz", "--value", "0.75", "-o", "g.vtk")
        vertices, cells, arrays = read_vtk(self.read("g.vtk").decode())
        kinds = sorted(t for t, _ in cells)
        self.assertEqual((kinds.count(1), kinds.count(3), kinds.count(5)), (1, 0, 1))
        self.assertEqual(len(vertices), 12)
        self.assertEqual([points[int(i)] for i in arrays["input"]], vertices)
        self.assertEqual(sum(arrays["multiplicity"]), len(points))
        self.assertEqual({v for (t, _), v in zip(cells, arrays["value"]) if t == 10}, {0.75})
        self.assertEqual({v for (t, _), v in zip(cells, arrays["value"]) if t == 5}, {0.5})
        done = self.run_quoin("alpha", "g.xyz", "--value", "0.75", "-o", "-")
        self.assertEqual(done.stdout.encode(), self.read("g.vtk"))


class Graphs(CommandTest):
    def pairs_of(self, kind, points):
        done = self.run_quoin("alpha", "-", "--graph", kind, "-q", "-o", "-", "--format", "txt", stdin=text_of(points))
        return sorted(tuple(sorted(map(int, line.split()))) for line in done.stdout.splitlines())

    def test_definitions(self):
        for points in (cloud(30, 3, seed=4), cloud(35, 2, seed=5), sorted(set(cloud(40, 3, grid=3)))):
            places = exact(points)
            pairs = list(itertools.combinations(range(len(points)), 2))
            others = {(i, j): [r for r in range(len(points)) if r not in (i, j)] for i, j in pairs}
            length = {(i, j): square(places[i], places[j]) for i, j in pairs}
            gabriel = [e for e in pairs if all(square(places[e[0]], places[r]) + square(places[e[1]], places[r]) > length[e]
                                               for r in others[e])]
            self.assertEqual(self.pairs_of("gabriel", points), gabriel)
            relative = [e for e in pairs if all(max(square(places[e[0]], places[r]), square(places[e[1]], places[r])) >= length[e]
                                                for r in others[e])]
            self.assertEqual(self.pairs_of("relative-neighbours", points), relative)
            tree = self.pairs_of("spanning-tree", points)
            part = list(range(len(points)))
            total = Fraction(0)
            for i, j in sorted(pairs, key=length.get):
                if part[i] != part[j]:
                    total += length[i, j]
                    part = [part[i] if p == part[j] else p for p in part]
            self.assertEqual((len(tree), sum(length[e] for e in tree)), (len(points) - 1, total))
            self.assertLessEqual(set(tree), set(relative))

    def test_report_and_grid(self):
        report = self.json_of("alpha", "-", "--graph", "spanning-tree", "-o", "t.vtk", stdin="0 0\n3 4\n3 0\n0 0\n")
        self.assertEqual((report["graph"], report["edges"], report["length"]), ("spanning-tree", 2, 7))
        self.assertNotIn("shape", report)
        vertices, cells, arrays = read_vtk(self.read("t.vtk").decode())
        self.assertEqual((len(vertices), [t for t, _ in cells], sorted(arrays["length"])), (3, [3, 3], [3, 4]))
        self.assertEqual(self.json_of("alpha", "-", "--graph", "gabriel", stdin="1 1\n")["edges"], 0)


class Pages(PageTest):
    """What a page holds; tests of the view look at it."""

    def test_every_value_has_its_complex(self):
        for points, dimension in ((cloud(40, 3), 3), (cloud(30, 2, grid=6), 2), (CUBE, 3)):
            text = text_of(points)
            values = self.json_of("alpha", "-", "--values", "--exact", stdin=text)
            header, array = self.page("alpha", "-", stdin=text)
            self.assertEqual(list(array(header["values"])), values["values"])
            counts = {c["name"]: [array(r["at"]) for r in c["rows"]] for c in header["counts"]}
            pairs = array(header["pairs"])
            pairs = list(zip(pairs[0::3], pairs[1::3], pairs[2::3]))
            shown = {layer["name"]: layer for layer in header["layers"]}
            for at in range(0, len(values["values"]), 7):
                shape = self.json_of("alpha", "-", "--value", values["exact_values"][at], stdin=text)["shape"]
                self.assertEqual([row[at] for row in counts["Simplices"]], shape["simplices"])
                betti = [sum(1 for d, b, e in pairs if d == k and b <= at < e) for k in range(dimension)]
                self.assertEqual([row[at] for row in counts["Betti numbers"]], shape["betti"][:dimension])
                self.assertEqual(betti, shape["betti"][:dimension])
                triangles = {"Boundary": "regular", "Singular triangles": "singular"} if dimension == 3 else {}
                for name, place in triangles.items():
                    layer = shown.get(name)
                    begun = array(layer["shown"])[at] if layer else 0
                    ends = array(layer["ends"])[:begun] if layer and "ends" in layer else [len(values["values"])] * begun
                    self.assertEqual(sum(1 for end in ends if end > at), shape[place][2], (name, at))

    def test_it_opens_at_the_value(self):
        text = text_of(cloud(20, 3))
        value = self.json_of("alpha", "-", "--values", "--exact", stdin=text)["exact_values"][9]
        self.assertEqual(self.page("alpha", "-", "--value", value, stdin=text)[0]["value"], 9)
        self.assertNotIn("value", self.page("alpha", "-", stdin=text)[0])

    def test_graphs_triangulations_and_few_points(self):
        header, array = self.page("alpha", "-", "--graph", "spanning-tree", stdin="0 0\n3 4\n3 0\n0 0\n")
        self.assertEqual([(layer["kind"], layer["vertices"]["length"]) for layer in header["layers"]], [("points", 3), ("segments", 4)])
        self.assertEqual(sorted(array(header["pointNumbers"])), [0, 1, 2])
        header, array = self.page("delaunay", "-", stdin=text_of([p + (10, 20, 30) for p in CUBE]))
        self.assertEqual({layer["name"]: layer["vertices"]["length"] for layer in header["layers"]}["Hull"], 36)
        self.assertEqual(array(header["layers"][0]["colors"])[:4], (10, 20, 30, 255))
        for text in ("1 2 3\n", "1 2\n", "0 0 0\n1 1 1\n3 3 3\n", "0 0 1\n1 0 1\n0 1 1\n1 1 1\n"):
            for command in ("alpha", "delaunay"):
                self.assertGreater(len(self.page(command, "-", stdin=text)[0]["layers"]), 0)
        weighted = text_of([(0, 0, 4), (1, 0, 1), (5, 5, -2)])
        self.assertLess(min(self.page("alpha", "-", "--weighted", stdin=weighted)[1](
            self.page("alpha", "-", "--weighted", stdin=weighted)[0]["values"])), 0)


class Mistakes(CommandTest):
    def test_usage(self):
        for words in (["--value", "1", "--radius", "1"], ["--value", "1", "--pieces", "1"], ["--value", "x"],
                      ["--value", "nan"], ["--value", "-1"], ["--value", "1,2"], ["--value", "1/0"], ["--radius", "-1"],
                      ["--radius", "inf"], ["--pieces", "0"], ["--pieces", "-1"], ["--pieces", "1.5"], ["--graph", "delaunay"],
                      ["--graph", "gabriel", "--weighted"], ["--graph", "gabriel", "--value", "1"],
                      ["--graph", "gabriel", "-o", "x.off"], ["-o", "x.stl"], ["-o", "-", "--format", "stl"],
                      ["--persistence", "--value", "1"], ["--persistence", "--graph", "gabriel"], ["--prime", "2"],
                      ["--barcode"], ["--persistence", "--prime", "4"], ["--persistence", "-o", "x.txt"],
                      ["--persistence", "-o", "-", "--format", "vtk"], ["-o", "x.svg"], ["--memory", "0"], ["--input-format", "las"], ["--format", "vtk"]):
            self.run_quoin("alpha", "missing.xyz", *words, code=USAGE)
        self.run_quoin("alpha", "missing.xyz", code=FILE_TROUBLE)

    def test_bad_points(self):
        for text in ("", "1 2\n3\n", "1 2 nan\n", "inf 0\n", "1 2 3\n4 5 6 7\n"):
            self.run_quoin("alpha", "-", stdin=text, code=REFUSED)
        self.run_quoin("alpha", "-", "--weighted", stdin="1 2\n3 4\n", code=REFUSED)

    def test_memory(self):
        points = text_of(cloud(500, 3))
        self.assertIn("nothing was begun", self.run_quoin("alpha", "-", "--memory", "0.1", stdin=points, code=REFUSED).stderr)
        self.assertIn("need about", self.run_quoin("alpha", "-", "--memory", "0.3", stdin=points, code=REFUSED).stderr)
        self.run_quoin("alpha", "-", "--memory", "10", stdin=points)


if __name__ == "__main__":
    main()
