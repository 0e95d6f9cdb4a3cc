# SPDX-License-Identifier: Apache-2.0
"""Commands that answer: info, check, classify, section, interfere.

    check_queries.py QUOIN
"""
import json
import math
import xml.etree.ElementTree

from command import CUBE_FACES, DONE, FILE_TROUBLE, REFUSED, USAGE, CommandTest, box, corners, main, off

INFO = ("file vertices edges faces triangles shells voids components closed manifold nonmanifold_edges "
        "nonmanifold_vertices unbounded volume area bounds inputs centroid warnings")


class Info(CommandTest):
    def test_a_cube(self):
        info = self.info("a.off")
        self.assert_keys(info, INFO + " exact_volume")
        expected = {"file": "a.off", "vertices": 8, "edges": 12, "faces": 6, "triangles": 12, "shells": 1, "voids": 0,
                    "components": 1, "closed": True, "manifold": True, "unbounded": False, "volume": 8,
                    "exact_volume": "8", "area": 24, "bounds": [[0, 0, 0], [2, 2, 2]], "centroid": [1, 1, 1]}
        self.assertEqual({k: info[k] for k in expected}, expected)
        self.assertRegex(self.run_quoin("info", "a.off").stdout, r"centroid +\[1.0,1.0,1.0\]")

    def test_an_open_mesh_has_a_summary_and_is_refused(self):
        info = self.json_of("info", "open.off", code=REFUSED)
        self.assert_keys(info, INFO + " error exit_code diagnosis")
        expected = {"vertices": 8, "edges": 12, "faces": 5, "triangles": 10, "closed": False, "manifold": False,
                    "volume": None, "area": 5, "bounds": [[0, 0, 0], [1, 1, 1]], "exit_code": REFUSED}
        self.assertEqual({k: info[k] for k in expected}, expected)
        self.assertEqual(info["diagnosis"]["open_edges"]["count"], 4)
        done = self.run_quoin("info", "open.off", code=REFUSED)
        self.assertRegex(done.stdout, r"closed +false")
        self.assertIn("4 edges are open", done.stderr)

    def test_one_bad_file_does_not_suppress_the_others(self):
        names = ["a.off", "open.off", "missing.off", "rubbish.off", "b.off"]
        for command in ("info", "check"):
            report = self.json_of(command, *names, code=FILE_TROUBLE)
            self.assertEqual([one["file"] for one in report], names)
            self.assertEqual(["error" in one for one in report], [False, command == "info", True, True, False])
            self.assertEqual(report[2]["exit_code"], FILE_TROUBLE)
            self.assertEqual(report[3]["exit_code"], REFUSED)
            done = self.run_quoin(command, *names, code=FILE_TROUBLE)
            self.assertIn("b.off", done.stdout)
            self.assertIn("missing.off", done.stderr)
        self.assertEqual(len(self.json_of("info", "a.off", "open.off", code=REFUSED)), 2)

    def test_an_overflowing_volume_is_null(self):
        self.write("huge.off", box((0, 0, 0), (1e200, 1e200, 1e200)))
        self.assertIsNone(self.info("huge.off")["volume"])


class Check(CommandTest):
    def test_verdicts(self):
        good = self.json_of("check", "a.off")
        self.assert_keys(good, "file valid findings diagnosis warnings")
        self.assertEqual((good["valid"], good["findings"]), (True, []))
        bad = self.json_of("check", "open.off", code=REFUSED)
        self.assertEqual(bad["valid"], False)
        self.assertTrue(bad["findings"])
        self.assertIn("a.off: a valid solid", self.run_quoin("check", "a.off").stdout)

    def test_exact_text(self):
        self.run_quoin("union", "a.off", "b.off", "-o", "u.qsolid")
        self.assertEqual(self.json_of("check", "u.qsolid")["valid"], True)
        broken = self.read("u.qsolid").decode().replace("\n1 1 2\n", "\n1 1 3\n", 1)
        self.assertNotEqual(broken, self.read("u.qsolid").decode())
        self.write("broken.qsolid", broken)
        self.assertEqual(self.json_of("check", "broken.qsolid", code=REFUSED)["valid"], False)


