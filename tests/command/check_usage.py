# SPDX-License-Identifier: Apache-2.0
"""Exit codes, errors and streams of every command.

    check_usage.py QUOIN
"""
import json
import os
import pathlib
import subprocess
import unittest

from command import FILE_TROUBLE, OUT_OF_TIME, REFUSED, USAGE, CommandTest, main

COMMANDS = {"union": ["a.off", "b.off"], "intersection": ["a.off", "b.off"], "difference": ["a.off", "b.off"],
            "xor": ["a.off", "b.off"], "csg": ["x|y", "x=a.off", "y=b.off"], "info": ["a.off"], "check": ["a.off"],
            "repair": ["a.off"], "convert": ["a.off"], "view": ["a.off", "-o", "v.off"],
            "classify": ["a.off", "--point", "1,1,1"], "section": ["a.off", "--plane", "0,0,1,1"],
            "interfere": ["a.off", "b.off"], "hull": ["a.off", "b.off"], "minkowski": ["a.off", "b.off"],
            "erode": ["a.off", "b.off"], "decompose": ["a.off", "-o", "p.off"],
            "distance": ["a.off", "b.off"], "width": ["a.off"], "gaussian-map": ["a.off"], "assembly": ["a.off", "far.off"],
            "homology": ["a.off"], "persistence": ["a.txt"],
            "delaunay": ["a.off"], "voronoi": ["a.off"], "alpha": ["a.off"],
            "flow": ["a.off", "--stable", "2"]}
DRAWERS = ("section", "persistence")  # which write svg alone
TRIANGULATORS = ("delaunay", "voronoi", "alpha", "flow")  # which write vtk and some meshes
MAKERS = ("union", "intersection", "difference", "xor", "csg", "repair", "convert", "view", "hull", "minkowski", "erode")


def with_file(words, name):
    """The words of a command, about another file."""
    return [w.replace("a.off", name).replace("a.txt", name) for w in words]


class Usage(CommandTest):
    def test_help_names_every_command(self):
        text = self.run_quoin("--help").stdout
        for command in COMMANDS:
            self.assertIn(f"\n  {command} ", text)
            self.run_quoin(command, "--help")
        self.assertRegex(self.run_quoin("--version").stdout, r"^quoin \d+\.\d+\.\d+\n$")

    def test_common_mistakes(self):
        for command, words in COMMANDS.items():
            self.run_quoin(command, code=USAGE)
            for mistake in (["--no-such-option"], ["--weld", "-1"], ["--weld", "nan"], ["--timeout", "nan"],
                            ["--timeout", "0"], ["--timeout", "x"], ["--threads", "-1"], ["--threads", "1.5"],
                            ["--seed", "-1"], ["--seed"]):
                self.run_quoin(command, *words, *mistake, code=USAGE)
        self.run_quoin(code=USAGE)
        self.run_quoin("no-such-command", code=USAGE)

    def test_outputs_are_refused_before_anything_is_read(self):
        for command in MAKERS:
            words = [w.replace("a.off", "missing.off") for w in COMMANDS[command]]
            for mistake in (["-o", "x.foo"], ["-o", "x"], ["-o", "x.svg"], ["-o", "-", "--format", "foo"],
                            ["-o", "x.off", "--format", "off"], ["--format", "off"], ["-o", "-", "-o", "-"]):
                self.run_quoin(command, *words, *mistake, code=USAGE)
        self.assertEqual(sorted(p.name for p in self.folder.glob("x*")), [])

    def test_mistakes_of_csg(self):
        for words in (["x"], ["x", "a.off"], ["x", "=a.off"], ["x", "x="], ["x", "x=a.off", "x=b.off"],
                      ["x|z", "x=missing.off"], ["x|", "x=missing.off"]):
            done = self.run_quoin("csg", *words, code=USAGE)
            self.assertTrue(done.stderr)

    def test_standard_input_named_twice(self):
        for words in (["union", "-", "-"], ["csg", "x|y", "x=-", "y=-"], ["classify", "-", "--points", "-"],
                      ["info", "-", "a.off", "-"], ["interfere", "-", "-"], ["distance", "-", "a.off", "--path", "-"]):
            self.assertIn("named twice", self.run_quoin(*words, stdin="", code=USAGE).stderr)

    def test_errors_as_json(self):
        cases = [(["union", "a.off", "open.off"], REFUSED), (["union", "a.off", "missing.off"], FILE_TROUBLE),
                 (["csg", "x |", "x=a.off"], USAGE), (["union", "a.off", "-o", "x.foo"], USAGE),
                 (["classify", "a.off"], USAGE), (["union"], USAGE), (["section", "a.off", "--plane", "1"], USAGE),
                 (["union", "a.off", "b.off", "--timeout", "1e-9"], OUT_OF_TIME), (["repair", "open.off"], REFUSED)]
        for words, code in cases:
            done = self.run_quoin(*words, "--json", code=code)
            report = json.loads(done.stdout)
            self.assertEqual(report["exit_code"], code)
            self.assertTrue(report["error"])
            self.assertTrue(done.stderr)
        done = self.run_quoin("union", "open.off", "-o", "-", "--json", code=REFUSED)
        self.assertEqual((done.stdout, json.loads(done.stderr)["exit_code"]), ("", REFUSED))


