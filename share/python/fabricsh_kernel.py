"""A Jupyter kernel over the prompt of fabricsh: cells of Lua, with what `fabric` holds as globals.

    python3 fabricsh_kernel.py install      for this user; then choose "fabricsh" in Jupyter

A cell is one chunk of Lua: its locals end with it, globals stay. A value that it returns, or a cell that is an expression, is
shown as the prompt shows it; figures and pictures (.svg, .png) that a cell names and makes are shown below it. Interrupting stops
a run behind its last step, as Ctrl-C does at the prompt. Needs python3-ipykernel.
"""
import base64
import json
import pathlib
import re
import select
import signal
import subprocess
import sys
import tempfile
import threading
import time

from ipykernel.kernelbase import Kernel

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import fabricsh

# Behind each cell both streams get a mark, that of standard output with whether the cell came to its end.
# The value of a cell is that of the expression that its last lines are: the fewest that can be returned, behind lines
# that are whole by themselves. A line that begins with what could go on with the one before stays with it.
_VALUE = ('(function(s) local f = load("return " .. s, "=cell") for i = #s, 1, -1 do if f then break end '
          'if s:sub(i, i) == "\\n" and s:find("^%s*[%w_#]", i + 1) and load(s:sub(1, i)) then '
          'f = load(s:sub(1, i) .. "return " .. s:sub(i + 1), "=cell") end end return f or assert(load(s, "=cell")) end)')
_CELL = ('(function(...) package.loaded["fabricsh.cell"] = true return ... end)'
         '(' + _VALUE + '({0})())\n'
         'do local d = package.loaded["fabricsh.cell"] package.loaded["fabricsh.cell"] = nil '
         'io.stderr:write("\\1") io.stdout:write(d and "\\2\\1" or "\\1") io.stdout:flush() end\n')


def _quoted(text):
    """As a Lua string on one line."""
    return '"' + re.sub(rb'[^ -!#-\[\]-~]', lambda m: b"\\%03d" % m.group()[0], text.encode()).decode() + '"'


class FabricshKernel(Kernel):
    implementation, implementation_version, banner = "fabricsh", "1", "fabricsh: the mechanics of woven cloth"
    language_info = {"name": "lua", "mimetype": "text/x-lua", "file_extension": ".lua"}

    def __init__(self, **options):
        super().__init__(**options)
        self._child = None

    def _start(self):
        # A session of its own: Jupyter's signal reaches this process alone, which passes it on while a cell runs.
        self._child = subprocess.Popen([fabricsh.find_program(), "--quiet", "-i"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE, start_new_session=True)

    def _stream(self, name, text):
        if text and not self._silent:
            self.send_response(self.iopub_socket, "stream", {"name": name, "text": text.decode(errors="replace")})
        return b""

    def _hear(self, pipe, name, heard, end):
        """Passes on what the program says, up to the mark. Text on the stream of errors right before the mark is
        kept: where the cell fails it is the message, which Jupyter shows by itself."""
        kept = b""
        while True:
            if kept and not select.select([pipe], [], [], 0.2)[0]:
                kept = self._stream(name, kept)
            piece = pipe.read1(65536)
            heard.append(piece)
            kept += piece.rstrip(b"\1\2")
            if name == "stdout":
                kept = self._stream(name, kept)
            if not piece or piece.endswith(b"\1"):
                self._complaint = kept if name == "stderr" else self._complaint
                return end.set()

    def do_execute(self, code, silent, store_history=True, user_expressions=None, allow_stdin=False):
        if self._child is None or self._child.poll() is not None:
            self._start()
        self._silent, self._complaint, begun = silent, b"", time.time() - 0.01
        self._child.stdin.write(_CELL.format(_quoted(code)).encode())
        self._child.stdin.flush()
        said, complained = [], []
        # Events, since a thread whose join was interrupted counts as ended while it still runs.
        ends = [threading.Event(), threading.Event()]
        for pipe, name, heard, end in ((self._child.stdout, "stdout", said, ends[0]), (self._child.stderr, "stderr", complained, ends[1])):
            threading.Thread(target=self._hear, args=(pipe, name, heard, end)).start()
        while not all(end.is_set() for end in ends):
            try:
                for end in ends:
                    end.wait()
            except KeyboardInterrupt:
                self._child.send_signal(signal.SIGINT)
        if not b"".join(said).endswith(b"\1"):
            self._await_end()
        if not silent:
            self._show_figures(code, begun)
        status = {"execution_count": self.execution_count}
        if b"".join(said).endswith(b"\2\1"):
            self._stream("stderr", self._complaint)
            return {**status, "status": "ok", "payload": [], "user_expressions": {}}
        message = self._complaint.decode(errors="replace").strip() or "the program ended"
        error = {"ename": "error", "evalue": message, "traceback": message.split("\n")}
        self.send_response(self.iopub_socket, "error", error)
        return {**status, **error, "status": "error"}

    # A program whose output has ended is about to end: the next cell must find it gone, not write to it.
    def _await_end(self):
        try:
            self._child.wait(timeout=10)
        except subprocess.TimeoutExpired:
            self._child.kill()
            self._child.wait()

    def _show_figures(self, code, begun):
        for name in re.findall(r"""["']([^"'\n]+\.(?:svg|png))["']""", code):
            path = pathlib.Path(name)
            if path.is_file() and path.stat().st_mtime >= begun:
                shown = ({"image/svg+xml": path.read_text()} if path.suffix == ".svg"
                         else {"image/png": base64.b64encode(path.read_bytes()).decode()})
                self.send_response(self.iopub_socket, "display_data", {"data": {**shown, "text/plain": name}, "metadata": {}})

    def do_shutdown(self, restart):
        if self._child:
            self._child.stdin.close()
            self._child.terminate()
            self._child.wait()
            self._child = None
        return {"status": "ok", "restart": restart}


def install():
    from jupyter_client.kernelspec import KernelSpecManager

    with tempfile.TemporaryDirectory() as folder:
        spec = {"argv": [sys.executable, str(pathlib.Path(__file__).resolve()), "-f", "{connection_file}"],
                "display_name": "fabricsh", "language": "lua"}
        pathlib.Path(folder, "kernel.json").write_text(json.dumps(spec))
        print(KernelSpecManager().install_kernel_spec(folder, "fabricsh", user=True))


if __name__ == "__main__":
    if sys.argv[1:] == ["install"]:
        install()
    else:
        from ipykernel.kernelapp import IPKernelApp

        IPKernelApp.launch_instance(kernel_class=FabricshKernel)