class Hull(CommandTest):
    def test_counts_and_files(self):
        report = self.json_of("hull", "a.off", "far.off", "-o", "h.off")
        self.assertEqual((report["dimension"], report["points"]), (3, 16))
        self.assertEqual(report["vertices"] - report["edges"] + report["facets"], 2)
        self.assertEqual(self.json_of("check", "h.off")["valid"], True)
        again = self.json_of("hull", "h.off")
        for key in ("vertices", "edges", "facets"):
            self.assertEqual(again[key], report[key])
        self.assertEqual(again["result"]["volume"], report["result"]["volume"])

    def test_points_without_faces(self):
        self.write("points.off", "OFF\n6 0 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n")
        report = self.json_of("hull", "points.off", "-o", "o.off")
        self.assertEqual((report["vertices"], report["edges"], report["facets"]), (6, 12, 8))
        self.assertEqual(report["result"]["volume"], 4 / 3)

    def test_flat_points(self):
        for points, dimension, word in (("0 0 0\n1 0 0\n0 1 0\n1 1 0\n", 2, "plane"), ("0 0 0\n1 1 1\n3 3 3\n", 1, "line"),
                                        ("2 2 2\n2 2 2\n", 0, "place")):
            self.write("flat.off", f"OFF\n{points.count(chr(10))} 0 0\n{points}")
            report = self.json_of("hull", "flat.off")
            self.assertEqual(report["dimension"], dimension)
            self.assertIn(word, report["warnings"][-1])
            self.assertIn(word, self.run_quoin("hull", "flat.off", "-o", "x.off", code=REFUSED).stderr)
            with self.assertRaises(FileNotFoundError):
                self.read("x.off")


