"""Writes letters.txt from Arimo-subset.ttf: `python letters.py`, with fonttools installed."""

from pathlib import Path

from fontTools.pens.basePen import BasePen
from fontTools.ttLib import TTFont

FOLDER = Path(__file__).parent
HEAD = """\
# Letters of Arimo-subset.ttf, written by letters.py. First how many units the size has, then a letter a line: its character,
# the width that it takes, and its outline, with the words of SVG's paths (M, L, Q, Z) and y up.
"""


class Words(BasePen):
    """An outline as words; compound glyphs are taken apart by the base."""

    def __init__(self, glyphs):
        super().__init__(glyphs)
        self.words = []

    def _say(self, what, *points):
        self.words += [what, *(f"{length:g}" for point in points for length in point)]

    def _moveTo(self, to):
        self._say("M", to)

    def _lineTo(self, to):
        self._say("L", to)

    def _qCurveToOne(self, by, to):
        self._say("Q", by, to)

    def _closePath(self):
        self._say("Z")


def line(character: str, name: str) -> str:
    pen = Words(glyphs)
    glyphs[name].draw(pen)
    return " ".join([character, str(glyphs[name].width), *pen.words])


font = TTFont(FOLDER / "Arimo-subset.ttf")
glyphs = font.getGlyphSet()
# What stands for letters that the font does not have comes first.
lines = [line("none", ".notdef")]
lines += [line(f"{code:04X}", name) for code, name in sorted(font.getBestCmap().items())]
text = f"{HEAD}{font['head'].unitsPerEm}\n" + "\n".join(lines) + "\n"
(FOLDER / "letters.txt").write_text(text, encoding="ascii", newline="\n")
