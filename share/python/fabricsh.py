"""fabricsh from Python: run decks, read what they leave.

    import fabricsh
    fabricsh.run("pull.lua")                                # or run_text("local fabric = require 'fabric' ...")
    curve = fabricsh.read_record("out/pull/curve.csv")      # curve["force"], curve.units["force"], curve.frame()
    sheet = fabricsh.read_series("out/pull/strip.pvd")[-1]  # sheet.points, sheet.cells, sheet["S11"]
    card = fabricsh.read_card("denim")                      # card["warp"]["loading"], card.pull("warp", strains)

`pip install share/python` installs it; it is also one file that works where it lies. It needs numpy; pandas only where a DataFrame is asked for, meshio only in Frame.meshio().
Values are in SI as everywhere in fabricsh. The program is found by, in this order, the argument `program`, the environment
variable FABRICSH, the tree or installation that this file lies in, and PATH.
"""
import base64
import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import xml.etree.ElementTree
import zlib

try:
    import numpy
except ImportError:
    raise ImportError("the module fabricsh needs numpy, which this Python has not: apt install python3-numpy, or pip install numpy") from None

__all__ = ["CardFile", "Curve", "DeckError", "Error", "Frame", "Interrupted", "NumericalFailure", "Result", "Series", "UsageError",
           "find_program", "read_card", "read_record", "read_run", "read_series", "read_test", "run", "run_text",
           "runs_frame"]


class Error(Exception):
    """A run of the program that did not end well. `str()` is the program's own message.

    deck, line: where in the deck, None where the message names no place. code: exit code. stdout, stderr: what was said.
    """

    def __init__(self, message, code, stdout="", stderr=""):
        super().__init__(message)
        place = re.match(r"(.+?):(\d+): ", message)
        self.deck, self.line = (place.group(1), int(place.group(2))) if place else (None, None)
        self.code, self.stdout, self.stderr = code, stdout, stderr


class DeckError(Error):
    """The deck is wrong (exit code 1)."""


class UsageError(Error):
    """The program was called wrongly (exit code 2)."""


class NumericalFailure(Error):
    """A run found no solution (exit code 3)."""


class Interrupted(Error):
    """The run was ended by a signal or by the time limit."""


class Result:
    """The output of a run: stdout (the deck's prints), stderr, and of that the warnings, one text each."""

    def __init__(self, stdout, stderr):
        self.stdout, self.stderr = stdout, stderr
        self.warnings = [line[len("warning: "):] for line in stderr.splitlines() if line.startswith("warning: ")]

    def __repr__(self):
        return self.stdout


def find_program(program=None):
    """Path of the program fabricsh as text; FileNotFoundError says where it was looked for."""
    if program or os.environ.get("FABRICSH"):
        found = shutil.which(str(program or os.environ["FABRICSH"]))
        if not found:
            raise FileNotFoundError(f"no program {program or os.environ['FABRICSH']!r}")
        return found
    # <tree>/share/python/fabricsh.py with <tree>/build, or <prefix>/share/fabricsh/share/python/fabricsh.py with <prefix>/bin.
    here = pathlib.Path(__file__).resolve().parents
    beside = [here[2] / "build" / "fabricsh"] + ([here[4] / "bin" / "fabricsh"] if len(here) > 4 else [])
    for path in beside:
        if os.access(path, os.X_OK):
            return str(path)
    found = shutil.which("fabricsh")
    if not found:
        raise FileNotFoundError("no program fabricsh in " + ", ".join(map(str, beside)) + " or PATH; the variable FABRICSH names it")
    return found


def _message(stderr):
    """The program's error: from the last line that begins with its name to the end."""
    at = stderr.rfind("\nfabricsh: ")
    return stderr[at + 1:].removeprefix("fabricsh: ").strip() if at >= 0 else stderr.removeprefix("fabricsh: ").strip()


def _name(word):
    """A name that begins with "-" as one that the program cannot take for an option, or for its standard input."""
    word = os.fspath(word) if isinstance(word, os.PathLike) else str(word)
    return os.path.join(os.curdir, word) if word.startswith("-") else word


_GRACE = 12  # seconds for the program to close its tables and series; it ends by itself within ten


def _end(child, number, grace):
    """Ends the program and what it started: first by this signal, then for good."""
    for one, wait in ((number, grace), (signal.SIGKILL, None)):
        try:
            os.killpg(child.pid, one)
        except (ProcessLookupError, PermissionError):
            pass
        try:
            child.wait(wait)
            break
        except subprocess.TimeoutExpired:
            pass
    try:  # what the program left behind in its group
        os.killpg(child.pid, signal.SIGKILL)
    except (ProcessLookupError, PermissionError):
        pass


