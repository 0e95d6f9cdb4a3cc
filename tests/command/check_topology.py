# SPDX-License-Identifier: Apache-2.0
"""homology and persistence.

    check_topology.py QUOIN
"""
from command import CUBE_FACES, REFUSED, USAGE, CommandTest, corners, main, off

PLANE = ["4 1 2", "4 2 3", "5 3 1", "5 1 2", "6 2 3", "6 3 1", "4 5 3", "5 6 2", "6 4 1", "4 5 6"]
TRIANGLE = "0 0\n0 1\n0 2\n1 0 1\n2 1 2\n3 0 2\n5 0 1 2\n"


class Homology(CommandTest):
    def test_a_cube_of_squares(self):
        report = self.json_of("homology", "a.off")
        expected = {"dimension": 2, "simplices": [14, 36, 24], "euler_characteristic": 2, "components": 1,
                    "betti": {"Q": [1, 0, 1], "Z2": [1, 0, 1]}, "torsion": [[], [], []], "manifold": True,
                    "closed": True, "orientable": True, "warnings": [],
                    "surfaces": [{"orientable": True, "genus": 0, "boundary_loops": 0, "euler_characteristic": 2}]}
        self.assertEqual({k: report[k] for k in expected}, expected)
        self.assertRegex(self.run_quoin("homology", "a.off").stdout, r"components +1\n")

    def test_every_mesh_format_and_streams(self):
        for ending in ("off", "obj", "stl", "ply"):
            self.run_quoin("convert", "a.off", "-o", f"c.{ending}")
            self.assertEqual(self.json_of("homology", f"c.{ending}")["betti"]["Q"], [1, 0, 1], ending)
        text = self.read("open.off").decode()
        report = self.json_of("homology", "-", stdin=text)
        self.assertEqual((report["betti"]["Q"], report["closed"]), ([1, 0, 0], False))
        self.assertEqual(report["surfaces"][0]["boundary_loops"], 1)

    def test_the_projective_plane(self):
        self.write("plane.txt", "# six vertices\n" + "\n".join(PLANE) + "\n")
        report = self.json_of("homology", "plane.txt", "--prime", "3", "--prime", "7")
        self.assertEqual(report["simplices"], [6, 15, 10])
        self.assertEqual(report["betti"], {"Q": [1, 0, 0], "Z2": [1, 1, 1], "Z3": [1, 0, 0], "Z7": [1, 0, 0]})
        self.assertEqual(report["torsion"], [[], [2], []])
        self.assertEqual((report["manifold"], report["closed"], report["orientable"]), (True, True, False))
        loop = [set(t) for t in report["reversing_loop"]]
        for i, t in enumerate(loop):
            self.assertEqual(len(t & loop[i - 1]), 2)
        self.assertEqual(report["surfaces"][0]["genus"], 1)
        self.assertEqual(self.json_of("homology", "-", stdin="\n".join(PLANE[:-1]))["betti"]["Q"], [1, 1, 0])

    def test_witnesses_and_torsion(self):
        for text, key, simplex in (("0 1 2\n2 3\n", "maximal", [2, 3]), ("0 1 2\n0 1 3\n0 1 4\n", "branching", [0, 1]),
                                   ("0 1 2\n0 3 4\n", "pinched", [0])):
            report = self.json_of("homology", "-", stdin=text)
            self.assertEqual((report["manifold"], report["not_manifold"]), (False, {key: simplex}))
            self.assertNotIn("surfaces", report)
        # A disk whose boundary goes five times around a circle, as one polygon with repeated corners.
        self.write("five.off", off([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2) * 5]))
        report = self.json_of("homology", "five.off")
        self.assertEqual(report["torsion"], [[], [5], []])
        self.assertEqual(report["betti"]["Z5"], [1, 1, 1])

    def test_what_a_mesh_has_beside_surfaces(self):
        vertices = corners((0, 0, 0), (1, 1, 1)) + [(9, 9, 9)]
        self.write("more.off", off(vertices, CUBE_FACES + [CUBE_FACES[0]]))
        report = self.json_of("homology", "more.off")
        self.assertEqual(report["betti"]["Q"], [1, 0, 1])
        self.assertEqual(len(report["warnings"]), 2)
        self.assertEqual(self.json_of("homology", "-", stdin=off(vertices, []))["betti"]["Q"], [9])

    def test_mistakes(self):
        for prime in ("1", "4", "x", "-2", "2147483648", "2.0", ""):
            self.run_quoin("homology", "missing.txt", "--prime", prime, code=USAGE)
        for text, where in (("0 1\n0 x\n", ":2: 'x'"), ("0 1 0\n", "twice"), ("7 7\n", ":1:"), ("", "empty")):
            self.assertIn(where, self.run_quoin("homology", "-", stdin=text, code=REFUSED).stderr)
        self.run_quoin("union", "a.off", "b.off", "-o", "u.qsolid")
        self.assertIn("convert", self.run_quoin("homology", "u.qsolid", code=REFUSED).stderr)


