"""The book: every block of Python runs, and the reference agrees with the docstrings."""

import os
import re
import sys
from pathlib import Path

import matplotlib.pyplot
import pytest

BOOK = Path(__file__).parents[3] / "docs/src"
PACKAGE = Path(__file__).parents[1]
PAGES = sorted(path for path in BOOK.glob("python*.md") if path.name != "python-reference.md")
BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.stem)
def test_every_block_runs(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    matplotlib.use("agg")
    monkeypatch.chdir(tmp_path)
    text = page.read_text(encoding="utf-8")
    blocks = list(BLOCK.finditer(text))
    assert blocks
    # In the order of the page.
    names: dict[str, object] = {"__name__": "__page__"}
    for block in blocks:
        line = text[: block.start(1)].count("\n")
        code = compile("\n" * line + block[1], str(page), "exec")
        exec(code, names)
    assert capsys.readouterr().out
    matplotlib.pyplot.close("all")


def test_the_readme_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    text = (PACKAGE / "README.md").read_text(encoding="utf-8")
    first = BLOCK.search(text)
    assert first is not None
    exec(compile(first[1], "README.md", "exec"), {"__name__": "__page__"})


def test_the_reference_is_what_the_docstrings_say(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "path", [str(PACKAGE), *sys.path])
    reference = __import__("reference")
    try:
        if os.environ.get("WHOLESTRING_UPDATE_DOCS") == "1":
            reference.PAGE.write_text(reference.page(), encoding="utf-8")
        written = reference.PAGE.read_text(encoding="utf-8")
        assert written == reference.page(), "WHOLESTRING_UPDATE_DOCS=1 rewrites it"
    finally:
        sys.modules.pop("reference", None)


def test_the_book_lists_its_pages() -> None:
    summary = (BOOK / "SUMMARY.md").read_text(encoding="utf-8")
    for page in (*PAGES, BOOK / "python-reference.md"):
        assert f"({page.name})" in summary, page.name
