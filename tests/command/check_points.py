# SPDX-License-Identifier: Apache-2.0
"""delaunay and voronoi.

    check_points.py QUOIN
"""
import itertools
import os
import random
import resource
import signal
import struct
import subprocess
import time
from fractions import Fraction

from clouds import CUBE, cloud, determinant, read_vtk, text_of
from command import DONE, OUT_OF_TIME, REFUSED, USAGE, CommandTest, main


def side(simplex, q):
    """Above zero where q is inside the sphere of the simplex, in rationals."""
    q = [Fraction(c) for c in q]
    lifted = []
    for p in simplex:
        d = [Fraction(a) - b for a, b in zip(p, q)]
        lifted.append(d + [sum(c * c for c in d)])
    turn = determinant([[Fraction(a) - Fraction(b) for a, b in zip(p, simplex[0])] for p in simplex[1:]])
    sign = 1 if turn > 0 else -1
    return sign * determinant(lifted) * (1 if len(q) == 2 else -1)


def volume(simplex):
    return abs(determinant([[Fraction(a) - Fraction(b) for a, b in zip(p, simplex[0])] for p in simplex[1:]]))


def cell_of_plane(site, others, weights=None):
    """The area of what is nearest to the site within a large square, and whether it keeps off the square's sides; with
    the weights of places, of what has the least power.
    """
    weight = weights or dict.fromkeys([site, *others], 0)
    far = Fraction(10) ** 9
    polygon = [(-far, -far), (far, -far), (far, far), (-far, far)]
    for o in others:
        a, b = Fraction(o[0]) - Fraction(site[0]), Fraction(o[1]) - Fraction(site[1])
        c = (Fraction(o[0]) ** 2 + Fraction(o[1]) ** 2 - Fraction(site[0]) ** 2 - Fraction(site[1]) ** 2
             + Fraction(weight[site]) - Fraction(weight[o])) / 2
        heights = [a * x + b * y - c for x, y in polygon]
        clipped = []
        for k, (p, h) in enumerate(zip(polygon, heights)):
            q, g = polygon[k - 1], heights[k - 1]
            if (h > 0) != (g > 0) and h != 0 and g != 0:
                t = g / (g - h)
                clipped.append((q[0] + t * (p[0] - q[0]), q[1] + t * (p[1] - q[1])))
            if h <= 0:
                clipped.append(p)
        polygon = clipped
    area = sum(polygon[k - 1][0] * p[1] - polygon[k - 1][1] * p[0] for k, p in enumerate(polygon)) / 2
    return area, all(abs(c) < far for p in polygon for c in p)


