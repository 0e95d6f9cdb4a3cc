# SPDX-License-Identifier: Apache-2.0
"""The command envelope.

    check_envelope.py QUOIN
"""
from command import REFUSED, USAGE, CommandTest, main

ROOF = "LINESTRING (0 0, 4 4, 8 0)"
STEP = "LINESTRING (2 1, 10 1)"


class Envelope(CommandTest):
    def test_intervals_and_breakpoints(self):
        report = self.json_of("envelope", ROOF, STEP)
        self.assert_keys(report, "envelope curves pieces intervals breakpoints warnings")
        self.assertEqual((report["envelope"], report["curves"], report["pieces"]), ("lower", 2, 4))
        self.assertEqual([(i["from"], i["to"]) for i in report["intervals"]],
                         [(None, [0, 0]), ([0, 0], [2, 2]), ([2, 1], [7, 1]), ([7, 1], [8, 0]), ([8, 1], [10, 1]),
                          ([10, 1], None)])
        self.assertEqual([b["point"] for b in report["breakpoints"]], [[0, 0], [2, 1], [7, 1], [8, 0], [10, 1]])
        self.assertEqual(len(report["breakpoints"][2]["curves"]), 2)
        self.assertIsNone(report["intervals"][0]["curve"])
        self.assertIn("linestring 1", report["intervals"][1]["curve"])

    def test_upper(self):
        report = self.json_of("envelope", ROOF, STEP, "--upper")
        self.assertEqual([(i["from"], i["to"]) for i in report["intervals"][1:-1]],
                         [([0, 0], [4, 4]), ([4, 4], [7, 1]), ([7, 1], [10, 1])])

    def test_overlaps_name_all_curves(self):
        report = self.json_of("envelope", "MULTILINESTRING ((0 0, 4 0), (2 0, 6 0))")
        self.assertEqual([len(i["curves"]) for i in report["intervals"]], [0, 1, 2, 1, 0])

    def test_wkt(self):
        done = self.run_quoin("envelope", ROOF, STEP, "-o", "-")
        self.assertEqual(done.stdout.splitlines(),
                         ["MULTILINESTRING ((0 0, 2 2), (2 1, 7 1, 8 0), (8 1, 10 1))"])
        self.assertEqual(done.stderr, "4 pieces, 5 breakpoints, 0 gaps\n")

    def test_arcs(self):
        circle = "CIRCULARSTRING (0 0, 4 0, 0 0)"
        done = self.run_quoin("envelope", circle, "--upper", "-o", "-", "-q")
        self.assertEqual(done.stdout, "CIRCULARSTRING (0 0, 2 2, 4 0)\n")
        self.run_quoin("envelope", circle, "-o", "arc.geojson", code=REFUSED)
        self.run_quoin("envelope", circle, "-o", "arc.geojson", "--flatten", "0.01")

    def test_picture(self):
        self.run_quoin("envelope", ROOF, STEP, "-o", "x.svg", "--labels")
        self.assertIn(b"strong", self.read("x.svg"))

    def test_usage(self):
        self.run_quoin("envelope", ROOF, "-o", "x.stl", code=USAGE)
        self.run_quoin("envelope", "POINT EMPTY")
        self.assertEqual(self.json_of("envelope", "POINT EMPTY")["pieces"], 0)


if __name__ == "__main__":
    main()