class Minkowski(CommandTest):
    def test_boxes(self):
        report = self.json_of("minkowski", "a.off", "b.off", "-o", "s.off", "-o", "s.qsolid")
        self.assertEqual((report["vertices"], report["edges"], report["facets"], report["volume"]), (8, 12, 6, 64))
        for name in ("s.off", "s.qsolid"):
            self.assertEqual(self.json_of("check", name)["valid"], True)

    def test_sums_that_are_no_doubles(self):
        self.write("tiny.off", box((0, 0, 0), (1e-20, 1e-20, 1e-20)))
        report = self.json_of("minkowski", "a.off", "tiny.off", "-o", "s.qsolid")
        self.assertEqual(report["facets"], 6)
        self.assertEqual(self.json_of("check", "s.qsolid")["valid"], True)
        self.assertEqual(self.info("s.qsolid")["vertices"], 8)

    def test_points_and_flat_operands(self):
        self.write("octahedron.off", "OFF\n6 0 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n")
        self.write("square.off", "OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n")
        report = self.json_of("minkowski", "octahedron.off", "a.off")
        self.assertEqual((report["vertices"], report["edges"], report["facets"]), (24, 48, 26))
        self.assertEqual(self.json_of("minkowski", "a.off", "square.off")["volume"], 18)
        flat = self.json_of("minkowski", "square.off", "square.off")
        self.assert_keys(flat, "dimension vertices edges facets warnings")
        self.assertEqual((flat["dimension"], flat["vertices"], flat["edges"], flat["facets"]), (2, 4, 4, 1))
        self.assertIn("plane", flat["warnings"][-1])
        self.assertIn("plane", self.run_quoin("minkowski", "square.off", "square.off", "-o", "x.off", code=REFUSED).stderr)
        self.write("segment.off", "OFF\n2 0 0\n0 0 0\n0 0 3\n")
        self.write("point.off", "OFF\n1 0 0\n5 5 5\n")
        self.assertEqual(self.json_of("minkowski", "square.off", "segment.off")["volume"], 3)
        self.assertEqual(self.json_of("minkowski", "a.off", "point.off")["volume"], 8)
        self.assertEqual(self.json_of("minkowski", "segment.off", "segment.off")["dimension"], 1)
        self.assertEqual(self.json_of("minkowski", "point.off", "point.off")["vertices"], 1)
        self.run_quoin("minkowski", "a.off", code=USAGE)

    def test_many_operands(self):
        self.write("x.off", "OFF\n2 0 0\n0 0 0\n1 0 0\n")
        self.write("y.off", "OFF\n2 0 0\n0 0 0\n0 1 0\n")
        self.write("d.off", "OFF\n2 0 0\n0 0 0\n1 1 1\n")
        self.write("z.off", "OFF\n2 0 0\n0 0 0\n0 0 1\n")
        report = self.json_of("minkowski", "x.off", "y.off", "z.off", "d.off", "-o", "zonotope.off")
        self.assertEqual((report["dimension"], report["vertices"], report["edges"], report["facets"]), (3, 14, 24, 12))
        self.assertEqual(report["volume"], 4)
        self.assertEqual(self.json_of("check", "zonotope.off")["valid"], True)

    def test_exact_vertices(self):
        # Where the third is cut off, two vertices are no doubles.
        self.write("wedge.off", "OFF\n6 0 0\n0 0 0\n3 0 0\n0 1 0\n0 0 4\n3 0 4\n0 1 4\n".replace("6 0 0", "6 5 0") +
                   "3 0 2 1\n3 3 4 5\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 3 5\n")
        self.write("box.off", box((-1, -1, -1), (1, 2, 5)))
        self.run_quoin("intersection", "wedge.off", "box.off", "-o", "cut.qsolid")
        self.assertEqual(self.json_of("hull", "cut.qsolid", "-o", "hull.qsolid")["vertices"], 8)
        self.assertEqual(self.json_of("check", "hull.qsolid")["valid"], True)
        report = self.json_of("minkowski", "cut.qsolid", "cut.qsolid", "-o", "twice.qsolid")
        self.assertEqual((report["vertices"], report["facets"]), (8, 6))
        self.assertAlmostEqual(report["volume"], 8 * self.info("cut.qsolid")["volume"])
        self.assertEqual(self.json_of("distance", "cut.qsolid", "cut.qsolid")["relation"], "overlapping")

    def test_solids_that_are_not_convex(self):
        self.run_quoin("difference", "a.off", "b.off", "-o", "l.off")
        report = self.json_of("minkowski", "l.off", "l.off", "-o", "s.off")
        self.assertEqual(self.json_of("check", "s.off")["valid"], True)
        self.assertEqual(report["dimension"], 3)
        self.assertAlmostEqual(report["volume"], self.info("s.off")["volume"])
        self.write("segment.off", "OFF\n2 0 0\n0 0 0\n0 0 3\n")
        self.assertEqual(self.json_of("minkowski", "segment.off", "l.off", "segment.off")["volume"],
                         self.json_of("minkowski", "l.off", "segment.off", "segment.off")["volume"])
        self.run_quoin("union", "a.off", "far.off", "-o", "two.off")
        self.assertEqual(self.json_of("minkowski", "two.off", "a.off")["result"]["components"], 2)
        self.run_quoin("csg", "!x", "x=a.off", "-o", "all_but.qsolid")
        self.assertIn("unbounded", self.run_quoin("minkowski", "l.off", "all_but.qsolid", code=REFUSED).stderr)

    def test_what_is_found_wrong_is_said_and_no_part_of_the_sum(self):
        self.write("c.off", box((0, 0, 0), (1, 1, 1)))
        self.write("lone.off", off([*corners((0, 0, 0), (1, 1, 1)), (10, 10, 10)], CUBE_FACES))
        two = corners((0, 0, 0), (1, 1, 1)) + corners((5, 0, 0), (6, 1, 1))
        self.write("turned.off", off(two, [*CUBE_FACES, *(tuple(8 + v for v in reversed(f)) for f in CUBE_FACES)]))
        for name, words in (("lone.off", "belong to no face"), ("turned.off", "inside out")):
            for operands in ((name, "c.off"), ("c.off", name)):
                report = self.json_of("minkowski", *operands)
                self.assertEqual(report["volume"], 8)
                self.assertEqual(len(report["warnings"]), 1)
                self.assertIn(words, report["warnings"][0])
                self.assertIn(name, report["warnings"][0])
            self.assertIn(words, self.json_of("distance", name, "far.off")["warnings"][0])

    def test_an_operand_from_a_stream(self):
        cube = box((0, 0, 0), (1, 1, 1))
        self.write("c.off", cube)
        for words in (["-", "c.off"], ["c.off", "-"]):
            report = json.loads(self.run_quoin("minkowski", *words, "--json", stdin=cube).stdout)
            self.assertEqual(report["volume"], 8)

    def test_balls(self):
        outer = self.json_of("minkowski", "a.off", "--ball", "1", "--within", "0.05")["volume"]
        inner = self.json_of("minkowski", "a.off", "--ball", "1", "--within", "0.05", "--inner")["volume"]
        exact = 8 + 24 + 6 * math.pi + 4 / 3 * math.pi
        self.assertLess(inner, exact)
        self.assertLess(exact, outer)
        self.assertLess(outer - inner, 0.1 * 60)
        self.run_quoin("minkowski", "a.off", "--inner", "a.off", code=USAGE)
        self.run_quoin("minkowski", "a.off", "--ball", "-1", code=USAGE)
        self.run_quoin("erode", "a.off", "b.off", "--ball", "1", code=USAGE)
        self.assertIn("millionth", self.run_quoin("erode", "a.off", "--ball", "1", "--within", "1e-9", code=REFUSED).stderr)