class Delaunay(CommandTest):
    def test_cells_are_those_of_empty_spheres(self):
        for points in (cloud(25, 3), cloud(30, 2), cloud(40, 3, grid=3), cloud(40, 2, grid=4), CUBE):
            self.write("p.xyz", text_of(points))
            report = self.json_of("delaunay", "p.xyz", "--check", "-o", "p.vtk")
            vertices, cells, arrays = read_vtk(self.read("p.vtk").decode())
            d = len(points[0])
            distinct = sorted(set(points))
            self.assertEqual((report["points"], report["distinct"], report["dimension"], report["check"]),
                             (len(points), len(distinct), d, "passed"))
            self.assertEqual(sorted(v[:d] for v in vertices), [tuple(map(float, p)) for p in distinct])
            self.assertEqual([points[int(i)] for i in arrays["input"]], [v[:d] for v in vertices])
            self.assertEqual(sum(arrays["multiplicity"]), len(points))
            self.assertEqual((len(cells), {t for t, _ in cells}), (report["cells"], {10 if d == 3 else 5}))
            self.assertEqual(len(set(arrays["delone_cell"])), report["delone_cells"])
            simplices = [[vertices[v][:d] for v in cell] for _, cell in cells]
            for simplex in simplices:
                self.assertTrue(all(side(simplex, q) <= 0 for q in distinct))
            whole = sum(volume(s) for s in simplices)
            if points is CUBE:
                self.assertEqual((whole, report["delone_cells"], report["hull_vertices"]), (6, 1, 8))

    def test_faces_in_meshes(self):
        points = CUBE + [(0.5, 0.5, 0.5)]
        for ending in ("ply", "obj", "off"):
            self.run_quoin("delaunay", "-", "-o", f"h.{ending}", stdin=text_of(points))
            self.assertEqual(self.info(f"h.{ending}")["volume"], 1, ending)
            self.assertEqual(self.info(f"h.{ending}")["vertices"], 8, ending)
        done = self.run_quoin("delaunay", "-", "-o", "-", "--format", "off", stdin="0 0\n1 0\n0 1\n1 1\n.5 .25\n")
        self.assertTrue(done.stdout.startswith("OFF\n5 4 0\n"))
        self.assertIn("delone cells", done.stderr)
        done = self.run_quoin("delaunay", "-", "-o", "-", stdin="0 0\n1 0\n0 1\n")
        self.assertTrue(done.stdout.startswith("# vtk DataFile Version 3.0\n"))

    def test_the_plane_of_three_columns(self):
        points = [(0, 0, 5), (2, 0, 6), (0, 2, 7), (2, 2, 8), (1, 1, 9), (1, 1, 10)]
        self.write("t.xyz", text_of(points))
        report = self.json_of("delaunay", "t.xyz", "--plane", "-o", "t.vtk")
        self.assertEqual((report["coordinates"], report["distinct"], report["dimension"], report["cells"],
                          report["largest_multiplicity"]), (2, 5, 2, 4, 2))
        self.assertIn("third coordinate", report["warnings"][0])
        vertices, _, _ = read_vtk(self.read("t.vtk").decode())
        self.assertEqual(sorted(v[2] for v in vertices), [5, 6, 7, 8, 9])

    def test_flat_clouds(self):
        for text, dimension, cells, vtk in (("1 2 3\n1 2 3\n", 0, 1, 1), ("0 0 0\n3 3 3\n1 1 1\n", 1, 2, 3),
                                            ("0 0 1\n1 0 1\n0 1 1\n1 1 1\n", 2, 2, 5), ("7 7\n", 0, 1, 1),
                                            ("0 0\n2 2\n5 5\n1 1\n", 1, 3, 3)):
            report = self.json_of("delaunay", "-", "--check", "-o", "f.vtk", stdin=text)
            self.assertEqual((report["dimension"], report["cells"]), (dimension, cells), text)
            self.assertEqual(len(report["warnings"]), 1)
            self.assertEqual({t for t, _ in read_vtk(self.read("f.vtk").decode())[1]}, {vtk})
        self.assertEqual(self.json_of("delaunay", "-", stdin="0 0 1\n1 0 1\n0 1 1\n1 1 1\n")["delone_cells"], 1)

    def test_the_order_of_points_does_not_matter(self):
        points = cloud(60, 3, grid=4)
        for options in ([], ["--plane"]):
            expected = None
            for seed in range(3):
                random.Random(seed).shuffle(points)
                report = self.json_of("delaunay", "-", *options, "-o", "s.vtk", stdin=text_of(points))
                vertices, cells, _ = read_vtk(self.read("s.vtk").decode())
                found = (report["cells"], report["delone_cells"],
                         sorted(sorted(vertices[v][:2 if options else 3] for v in cell) for _, cell in cells))
                self.assertEqual(found, expected or found)
                expected = found

    def test_weights(self):
        points = cloud(30, 3, seed=3)
        plain = self.json_of("delaunay", "-", stdin=text_of(points))
        same = self.json_of("delaunay", "-", "--weighted", stdin=text_of([p + (0.25,) for p in points]))
        self.assertEqual((same["cells"], same["hidden"], same["vertices"]), (plain["cells"], 0, 30))
        for given in (CUBE, cloud(40, 3, seed=4, grid=4), [p[:2] for p in cloud(40, 3, seed=4, grid=5)], [(x, x, x) for x in range(6)],
                      [(1, 2, 3)] * 2):
            plain, same = [self.json_of("delaunay", "-", *words, "-o", "w.vtk", stdin=text_of([p + more for p in given]))
                           for words, more in (([], ()), (["--weighted"], (2.5,)))]
            self.assertEqual(same["delone_cells"], plain["delone_cells"])
            self.assertEqual(len(set(read_vtk(self.read("w.vtk").decode())[2]["delone_cell"])), same["delone_cells"])
        # Lifted into one line or plane, whatever is a vertex there.
        for given, of_line in (([(x, 0, x * x) for x in range(5)], True), ([(x, y, x * x + y * y) for x in range(4) for y in range(4)], False)):
            report = self.json_of("delaunay", "-", "--weighted", "-o", "w.vtk", stdin=text_of(given))
            self.assertEqual((report["delone_cells"], report["dimension"]), (1, 1 if of_line else 2))
            self.assertEqual(set(read_vtk(self.read("w.vtk").decode())[2]["delone_cell"]), {0})
        bent = [(x, 0, x * x - (2 if x in (0, 2, 5) else 0)) for x in range(6)]
        lifted = [x * x - w for x, _, w in bent]
        corners = [i for i in range(6) if not any(a < i < b and lifted[i] * (b - a) >= lifted[a] * (b - i) + lifted[b] * (i - a)
                                                  for a in range(6) for b in range(6))]
        report = self.json_of("delaunay", "-", "--weighted", stdin=text_of(bent))
        self.assertEqual((report["delone_cells"], report["cells"] >= len(corners) - 1), (len(corners) - 1, True))
        heavy = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (4, 4, 9)]
        report = self.json_of("delaunay", "-", "--weighted", "-o", "w.vtk", stdin=text_of(heavy + [(1, 1, -9)]))
        self.assertEqual((report["coordinates"], report["hidden"], report["vertices"]), (2, 1, 4))
        self.assertEqual(sorted(read_vtk(self.read("w.vtk").decode())[2]["weight"]), [0, 0, 0, 9])
        solid = [p + (0,) for p in CUBE] + [(0.5, 0.5, 0.5, 1), (0.5, 0.5, 0.5, 0), (0.75, 0.75, 0.75, -2)]
        report = self.json_of("delaunay", "-", "--weighted", "-o", "w.vtk", stdin=text_of(solid))
        self.assertEqual((report["vertices"], report["hidden"], report["distinct"]), (9, 2, 10))
        self.run_quoin("delaunay", "missing.xyz", "--weighted", "--check", code=USAGE)
        self.run_quoin("delaunay", "-", "--weighted", stdin="1 2\n3 4\n", code=REFUSED)

    def test_attributes_go_along(self):
        self.write("c.csv", "x,y,z,r,g,b,nx,ny,nz,intensity\n" + "".join(
            f"{x},{y},{z},{255 * x},0,51,0,0,1,{x + y}\n" for x, y, z in CUBE))
        self.run_quoin("delaunay", "c.csv", "-o", "c.vtk")
        vertices, _, arrays = read_vtk(self.read("c.vtk").decode())
        for vertex, color, normal, intensity in zip(vertices, arrays["color"], arrays["normal"], arrays["intensity"]):
            self.assertEqual((color, normal, intensity), ((vertex[0], 0, 0.2, 1), (0, 0, 1), vertex[0] + vertex[1]))


