"""Writes docs/src/fonts/stix-two-math.woff2: `python equation_font.py stix-two-math-latin-400-normal.woff2`.

The whole font, STIX Two Math 2.12 b168a, comes from the npm package @fontsource/stix-two-math 5.3.0. Takes fonttools and
brotli.
"""

import sys
from pathlib import Path

from fontTools import subset
from fontTools.misc.roundTools import otRound
from fontTools.ttLib import TTFont

HERE = Path(__file__).parent

# Latin, Greek, upright, bold and italic, and the signs that equations use.
LETTERS = (
    "20-7E,A0,B0-B3,B7,B9,BC-BE,D7,131,237,300-308,391-3A1,3A3-3CE,3D0-3D2,3D5-3D6,3D8-3E1,3F0-3F1,3F4-3F6,2013-2014,"
    "2016,2018-201D,2026,2032-2034,2057,2061-2064,20D7,210E,2190-2194,21D0-21D4,2200-2208,220B,220F,2211-2213,221A,"
    "221D-221E,2223,2225,2227-222E,223C-223D,2248,2260-2265,226A-226B,2282-2287,22A5,22C5,22EE-22F1,2308-230B,"
    "23DE-23DF,27E8-27E9,1D400-1D454,1D456-1D467,1D6E2-1D71B"
)

# Browsers set a prime as a superscript, for which the font's own are too small and too high. Lengths are in units of the
# font, 1000 to the em.
PRIMES = "′″‴⁗"
SCALE = 1.69
TOP = 571
LEFT = 30
RIGHT = 26


def redraw(font: TTFont, name: str) -> None:
    """Enlarges and lowers a prime."""
    glyph = font["glyf"][name]
    left, top = glyph.xMin, glyph.yMax
    for at, (x, y) in enumerate(glyph.coordinates):
        glyph.coordinates[at] = (otRound(LEFT + SCALE * (x - left)), otRound(TOP + SCALE * (y - top)))
    # Its hints are for the old outline.
    glyph.removeHinting()
    glyph.recalcBounds(font["glyf"])
    font["hmtx"][name] = (glyph.xMax + RIGHT, glyph.xMin)


def main() -> None:
    # The same bytes whenever it is made.
    font = TTFont(sys.argv[1], recalcTimestamp=False)
    names = font.getBestCmap()
    for prime in PRIMES:
        redraw(font, names[ord(prime)])
    options = subset.Options()
    options.flavor = "woff2"
    chosen = subset.Subsetter(options)
    chosen.populate(unicodes=subset.parse_unicodes(LETTERS))
    chosen.subset(font)
    subset.save_font(font, HERE.parent / "src/fonts/stix-two-math.woff2", options)


main()
