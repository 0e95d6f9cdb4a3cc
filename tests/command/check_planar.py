# SPDX-License-Identifier: Apache-2.0
"""Commands of the plane: arrange, overlay, locate, polygon.

    check_planar.py QUOIN
"""
import json
import math
import os
import subprocess
import unittest

from command import FILE_TROUBLE, OUT_OF_TIME, REFUSED, USAGE, CommandTest, main

COUNTS = "vertices edges faces components isolated_vertices unbounded_faces"
SQUARE = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
SHIFTED = "POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))"
FAR = "POLYGON ((9 9, 10 9, 10 10, 9 9))"
FRAME = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 3 1, 3 3, 1 3, 1 1))"
BOW = "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))"
DISC = "CURVEPOLYGON (CIRCULARSTRING (0 0, 2 0, 0 0))"
CROSS = "MULTILINESTRING ((0 0, 2 2), (0 2, 2 0))"
RIGHT_ANGLED = "POLYGON ((0 0, 4 0, 4 3, 0 0))"
COMMANDS = {"arrange": ["a.wkt"], "overlay": ["a.wkt", "b.wkt"], "locate": ["a.wkt", "--point", "1,1"],
            "polygon": ["union", "a.wkt", "b.wkt"]}


class PlanarTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("a.wkt", SQUARE + "\n")
        self.write("b.wkt", SHIFTED + "\n")
        self.write("cross.wkt", CROSS)
        self.write("bad.wkt", "POINT (1 1)\nPOLYGON ((0 0, 1 0, 1 1))")

    def has_pages(self):
        return "was not built" not in self.run_quoin("arrange", "a.wkt", "-o", "page.html", code=None).stderr

    def polygon(self, *words, **more):
        return self.json_of("polygon", *words, **more)

    def assert_holds(self, report, **expected):
        self.assertEqual({k: report.get(k) for k in expected}, expected)


class Arrange(PlanarTest):
    def test_counts(self):
        report = self.json_of("arrange", "cross.wkt")
        self.assert_keys(report, COUNTS + " curves warnings")
        self.assert_holds(report, vertices=5, edges=4, faces=1, components=1, curves=2, warnings=[])
        self.assert_holds(self.json_of("arrange", "a.wkt", "b.wkt"), vertices=10, edges=12, faces=4, components=1)
        self.assert_holds(self.json_of("arrange", "a.wkt", "POINT (1 1)"), vertices=5, isolated_vertices=1,
                          components=2)
        self.assert_holds(self.json_of("arrange", "CIRCULARSTRING (0 0, 2 0, 0 0)", "LINESTRING (1 0, 3 0)"), faces=2,
                          curves=2)
        self.assertIn("5 vertices, 4 edges, 1 faces", self.run_quoin("arrange", "cross.wkt").stdout)

    def test_nothing_is_an_arrangement(self):
        self.write("empty.wkt", "")
        self.write("empty.geojson", '{"type": "FeatureCollection", "features": []}')
        for name in ("empty.wkt", "empty.geojson", "POLYGON EMPTY", "-"):
            report = self.json_of("arrange", name, stdin="")
            self.assert_holds(report, vertices=0, edges=0, faces=1, components=0)
            self.assertEqual(len(report["warnings"]), 1, name)

    def test_pictures(self):
        done = self.run_quoin("arrange", "cross.wkt", "-o", "-", "--labels")
        self.assertTrue(done.stdout.startswith("<svg") or done.stdout.startswith("<?xml"), done.stdout[:40])
        self.assertIn("5 vertices", done.stderr)
        self.run_quoin("arrange", "cross.wkt", "-o", "c.svg", "--labels")
        self.assertEqual(self.read("c.svg").decode(), done.stdout)
        if self.has_pages():
            self.run_quoin("arrange", "cross.wkt", "-o", "c.html")
            self.assertIn(b"<html", self.read("c.html"))
        else:
            self.run_quoin("arrange", "missing.wkt", "-o", "c.html", code=REFUSED)


