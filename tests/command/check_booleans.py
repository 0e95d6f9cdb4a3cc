# SPDX-License-Identifier: Apache-2.0
"""Commands that make solids: union, intersection, difference, xor, csg, repair, convert, view.

    check_booleans.py QUOIN
"""
import time

from command import REFUSED, USAGE, CUBE_FACES, CommandTest, box, corners, main, off

SUMMARY = ("vertices edges faces triangles shells voids components closed manifold nonmanifold_edges "
           "nonmanifold_vertices unbounded volume area bounds inputs")
MAKER = "seconds threads rounding max_displacement rounding_rounds outputs warnings result"


class Booleans(CommandTest):
    def test_volumes_and_keys(self):
        for command, volume in {"union": 15, "intersection": 1, "difference": 7, "xor": 14}.items():
            report = self.json_of(command, "a.off", "b.off", "-o", "out.off")
            self.assert_keys(report, MAKER)
            self.assert_keys(report["result"], SUMMARY)
            self.assertEqual(report["result"]["volume"], volume, command)
            self.assertEqual(report["rounding"], "exact")
            self.assertEqual(self.info("out.off")["volume"], volume, command)

    def test_output_option_takes_one_file_wherever_it_stands(self):
        before = self.read("a.off"), self.read("b.off")
        orders = [("-o", "out.off", "a.off", "b.off"), ("a.off", "-o", "out.off", "b.off"),
                  ("a.off", "b.off", "-o", "out.off"), ("--output", "out.off", "a.off", "b.off"),
                  ("--output=out.off", "a.off", "b.off"), ("--threads", "1", "-o", "out.off", "-q", "a.off", "b.off")]
        for words in orders:
            self.run_quoin("union", *words)
            self.assertEqual(self.info("out.off")["volume"], 15, words)
            (self.folder / "out.off").unlink()
            self.assertEqual((self.read("a.off"), self.read("b.off")), before, words)
        self.run_quoin("csg", "-o", "out.off", "x-y", "x=a.off", "y=b.off")
        self.assertEqual(self.info("out.off")["volume"], 7)
        for command in ("repair", "convert", "view"):
            self.run_quoin(command, "-o", "out.off", "a.off")
            self.assertEqual(self.info("out.off")["volume"], 8)

    def test_output_repeated_and_every_format(self):
        names = ["out.off", "out.obj", "out.stl", "out.ply", "out.qsolid", "OUT.OFF", "OUT.QSOLID", "out.StL"]
        report = self.json_of("difference", *(w for n in names for w in ("-o", n)), "a.off", "b.off")
        self.assertEqual(report["outputs"], names)
        for name in names:
            self.assertEqual(self.info(name)["volume"], 7, name)

    def test_same_bytes_on_any_number_of_threads(self):
        results = set()
        for threads in ("1", "2", "4"):
            self.run_quoin("union", "a.off", "b.off", "far.off", "--threads", threads, "-o", "t.ply", "-o", "t.qsolid")
            results.add((self.read("t.ply"), self.read("t.qsolid")))
        self.assertEqual(len(results), 1)

    def test_quiet_prints_nothing(self):
        for words in (("union", "a.off", "b.off"), ("csg", "!x", "x=a.off"), ("repair", "a.off"), ("convert", "a.off"),
                      ("info", "a.off"), ("check", "a.off"), ("interfere", "a.off", "b.off"),
                      ("classify", "a.off", "--point", "1,1,1"), ("section", "a.off", "--plane", "0,0,1,1")):
            done = self.run_quoin(*words, "-q")
            self.assertEqual(done.stdout + done.stderr, "", words)

    def test_view_names_pages_only(self):
        self.assertNotIn("browser", self.run_quoin("view", "a.off", "-o", "x.off").stdout)

    def test_pages_are_made_or_refused_before_reading(self):
        if "was not built" in self.run_quoin("view", "missing.off", code=None).stderr:
            self.run_quoin("union", "missing.off", "-o", "x.html", code=REFUSED)
            return
        self.assertIn("open a.html in a browser", self.run_quoin("view", "a.off").stdout)
        self.run_quoin("union", "a.off", "b.off", "-o", "x.HTML", "-o", "x.off")
        self.assertIn(b"<html", self.read("x.HTML"))
        self.assertIn("<html", self.run_quoin("union", "a.off", "b.off", "-o", "-", "--format", "html").stdout)

    def test_weld_says_what_it_did(self):
        vertices = corners((0, 0, 0), (1, 1, 1))
        faces = CUBE_FACES[:5] + [tuple(v + 8 if v == 7 else v for v in CUBE_FACES[5])]
        faces[5] = tuple(8 if v == 15 else v for v in faces[5])
        self.write("gap.off", off(vertices + [(1, 1, 1.0009765625)], faces))
        self.run_quoin("convert", "gap.off", code=REFUSED)
        report = self.json_of("convert", "gap.off", "--weld", "0.01")
        self.assertEqual(report["result"]["volume"], 1)
        self.assertRegex(" ".join(report["warnings"]), r"1 of 9 vertices welded.*0\.0009765625")