class Erode(CommandTest):
    def test_boxes(self):
        self.write("small.off", box((0, 0, 0), (0.5, 0.5, 1)))
        report = self.json_of("erode", "a.off", "small.off", "-o", "rest.qsolid")
        self.assertEqual((report["volume"], report["facets"]), (2.25, 6))
        self.assertEqual(self.info("rest.qsolid")["bounds"], [[0, 0, 0], [1.5, 1.5, 1]])
        self.assertIn("empty", self.json_of("erode", "a.off", "b.off")["warnings"][-1])
        self.write("segment.off", "OFF\n2 0 0\n0 0 0\n0 0 1\n")
        self.assertEqual(self.json_of("erode", "a.off", "segment.off")["volume"], 4)
        self.assertIn("bound no solid", self.run_quoin("erode", "segment.off", "a.off", code=REFUSED).stderr)
        self.assertAlmostEqual(self.json_of("erode", "a.off", "--ball", "0.5", "--inner")["volume"], 1, delta=0.1)


class Decompose(CommandTest):
    def test_pieces(self):
        self.run_quoin("difference", "a.off", "b.off", "-o", "l.off")
        report = self.json_of("decompose", "l.off", "-o", "piece.off", "-o", "piece.qsolid")
        self.assert_keys(report, "seconds pieces lower_bound notches cuts volumes outputs warnings")
        self.assertGreaterEqual(report["pieces"], report["lower_bound"])
        self.assertEqual(len(report["outputs"]), 2 * report["pieces"])
        names = [f"piece-{i + 1}.off" for i in range(report["pieces"])]
        for name in names:
            self.assertEqual(self.json_of("minkowski", name, name)["dimension"], 3)
        self.run_quoin("union", *names, "-o", "again.off")
        self.assertEqual(self.json_of("csg", "x ^ y", "x=again.off", "y=l.off")["result"]["faces"], 0)
        self.assertEqual(self.json_of("decompose", "a.off")["pieces"], 1)
        self.run_quoin("decompose", "l.off", "-o", "-", code=USAGE)