class Overlay(PlanarTest):
    def test_sources_and_cells(self):
        report = self.json_of("overlay", "a.wkt", "b.wkt")
        self.assert_holds(report, vertices=10, edges=12, faces=4)
        self.assertEqual([source["vertices"] for source in report["sources"]], [4, 4])
        self.assert_holds(report["cells"], crossing=2, overlap=0, vertex_in_face=4, face_around_vertex=4, face=4,
                          vertex_on_vertex=0, vertex_on_edge=0, edge_on_vertex=0, edge_in_face=6,
                          face_around_edge=6)
        self.assertNotIn("cells", self.json_of("overlay", "a.wkt", "b.wkt", FAR))
        self.assert_holds(self.json_of("overlay", "a.wkt", "a.wkt")["cells"], overlap=4, vertex_on_vertex=4, face=2)

    def test_labels_are_the_faces_of_the_sources(self):
        svg = self.run_quoin("overlay", "a.wkt", "b.wkt", "-o", "-", "--labels").stdout
        for label in (">0/1<", ">1/0<", ">1/1<"):
            self.assertIn(label, svg)


class Locate(PlanarTest):
    def test_cells(self):
        report = self.json_of("locate", "cross.wkt", "--point", "1,1", "--point", "0.5,1/2", "--point", "9,9")
        cells = [p["cell"] for p in report["points"]]
        self.assertEqual(cells, ["vertex", "edge", "face"])
        self.assertEqual(report["points"][1]["curves"], ["multilinestring 1, linestring 1"])
        self.assertEqual(report["points"][2]["unbounded"], True)
        report = self.json_of("locate", "a.wkt", "b.wkt", "--point", "4,1", "--point", "3,3")
        self.assertEqual(report["points"][0]["curves"], ["a.wkt: polygon 1, ring 1"])
        self.assertEqual(report["points"][1]["unbounded"], False)

    def test_fractions_are_exact(self):
        for point, cell in (("1/3,1/3", "edge"), ("1/3,0.3333333333333333", "face")):
            self.assertEqual(self.json_of("locate", "cross.wkt", "--point", point)["points"][0]["cell"], cell)

    def test_points_from_a_file(self):
        self.write("p.txt", "# two\n1,1\n\n9 9\n")
        for words, stdin in ((["p.txt"], None), (["-"], "1,1\n9,9\n")):
            done = self.run_quoin("locate", "cross.wkt", "--points", *words, stdin=stdin)
            self.assertRegex(done.stdout, r"^1,1: vertex \d+\n9.9: face 0\n$")
        self.write("p.txt", "1,1\n1,x\n")
        self.assertIn("p.txt:2", self.run_quoin("locate", "a.wkt", "--points", "p.txt", code=REFUSED).stderr)
        self.run_quoin("locate", "a.wkt", "--points", "missing.txt", code=FILE_TROUBLE)

    def test_mistakes(self):
        for words in ([], ["--point", "1"], ["--point", "1,2,3"], ["--point", "1,nan"], ["--point"]):
            self.run_quoin("locate", "missing.wkt", *words, code=USAGE)