class Expressions(CommandTest):
    def test_precedence_and_grouping(self):
        solids = ("a=a.off", "b=b.off", "f=far.off")
        for text, volume in {"a": 8, "a | b": 15, "a+b+f": 16, "a-b": 7, "a - b | f": 8, "a - (b | f)": 7, "f | a & b": 2,
                             "(f|a)*b": 1, "a^b^f": 15, "a^a": 0, "a^a^a": 8, "a & !b": 7, "~~a": 8, "a--b": None,
                             "a - !b": 1, "!(!a | !b)": 1, "a|b-b|f": 8, "a-b-f-b": 7, "((a))-((b))": 7}.items():
            if volume is None:
                self.run_quoin("csg", text, *solids, code=USAGE)
                continue
            self.assertEqual(self.json_of("csg", text, *solids)["result"]["volume"], volume, text)

    def test_complement_has_minus_the_volume_left_out(self):
        result = self.json_of("csg", "!a", "a=a.off", "-o", "c.qsolid")["result"]
        self.assertEqual((result["volume"], result["unbounded"]), (-8, True))
        self.run_quoin("csg", "!a", "a=a.off", "-o", "c.off", code=REFUSED)
        self.assertEqual(self.json_of("intersection", "c.qsolid", "b.off")["result"]["volume"], 7)

    def test_errors_name_the_column(self):
        for text, column in {"a -": 4, "": 1, "(a": 3, "a)": 2, "a b": 3, "a | c": 5, "a ? b": 3, "!": 2, "()": 2,
                             "a & * b": 5}.items():
            done = self.run_quoin("csg", text, "a=a.off", "b=b.off", code=USAGE)
            self.assertIn(f"column {column}:", done.stderr, text)

    def test_long_and_deep_expressions(self):
        count = 30_000
        for text, volume in {"^".join(["a"] * (count + 1)): 8, "-".join(["a"] * (count + 1)): 0,
                             "(" * count + "a" + ")" * count: 8, "!" * count + "a": 8,
                             "a" + "|b^a-b" * (count // 3): 7,
                             "a-(" * (count // 2) + "b" + ")" * (count // 2): 1}.items():
            start = time.monotonic()
            report = self.json_of("csg", text, "a=a.off", *(["b=b.off"] if "b" in text else []))
            self.assertEqual(report["result"]["volume"], volume, text[:12])
            self.assertLess(time.monotonic() - start, 10, text[:12])


class Repairs(CommandTest):
    def test_turned_and_double_faces(self):
        faces = [CUBE_FACES[0][::-1], *CUBE_FACES[1:], CUBE_FACES[3]]
        self.write("bad.off", off(corners((0, 0, 0), (1, 1, 1)), faces))
        self.run_quoin("union", "bad.off", code=REFUSED)
        report = self.json_of("repair", "bad.off", "-o", "good.off")
        self.assert_keys(report, MAKER + " repairs diagnosis")
        self.assertEqual(report["result"]["volume"], 1)
        self.assertEqual(self.json_of("check", "good.off")["valid"], True)
        for repair in report["repairs"]:
            self.assert_keys(repair, "change count faces")

    def test_what_cannot_be_repaired(self):
        self.assertIn("cannot be repaired", self.run_quoin("repair", "open.off", code=REFUSED).stderr)

    def test_exact_text(self):
        self.run_quoin("union", "a.off", "b.off", "-o", "u.qsolid")
        report = self.json_of("repair", "u.qsolid", "-o", "r.qsolid")
        self.assertEqual((report["result"]["volume"], report["repairs"]), (15, []))
        self.run_quoin("csg", "!a", "a=u.qsolid", "-o", "c.qsolid")
        self.assertEqual(self.json_of("repair", "c.qsolid")["result"]["volume"], -15)


class Rounding(CommandTest):
    def test_thirds_are_certified(self):
        self.write("slope.off", off([(0, 0, 0), (3, 0, 0), (0, 3, 0), (0, 0, 1)],
                                    [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]))
        self.write("step.off", box((0, 0, 0.25), (1, 1, 2)))
        for more in ([], ["--accept-rounding"]):
            report = self.json_of("intersection", "slope.off", "step.off", "-o", "t.off", "-o", "t.stl", *more)
            self.assertEqual(report["rounding"], "certified")
            self.assertGreater(report["max_displacement"], 0)
            for name in ("t.off", "t.stl"):
                self.assertEqual(self.json_of("check", name)["valid"], True)

    def test_a_format_that_cannot_hold_the_result(self):
        self.write("large.off", box((0, 0, 0), (1e300, 1, 1)))
        self.run_quoin("convert", "large.off", "-o", "large.off.ply")
        self.assertIn("too large", self.run_quoin("convert", "large.off", "-o", "large.stl", code=REFUSED).stderr)


if __name__ == "__main__":
    main()
