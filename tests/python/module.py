"""share/python/fabricsh.py: runs, errors, tables, series, cards, run.json."""
import importlib.util
import json
import os
import pathlib
import struct
import subprocess
import sys
import time
import unittest

if importlib.util.find_spec("numpy") is None:
    print("SKIPPED: python3-numpy not installed: the Python module was not tried")
    sys.exit(77)
import numpy

tree = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(tree / "share/python"))
import fabricsh

PULL = """
local fabric = require "fabric"
local mm = fabric.units.mm
local mesh = fabric.mesh.rectangle{ width=25.4*mm, height=76.2*mm, nx=3, ny=9 }
local model = fabric.model{ mesh=mesh, card=fabric.card "denim", warp=90 }
model:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y=fabric.ramp(10*mm, 1) })
local run = fabric.static{ model=model, duration=1, step=0.25 }
run:record("out/curve.csv", { order={ "displacement", "force", "peak" }, units={ peak="MPa" }, columns={
  displacement=function(a) return a:node(40).uy end,
  force=function(a) return select(2, a:reaction "top") end,
  peak=function(a) return math.max(table.unpack(a:field "S11")) / 1e6 end } })
run:vtk("out/strip", { every=0.25 })
run:solve()
print(("%.17g %.17g"):format(select(2, run:reaction "top"), run:element(5).S11), arg[1])
"""


def has(name):
    return importlib.util.find_spec(name) is not None