def _call(options, *, text=None, program=None, cwd=None, timeout=None):
    """Runs the program with these options, `text` as its standard input, and raises what its exit code says.

    The output goes to files, not to pipes: a program that it started and that goes on would hold a pipe open.
    """
    with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as said:
        given.write((text or "").encode("utf-8", "surrogateescape"))
        given.seek(0)

        def told():
            texts = []
            for file in (out, said):
                file.seek(0)
                texts.append(file.read().decode("utf-8", "replace").replace("\r\n", "\n"))
            return texts

        # A group of its own, so that all of it can be ended.
        child = subprocess.Popen([find_program(program), "--quiet", *map(str, options)], cwd=cwd, stdin=given if text is not None else subprocess.DEVNULL,
                                 stdout=out, stderr=said, start_new_session=True)
        try:
            child.wait(timeout)
        except subprocess.TimeoutExpired:
            _end(child, signal.SIGTERM, _GRACE)  # the program closes its tables and series
            raise Interrupted(f"ended after {timeout} s, the time limit", child.returncode, *told()) from None
        except BaseException:
            _end(child, signal.SIGINT, _GRACE)
            raise
        stdout, stderr = told()
    code = child.returncode
    if code:
        stopped = code < 0 or code in (128 + signal.SIGHUP, 128 + signal.SIGINT, 128 + signal.SIGTERM)
        kind = {1: DeckError, 2: UsageError, 3: NumericalFailure}.get(code, Interrupted if stopped else Error)
        raise kind(_message(stderr) if code in (1, 2, 3) or stopped and _message(stderr) else _ended_with(code), code, stdout, stderr)
    return Result(stdout, stderr)


def _ended_with(code):
    """The meaning of an exit code that is none of the program's own: os.exit(7) in a deck, or a signal."""
    if code >= 0:
        return f"ended with exit code {code}"
    try:
        return f"ended by signal {-code} ({signal.Signals(-code).name})"
    except ValueError:
        return f"ended by signal {-code}"


def _options(threads, restart, check, safe):
    options = ["--threads", threads] if threads is not None else []
    options += ["--restart", _name(restart)] if restart is not None else []
    return options + ["--check"] * bool(check) + ["--safe"] * bool(safe)


def run(deck, *arguments, threads=None, restart=None, check=False, safe=False, program=None, cwd=None, timeout=None):
    """Runs a deck to its end and returns a Result; raises DeckError, UsageError, NumericalFailure or Interrupted, and Error for an exit code of the deck's own.

    deck: a name, also one that begins with "-". arguments: what the deck sees in `arg`. threads: None is the program's own choice. restart: a checkpoint's file. check: validate
    everything, run nothing. safe: for decks from elsewhere. cwd: the folder it runs in. timeout: seconds; then the program
    and what it started are ended.
    """
    options = _options(threads, restart, check, safe)
    return _call([*options, _name(deck), *arguments], program=program, cwd=cwd, timeout=timeout)


def run_text(text, *arguments, threads=None, restart=None, check=False, safe=False, program=None, cwd=None, timeout=None):
    """Runs Lua text as a deck; else as run(). Messages call it stdin."""
    options = _options(threads, restart, check, safe)
    return _call([*options, "-", *arguments], text=text, program=program, cwd=cwd, timeout=timeout)


class Curve(dict):
    """Columns of a table by name, 1-D arrays of one length; `units` has the unit of each column as text, "" where none is told."""

    def __init__(self, columns, units):
        super().__init__(columns)
        self.units = units

    def frame(self):
        """A pandas DataFrame; its attrs["units"] are the units."""
        import pandas

        frame = pandas.DataFrame(dict(self))
        frame.attrs["units"] = dict(self.units)
        return frame


def _number(text, path, row, name):
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"{path}: line {row}, column '{name}': expected a number, got '{text}'") from None


