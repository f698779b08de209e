"""Text that scripts write into pages of the book, between markers."""

import pathlib

ROOT = pathlib.Path(__file__).parents[1]
END = "<!-- end -->\n"


def parts(page: str, command: str) -> tuple[str, str, str]:
    """Return the text before a command's text with its marker, that text, and the rest."""
    begin = f"<!-- written by `{command}`: begin -->\n"
    before, found, rest = (ROOT / page).read_text(encoding="utf-8").partition(begin)
    written, end, after = rest.partition(END)
    if not found or not end:
        raise SystemExit(f"{page} lacks {begin}")
    return before + begin, written, end + after


def write(page: str, command: str, text: str) -> None:
    """Replace a command's earlier text."""
    before, _, after = parts(page, command)
    (ROOT / page).write_text(f"{before}\n{text}\n{after}", encoding="utf-8", newline="\n")
