"""The notebooks: each runs from its top to its end, and none is committed with outputs."""

import os
from pathlib import Path
from typing import Any

import nbclient
import nbformat
import pytest
import wholestring as ws

FOLDER = Path(__file__).parents[1] / "notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))

# Text in the final output.
SAID = {"ensemble-on-dask": "90 % of the draws have less than"}


def read(path: Path) -> Any:
    return nbformat.read(path, as_version=4)  # type: ignore[no-untyped-call]


def test_they_are_there() -> None:
    assert NOTEBOOKS


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_no_outputs_are_committed(path: Path) -> None:
    for cell in read(path).cells:
        if cell.cell_type == "code":
            assert cell.outputs == []
            assert cell.execution_count is None
    assert "widgets" not in read(path).metadata


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_it_runs(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run in an empty folder: all required files are in the package."""
    # The kernel of this environment: `python3` is the interpreter that runs the tests.
    monkeypatch.setenv("MPLBACKEND", "module://matplotlib_inline.backend_inline")
    # The kernel works in a folder of its own, and must still find the package.
    search = [str(Path(ws.__file__).parents[1]), os.environ.get("PYTHONPATH", "")]
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(part for part in search if part))
    notebook = read(path)
    client = nbclient.NotebookClient(
        notebook,
        # 60 s with an optimised build of the package; tests may use a debug build.
        timeout=240,
        kernel_name="python3",
        resources={"metadata": {"path": str(tmp_path)}},
    )
    client.execute()
    outputs = [
        output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs
    ]
    pictures = [output for output in outputs if "image/png" in output.get("data", {})]
    cells = [cell for cell in notebook.cells if "ws.plot." in cell.source]
    assert len(pictures) >= sum(cell.cell_type == "code" for cell in cells)
    text = "".join(output.text for output in outputs if output.output_type == "stream")
    assert SAID.get(path.stem, "") in text