def read_record(path):
    """A CSV file of run:record or of a virtual test: a Curve. Headings are `name (unit)`, empty cells nan."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = csv.reader(file)
        try:
            heading = next(rows, None)
        except UnicodeDecodeError:
            raise ValueError(f"{path}: not written by fabricsh (its letters are not UTF-8); read_test reads the files of testing machines") from None
        if not heading:
            raise ValueError(f"{path}: no heading")
        split = [re.fullmatch(r"(.*?)(?: \(([^()]*)\))?", text) for text in heading]
        names = [match.group(1) for match in split]
        if len(set(names)) != len(names):
            raise ValueError(f"{path}: a column twice: {', '.join(heading)}")
        columns = [[] for _ in names]
        for row in rows:
            if not row:
                continue
            if len(row) != len(names):
                raise ValueError(f"{path}: line {rows.line_num}: expected {len(names)} values, got {len(row)}")
            for name, column, text in zip(names, columns, row):
                column.append(_number(text, path, rows.line_num, name) if text.strip() else numpy.nan)
    return Curve({name: numpy.array(column, dtype=float) for name, column in zip(names, columns)},
                 {name: match.group(2) or "" for name, match in zip(names, split)})


def read_run(path):
    """run.json as a dict: version, deck, deck_hash, arguments, threads, and runs, a list with a dict for each run of that folder."""
    with open(path, encoding="utf-8") as file:
        try:
            return json.load(file)
        except ValueError as error:
            raise ValueError(f"{path}: not a run.json: {error}") from None


def runs_frame(path):
    """The runs of a run.json as a pandas DataFrame, a row each; what is nested is named as in steps.iterations."""
    import pandas

    return pandas.json_normalize(read_run(path)["runs"])


_TYPES = {"Float64": "f8", "Float32": "f4", "Int64": "i8", "Int32": "i4", "UInt64": "u8", "UInt32": "u4", "UInt8": "u1", "Int8": "i1"}


class Frame:
    """A sheet at one time, from a .vtu file: lists of nodes and elements begin at 0 here.

    points: (nodes, 3), m, as the file has them; deformed, reference: where the nodes are and were. units: by the name of an array. cells: the nodes of each element, a list of integer arrays.
    node, element: arrays by name, (nodes or elements[, components]). frame["S11"] is an array of the file or a component of one.
    """

    def __init__(self, path, time=None):
        self.path, self.time = str(path), time
        with open(path, "rb") as file:
            raw = file.read()
        # Bytes that are no XML stand in <AppendedData> behind an underscore.
        head, mark, tail = raw.partition(b"<AppendedData")
        encoding, _, self._data = tail.partition(b"_") if mark else (b"", b"", b"")
        self._base64 = b"base64" in encoding
        try:
            root = xml.etree.ElementTree.fromstring(head + b"</VTKFile>" if mark else head)
        except xml.etree.ElementTree.ParseError as error:
            raise ValueError(f"{path}: not a .vtu file: {error}") from None
        piece = root.find("UnstructuredGrid/Piece")
        if piece is None:
            raise ValueError(f"{path}: no <UnstructuredGrid> with a <Piece>")
        self._order = "<" if root.get("byte_order") == "LittleEndian" else ">"
        self._header = numpy.dtype(self._order + _TYPES[root.get("header_type", "UInt32")])
        self._compressed = bool(root.get("compressor"))
        if self._compressed and "ZLib" not in root.get("compressor"):
            raise ValueError(f"{path}: compressed by {root.get('compressor')}, expected vtkZLibDataCompressor")
        self._components = {}
        self.units = {}
        self.points = self._arrays(piece.find("Points"))["Points"]
        self.node = self._arrays(piece.find("PointData"))
        self.element = self._arrays(piece.find("CellData"))
        cells = self._arrays(piece.find("Cells"))
        self.cells = numpy.split(cells["connectivity"], cells["offsets"][:-1]) if len(cells["offsets"]) else []
        if self.time is None:
            told = self._arrays(root.find("UnstructuredGrid/FieldData")).get("TimeValue")
            self.time = float(told[0]) if told is not None else None
        del self._data

    @property
    def reference(self):
        return self.node["reference"] if "reference" in self.node else self.points - self.node["displacement"]

    @property
    def deformed(self):
        return self.reference + self.node["displacement"] if "reference" in self.node else self.points

    def names(self):
        """Everything that frame[name] knows."""
        return [*self.node, *self.element, *self._components]

    def __getitem__(self, name):
        for arrays in (self.node, self.element):
            if name in arrays:
                return arrays[name]
        if name in self._components:
            array, column = self._components[name]
            return array[:, column]
        raise KeyError(f"{self.path}: no '{name}', there are {', '.join(self.names())}")

    def meshio(self):
        """The same as a meshio.Mesh."""
        import meshio

        kinds = {3: "triangle", 4: "quad"}
        sizes = numpy.array([len(cell) for cell in self.cells])
        groups = [(kinds[size], numpy.flatnonzero(sizes == size)) for size in sorted(set(sizes))]
        return meshio.Mesh(self.points, [(kind, numpy.array([self.cells[i] for i in at])) for kind, at in groups],
                           point_data=self.node,
                           cell_data={name: [array[at] for _, at in groups] for name, array in self.element.items()})

    def _arrays(self, parent):
        arrays = {}
        for tag in parent if parent is not None else []:
            if tag.tag == "DataArray" and tag.get("type") in _TYPES:
                arrays[tag.get("Name")] = self._array(tag)
                unit = tag.find("InformationKey[@name='UNITS_LABEL']")
                if unit is not None:
                    self.units[tag.get("Name")] = unit.text.strip()
        return arrays

    def _array(self, tag):
        dtype = numpy.dtype(self._order + _TYPES[tag.get("type")])
        if tag.get("format") == "ascii":
            values = numpy.array((tag.text or "").split(), dtype=dtype)
        elif tag.get("format") == "appended":
            values = numpy.frombuffer(self._bytes(self._data[int(tag.get("offset")):], self._base64), dtype=dtype)
        else:
            values = numpy.frombuffer(self._bytes((tag.text or "").strip().encode(), True), dtype=dtype)
        count = int(tag.get("NumberOfComponents", "1"))
        if count == 1:
            return values
        values = values.reshape(-1, count)
        for column in range(count):
            name = tag.get(f"ComponentName{column}")
            if name:
                # Directions of a residual strain share the names of other arrays: told apart by the array's.
                self._components[name if name[-1:].isdigit() else f"{tag.get('Name')}_{name}"] = values, column
        return values

    def _bytes(self, data, is_base64):
        """The bytes of one array: a header of lengths, then blocks, each alone compressed, or one block as it is."""
        width = self._header.itemsize

        def taken(start, count):  # bytes of the file's coding that hold `count` bytes
            piece = data[start:start + (4 * ((count + 2) // 3) if is_base64 else count)]
            return (base64.b64decode(piece)[:count] if is_base64 else piece), start + len(piece)

        if not self._compressed:
            whole, _ = taken(0, width)
            count = int(numpy.frombuffer(whole, self._header)[0])
            return taken(0, width + count)[0][width:]
        blocks = int(numpy.frombuffer(taken(0, width)[0], self._header)[0])
        header, at = taken(0, (3 + blocks) * width)
        sizes = numpy.frombuffer(header, self._header)[3:]
        body, _ = taken(at, int(sizes.sum()))
        ends = numpy.cumsum(sizes)
        return b"".join(zlib.decompress(body[int(end - size):int(end)]) for size, end in zip(sizes, ends))


class Series:
    """Frames of a .pvd file, read as they are asked for: len(series), series.times (s), series[i], series.at(time)."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        try:
            sets = xml.etree.ElementTree.parse(path).getroot().iter("DataSet")
        except xml.etree.ElementTree.ParseError as error:
            raise ValueError(f"{path}: not a .pvd file: {error}") from None
        self._files = [(float(tag.get("timestep")), tag.get("file")) for tag in sets]
        self.times = numpy.array([time for time, _ in self._files])

    def __len__(self):
        return len(self._files)

    def __getitem__(self, i):
        if not -len(self._files) <= i < len(self._files):
            raise IndexError(f"{self.path}: frame {i} of {len(self._files)}")
        time, file = self._files[i]
        return Frame(self.path.parent / file, time)

    def at(self, time):
        """The frame nearest to this time, s."""
        if not self._files:
            raise IndexError(f"{self.path}: a series without frames")
        return self[int(numpy.abs(self.times - time).argmin())]