class Polygon(PlanarTest):
    def test_operations(self):
        for operation, area, polygons in (("union", 28, 1), ("intersection", 4, 1), ("difference", 12, 1),
                                          ("xor", 24, 2)):
            report = self.polygon(operation, "a.wkt", "b.wkt")
            self.assert_keys(report, "unbounded vertices edges isolated_vertices warnings")
            self.assert_holds(report, operation=operation, area=area, exact_area=str(area), polygons=polygons)
        self.assert_holds(self.polygon("difference", "a.wkt", "b.wkt", FAR), area=12)
        self.assert_holds(self.polygon("union", "a.wkt"), area=16)

    def test_exact_areas_are_given_where_they_are_short(self):
        self.assert_holds(self.polygon("union", "POLYGON ((0 0, 0.1 0, 0 0.1, 0 0))"), area=0.005000000000000001)
        ring = [(math.cos(i * math.pi / 1500), math.sin(i * math.pi / 1500)) for i in range(3000)]
        wheel = "POLYGON ((" + ", ".join(f"{x!r} {y!r}" for x, y in ring + ring[:1]) + "))"
        report = self.polygon("intersection", wheel, "POLYGON ((0 0, 2 1, 1 2, 0 0))")
        self.assertNotIn("exact_area", report)
        self.assertAlmostEqual(report["area"], math.atan(0.75) / 2, places=5)

    def test_rings_that_doubles_cannot_hold(self):
        sliver = "POLYGON ((0 1000, 3 1001, 3 1001.0000000000001, 0 1000))"
        strip = "POLYGON ((0.25 0, 0.375 0, 0.375 2000, 0.25 2000, 0.25 0))"
        report = self.polygon("intersection", sliver, strip, "-o", "t.wkt")
        self.assert_holds(report["rounding"], vanished_rings=1)
        self.assertIn("a ring is too thin to be written in doubles", report["warnings"])
        self.assertEqual(self.read("t.wkt"), b"POLYGON EMPTY\n")

    def test_standard_output_is_one_geometry(self):
        def out(*words):
            return self.run_quoin("polygon", *words, "-o", "-").stdout
        self.assertEqual(out("union", "a.wkt"), SQUARE + "\n")
        self.assertEqual(out("difference", "a.wkt", "a.wkt"), "POLYGON EMPTY\n")
        self.assertEqual(out("union", FAR, "a.wkt"),
                         "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((9 9, 10 9, 10 10, 9 9)))\n")
        text = out("union", FAR, DISC)
        self.assertTrue(text.startswith("MULTISURFACE (CURVEPOLYGON (CIRCULARSTRING (") and text.count("\n") == 1, text)
        self.assert_holds(self.polygon("union", text), polygons=2)
        self.assertEqual(json.loads(out("difference", "a.wkt", "a.wkt", "--format", "geojson"))["features"], [])
        self.assertEqual(len(json.loads(out("xor", "a.wkt", "b.wkt", "--format", "geojson"))["features"]), 2)

    def test_files_hold_what_standard_output_does(self):
        for ending in ("wkt", "geojson", "dxf", "svg"):
            self.run_quoin("polygon", "union", "a.wkt", "b.wkt", "-o", f"u.{ending}")
            done = self.run_quoin("polygon", "union", "a.wkt", "b.wkt", "-o", "-", "--format", ending)
            self.assertEqual(self.read(f"u.{ending}").decode(), done.stdout, ending)
            if ending != "svg":
                self.assert_holds(self.polygon("union", f"u.{ending}"), exact_area="28")

    def test_fill_rules(self):
        done = self.run_quoin("polygon", "union", BOW, code=REFUSED)
        self.assertIn("WKT argument 1: polygon 1, ring 1 crosses itself near (1, 1)", done.stderr)
        self.assert_holds(self.polygon("union", BOW, "--fill", "even-odd"), area=2, polygons=2)
        self.assert_holds(self.polygon("union", BOW, "--fill", "nonzero"), area=2)
        self.assert_holds(self.polygon("union", BOW, "--fill", "positive"), area=1, polygons=1)
        self.run_quoin("polygon", "union", "missing.wkt", "--fill", "odd", code=USAGE)

    def test_files_that_state_a_rule_are_read_by_it(self):
        nested = "M0 0H6V6H0Z M2 2H4V4H2Z"
        apart = "M0 0H2V2H0Z M5 0H7V2H5Z"
        for path, rule, polygons, area in ((nested, "", 1, 36), (nested, "nonzero", 1, 36), (nested, "evenodd", 1, 32),
                                           (apart, "", 2, 8), (apart, "evenodd", 2, 8)):
            style = f' fill-rule="{rule}"' if rule else ""
            self.write("a.svg", f'<svg xmlns="http://www.w3.org/2000/svg"><path{style} d="{path}"/></svg>')
            report = json.loads(self.run_quoin("polygon", "union", "a.svg", "--json").stdout)
            self.assertEqual((report["polygons"], report["area"]), (polygons, area), (path, rule))
        self.write("a.svg", f'<svg xmlns="http://www.w3.org/2000/svg"><path d="{nested}"/></svg>')
        report = json.loads(self.run_quoin("polygon", "union", "a.svg", "--fill", "even-odd", "--json").stdout)
        self.assertEqual(report["area"], 32)

    def test_arcs(self):
        report = self.polygon("union", DISC)
        self.assertAlmostEqual(report["area"], math.pi, delta=report["area_error"])
        self.assertNotIn("exact_area", report)
        done = self.run_quoin("polygon", "union", DISC, "-o", "-", "--format", "geojson", code=REFUSED)
        self.assertEqual(done.stdout, "")
        done = self.run_quoin("polygon", "union", DISC, "-o", "-", "--format", "geojson", "--flatten", "0.01")
        ring = json.loads(done.stdout)["features"][0]["geometry"]["coordinates"][0]
        self.assertGreater(len(ring), 20)
        self.assertIn("standard output: paths with arcs are flattened", done.stderr)

    def test_plain(self):
        touching = ["intersection", "a.wkt", "POLYGON ((4 0, 8 0, 8 4, 4 4, 4 0))"]
        self.assert_holds(self.polygon(*touching), polygons=0, edges=0, vertices=0)
        report = self.polygon(*touching, "--plain")
        self.assert_holds(report, polygons=0, edges=1, vertices=2)
        self.assertEqual(len(report["warnings"]), 1)

    def test_what_encloses_nothing(self):
        report = self.polygon("union", "a.wkt", "MULTIPOINT ((1 1), (2 2))")
        self.assert_holds(report, area=16)
        self.assertEqual(report["warnings"],
                         [f"WKT argument 2: multipoint 1, point {i} encloses nothing" for i in (1, 2)])
        for words in (["union", "POINT (1 1)"], ["xor", "LINESTRING (0 0, 1 1)", "POINT (1 1)"],
                      ["minkowski", "POINT (1 1)", "a.wkt"], ["offset", "POINT (1 1)", "--distance", "1"]):
            report = self.polygon(*words)
            self.assert_holds(report, polygons=0, area=0)
            self.assertIn("the result is empty", report["warnings"])


