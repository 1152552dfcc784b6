"""The Jupyter kernel, through Jupyter's own client: values, errors that leave the session alive, an interrupt, a figure."""
import importlib.util
import json
import os
import pathlib
import signal
import sys

missing = [name for name in ("ipykernel", "jupyter_client") if importlib.util.find_spec(name) is None]
if missing:
    print("SKIPPED: python3-" + " and python3-".join(missing) + " not installed: the kernel was not tried")
    sys.exit(77)

kernel = pathlib.Path(sys.argv[1]).resolve() / "share/python/fabricsh_kernel.py"
data = pathlib.Path("jupyter").resolve()
for name in ("JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR", "JUPYTER_CONFIG_DIR"):
    os.environ[name] = str(data)
import subprocess

subprocess.run([sys.executable, str(kernel), "install"], check=True, stdout=subprocess.DEVNULL)
assert json.loads((data / "kernels/fabricsh/kernel.json").read_text())["display_name"] == "fabricsh"

# A program that a shell starts in the background has Ctrl-C ignored, which programs inherit.
signal.signal(signal.SIGINT, signal.default_int_handler)

from jupyter_client.manager import KernelManager

manager = KernelManager(kernel_name="fabricsh")
manager.start_kernel(env={**os.environ})
client = manager.blocking_client()
client.start_channels()
client.wait_for_ready(timeout=240)


def cell(code, wait=240, on_busy=None):
    heard = {"stdout": "", "stderr": "", "shown": []}

    def hear(message):
        content = message["content"]
        if message["msg_type"] == "stream":
            before = heard[content["name"]]
            heard[content["name"]] += content["text"]
            if on_busy and "busy" in heard[content["name"]] and "busy" not in before:
                on_busy()
        elif message["msg_type"] == "display_data":
            heard["shown"].append(sorted(content["data"]))

    # Jupyter drops what is sent right behind a cell that fails, unless it is told not to.
    reply = client.execute_interactive(code, timeout=wait, output_hook=hear, stop_on_error=False)["content"]
    return reply, heard


try:
    reply, heard = cell("1 + 1")
    assert reply["status"] == "ok" and heard["stdout"] == "2\n", (reply, heard)
    reply, heard = cell("local n = 0\nfor i = 1, 4 do\n  n = n + i\nend\nprint('sum \"so\"', n)\nreturn 3*mm")
    assert reply["status"] == "ok" and heard["stdout"] == 'sum "so"\t10\n0.003\n', (reply, heard)
    reply, heard = cell("strip = mesh.rectangle{ width=25.4*mm, height=76.2*mm, nx=3, ny=9 }")
    assert reply["status"] == "ok" and heard["stdout"] == "", (reply, heard)
    assert cell("strip")[1]["stdout"] == "<mesh 3x9, 40 nodes, 25.4 x 76.2 mm>\n"
    reply, heard = cell("x = 1\nmesh.rectangle{ widht=3 }")
    assert reply["status"] == "error" and "cell:2: rectangle: unknown field 'widht', did you mean 'width'?" in reply["evalue"], reply
    assert heard["stderr"] == "", heard  # Jupyter shows the error itself
    reply, heard = cell("for i = 1, 3 do")
    assert reply["status"] == "error" and "'end' expected near <eof>" in reply["evalue"], reply
    # The value of the last expression, behind other statements; what would go on with the line before stays with it.
    for code, value in (("local n = 2\nn + 1", "3\n"), ("y = 4\n\nfabric.units.mm *\n  y  -- a comment\n", "0.004\n"), ("y = 5", ""),
                        ("local f = function(t) return t[1] end\ny = f\n{ 7 }\ny", "7\n"), ("y = [[a\nb]]\n#y", "3\n"), ("y = 1 -- no value", "")):
        reply, heard = cell(code)
        assert reply["status"] == "ok" and heard["stdout"] == value, (code, reply, heard)
    reply, heard = cell("local k = { 1, 4, 9 }\nfabric.plot{ curves={ { x={ 1, 2, 3 }, y=k } } }")
    assert heard["stdout"].count("\n") > 20 or "gnuplot" in heard["stderr"] + reply.get("evalue", ""), (reply, heard)
    assert cell("x, strip == nil")[1]["stdout"] == "1\tfalse\n"
    assert cell("'\u00e4'")[1]["stdout"].strip().strip("\"'") == "\u00e4"
    # An interrupt stops what runs; the session and its values stay.
    reply, heard = cell("io.stderr:write 'busy\\n' while true do end", on_busy=manager.interrupt_kernel)
    assert reply["status"] == "error" and "interrupt" in reply["evalue"], (reply, heard)
    assert cell("x")[1]["stdout"] == "1\n"
    reply, heard = cell("fabric = require 'fabric'\nfabric.plot{ file='curve.svg', curves={ { x={0, 1, 2}, y={0, 1, 4} } } }")
    if pathlib.Path("curve.svg").exists():
        assert heard["shown"] == [["image/svg+xml", "text/plain"]], heard
    else:
        assert "gnuplot" in heard["stderr"], heard
    # The program's own end is told, and the next cell begins a new one.
    reply, heard = cell("os.exit(0)")
    assert reply["status"] == "error", reply
    assert cell("2*3")[1]["stdout"] == "6\n"
    print("kernel: 20 cells")
finally:
    client.stop_channels()
    manager.shutdown_kernel(now=False)
