#!/usr/bin/env python3
"""notebook_test.py PAGE [--update]: runs docs/notebook.ipynb, compares what comes out with what is in it, and writes it as a
page of HTML. With --update what is different is written into the notebook."""
import base64
import os
import sys
from pathlib import Path

import nbformat
from nbconvert import HTMLExporter
from nbconvert.preprocessors import ExecutePreprocessor

NOTEBOOK = Path(__file__).resolve().parents[3] / "docs/notebook.ipynb"


def outputs(cell):
    """What a cell shows: texts and pictures."""
    return [output.get("data") or output.get("text") or output for output in cell.get("outputs", [])]


def with_images(notebook):
    """A page has each picture as an image: some exporters take inline SVG apart, and styles of one would hold for all."""
    for output in (output for cell in notebook.cells for output in cell.get("outputs", [])):
        svg = output.get("data", {}).pop("image/svg+xml", None)
        if svg:
            image = base64.b64encode(svg.encode()).decode()
            output["data"]["text/html"] = f'<img src="data:image/svg+xml;base64,{image}">'
    return notebook


def main():
    os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # no remarks of the debugger
    # The kernel may be that of another environment: it finds what this one finds.
    os.environ["PYTHONPATH"] = os.pathsep.join(path for path in sys.path if path.endswith("site-packages"))
    shown = nbformat.read(NOTEBOOK, as_version=4)
    run = nbformat.read(NOTEBOOK, as_version=4)
    ExecutePreprocessor(timeout=600, record_timing=False).preprocess(run, {"metadata": {"path": str(NOTEBOOK.parent)}})
    run.metadata = shown.metadata  # without the versions of this machine
    differ = [old.source for old, new in zip(shown.cells, run.cells) if outputs(old) != outputs(new)]
    for source in differ:
        print(f"docs/notebook.ipynb shows something else than it computes:\n{source}")
    print(f"docs/notebook.ipynb: {len(run.cells)} cells, {len(differ)} show something else")
    update = "--update" in sys.argv
    if update:
        nbformat.write(run, NOTEBOOK)
    Path(sys.argv[1]).write_text(HTMLExporter().from_notebook_node(with_images(run))[0])
    return 1 if differ and not update or not any(map(outputs, run.cells)) else 0


if __name__ == "__main__":
    sys.exit(main())
