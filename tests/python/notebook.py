"""The cells of a notebook, one after the other: what they show is what the notebook says they show.

    notebook.py <tree> <notebook.ipynb> [write]     write: put what they show into the notebook
Through Jupyter as well where nbclient and ipykernel are at hand.
"""
import ast
import contextlib
import importlib.util
import io
import json
import os
import pathlib
import sys

if importlib.util.find_spec("numpy") is None:
    print("SKIPPED: python3-numpy not installed: the notebook was not run")
    sys.exit(77)
tree, path = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
module = str(tree / "share/python")
sys.path.insert(0, module)
os.environ["PYTHONPATH"] = module
notebook = json.loads(path.read_text())
cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]


def shown_by(code, names):
    """The output of the cell, and its last expression's value as text, None without."""
    body = ast.parse(code).body
    value = body.pop() if body and isinstance(body[-1], ast.Expr) else None
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(compile(ast.Module(body, []), path.name, "exec"), names)
        result = eval(compile(ast.Expression(value.value), path.name, "eval"), names) if value else None
    return said.getvalue(), None if result is None else repr(result)


names, outputs = {"__name__": "__main__"}, []
for count, cell in enumerate(cells, 1):
    said, value = shown_by("".join(cell["source"]), names)
    output = [{"name": "stdout", "output_type": "stream", "text": said.splitlines(keepends=True)}] if said else []
    if value is not None:
        output.append({"data": {"text/plain": value.splitlines(keepends=True)}, "execution_count": count, "metadata": {},
                       "output_type": "execute_result"})
    if sys.argv[3:] == ["write"]:
        cell["outputs"], cell["execution_count"] = output, count
    elif cell["outputs"] != output:
        sys.exit(f"{path.name}: cell {count}\n--- showed:\n{said}{value}\n--- the notebook says:\n{json.dumps(cell['outputs'], indent=1)}")
if sys.argv[3:] == ["write"]:
    path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n")
print(f"{path.name}: {len(cells)} cells")

if all(importlib.util.find_spec(name) for name in ("nbclient", "nbformat", "ipykernel")):
    import nbclient
    import nbformat

    for name in ("JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR", "JUPYTER_CONFIG_DIR"):
        os.environ[name] = str(pathlib.Path("jupyter").resolve())
    nbclient.NotebookClient(nbformat.read(path, as_version=4), timeout=120, kernel_name="python3").execute()
    print(f"{path.name}: and through Jupyter")
else:
    print("not through Jupyter: python3-nbclient or python3-ipykernel is not installed")