NOT_NUMBERS = ("nan", "NaN", "inf", "-inf", "infinity", "", " ", "1e", "1e+", "e5", ".", "+", "-", "+-1", "--1", "0x10", "0x1p3",
               "1,5", "1;5", "1_0", "1'0", " 1", "1 ", "1\t", "1e5.0", "1e999999999", "1e-100000", "1/0", "1/", "/2", "1/2/3", "one")
EXACT_NUMBERS = [("alpha", "--value"), ("alpha", "--radius"), ("flow", "--shape"), ("flow", "--simplify"),
                 ("flow --reconstruct", "--ratio"), ("polygon offset", "--distance"),
                 ("polygon offset --distance 1", "--precision")]
DOUBLES = [(command, option) for command in ("delaunay", "voronoi", "alpha", "flow")
           for option in ("--memory", "--timeout", "--weld")] + [
    ("homology", "--timeout"), ("persistence", "--timeout"), ("polygon union", "--flatten"), ("minkowski", "--ball")]
WHOLES = [("alpha", "--pieces"), ("flow", "--stable"), ("flow", "--unstable"), ("homology", "--prime"),
          ("persistence", "--prime"), ("alpha --persistence", "--prime")] + [
    (command, option) for command in ("delaunay", "voronoi", "alpha", "flow", "homology", "persistence")
    for option in ("--threads", "--seed")]