class Persistence(CommandTest):
    def test_a_triangle(self):
        self.write("t.txt", TRIANGLE)
        report = self.json_of("persistence", "t.txt")
        expected = {"simplices": [3, 3, 1], "prime": 2, "pairs": [3, 1, 0], "essential": [1, 0, 0],
                    "intervals": [[[0, 1], [0, 2], [0, None]], [[3, 5]], []], "warnings": []}
        self.assertEqual(report, expected)
        text = self.run_quoin("persistence", "-", stdin=TRIANGLE).stdout
        self.assertIn("degree 1: 1 intervals\n  3.0 to 5.0\n", text)
        self.assertIn("0.0 to infinity", text)

    def test_exact_values_and_missing_faces(self):
        report = self.json_of("persistence", "-", stdin="1/3 0\n1/2 1\n2/3 0 1\n7 2 3\n")
        self.assertEqual(report["exact_intervals"], [[["1/3", None], ["1/2", "2/3"], ["7", None]], []])
        self.assertEqual(report["intervals"][0][0], [1 / 3, None])
        self.assertIn("2 faces are not listed", report["warnings"][0])

    def test_fields(self):
        text = "".join(f"{i} {line}\n" for i, line in enumerate(PLANE))
        self.assertEqual(self.json_of("persistence", "-", stdin=text)["essential"], [1, 1, 1])
        three = self.json_of("persistence", "-", "--prime", "3", stdin=text)
        self.assertEqual((three["essential"], three["prime"]), ([1, 0, 0], 3))

    def test_drawings(self):
        self.write("t.txt", TRIANGLE)
        self.run_quoin("persistence", "t.txt", "-o", "d.svg")
        self.assertIn(b">birth<", self.read("d.svg"))
        self.run_quoin("persistence", "t.txt", "--barcode", "-o", "b.svg", "-q")
        self.assertIn(b"class=\"bar d1\"", self.read("b.svg"))
        done = self.run_quoin("persistence", "t.txt", "-o", "-", "--json")
        self.assertEqual(done.stdout.encode(), self.read("d.svg"))

    def test_mistakes(self):
        self.run_quoin("persistence", "missing.txt", "-o", "d.off", code=USAGE)
        self.run_quoin("persistence", "missing.txt", "--prime", "6", code=USAGE)
        self.run_quoin("persistence", "missing.txt", "--prime", "2", "--prime", "3", code=USAGE)
        for text, where in (("0 0\n0 1\n-1 0 1\n", "enters before its face"), ("0 0\n1 0\n", "listed twice"),
                            ("x 0\n", ":1:"), ("nan 0\n", ":1:"), ("0\n", ":1:"), ("", "no simplex"),
                            ("0 -1\n", ":1:"), ("1/0 1\n", ":1:")):
            self.assertIn(where, self.run_quoin("persistence", "-", stdin=text, code=REFUSED).stderr)


if __name__ == "__main__":
    main()