class Module(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        pathlib.Path("pull.lua").write_text(PULL)
        cls.result = fabricsh.run("pull.lua", "an argument", threads=1)
        cls.curve = fabricsh.read_record("out/curve.csv")
        cls.series = fabricsh.read_series("out/strip.pvd")

    def refused(self, kind, call):
        with self.assertRaises(kind) as caught:
            call()
        return caught.exception

    def test_without_numpy(self):
        pathlib.Path("bare").mkdir(exist_ok=True)
        pathlib.Path("bare/numpy.py").write_text("raise ImportError('no')\n")
        said = subprocess.run([sys.executable, "-c", "import fabricsh"], stderr=subprocess.PIPE, encoding="utf-8",
                              env={**os.environ, "PYTHONPATH": f"bare:{tree / 'share/python'}"}).stderr
        self.assertIn("ImportError: the module fabricsh needs numpy, which this Python has not: apt install", said)

    def test_pip(self):
        """The description of the package names this version and these files."""
        text = (tree / "share/python/pyproject.toml").read_text()
        version = (tree / "CMakeLists.txt").read_text().split("project(fabricsh VERSION ")[1].split()[0]
        self.assertIn(f'version = "{version}"', text)
        for name in ("fabricsh", "fabricsh_kernel"):
            self.assertTrue((tree / f"share/python/{name}.py").exists() and f'"{name}"' in text)

    def test_a_run(self):
        self.assertIn("an argument", self.result.stdout)
        self.assertEqual(self.result.warnings, [])
        self.assertEqual(fabricsh.run_text("print(1 + 1)").stdout, "2\n")
        self.assertEqual(fabricsh.run_text("print(arg[1], arg[2])", 12, "b", threads=1).stdout, "12\tb\n")
        pathlib.Path("elsewhere").mkdir(exist_ok=True)
        fabricsh.run("../pull.lua", "x", cwd="elsewhere", check=True)
        self.assertFalse(pathlib.Path("elsewhere/out").exists())

    def test_warnings_are_told(self):
        warned = fabricsh.run_text(PULL.replace("out/", "out/warned/").replace('fix("all", "z rotation")', 'fix("bottom", "z rotation"):fix("top", "z rotation")'))
        self.assertEqual(len(warned.warnings), 1)
        self.assertIn("bending.warp", warned.warnings[0])

    def test_a_deck_that_is_wrong(self):
        pathlib.Path("bad.lua").write_text('local fabric = require "fabric"\nprint "so far"\nfabric.mesh.rectangle{ widht=3 }\n')
        error = self.refused(fabricsh.DeckError, lambda: fabricsh.run("bad.lua"))
        self.assertEqual(str(error), "bad.lua:3: rectangle: unknown field 'widht', did you mean 'width'?")
        self.assertEqual((error.deck, error.line, error.code, error.stdout), ("bad.lua", 3, 1, "so far\n"))
        error = self.refused(fabricsh.DeckError, lambda: fabricsh.run("none.lua"))
        self.assertEqual(str(error), "cannot read 'none.lua': No such file or directory")
        self.assertIsNone(error.deck)
        error = self.refused(fabricsh.DeckError, lambda: fabricsh.run_text("local function f() error 'both\\nlines' end\nf()"))
        self.assertIn("both\nlines", str(error))

    def test_other_ends(self):
        error = self.refused(fabricsh.UsageError, lambda: fabricsh.run("pull.lua", threads="many"))
        self.assertIn("expected an integer from 1 to 4096, got 'many'", str(error))
        hard = PULL.replace("out/", "out/hard/").replace("step=0.25", "step=1, max_cuts=0, max_iterations=2").replace("10*mm", "-70*mm")
        error = self.refused(fabricsh.NumericalFailure, lambda: fabricsh.run_text(hard))
        self.assertEqual(error.deck, "stdin")
        self.assertIn("Try:", str(error))
        for seconds in (1, 10, 100):  # a busy machine may take longer to begin
            error = self.refused(fabricsh.Interrupted, lambda: fabricsh.run_text("print 'begun' io.stdout:flush() while true do end", timeout=seconds))
            if error.stdout:
                break
        self.assertEqual(error.stdout, "begun\n")
        self.assertIn("no program 'no-such-program'", str(self.refused(FileNotFoundError, lambda: fabricsh.run_text("", program="no-such-program"))))

    def test_names_that_begin_with_a_dash(self):
        """A name is a name, whatever it begins with: no option of the program's, nor its standard input."""
        for name in ("-e.lua", "--safe", "-", "--threads=2"):
            pathlib.Path(name).write_text("print(#arg, arg[1], arg[2])\n")
            self.assertEqual(fabricsh.run(name, "-i", "--check").stdout, "2\t-i\t--check\n", name)
            self.assertEqual(fabricsh.run(pathlib.Path(name), "--").stdout, "1\t--\tnil\n", name)
        self.assertEqual(fabricsh.run_text("print(arg[1])", "--version").stdout, "--version\n")
        error = self.refused(fabricsh.DeckError, lambda: fabricsh.run("--nonsense"))
        self.assertEqual(str(error), "cannot read './--nonsense': No such file or directory")
        self.assertIn("'./-none.ckpt'", str(self.refused(fabricsh.DeckError, lambda: fabricsh.run("pull.lua", restart="-none.ckpt"))))

    def test_exit_codes_as_they_are(self):
        for code in (4, 7, 77, 200):
            error = self.refused(fabricsh.Error, lambda: fabricsh.run_text(f"print 'so far' io.stdout:flush() os.exit({code})"))
            self.assertEqual((type(error), error.code, error.stdout), (fabricsh.Error, code, "so far\n"))
            self.assertEqual(str(error), f"ended with exit code {code}")
        for code, kind in ((1, fabricsh.DeckError), (2, fabricsh.UsageError), (3, fabricsh.NumericalFailure)):
            self.assertEqual(self.refused(kind, lambda: fabricsh.run_text(f"os.exit({code})")).code, code)
        error = self.refused(fabricsh.Interrupted, lambda: fabricsh.run_text("os.execute 'kill -KILL $PPID'"))
        self.assertEqual((error.code, str(error)), (-9, "ended by signal 9 (SIGKILL)"))

    def test_the_time_limit_ends_all(self):
        """Also what the deck started, and no pipe is waited for that something else holds open."""
        deck = "os.execute 'sleep 61.25 & setsid sleep 3.5 & sleep 61.25'"
        began = time.monotonic()
        error = self.refused(fabricsh.Interrupted, lambda: fabricsh.run_text(deck, timeout=1))
        self.assertIn("ended after 1 s, the time limit", str(error))
        self.assertLess(time.monotonic() - began, 30)
        for _ in range(100):  # the end of a process takes the system a moment
            left = [p for p in pathlib.Path("/proc").glob("[0-9]*/cmdline") if self.command(p) == ["sleep", "61.25"]]
            if not left:
                break
            time.sleep(0.1)
        self.assertEqual(left, [])
        began = time.monotonic()
        self.assertEqual(fabricsh.run_text("print 'done' io.stdout:flush() os.execute 'setsid sleep 20 &'").stdout, "done\n")
        self.assertLess(time.monotonic() - began, 15)

    @staticmethod
    def command(path):
        try:
            return path.read_bytes().decode("utf-8", "replace").split("\0")[:-1]
        except OSError:
            return []

    def test_a_record(self):
        force, S11 = map(float, self.result.stdout.split()[:2])
        self.assertEqual(list(self.curve), ["time", "displacement", "force", "peak"])
        self.assertEqual(self.curve.units, {"time": "s", "displacement": "m", "force": "N", "peak": "MPa"})
        self.assertEqual(self.curve["force"][-1], force)  # to the bit
        self.assertEqual(self.curve["time"].tolist(), [0, 0.25, 0.5, 0.75, 1])
        self.assertEqual(self.series[-1]["S11"][4], S11)

    def test_tables_of_others(self):
        pathlib.Path("odd.csv").write_text('"a, so ""called"" (kN)",b,c (1/s)\n1,nan,\n-2e-3,inf,5\n\n')
        odd = fabricsh.read_record("odd.csv")
        self.assertEqual(odd.units, {'a, so "called"': "kN", "b": "", "c": "1/s"})
        self.assertEqual(odd['a, so "called"'].tolist(), [1, -2e-3])
        self.assertTrue(numpy.isnan(odd["b"][0]) and numpy.isinf(odd["b"][1]) and numpy.isnan(odd["c"][0]))
        for text, told in (("", "bad.csv: no heading"), ("a,b\n1,2\n3\n", "bad.csv: line 3: expected 2 values, got 1"),
                           ("a,b\n1,x\n", "bad.csv: line 2, column 'b': expected a number, got 'x'"),
                           ("a (m),a (mm)\n", "bad.csv: a column twice: a (m), a (mm)")):
            pathlib.Path("bad.csv").write_text(text)
            self.assertEqual(str(self.refused(ValueError, lambda: fabricsh.read_record("bad.csv"))), told)

    def test_the_file_of_a_testing_machine(self):
        pathlib.Path("machine.csv").write_bytes("Prüfzeit;Weg;Kraft\ns;mm;daN\n0;0;0\n0,5;1,5;2,25\n1;3;4,5\n".encode("latin-1"))
        test = fabricsh.read_test("machine.csv")
        self.assertEqual((list(test), test.units["force"]), (["time", "displacement", "force"], "N"))
        numpy.testing.assert_allclose(test["force"], [0, 22.5, 45], rtol=1e-15)
        numpy.testing.assert_allclose(test["displacement"], [0, 1.5e-3, 3e-3], rtol=1e-15)
        self.assertIn("machine.csv: not written by fabricsh", str(self.refused(ValueError, lambda: fabricsh.read_record("machine.csv"))))
        pathlib.Path("strip.csv").write_text("Dehnung (%),Last (N/5cm),b\n0,0,0\n2,100,1\n4,210,2\n")
        strip = fabricsh.read_test("strip.csv", gauge_length=0.2, width=0.03, columns={"force": 2})
        numpy.testing.assert_allclose((strip["force"][1], strip["displacement"][1], strip["strain"][2]), (60, 4e-3, 0.04), rtol=1e-14)
        self.assertIn("read: strip.csv: field 'default_units.force': 'stone' is no unit", str(self.refused(fabricsh.DeckError,
                      lambda: fabricsh.read_test("strip.csv", default_units={"force": "stone"}, gauge_length=0.2, width=0.03))))

    def test_a_series(self):
        self.assertEqual(self.series.times.tolist(), [0, 0.25, 0.5, 0.75, 1])
        frame = self.series.at(0.6)
        self.assertEqual(frame.time, 0.5)
        self.assertEqual((frame.points.shape, len(frame.cells), frame.cells[0].tolist()), ((40, 3), 27, [0, 1, 5, 4]))
        numpy.testing.assert_allclose(frame.reference.max(axis=0), [0.0254, 0.0762, 0], atol=1e-15)
        self.assertAlmostEqual(frame.points[39, 1], 0.0762 + 0.005, places=12)
        self.assertEqual(frame["S"].shape, (27, 6))
        numpy.testing.assert_array_equal(frame["E12"], frame["E"][:, 3])
        numpy.testing.assert_allclose(frame.deformed, frame.points, atol=1e-17)
        self.assertEqual((frame.units["S"], frame.units["displacement"], frame.units.get("E")), ("Pa", "m", None))
        self.assertEqual(frame["top"].sum(), 4)
        self.assertIn("displacement", frame.names())
        self.assertIn("no 'S99', there are displacement", str(self.refused(KeyError, lambda: frame["S99"])))

    def test_every_way_a_vtu_is_written(self):
        points = [0., 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 0, 0]
        head = ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" byte_order="{order}" header_type="UInt64">\n<UnstructuredGrid>'
                '<Piece NumberOfPoints="5" NumberOfCells="2"><PointData/><CellData/><Points><DataArray type="Float64" Name="Points" '
                'NumberOfComponents="3" {data}</Points><Cells><DataArray type="Int32" Name="connectivity" format="ascii">0 1 3 2 1 4 3'
                '</DataArray><DataArray type="Int32" Name="offsets" format="ascii">4 7</DataArray></Cells></Piece></UnstructuredGrid>\n')
        import base64
        for order, mark in (("LittleEndian", "<"), ("BigEndian", ">")):
            block = struct.pack(mark + "Q15d", 120, *points)
            text = base64.b64encode(block).decode()
            for data, tail in ((f'format="binary">{text}</DataArray>', b""),
                               ('format="appended" offset="0"/>', b'<AppendedData encoding="raw">_' + block + b"</AppendedData>"),
                               ('format="appended" offset="0"/>', f'<AppendedData encoding="base64">_{text}</AppendedData>'.encode())):
                pathlib.Path("own.vtu").write_bytes(head.format(order=order, data=data).encode() + tail + b"</VTKFile>\n")
                frame = fabricsh.Frame("own.vtu")
                self.assertEqual(frame.points.ravel().tolist(), points)
                self.assertEqual([cell.tolist() for cell in frame.cells], [[0, 1, 3, 2], [1, 4, 3]])
        pathlib.Path("own.vtu").write_text("<VTKFile")
        self.assertIn("own.vtu: not a .vtu file", str(self.refused(ValueError, lambda: fabricsh.Frame("own.vtu"))))

    @unittest.skipUnless(has("meshio"), "SKIPPED: python3-meshio not installed")
    def test_as_meshio_reads_it(self):
        import meshio

        frame, theirs = self.series[-1], meshio.read("out/strip_00004.vtu")
        ours = frame.meshio()
        numpy.testing.assert_array_equal(ours.points, theirs.points)
        numpy.testing.assert_array_equal(ours.cells[0].data, theirs.cells[0].data)
        self.assertEqual(set(ours.point_data), set(theirs.point_data))
        for name, blocks in theirs.cell_data.items():
            numpy.testing.assert_array_equal(ours.cell_data[name][0], blocks[0])

    def test_what_is_not_there(self):
        pathlib.Path("none.pvd").write_text('<VTKFile type="Collection"><Collection></Collection></VTKFile>')
        none = fabricsh.read_series("none.pvd")
        self.assertEqual((len(none), list(none)), (0, []))
        self.assertEqual(str(self.refused(IndexError, lambda: none.at(1))), "none.pvd: a series without frames")
        self.assertEqual(str(self.refused(IndexError, lambda: self.series[5])), "out/strip.pvd: frame 5 of 5")
        self.assertEqual(self.series[-5].time, 0)
        self.assertIn("none.pvd: not a run.json", str(self.refused(ValueError, lambda: fabricsh.read_run("none.pvd"))))
        denim = fabricsh.read_card("denim")
        for strains in ([], [float("nan")], [0.01, float("inf")]):
            self.assertIn("pull: expected finite strains, one at least, got [", str(self.refused(ValueError, lambda: denim.pull("warp", strains))))

    def test_a_card(self):
        denim = fabricsh.read_card("denim")
        self.assertEqual((denim["kind"], denim["name"], denim["density"], denim["thickness"]), ("woven", "denim", 350, 1.12 * 1e-3))
        self.assertEqual(denim["warp"]["loading"].tolist(), [7e6, 3e6, -2e8, 1.81e9])
        E = numpy.array([0, 0.05, 0.1])
        pull = denim.pull("warp", E)
        # dS/dE = 7 + 3 E - 200 E^2 + 1810 E^3 MPa, and the weft's strain is -nu of it.
        numpy.testing.assert_allclose(pull["S"], 7e6*E + 3e6*E**2/2 - 2e8*E**3/3 + 1.81e9*E**4/4, rtol=1e-12)
        numpy.testing.assert_allclose(pull["E_lateral"], -0.12*E, rtol=1e-12)
        self.assertEqual(pull.units["S"], "Pa")
        self.assertGreater(denim.pull(45, [0.1])["E"][0], 0.09)
        pathlib.Path("mine.lua").write_text('return require "fabric".card "denim":with{ name="a \\"quoted\\"\\nname" }\n')
        self.assertEqual(fabricsh.read_card("./mine.lua")["name"], 'a "quoted"\nname')
        error = self.refused(fabricsh.DeckError, lambda: fabricsh.read_card("denm"))
        self.assertEqual(str(error), "card: unknown fabric 'denm', did you mean 'denim'?")
        pathlib.Path("svk.lua").write_text('return require "fabric".svk{ young=1e6, poisson=0.3, density=400, thickness=1e-3 }\n')
        self.assertEqual(fabricsh.read_card("./svk.lua")["kind"], "svk")

    def test_run_json(self):
        told = fabricsh.read_run("out/run.json")
        self.assertEqual((told["program"], told["deck"], told["arguments"][-1]), ("fabricsh", "pull.lua", "an argument"))
        self.assertEqual(told["runs"][0]["steps"]["count"], 4)

    @unittest.skipUnless(has("pandas"), "SKIPPED: python3-pandas not installed")
    def test_pandas(self):
        frame = self.curve.frame()
        self.assertEqual((list(frame.columns), len(frame), frame.attrs["units"]["force"]), (list(self.curve), 5, "N"))
        runs = fabricsh.runs_frame("out/run.json")
        self.assertEqual((runs["status"][0], runs["steps.count"][0]), ("done", 4))

    def test_without_pandas_and_meshio(self):
        script = ("import sys; sys.modules['pandas'] = sys.modules['meshio'] = None\nimport fabricsh\n"
                  "c, s = fabricsh.read_record('out/curve.csv'), fabricsh.read_series('out/strip.pvd')\n"
                  "print(len(c['force']), s[1]['S11'].size, fabricsh.read_run('out/run.json')['program'])\n")
        told = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(tree / "share/python")}).stdout
        self.assertEqual(told, "5 27 fabricsh\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