class Numbers(CommandTest):
    def refused(self, command, option, word):
        words = command.split()
        done = self.run_quoin(*words, "missing.xyz", f"{option}={word}", code=USAGE)
        self.assertIn(option, done.stderr, word)
        return done.stderr

    def test_what_is_no_number_is_a_mistake_of_usage(self):
        for command, option in EXACT_NUMBERS + DOUBLES + WHOLES:
            for word in NOT_NUMBERS:
                self.refused(command, option, word)
        for command, option in DOUBLES:
            self.refused(command, option, "1/2")
            self.assertIn("beyond the largest double", self.refused(command, option, "1e400"))
        for command, option in WHOLES:
            for word in ("1.5", "1e0", "-1", "+1", "1/1", "18446744073709551616"):
                self.refused(command, option, word)
        for command, option in EXACT_NUMBERS:
            self.assertIn("exponent beyond 99999", self.refused(command, option, "1e100000"))
        done = self.run_quoin("flow", "missing.xyz", "--shape", "nan", "--json", code=USAGE)
        self.assertEqual(json.loads(done.stdout)["exit_code"], USAGE)

    def test_numbers_out_of_range(self):
        for command, option, word in (("alpha", "--radius", "-1"), ("alpha", "--radius", "-1e-400"), ("flow", "--shape", "-1/3"),
                                      ("flow", "--simplify", "-1"), ("flow --reconstruct", "--ratio", "-1e-400"),
                                      ("flow --reconstruct", "--ratio", "1000001/1000000"), ("flow", "--stable", "0"),
                                      ("flow", "--stable", "4"), ("flow", "--unstable", "3"), ("alpha", "--pieces", "0"),
                                      ("alpha", "--pieces", "4294967296"), ("alpha", "--memory", "0"), ("alpha", "--weld", "-1"),
                                      ("alpha", "--timeout", "0"), ("polygon offset --distance 1", "--precision", "0")):
            self.refused(command, option, word)

    def test_exact_numbers_beyond_doubles(self):
        self.write("c.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        whole = self.json_of("alpha", "c.xyz")["shape"]
        for word, exact in (("1e400", "1" + 400 * "0"), ("+10.50E+399", "105" + 398 * "0"), ("1e99999", "1" + 99999 * "0")):
            report = self.json_of("alpha", "c.xyz", "--value", word)
            self.assertEqual((report["shape"], report["value"], report["exact_value"]), (whole, None, exact))
            report = self.json_of("flow", "c.xyz", "--shape", word)["shape"]
            self.assertEqual((report["betti_numbers"], report["distance"], report["exact_distance"]), ([1, 0, 0], None, exact))
            self.json_of("flow", "c.xyz", "--simplify", word)
        for word in ("1e-400", "0." + 400 * "0" + "1", "1e-99999", "1/1" + 400 * "0"):
            self.assertEqual(self.json_of("alpha", "c.xyz", "--value", word)["shape"]["simplices"], [4, 0, 0, 0])
            report = self.json_of("flow", "c.xyz", "--shape", word)["shape"]
            self.assertEqual((report["betti_numbers"], report["distance"]), ([4, 0, 0], 0))
            self.assertTrue(report["exact_distance"].startswith("1/1000"))
        # Reading keeps the order: what is beyond the largest double is more than that.
        self.assertEqual(self.json_of("alpha", "c.xyz", "--value", "1.7976931348623158e308")["value"], 1.7976931348623157e308)
        self.assertIsNone(self.json_of("alpha", "c.xyz", "--value", "1.8e308")["value"])
        self.assertEqual(self.json_of("alpha", "c.xyz", "--radius", "1e200")["exact_value"], str(int(1e200) ** 2))
        self.assertEqual(self.json_of("alpha", "c.xyz", "--value", "0e99999")["exact_value"], "0")

    def test_decimals_are_their_nearest_doubles_and_fractions_are_exact(self):
        self.write("c.xyz", "0 0 0\n2 0 0\n0 2 0\n0 0 2\n")
        third = self.json_of("flow", "c.xyz", "--shape", "4/3")["shape"]
        self.assertEqual((third["distance"], third["exact_distance"]), (4 / 3, "4/3"))
        self.assertNotIn("exact_distance", self.json_of("flow", "c.xyz", "--shape", "0.1")["shape"])
        self.assertEqual(self.json_of("alpha", "c.xyz", "--value", "0.1")["exact_value"], "3602879701896397/36028797018963968")
        half = self.json_of("flow", "c.xyz", "--reconstruct", "--ratio", "1/2")
        self.assertEqual(half, self.json_of("flow", "c.xyz", "--reconstruct", "--ratio", "0.5"))
        self.assertEqual(self.json_of("flow", "c.xyz", "--reconstruct", "--ratio", "1/3")["solid"]["exact_ratio"], "1/3")
        # Midpoints of the axes' edges are at 1 exactly, others at the root of 2, which no fraction is.
        for word, joined in (("1", 1), ("9999999999999999999999/10000000000000000000000", 4)):
            self.assertEqual(self.json_of("flow", "c.xyz", "--shape", word)["shape"]["betti_numbers"][0], joined)
        # Digits alone are decimal.
        self.assertEqual(self.json_of("alpha", "c.xyz", "--pieces", "010"), self.json_of("alpha", "c.xyz", "--pieces", "10"))


class Codes(CommandTest):
    def test_bad_geometry(self):
        for command, words in COMMANDS.items():
            if command not in ("hull", "homology", *TRIANGULATORS):  # which take what bounds no solid
                self.run_quoin(command, *with_file(words, "open.off"), code=REFUSED)
            self.run_quoin(command, *with_file(words, "rubbish.off"), code=REFUSED)

    def test_missing_files_and_folders(self):
        (self.folder / "folder.off").mkdir()
        for command, words in COMMANDS.items():
            for name in ("missing.off", "missing.qsolid", "folder.off"):
                done = self.run_quoin(command, *with_file(words, name), code=FILE_TROUBLE)
                self.assertIn(name, done.stderr)

    def test_unwritable_outputs(self):
        for command in MAKERS:
            for name in ("no/such/folder.off", "no/such/folder.qsolid"):
                self.run_quoin(command, *COMMANDS[command], "-o", name, code=FILE_TROUBLE)
        for command in DRAWERS:
            self.run_quoin(command, *COMMANDS[command], "-o", "no/such.svg", code=FILE_TROUBLE)
        for command in TRIANGULATORS:
            for name in ("no/such.vtk", "no/such.ply"):
                self.run_quoin(command, *COMMANDS[command], "-o", name, code=FILE_TROUBLE)

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_full_devices(self):
        for ending in ("off", "obj", "stl", "ply", "qsolid", "svg", "vtk"):
            (self.folder / f"full.{ending}").symlink_to("/dev/full")
        for command, words in COMMANDS.items():
            endings = (["svg"] if command in DRAWERS else ["off", "obj", "ply", "vtk"] if command in TRIANGULATORS
                       else ["off", "obj", "stl", "ply", "qsolid"])
            if command in (*MAKERS, *DRAWERS, *TRIANGULATORS):
                if command == "voronoi":  # all cells are infinite, and an OBJ of none is empty
                    endings.remove("obj")
                for ending in endings:
                    self.run_quoin(command, *words, "-o", f"full.{ending}", code=FILE_TROUBLE)
            for more in ([], ["--json"], *([["-o", "-"]] if command in (*MAKERS, *DRAWERS, *TRIANGULATORS) else [])):
                with open("/dev/full", "w", encoding="ascii") as full:
                    done = subprocess.run([self.quoin, command, *words, *more], stdout=full, stderr=subprocess.PIPE,
                                          cwd=self.folder, timeout=60, check=False)
                self.assertEqual(done.returncode, FILE_TROUBLE, (command, more, done.stderr))

    def test_out_of_time(self):
        for command, words in COMMANDS.items():
            done = self.run_quoin(command, *words, "--timeout", "1e-9", code=OUT_OF_TIME)
            self.assertIn("out of time", done.stderr)


class Streams(CommandTest):
    def test_meshes_in_and_out(self):
        text = self.read("a.off").decode()
        done = self.run_quoin("union", "-", "b.off", "-o", "-", stdin=text)
        self.assertTrue(done.stdout.startswith("OFF"))
        self.assertIn("rounding", done.stderr)
        self.assertEqual(self.json_of("info", "-", stdin=done.stdout)["volume"], 15)
        done = self.run_quoin("csg", "x-y", "x=a.off", "y=-", "-o", "-", "-q", stdin=self.read("b.off").decode())
        self.assertEqual(self.json_of("info", "-", stdin=done.stdout)["volume"], 7)
        self.assertEqual(done.stderr, "")

    def test_the_report_goes_to_standard_error(self):
        done = self.run_quoin("union", "a.off", "b.off", "-o", "-", "--json")
        self.assertEqual(json.loads(done.stderr)["result"]["volume"], 15)
        self.assertTrue(done.stdout.startswith("OFF"))

    def test_formats_of_standard_output(self):
        for name in ("off", "obj", "stl", "ply", "qsolid", "OFF", "QSOLID"):
            done = subprocess.run([self.quoin, "union", "a.off", "b.off", "-q", "-o", "-", "--format", name],
                                  capture_output=True, cwd=self.folder, timeout=60, check=True)
            self.run_quoin("union", "a.off", "b.off", "-q", "-o", f"u.{name}")
            self.assertEqual(done.stdout, self.read(f"u.{name}"), name)

    def test_exact_text_is_told_by_its_first_word(self):
        self.run_quoin("union", "a.off", "b.off", "-o", "u.qsolid")
        text = "# exact\n\n" + self.read("u.qsolid").decode()
        self.write("u.txt", text)
        self.write("U.QSOLID", text)
        for words in (["info", "{}"], ["repair", "{}"], ["convert", "{}"], ["union", "{}"], ["csg", "x", "x={}"],
                      ["check", "{}"], ["classify", "{}", "--point", "1,1,1"], ["section", "{}", "--plane", "0,0,1,1"],
                      ["interfere", "{}", "a.off"], ["view", "{}", "-o", "v.off"]):
            for name in ("-", "u.txt", "U.QSOLID"):
                report = self.json_of(*[w.format(name) for w in words], stdin=text if name == "-" else "")
                self.assertEqual((report.get("result") or report).get("volume", 15), 15, words)

    def test_a_named_pipe(self):
        os.mkfifo(self.folder / "pipe")
        self.run_quoin("union", "a.off", "b.off", "-o", "u.qsolid")
        for name in ("u.qsolid", "a.off"):
            with subprocess.Popen([self.quoin, "info", "pipe", "--json"], stdout=subprocess.PIPE,
                                  cwd=self.folder) as process:
                pathlib.Path(self.folder / "pipe").write_bytes(self.read(name))
                self.assertEqual(json.loads(process.communicate(timeout=60)[0])["closed"], True)


if __name__ == "__main__":
    main()