class Distance(CommandTest):
    def test_relations(self):
        apart = self.json_of("distance", "a.off", "far.off")
        self.assert_keys(apart, "relation squared_distance exact_squared_distance distance witness exact_witness warnings")
        self.assertEqual((apart["relation"], apart["squared_distance"]), ("apart", 147))
        self.assertEqual(apart["witness"], [[2, 2, 2], [9, 9, 9]])
        inside = self.json_of("distance", "a.off", "b.off")
        self.assertEqual((inside["relation"], inside["squared_penetration"]), ("overlapping", 1))
        touching = self.json_of("distance", "a.off", "b.off", "--translate", "-1,1/2,0")
        self.assertEqual((touching["relation"], touching["squared_distance"]), ("touching", 0))
        third = self.json_of("distance", "a.off", "far.off", "--translate", "1/3,0,0")
        self.assertEqual(third["exact_squared_distance"], "1282/9")
        self.assertEqual(third["exact_witness"][0], ["7/3", "2", "2"])
        self.write("point.off", "OFF\n1 0 0\n5 5 5\n")
        self.write("segment.off", "OFF\n2 0 0\n5 0 0\n5 0 9\n")
        self.assertEqual(self.json_of("distance", "point.off", "segment.off")["squared_distance"], 25)
        self.assertEqual(self.json_of("distance", "point.off", "point.off")["relation"], "touching")
        self.assertEqual((touching["contact"], touching["grazing"]), (["face", "face"], False))
        corner = self.json_of("distance", "a.off", "b.off", "--translate", "-1,3,-1")
        self.assertEqual((corner["relation"], corner["contact"], corner["grazing"]), ("touching", ["vertex", "vertex"], True))
        # By what is no double: 1/3 further than where they touch.
        exact = self.json_of("distance", "a.off", "b.off", "--translate", "-4/3,0,0")
        self.assertEqual((exact["relation"], exact["exact_squared_distance"]), ("apart", "1/9"))
        self.assertEqual(exact["exact_witness"][0][0], "2/3")
        self.run_quoin("distance", "a.off", "b.off", "--translate", "1,2", code=USAGE)
        self.assertRegex(self.run_quoin("distance", "a.off", "far.off").stdout, r"relation +apart\n")

    def test_solids_that_are_not_convex(self):
        # A hollow box, one in its cavity, and a frame with something through its hole.
        self.write("big.off", box((0, 0, 0), (10, 10, 10)))
        self.write("cavity.off", box((1, 1, 1), (9, 9, 9)))
        self.run_quoin("difference", "big.off", "cavity.off", "-o", "hollow.qsolid")
        self.write("inner.off", box((4, 4, 4), (6, 6, 7)))
        inside = self.json_of("distance", "hollow.qsolid", "inner.off")
        self.assertEqual((inside["relation"], inside["exact_squared_distance"]), ("apart", "4"))
        self.assertEqual([p[2] for p in inside["witness"]], [9, 7])
        down = self.json_of("distance", "inner.off", "hollow.qsolid", "--translate", "0,0,-3")
        self.assertEqual((down["relation"], down["witness"][0][2]), ("touching", 1))
        through = self.json_of("distance", "hollow.qsolid", "inner.off", "--translate", "0,0,7/2")
        self.assertEqual(through["relation"], "overlapping")
        self.assertNotIn("witness", through)
        self.assertEqual(self.json_of("distance", "big.off", "inner.off")["relation"], "overlapping")
        self.run_quoin("union", "a.off", "b.off", "far.off", "-o", "pieces.off")
        apart = self.json_of("distance", "pieces.off", "pieces.off", "--translate", "4,4,4")
        self.assertEqual(apart["exact_squared_distance"], "3")
        self.run_quoin("difference", "a.off", "a.off", "-o", "nothing.qsolid")
        self.assertIn("empty", self.run_quoin("distance", "a.off", "nothing.qsolid", code=REFUSED).stderr)

    def test_points_that_mean_their_hull(self):
        self.write("square.off", "OFF\n4 0 0\n0 0 5\n2 0 5\n2 2 5\n0 2 5\n")
        self.assertEqual(self.json_of("distance", "a.off", "square.off")["squared_distance"], 9)
        self.run_quoin("union", "a.off", "b.off", "-o", "u.off")
        self.assertIn("in a plane", self.run_quoin("distance", "u.off", "square.off", code=REFUSED).stderr)

    def test_directions(self):
        inside = self.json_of("distance", "a.off", "b.off", "--direction", "-2,0,0")
        self.assertEqual(inside["exact_directional_penetration"], "1/2")
        self.assertEqual(self.json_of("distance", "a.off", "b.off", "--direction", "0,3,0")["directional_penetration"], 1)
        self.assertEqual(self.json_of("distance", "a.off", "far.off", "--direction", "1,0,0")["directional_penetration"], 0)
        self.run_quoin("union", "a.off", "b.off", "-o", "u.off")
        deep = self.json_of("distance", "u.off", "a.off", "--direction", "1,0,0")
        self.assertEqual((deep["relation"], deep["squared_penetration"]), ("overlapping", 4))
        moved = f"{deep['exact_directional_penetration']},0,0"
        self.assertEqual(self.json_of("distance", "u.off", "a.off", "--translate", moved)["relation"], "touching")
        self.run_quoin("csg", "!x", "x=a.off", "-o", "all_but.qsolid")
        self.assertIn("bounded", self.run_quoin("distance", "u.off", "all_but.qsolid", "--direction", "1,0,0", code=REFUSED).stderr)
        # No doubles: by the sum of the two.
        third = self.json_of("distance", "a.off", "b.off", "--direction", "-1/3,0,0")
        self.assertEqual(third["exact_directional_penetration"], "3")
        moved = self.json_of("distance", "a.off", "b.off", "--translate", "1/3,0,0", "--direction", "-1,0,0")
        self.assertEqual(moved["exact_directional_penetration"], "4/3")
        for wrong in ("0,0,0", "1,2", "x,0,0"):
            self.run_quoin("distance", "a.off", "b.off", "--direction", wrong, code=USAGE)

    def test_paths(self):
        # Down onto b, along its top, off the edge, and into far.off from above; pieces are in the order of the file.
        self.run_quoin("union", "b.off", "far.off", "-o", "two.off")
        self.write("path.txt", "# places\n0 0 4\n0,0,3\n\n2 0 3\n8 0 3\n8 8 12\n8 8 8\n")
        report = self.json_of("distance", "a.off", "two.off", "--path", "path.txt", "-o", "trail.svg")
        self.assert_keys(report, "steps events between nearest_step outputs warnings")
        self.assertEqual([s["relation"] for s in report["steps"]],
                         ["apart", "touching", "touching", "apart", "apart", "overlapping"])
        self.assertEqual([s["exact_squared_distance"] for s in report["steps"][:4]], ["1", "0", "0", "25"])
        self.assertEqual(report["steps"][1]["contact"], ["face", "face"])
        self.assertEqual(report["nearest_step"], 0)
        events = [(e["leg"], e["relation"], e["exact_enter"], e["exact_leave"], e["continues"]) for e in report["events"]]
        self.assertEqual(events, [(0, "touching", "1", "1", False), (1, "touching", "0", "1", True),
                                  (2, "touching", "0", "1/6", True), (4, "overlapping", "1/2", "1", False)])
        self.assertEqual(report["events"][2]["to"], [3, 0, 3])
        self.assertEqual([e["pieces"][1] for e in report["events"]][-1], 1)
        drawing = self.read("trail.svg").decode()
        self.assertEqual(xml.etree.ElementTree.fromstring(drawing).tag, "{http://www.w3.org/2000/svg}svg")
        self.assertEqual(drawing.count('class="place'), 6)
        text = self.run_quoin("distance", "a.off", "two.off", "--path", "-", stdin="0 0 3\n").stdout
        self.assertIn("0: at [0.0,0.0,3.0] touching, face on face", text)
        self.assertTrue(self.run_quoin("distance", "a.off", "two.off", "--path", "path.txt", "-o", "-").stdout.startswith("<svg"))

    def test_paths_of_solids_that_are_not_convex(self):
        self.run_quoin("union", "a.off", "b.off", "-o", "u.off")
        self.write("path.txt", "1/3 0 9\n0 0 7\n0 0 6\n")
        report = self.json_of("distance", "u.off", "far.off", "--path", "path.txt", "-o", "trail.svg")
        self.assertEqual([s["exact_squared_distance"] for s in report["steps"]], ["613/9", "72", "72"])
        self.assertFalse(report["between"])
        self.assertNotIn("events", report)
        self.assertIn("<svg", self.read("trail.svg").decode())

    def test_mistakes_of_paths(self):
        self.write("path.txt", "0 0 4\n0 0\n")
        self.assertIn("path.txt:2", self.run_quoin("distance", "a.off", "b.off", "--path", "path.txt", code=REFUSED).stderr)
        self.write("path.txt", "# nothing\n")
        self.assertIn("no places", self.run_quoin("distance", "a.off", "b.off", "--path", "path.txt", code=REFUSED).stderr)
        self.run_quoin("distance", "a.off", "b.off", "--path", "missing.txt", code=FILE_TROUBLE)
        for words in (["-o", "trail.svg"], ["--path", "path.txt", "-o", "trail.off"],
                      ["--path", "path.txt", "--translate", "1,0,0"], ["--path", "path.txt", "--direction", "1,0,0"]):
            self.run_quoin("distance", "a.off", "b.off", *words, code=USAGE)
        self.write("path.txt", "0 0 4\n")
        self.run_quoin("distance", "a.off", "b.off", "--path", "path.txt", "-o", "no/folder.svg", code=FILE_TROUBLE)
        # What cannot be drawn leaves a file as it was, and prints no part.
        self.write("trail.svg", "before")
        self.write("path.txt", "1e308 0 0\n-1e308 0 0\n")
        for target in ("trail.svg", "-"):
            done = self.run_quoin("distance", "a.off", "b.off", "--path", "path.txt", "-o", target, code=REFUSED)
            self.assertIn("too large for a drawing", done.stderr)
            self.assertEqual(done.stdout, "")
        self.assertEqual(self.read("trail.svg"), b"before")

    def test_width(self):
        self.write("slab.off", box((0, 0, 0), (3, 5, 0.5)))
        report = self.json_of("width", "slab.off")
        self.assertEqual((report["width"], report["exact_squared_width"]), (0.5, "1/4"))
        self.assert_keys(report["ball"], "radius squared_radius exact_squared_radius center exact_center witness")
        self.assertEqual((report["ball"]["exact_squared_radius"], report["ball"]["center"]), ("137/16", [1.5, 2.5, 0.25]))
        self.assertEqual(sorted(len(face) for face in report["witness"]), [4, 4])
        self.write("segment.off", "OFF\n2 0 0\n5 0 0\n5 0 9\n")
        flat = self.json_of("width", "segment.off")
        self.assertEqual((flat["width"], flat["diameter"]), (0, 9))
        self.assertEqual((report["exact_squared_diameter"], len(report["diameter_witness"])), ("137/4", 2))

    def test_ball_of_rational_vertices(self):
        # The prism over (1, 0), (3, 0), (1, 2/3), of height 4: the ball is that of a box with the right angle in a corner.
        self.write("wedge.off", "OFF\n6 5 0\n0 0 0\n3 0 0\n0 1 0\n0 0 4\n3 0 4\n0 1 4\n"
                   "3 0 2 1\n3 3 4 5\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 3 5\n")
        self.write("box.off", box((1, -1, -1), (4, 2, 5)))
        self.run_quoin("intersection", "wedge.off", "box.off", "-o", "cut.qsolid")
        report = self.json_of("width", "cut.qsolid")
        self.assertEqual(report["warnings"], [])
        self.assertEqual(report["ball"]["exact_squared_radius"], "46/9")
        self.assertEqual(report["ball"]["exact_center"], ["2", "1/3", "2"])
        self.assertIn(len(report["ball"]["witness"]), (2, 3, 4))