class Minkowski(PlanarTest):
    def test_sums(self):
        report = self.polygon("minkowski", "a.wkt", "POLYGON ((0 0, 1 0, 0 1, 0 0))")
        self.assert_keys(report, "polygons vertices edges holes new_holes vanished_holes")
        self.assert_holds(report, exact_area="49/2", area=24.5, vertices=5, edges=5, holes=0)
        self.assertNotIn("slits", report)
        self.assert_holds(self.polygon("minkowski", FRAME, "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"), holes=1,
                          new_holes=0, vanished_holes=0, exact_area="24")
        self.assert_holds(self.polygon("minkowski", "-", "a.wkt", stdin=SQUARE), exact_area="64")

    def test_a_file_is_one_set(self):
        both = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((9 0, 10 0, 10 1, 9 1, 9 0)))"
        self.assert_holds(self.polygon("minkowski", both, "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"), polygons=2, area=8)

    def test_tight_places(self):
        report = self.polygon("minkowski", FRAME, "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))", "--tight")
        self.assert_holds(report, exact_area="36", vanished_holes=1, slits=0, isolated_points=1)
        self.assertEqual(report["tight"], {"segments": [], "points": [[3, 3]]})
        report = self.polygon("minkowski", FRAME, "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))", "--tight")
        self.assert_holds(report, slits=1, isolated_points=0)
        self.assertEqual(report["tight"]["segments"], [[[3, 2], [3, 3]]])
        for more in ([], ["--tight"]):
            self.run_quoin("polygon", "minkowski", FRAME, "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))", *more, "-o",
                           f"t{len(more)}.svg")
        self.assertNotEqual(self.read("t0.svg"), self.read("t1.svg"))

    def test_reflected(self):
        words = ["minkowski", SQUARE, "POLYGON ((0 0, 1 0, 0 1, 0 0))"]
        one = self.run_quoin("polygon", *words, "-o", "-").stdout
        two = self.run_quoin("polygon", *words, "--reflect", "-o", "-").stdout
        self.assertEqual(one, "POLYGON ((0 0, 5 0, 5 4, 4 5, 0 5, 0 0))\n")
        self.assertEqual(two, "POLYGON ((-1 0, 0 -1, 4 -1, 4 4, -1 4, -1 0))\n")

    def test_refusals(self):
        done = self.run_quoin("polygon", "minkowski", "a.wkt", DISC, code=REFUSED)
        self.assertIn("WKT argument 2: curvepolygon 1 has arcs", done.stderr)
        self.run_quoin("polygon", "minkowski", "a.wkt", BOW, code=REFUSED)
        self.assert_holds(self.polygon("minkowski", "a.wkt", BOW, "--fill", "even-odd"), polygons=1)
        for words in (["missing.wkt"], ["missing.wkt"] * 3, ["missing.wkt"] * 2 + ["--plain"],
                      ["missing.wkt"] * 2 + ["--distance", "1"], ["missing.wkt"] * 2 + ["--inner"]):
            self.run_quoin("polygon", "minkowski", *words, code=USAGE)
        self.run_quoin("polygon", "union", "missing.wkt", "--tight", code=USAGE)
        self.run_quoin("polygon", "union", "missing.wkt", "--reflect", code=USAGE)