def read_series(path):
    """The .pvd file of run:vtk as a Series."""
    return Series(path)


# A card's own file says all of its fields, so that it is written and read back with functions that return their table.
_CARD = r"""
local fabric = require "fabric"
local function text(v)
  if type(v) == "string" then
    return '"' .. v:gsub('[%c"\\]', function(c) return ("\\u%04x"):format(c:byte()) end) .. '"'
  elseif type(v) == "table" then
    local parts = {}
    for _, x in ipairs(v) do parts[#parts + 1] = text(x) end
    if #parts > 0 or next(v) == nil then return "[" .. table.concat(parts, ",") .. "]" end
    for k, x in pairs(v) do parts[#parts + 1] = text(k) .. ":" .. text(x) end
    table.sort(parts)
    return "{" .. table.concat(parts, ",") .. "}"
  elseif type(v) == "number" then
    return v ~= v and "NaN" or v == 1/0 and "Infinity" or v == -1/0 and "-Infinity" or ("%.17g"):format(v)
  end
  return tostring(v)
end
fabric.card(arg[2]):write(arg[1])
package.loaded.fabric = setmetatable({}, { __index = function(_, kind)
  return function(fields) fields.kind = kind return fields end
end })
print(text(dofile(arg[1])))
"""

_PULL = """
local fabric = require "fabric"
local angle, at = tonumber(arg[3]) or arg[3], {}
for i = 4, #arg do at[#at + 1] = tonumber(arg[i]) end
local r = fabric.point(fabric.card(arg[2])):uniaxial(angle, at, { "E", "S", "E_lateral" })
for i = 1, #at do print(("%.17g %.17g %.17g"):format(r.E[i], r.S[i], r.E_lateral[i])) end
"""