class GaussianMap(CommandTest):
    def test_counts_and_page(self):
        report = self.json_of("gaussian-map", "a.off")
        self.assertEqual((report["vertices"], report["edges"], report["faces"]), (6, 12, 8))
        self.assertEqual(report["polytope"], {"vertices": 8, "edges": 12, "facets": 6})
        self.run_quoin("gaussian-map", "a.off", "-o", "map.qarr", code=USAGE)
        self.run_quoin("gaussian-map", "a.off", "--labels", "-o", "map.svg")
        flat = self.read("map.svg").decode()
        self.assertIn("vertex 0 at [0.0,0.0,0.0]", flat)
        self.assertEqual(flat, self.run_quoin("gaussian-map", "a.off", "--labels", "-q", "-o", "-").stdout)
        done = self.run_quoin("gaussian-map", "a.off", "-o", "map.html", code=None)
        if "was not built" in done.stderr:
            return
        self.assertEqual(done.returncode, DONE)
        self.assertIn(b"vertex 0 at [0.0,0.0,0.0]", self.read("map.html"))

    def test_on_the_cube(self):
        self.write("octahedron.off", "OFF 6 0 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n")
        report = self.json_of("gaussian-map", "octahedron.off", "--cube")
        self.assertEqual((report["vertices"], report["edges"], report["faces"]), (24, 24, 12))
        self.assertEqual(report["polytope"], {"vertices": 6, "edges": 12, "facets": 8})
        self.assertEqual(report["squares"][5], {"vertices": 4, "edges": 4, "faces": 2, "square": "z = 1"})
        done = self.run_quoin("gaussian-map", "a.off", "--cube", "--labels", "-o", "cube.svg")
        self.assertRegex(done.stdout, r"square y = -1 +9 vertices, 12 edges, 5 faces\n")
        drawing = self.read("cube.svg").decode()
        self.assertEqual(drawing.count('class="strong"'), 24)
        self.assertIn("vertex 7 at [", drawing)
        self.assertIn(">y = -1</text>", drawing)
        self.run_quoin("gaussian-map", "a.off", "--cube", "-o", "cube.off", code=USAGE)
        self.write("line.off", "OFF 3 0 0\n0 0 0\n1 1 1\n2 2 2\n")
        self.assertIn("line.off", self.run_quoin("gaussian-map", "--cube", "line.off", code=REFUSED).stderr)

    def test_curves_on_the_sphere_as_a_flat_picture(self):
        self.write("curves.txt", "circle 0 0 1\narc 1 0 0 0 0 1\n")
        self.run_quoin("arrange", "--sphere", "curves.txt", "-o", "flat.svg")
        drawing = self.read("flat.svg").decode()
        self.assertEqual(drawing.count("<title>Face "), 2)
        self.assertIn("<title>Vertex 2", drawing)