class Formats(CommandTest):
    def test_every_format_gives_the_same(self):
        self.write("c.xyz", text_of(CUBE))
        self.write("c.txt", text_of(CUBE, "\t"))
        self.write("c.csv", "X;Y;Z\n" + text_of(CUBE, ";"))
        self.write("c.pts", "8\n" + text_of(CUBE))
        self.write("c.obj", "".join("v " + line + "\n" for line in text_of(CUBE).splitlines()))
        self.write("c.off", "OFF\n8 0 0\n" + text_of(CUBE))
        header = ("ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
                  "property float z\nend_header\n")
        body = b"".join(struct.pack("<3f", *p) for p in CUBE)
        (self.folder / "c.ply").write_bytes(header.encode() + body)
        header = ("VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 9\nHEIGHT 1\n"
                  "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 9\nDATA binary\n")
        (self.folder / "c.pcd").write_bytes(header.encode() + body + struct.pack("<3f", 1, float("nan"), 2))
        for ending in ("xyz", "txt", "csv", "pts", "obj", "off", "ply", "pcd"):
            report = self.json_of("delaunay", f"c.{ending}")
            self.assertEqual((report["points"], report["delone_cells"]), (8, 1), ending)
            self.assertEqual(report["format"], "xyz" if ending == "txt" else ending)
            bytes_of = self.read(f"c.{ending}")
            (self.folder / "nameless").write_bytes(bytes_of)
            self.assertEqual(self.json_of("delaunay", "nameless")["points"], 8, ending)
            again = self.json_of("voronoi", f"c.{ending}", "--input-format", report["format"].upper())
            self.assertEqual(again["vertices"], 1)
        report = self.json_of("delaunay", "c.pcd")
        self.assertEqual(report["missing"], 1)
        self.assertIn("1 points are missing", report["warnings"][0])

    def test_bad_files_are_refused_with_their_place(self):
        for text, where in (("1 2 3\n4 5\n", "standard input:2: 2 columns"), ("1 2\n3 nan\n", ":2: 'nan'"), ("", "empty"),
                            ("1 2 inf\n", ":1: 'inf'"), ("x,y\n1,\n", ":2:"), ("9\n1 2 3\n", ":1: a count of '9'"),
                            ("2\n1 2 3\n", ":2: the file ends"),
                            ("OFF\n9 0 0\n0 0 0\n", ":3:"), ("<html>\n", "neither the content")):
            for command in ("delaunay", "voronoi"):
                self.assertIn(where, self.run_quoin(command, "-", stdin=text, code=REFUSED).stderr)

    def test_memory_and_mistakes(self):
        self.write("c.xyz", text_of(CUBE))
        for command in ("delaunay", "voronoi"):
            done = self.run_quoin(command, "c.xyz", "--memory", "0.001", code=REFUSED)
            self.assertRegex(done.stderr, r"8 points need about \d+ MB of memory, more than --memory allows")
            self.run_quoin(command, "c.xyz", "--memory", "100")
            for mistake in (["--memory", "0"], ["--memory", "x"], ["--input-format", "las"], ["-o", "x.stl"],
                            ["-o", "x.qsolid"], ["-o", "x"], ["--format", "vtk"],
                            ["-o", "-", "--format", "stl"], ["-o", "x.vtk", "--format", "vtk"]):
                self.run_quoin(command, "missing.xyz", *mistake, code=USAGE)
            self.assertIn("not welded", self.json_of(command, "c.xyz", "--weld", "1")["warnings"][0])
        self.run_quoin("voronoi", "missing.xyz", "--exact", code=USAGE)
        self.run_quoin("voronoi", "missing.xyz", "-o", "x.html", code=USAGE)

    def most_memory(self, *words):
        """The exit code and the most memory that the command holds, in bytes."""
        with open(self.folder / "errors", "wb") as errors:
            process = subprocess.Popen([self.quoin, *words], cwd=self.folder, stderr=errors, stdout=subprocess.DEVNULL)
            _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        return process.returncode, usage.ru_maxrss * 1024

    def test_far_more_cells_than_points_do_not_take_more_memory_than_allowed(self):
        count = 2000  # on each of two skew lines: its square is the number of cells
        self.write("skew.xyz", text_of([(i, 0, 0) for i in range(count)] + [(0, i, 1) for i in range(count)]))
        code, most = self.most_memory("delaunay", "skew.xyz", "--memory", "20", "-o", "out.vtk")
        self.assertEqual(code, REFUSED)
        self.assertRegex(self.read("errors").decode(), r"^quoin: stopped at \d+ MB of memory, more than --memory allows\n$")
        self.assertFalse((self.folder / "out.vtk").exists())
        code, needed = self.most_memory("delaunay", "skew.xyz", "--memory", "2000")
        self.assertEqual(code, DONE)
        self.assertLess(most, needed * 3 // 4)

    def run_within(self, limits, *words):
        """The finished process under these limits of the system, or None where it cannot even begin under them."""
        def set_limits():
            for kind, value in limits:
                resource.setrlimit(kind, (value, resource.getrlimit(kind)[1]))
        def run(*words):
            return subprocess.run([self.quoin, *words], cwd=self.folder, capture_output=True, text=True, timeout=120,
                                  preexec_fn=set_limits)
        try:
            return run(*words) if run("--version").returncode == DONE else None
        except subprocess.SubprocessError:
            return None

    def test_no_thread_for_the_watch(self):
        self.write("few.xyz", text_of(CUBE))
        limits = [(resource.RLIMIT_STACK, 1 << 47)]  # what a thread's stack has then is beyond all addresses
        done = self.run_within(limits, "delaunay", "few.xyz")
        if done is None:
            self.skipTest("no such limits here")
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        self.assertEqual(done.stdout, self.run_quoin("delaunay", "few.xyz").stdout)
        done = self.run_within(limits, "delaunay", "few.xyz", "--memory", "100")
        self.assertEqual((done.returncode, done.stdout), (REFUSED, ""))
        self.assertRegex(done.stderr, "^quoin: cannot start a thread: Resource temporarily unavailable; there is too "
                         "little memory or too many threads\n$")

    def test_little_memory(self):
        def within(megabytes, *words):
            return self.run_within([(resource.RLIMIT_AS, megabytes << 20)], *words)
        too_few, enough = 1, 2048
        if within(enough, "--version") is None:
            self.skipTest("no such limits here")
        while too_few + 1 < enough:  # to begin at all
            middle = (too_few + enough) // 2
            too_few, enough = (middle, enough) if within(middle, "--version") is None else (too_few, middle)
        self.write("many.xyz", text_of(cloud(20000, 3)))
        codes = []
        for megabytes in [*range(enough, enough + 30, 2), 2048]:
            done = within(megabytes, "delaunay", "many.xyz", "--threads", "4")
            if done is None:  # at the edge it may begin, or not
                continue
            codes.append(done.returncode)
            if done.returncode == DONE:
                continue
            self.assertEqual(done.returncode, REFUSED, f"{megabytes} MB: {done.stderr}")
            self.assertRegex(done.stderr, "(?m)^quoin: (out of memory|cannot start a thread: .*|too little memory .*|"
                             "20000 points need about .*)$", f"{megabytes} MB")
        self.assertIn(REFUSED, codes)
        self.assertEqual(codes[-1], DONE)

    def test_interruption(self):
        self.write("large.xyz", text_of(cloud(200000, 3)))
        self.write("less.xyz", text_of(cloud(20000, 3)))
        for words, stage in ((["delaunay", "large.xyz"], b"reading"), (["voronoi", "less.xyz", "--cells"], b"volumes")):
            with subprocess.Popen([self.quoin, *words, "-v"], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL,
                                  cwd=self.folder) as process:
                while stage not in process.stderr.readline():
                    pass
                start = time.monotonic()
                process.send_signal(signal.SIGINT)
                self.assertIn(b"cancelled", process.stderr.read())
                self.assertLess(time.monotonic() - start, 2)  # of a loaded machine, perhaps with sanitizers
                self.assertEqual(process.wait(timeout=60), OUT_OF_TIME)


class Voronoi(CommandTest):
    def test_areas_of_the_plane(self):
        for points in (cloud(25, 2), cloud(40, 2, grid=5)):
            sites = sorted(set(points))
            report = self.json_of("voronoi", "-", "--cells", "--exact", stdin=text_of(points))
            self.assertEqual((report["distinct"], len(report["cells"])), (len(sites), len(sites)))
            for cell in report["cells"]:
                site = tuple(cell["point"])
                self.assertEqual(points[cell["input"]], site)
                self.assertEqual([i for i, p in enumerate(points) if p == site], cell.get("inputs", [cell["input"]]))
                area, bounded = cell_of_plane(site, [s for s in sites if s != site])
                self.assertEqual(cell["bounded"], bounded)
                if bounded:
                    self.assertEqual(Fraction(cell["exact_area"]), area)
                    self.assertEqual(cell["area"], float(area))
                else:
                    self.assertIsNone(cell["area"])
            self.assertEqual(report["bounded_cells"], sum(c["bounded"] for c in report["cells"]))
            self.assertEqual(report["distinct"] - report["edges"] + report["vertices"], 1)
            pairs = {(c["input"], n) for c in report["cells"] for n in c["neighbours"]}
            self.assertEqual(len(pairs), 2 * report["edges"])
            self.assertEqual(pairs, {(b, a) for a, b in pairs})

    def test_areas_with_weights(self):
        for points in (cloud(25, 2), cloud(40, 2, grid=5)):
            rng = random.Random(5)
            weights = {p: rng.randint(-3, 6) for p in sorted(set(points))}
            lines = [p + (weights[p],) for p in points] + [points[0] + (weights[points[0]] - 1,)]
            report = self.json_of("voronoi", "-", "--weighted", "--cells", "--exact", stdin=text_of(lines))
            cells = {tuple(c["point"]): c for c in report["cells"]}
            for site, weight in weights.items():
                area, bounded = cell_of_plane(site, [s for s in weights if s != site], weights)
                self.assertEqual(area > 0, site in cells)
                if site not in cells:
                    continue
                self.assertEqual((cells[site]["bounded"], cells[site]["weight"]), (bounded, weight))
                self.assertEqual(cells[site].get("inputs", [cells[site]["input"]]),
                                 [i for i, p in enumerate(points) if p == site])
                if bounded:
                    self.assertEqual(Fraction(cells[site]["exact_area"]), area)
            hidden = [i for i, p in enumerate(points) if p not in cells] + [len(points)]
            self.assertEqual((report["distinct"], report["hidden"], report["hidden_points"]),
                             (len(weights), len(hidden), hidden))
            self.assertEqual(len(cells) - report["edges"] + report["vertices"], 1)
            self.assertEqual(len(cells), report["bounded_cells"] + report["infinite_cells"])

    def test_equal_weights_count_for_nothing(self):
        for points in (cloud(30, 3), cloud(60, 3, grid=3), cloud(30, 2), [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 0, 0)]):
            plain = self.json_of("voronoi", "-", "--cells", "--exact", "-o", "p.vtk", "-o", "p.obj", "-o", "p.qcells",
                                 stdin=text_of(points))
            same = self.json_of("voronoi", "-", "--weighted", "--cells", "--exact", "-o", "w.vtk", "-o", "w.obj",
                                "-o", "w.qcells", stdin=text_of([p + (-2.5,) for p in points]))
            self.assertEqual((same.pop("hidden"), same.pop("hidden_points")), (0, []))
            for cell in same["cells"]:
                self.assertEqual(cell.pop("weight"), -2.5)
            for key in ("outputs", "warnings"):
                plain.pop(key, None)
                same.pop(key, None)
            self.assertEqual(same, plain)
            self.assertEqual(self.read("w.qcells"), self.read("p.qcells"))
            self.assertEqual(self.read("w.obj"), self.read("p.obj"))
            _, cells, arrays = read_vtk(self.read("w.vtk").decode())
            self.assertEqual(arrays["weight"], [-2.5] * len(cells))

    def test_weights_that_hide(self):
        # A heavy ball in a cube of light ones takes all of the inside; one in the middle of a side lies in a face only.
        points = [p + (0,) for p in CUBE] + [(0.5, 0.5, 0.5, 0.25), (0.5, 0.5, 0.5, 0), (0.5, 0.5, 0, -0.5)]
        report = self.json_of("voronoi", "-", "--weighted", "--cells", stdin=text_of(points))
        self.assertEqual((report["distinct"], report["hidden_points"]), (10, [9, 10]))
        self.assertEqual((report["bounded_cells"], report["infinite_cells"]), (1, 8))
        ball = report["cells"][8]
        self.assertEqual((ball["input"], ball["exact_volume"], ball["neighbours"]), (8, "4/3", list(range(8))))
        self.run_quoin("voronoi", "-", "--weighted", stdin="1 2\n3 4\n", code=REFUSED)
        self.run_quoin("voronoi", "-", "--weighted", stdin="1 2 0\n3 4 nan\n", code=REFUSED)

    def test_volumes_of_lattices(self):
        points = list(itertools.product(range(4), repeat=3))
        report = self.json_of("voronoi", "-", "--cells", "-o", "v.vtk", "-o", "v.obj", "-o", "w.vtk",
                              stdin=text_of(points))
        self.assertEqual((report["vertices"], report["edges"], report["facets"]), (27, 108, 144))
        for cell in report["cells"]:
            inner = all(c in (1, 2) for c in cell["point"])
            self.assertEqual((cell["bounded"], cell["volume"], cell["exact_volume"]),
                             (True, 1, "1") if inner else (False, None, None))
            near = [i for i, p in enumerate(points) if sum(abs(a - b) for a, b in zip(p, cell["point"])) == 1]
            self.assertEqual(cell["neighbours"], near)
        self.assertEqual(self.read("v.vtk"), self.read("w.vtk"))
        vertices, cells, arrays = read_vtk(self.read("v.vtk").decode())
        self.assertEqual((len(vertices), len(cells), arrays["volume"]), (27, 8, [1] * 8))
        for (kind, numbers), site in zip(cells, arrays["input"]):
            self.assertEqual((kind, numbers[0], len(numbers)), (42, 6, 31))
            corners = {vertices[v] for k in range(6) for v in numbers[2 + 5 * k:6 + 5 * k]}
            self.assertEqual(corners, {tuple(c + e for c, e in zip(points[int(site)], offset))
                                       for offset in itertools.product((-0.5, 0.5), repeat=3)})
        self.assertEqual(sum(line.startswith("f ") for line in self.read("v.obj").decode().splitlines()), 36)
        self.assertIn("56 cells are infinite", report["warnings"][0])

    def test_polygons(self):
        self.write("g.csv", "".join(f"{x},{y}\n" for x in range(4) for y in range(4)))
        report = self.json_of("voronoi", "g.csv", "-o", "g.off", "-o", "g.vtk")
        self.assertTrue(self.read("g.off").startswith(b"OFF\n9 4 0\n"))
        self.assertEqual({t for t, _ in read_vtk(self.read("g.vtk").decode())[1]}, {7})
        self.assertNotIn("cells", report)
        text = self.run_quoin("voronoi", "g.csv", "--cells", "-q").stdout
        self.assertEqual(text, "")
        self.assertIn("cell 5 of [1.0,1.0]: 1.0 = 1, next to [1,4,6,9]\n", self.run_quoin("voronoi", "g.csv", "--cells").stdout)

    def test_degenerate_clouds(self):
        for text, dimension, faces in (("1 2 3\n", 0, (0, 0, 0)), ("0 0 0\n1 1 1\n2 2 2\n", 1, (0, 0, 2)),
                                       ("0 0 1\n1 0 1\n0 1 1\n1 1 1\n", 2, (0, 1, 4))):
            report = self.json_of("voronoi", "-", "--cells", "-o", "d.vtk", stdin=text)
            self.assertEqual((report["dimension"], report["bounded_cells"]), (dimension, 0))
            self.assertEqual((report["vertices"], report["edges"], report["facets"]), faces)
            self.assertEqual(read_vtk(self.read("d.vtk").decode())[:2], ([], []))
        report = self.json_of("voronoi", "-", "--cells", stdin="0 0\n2 2\n1 1\n0 0\n")
        self.assertEqual([c["neighbours"] for c in report["cells"]], [[2], [2], [0, 1]])
        self.assertEqual((report["edges"], report["vertices"]), (2, 0))

    def test_long_fractions_only_if_asked_for(self):
        points = text_of(cloud(60, 3, seed=9))
        short = self.json_of("voronoi", "-", "--cells", stdin=points)
        exact = self.json_of("voronoi", "-", "--cells", "--exact", stdin=points)
        for a, b in zip(short["cells"], exact["cells"]):
            self.assertEqual((a["volume"], a["exact_volume"]), (b["volume"], None))
            if b["bounded"]:
                self.assertEqual(float(Fraction(b["exact_volume"])), b["volume"])
        self.assertGreater(exact["bounded_cells"], 10)


if __name__ == "__main__":
    main()