_TEST = """
local fabric = require "fabric"
local t = { file = arg[2] }
for i = 3, #arg do
  local name, part, value = arg[i]:match "^([%a_]+)%.?([%a_]*)=(.*)$"
  if part ~= "" then
    t[name] = t[name] or {}
    t[name][part] = name == "columns" and tonumber(value) or value
  else
    t[name] = (name == "gauge_length" or name == "width") and tonumber(value) or value
  end
end
local r = fabric.lab.read(t)
local names = {}
for _, name in ipairs { "time", "displacement", "strain", "force" } do if r[name] then names[#names + 1] = name end end
print(table.concat(names, " "))
for i = 1, #r[names[1]] do
  local cells = {}
  for k, name in ipairs(names) do cells[k] = ("%.17g"):format(r[name][i]) end
  print(table.concat(cells, " "))
end
"""


def read_test(path, *, program=None, cwd=None, **options):
    """The record of a testing machine, in whatever language, units and encoding, as fabric.lab.read reads it: a Curve in SI with displacement, force,
    and time and strain where the file has them. options: its fields, such as units={"force": "daN"}, columns={"force": 3}, gauge_length=0.2 (m),
    width=0.05 (m), decimal=",", separator=";"."""
    arguments = []
    for name, value in options.items():
        if isinstance(value, dict):
            arguments += [f"{name}.{part}={entry}" for part, entry in value.items()]
        else:
            arguments.append(f"{name}={value}")
    names, *lines = _helper(_TEST, [str(path), *arguments], program, cwd).splitlines()
    rows = numpy.array([line.split() for line in lines], dtype=float).reshape(-1, len(names.split()))
    units = {"time": "s", "displacement": "m", "strain": "", "force": "N"}
    return Curve({name: rows[:, k] for k, name in enumerate(names.split())}, {name: units[name] for name in names.split()})


def _helper(text, arguments, program, cwd):
    """The output of a deck of this module; it sees the path of a file that it may write, then these arguments."""
    with tempfile.TemporaryDirectory() as folder:
        deck = os.path.join(folder, "deck.lua")
        with open(deck, "w", encoding="utf-8") as file:
            file.write(text)
        try:
            return _call([deck, os.path.join(folder, "card.lua"), *arguments], program=program, cwd=cwd).stdout
        except Error as error:  # the place in a deck that nobody wrote says nothing
            message = re.sub(r"^\S*deck\.lua:\d+: ", "", str(error)).split("\n  called from")[0]
            raise type(error)(message, error.code, error.stdout, error.stderr) from None


class CardFile(dict):
    """The fields of a card as its file has them, in SI; kind is "woven", "svk" or "linear". Lists of numbers are arrays."""

    def __init__(self, fields, name, program, cwd):
        super().__init__(fields)
        self._name, self._program, self._cwd = name, program, cwd

    def pull(self, direction, strains):
        """One material point pulled along "warp", "weft" or an angle in degrees to these Green-Lagrange strains, one after the
        other: a Curve with E, S (2nd Piola-Kirchhoff, Pa) and E_lateral."""
        strains = numpy.ravel(numpy.asarray(strains, dtype=float))
        if not len(strains) or not numpy.all(numpy.isfinite(strains)):
            raise ValueError(f"pull: expected finite strains, one at least, got {strains.tolist()}")
        texts = [repr(float(E)) for E in strains]
        told = _helper(_PULL, [self._name, direction, *texts], self._program, self._cwd)
        rows = numpy.array([line.split() for line in told.splitlines()], dtype=float).reshape(-1, 3)
        return Curve({"E": rows[:, 0], "S": rows[:, 1], "E_lateral": rows[:, 2]}, {"E": "", "S": "Pa", "E_lateral": ""})


def _arrays_of(value):
    if isinstance(value, dict):
        return {key: _arrays_of(entry) for key, entry in value.items()}
    if isinstance(value, list) and value and all(isinstance(x, float) for x in value):
        return numpy.array(value, dtype=float)
    return [_arrays_of(entry) for entry in value] if isinstance(value, list) else value


def read_card(name, *, program=None, cwd=None):
    """A card, shipped by its name or in a file by its path, as a CardFile."""
    name = str(name)
    return CardFile(_arrays_of(json.loads(_helper(_CARD, [name], program, cwd), parse_int=float)), name, program, cwd)