class Classify(CommandTest):
    def test_points(self):
        report = self.json_of("classify", "--point", "1,1,1", "a.off", "--point", "0,1,1", "--point", "0,0,1", "--point",
                              "0,0,0", "--point", "-1,0,0", "--point", "1/3,1/3,2")
        self.assert_keys(report, "file points lines warnings")
        self.assertEqual([p["place"] for p in report["points"]],
                         ["in", "on face", "on edge", "on vertex", "out", "on face"])
        self.assert_keys(report["points"][1], "point place face origin")
        self.assertIn("edge", report["points"][2])
        self.assertIn("vertex", report["points"][3])
        self.assertEqual(self.run_quoin("classify", "a.off", "--point", "1,1,1").stdout, "1,1,1: in\n")

    def test_lines(self):
        line = self.json_of("classify", "--line", "-1,1,1,1,0,0", "--line", "5,5,5,1,0,0", "a.off")["lines"][0]
        self.assertEqual(line["pieces"], ["out", "in", "out"])
        self.assertEqual([e["parameter"] for e in line["events"]], [1, 3])
        self.assert_keys(line["events"][0], "parameter exact_parameter point place face origin")

    def test_points_of_a_file_and_of_a_stream(self):
        self.write("points.txt", "# a comment\n1 1 1\n\n3,3,3\r\n")
        from_file = self.run_quoin("classify", "a.off", "--points", "points.txt").stdout
        self.assertEqual(from_file, "1 1 1: in\n3,3,3: out\n")
        self.assertEqual(self.run_quoin("classify", "a.off", "--points", "-", stdin="1 1 1\n3,3,3\n").stdout, from_file)
        self.write("points.txt", "1 1 1\n1 1\n")
        self.assertIn("points.txt:2", self.run_quoin("classify", "a.off", "--points", "points.txt", code=REFUSED).stderr)
        self.run_quoin("classify", "a.off", "--points", "missing.txt", code=FILE_TROUBLE)

    def test_malformed_queries(self):
        for words in ((), ("--point", "1,2"), ("--point", "1,2,x"), ("--point", "1,2,nan"), ("--point", "1,2,1/0"),
                      ("--line", "1,2,3"), ("--line", "1,2,3,0,0,0")):
            self.run_quoin("classify", "missing.off", *words, code=USAGE)