class Offset(PlanarTest):
    def test_rational_edges_are_exact(self):
        report = self.polygon("offset", RIGHT_ANGLED, "--distance", "1")
        self.assert_keys(report, "polygons vertices edges area area_error written inner outer")
        self.assert_holds(report, is_exact=True, bound=0, written="outer", distance=1)
        self.assertAlmostEqual(report["area"], 6 + 12 + math.pi, delta=2 * report["area_error"] + 1e-12)
        report = self.polygon("offset", RIGHT_ANGLED, "--distance", "-1/2")
        self.assert_holds(report, is_exact=True, distance=-0.5)
        self.assertAlmostEqual(report["area"], 1.5, delta=2 * report["area_error"] + 1e-12)

    def test_bounds(self):
        slanted = "POLYGON ((0 0, 3 1, 1 3, 0 0))"
        lengths = 2 * math.sqrt(10) + math.sqrt(8)
        true_area = 4 + lengths + math.pi
        last = math.inf
        for words, bound in (([], 2**-20), (["--precision", "1/10"], 0.1), (["--precision", "1e-12"], 1e-12)):
            report = self.polygon("offset", slanted, "--distance", "1", *words)
            self.assert_holds(report, is_exact=False)
            self.assertLessEqual(report["bound"], bound)
            inner, outer = report["inner"], report["outer"]
            self.assertEqual(report["area"], outer["area"])
            self.assertLessEqual(inner["area"] - inner["area_error"], true_area + 1e-12)
            self.assertGreaterEqual(outer["area"] + outer["area_error"], true_area - 1e-12)
            self.assertLess(outer["area"] - inner["area"], 2 * bound * (lengths + 7) + 1e-9)
            last = outer["area"] - inner["area"]
        self.assertLess(last, 1e-9)
        report = self.polygon("offset", slanted, "--distance", "1", "--inner", "--precision", "0.1", "-o", "in.wkt")
        self.assert_holds(report, written="inner", area=report["inner"]["area"])
        self.assertAlmostEqual(self.polygon("union", "in.wkt")["area"], report["area"], places=9)

    def test_vanishing_and_parts(self):
        self.assert_holds(self.polygon("offset", "a.wkt", "--distance", "-2"), polygons=0, area=0)
        self.assert_holds(self.polygon("offset", "a.wkt", "--distance=-1"), polygons=1, is_exact=True)
        pair = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((2 0, 3 0, 3 1, 2 1, 2 0)))"
        self.assert_holds(self.polygon("offset", pair, "--distance", "0.25"), polygons=2)
        self.assert_holds(self.polygon("offset", pair, "--distance", "0.75"), polygons=1)

    def test_mistakes(self):
        for words in ([], ["--distance", "0"], ["--distance", "x"], ["--distance", "inf"], ["--distance"],
                      ["--distance", "1", "--precision", "0"], ["--distance", "1", "--precision", "-1"],
                      ["--distance", "1", "--tight"], ["--distance", "1", "--plain"], ["b.wkt", "--distance", "1"]):
            self.run_quoin("polygon", "offset", "missing.wkt", *words, code=USAGE)
        for option in (["--distance", "1"], ["--precision", "1"], ["--inner"]):
            self.run_quoin("polygon", "union", "missing.wkt", *option, code=USAGE)
        self.assertIn("has arcs", self.run_quoin("polygon", "offset", DISC, "--distance", "1", code=REFUSED).stderr)