class Section(CommandTest):
    def test_report(self):
        report = self.json_of("section", "--plane", "0,0,1,1", "-o", "cut.svg", "-o", "CUT.SVG", "a.off")
        self.assert_keys(report, "file plane area unbounded loops exact_loops outputs rounding max_displacement seconds "
                                 "threads result warnings")
        self.assertEqual((report["area"], len(report["loops"][0]), report["outputs"]), (4, 4, ["cut.svg", "CUT.SVG"]))
        self.assertEqual(report["result"], {"area": 4, "loops": 1, "corners": 4, "unbounded": False})
        self.assertEqual(self.read("cut.svg"), self.read("CUT.SVG"))
        self.assertIn(b"<path", self.read("cut.svg"))
        self.assertEqual(self.json_of("section", "a.off", "--plane", "0,0,1,1")["rounding"], "exact")
        self.assertIn(report["rounding"], ("exact", "accepted"))

    def test_the_drawing_as_a_stream(self):
        done = self.run_quoin("section", "a.off", "--plane", "0,0,1,1", "-o", "-", "--json")
        self.assertTrue(done.stdout.startswith("<svg"))
        self.assertEqual(json.loads(done.stderr)["area"], 4)

    def test_refusals_come_before_reading(self):
        for words in (("--plane", "0,0,1"), ("--plane", "0,0,0,1"), ("--plane", "a,b,c,d"), (),
                      ("--plane", "0,0,1,1", "-o", "x.html"), ("--plane", "0,0,1,1", "-o", "x.off")):
            self.run_quoin("section", "missing.off", *words, code=USAGE)


class Interfere(CommandTest):
    def test_pairs(self):
        self.write("touch.off", box((2, 0, 0), (3, 1, 1)))
        report = self.json_of("interfere", "a.off", "b.off", "far.off", "touch.off")
        self.assert_keys(report, "pairs warnings")
        found = {(p["a"], p["b"]): (p["interference"], p["common_volume"]) for p in report["pairs"]}
        self.assertEqual(len(found), 6)
        self.assertEqual(found["a.off", "b.off"], ("overlapping", 1))
        self.assertEqual(found["a.off", "far.off"], ("apart", 0))
        self.assertEqual(found["a.off", "touch.off"], ("touching", 0))
        self.run_quoin("interfere", "a.off", code=USAGE)
        self.assertEqual(self.run_quoin("interfere", "a.off", "b.off", code=DONE).stdout, "a.off b.off: overlapping\n")


if __name__ == "__main__":
    main()