class Usage(PlanarTest):
    def test_help(self):
        text = self.run_quoin("--help").stdout
        for command in COMMANDS:
            self.assertIn(f"\n  {command} ", text)
            self.run_quoin(command, "--help")

    def test_mistakes(self):
        for command, words in COMMANDS.items():
            words = [w.replace("a.wkt", "missing.wkt") for w in words]
            self.run_quoin(command, code=USAGE)
            for mistake in (["--no-such-option"], ["-o", "x.foo"], ["-o", "x.off"], ["--format", "svg"],
                            ["-o", "-", "--format", "foo"], ["-o", "-", "-o", "-"], ["--timeout", "0"]):
                self.run_quoin(command, *words, *mistake, code=USAGE)
            if command != "polygon":
                self.run_quoin(command, *words, "-o", "x.wkt", code=USAGE)
        self.run_quoin("polygon", "cut", "a.wkt", code=USAGE)
        for words in (["overlay", "-", "-"], ["locate", "-", "--points", "-"], ["polygon", "union", "-", "-"]):
            self.assertIn("named twice", self.run_quoin(*words, stdin="", code=USAGE).stderr)
        self.assertEqual(list(self.folder.glob("x*")), [])

    def test_refusals_name_file_line_and_element(self):
        for command, words in COMMANDS.items():
            words = [w.replace("a.wkt", "bad.wkt") for w in words]
            done = self.run_quoin(command, *words, code=REFUSED)
            self.assertIn("bad.wkt:2: polygon 2, ring 1: the ring is not closed", done.stderr)
            self.assertEqual(self.json_of(command, *words, code=REFUSED)["exit_code"], REFUSED)
            done = self.run_quoin(command, *[w.replace("bad.wkt", "-") for w in words], stdin="POINT (1", code=REFUSED)
            self.assertIn("standard input:1", done.stderr)
            done = self.run_quoin(command, *[w.replace("bad.wkt", "LINESTRING (1 1, 1 1)") for w in words],
                                  code=None if command == "polygon" else REFUSED)
            self.assertIn("WKT argument 1: linestring 1", done.stderr)

    def test_file_trouble_and_time(self):
        for command, words in COMMANDS.items():
            self.run_quoin(command, *[w.replace("a.wkt", "missing.wkt") for w in words], code=FILE_TROUBLE)
            self.run_quoin(command, *words, "-o", "no/such/folder.svg", code=FILE_TROUBLE)
            self.run_quoin(command, *words, "--timeout", "1e-9", code=OUT_OF_TIME)
        self.run_quoin("polygon", "union", "a.wkt", "-o", "no/such/folder.wkt", code=FILE_TROUBLE)

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_full_devices(self):
        for ending in ("svg", "wkt"):
            (self.folder / f"full.{ending}").symlink_to("/dev/full")
        for command, words in COMMANDS.items():
            for ending in ["svg", "wkt"] if command == "polygon" else ["svg"]:
                self.run_quoin(command, *words, "-o", f"full.{ending}", code=FILE_TROUBLE)
            for more in ([], ["--json"], ["-o", "-"]):
                with open("/dev/full", "w", encoding="ascii") as full:
                    done = subprocess.run([self.quoin, command, *words, *more], stdout=full, stderr=subprocess.PIPE,
                                          cwd=self.folder, timeout=60, check=False)
                self.assertEqual(done.returncode, FILE_TROUBLE, (command, more, done.stderr))

    def test_streams(self):
        for command, words in COMMANDS.items():
            done = self.run_quoin(command, *words, "-o", "-", "--json")
            self.assertTrue(json.loads(done.stderr), command)
            self.assertTrue(done.stdout.startswith("POLYGON" if command == "polygon" else "<"), done.stdout[:40])
            done = self.run_quoin(command, *words, "-q")
            self.assertEqual((done.stdout, done.stderr), ("", ""))

    def test_threads_change_nothing(self):
        for command, words in COMMANDS.items():
            outputs = {self.run_quoin(command, *words, "-o", "-", "--threads", n).stdout for n in ("1", "2")}
            self.assertEqual(len(outputs), 1, command)


if __name__ == "__main__":
    main()
