"""Difference of two colours for every type of colour vision, and their contrast.

The same sources as the report's own test: Machado, Oliveira and Fernandes 2009 for eyes without
red, green or blue cones (severity 1), Sharma, Wu and Dalal 2005 for CIEDE2000, WCAG 2.2 for
contrast.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]

EYES = np.array(
    [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    ]
)
XYZ = np.array(
    [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.1191920, 0.9503041],
    ]
)


def linear(colour: str) -> Numbers:
    """Return a colour such as ``#18008e`` in linear sRGB."""
    parts = np.array([int(colour[at : at + 2], 16) / 255.0 for at in (1, 3, 5)])
    return np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)


def contrast(a: str, b: str) -> float:
    """Return the contrast of two colours."""
    weights = [0.2126, 0.7152, 0.0722]
    light = sorted(0.05 + float(np.dot(weights, linear(colour))) for colour in (a, b))
    return light[1] / light[0]


def difference(a: str, b: str) -> float:
    """Return the least CIEDE2000 difference over all types of colour vision."""
    return min(ciede2000(lab(eye @ linear(a)), lab(eye @ linear(b))) for eye in EYES)


def lab(rgb: Numbers) -> Numbers:
    """Return CIE L*a*b* of a colour in linear sRGB."""
    parts: Numbers = (XYZ @ np.clip(rgb, 0.0, 1.0)) / XYZ.sum(axis=1)
    dark = (24389.0 / 27.0 * parts + 16.0) / 116.0
    x, y, z = (
        bright if part > 216.0 / 24389.0 else low
        for part, bright, low in zip(
            parts.tolist(), np.cbrt(parts).tolist(), dark.tolist(), strict=True
        )
    )
    return np.array([116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)])


def ciede2000(one: Numbers, other: Numbers) -> float:
    """Return the difference of two colours; equation numbers are those of the article."""
    (l1, a1, b1), (l2, a2, b2) = one.tolist(), other.tolist()

    def seventh(chroma: float) -> float:
        return float(np.sqrt(chroma**7 / (chroma**7 + 25.0**7)))

    # (2) to (7)
    g = 0.5 * (1.0 - seventh(0.5 * (np.hypot(a1, b1) + np.hypot(a2, b2))))
    a1, a2 = (1.0 + g) * a1, (1.0 + g) * a2
    c1, c2 = float(np.hypot(a1, b1)), float(np.hypot(a2, b2))
    h1, h2 = np.degrees(np.arctan2(b1, a1)) % 360.0, np.degrees(np.arctan2(b2, a2)) % 360.0
    # (8) to (11)
    turn = 0.0 if c1 * c2 == 0.0 else (h2 - h1 + 180.0) % 360.0 - 180.0
    hue = 2.0 * np.sqrt(c1 * c2) * np.sin(np.radians(0.5 * turn))
    # (12) to (14)
    lightness, chroma = 0.5 * (l1 + l2), 0.5 * (c1 + c2)
    if c1 * c2 == 0.0:
        h = h1 + h2
    elif abs(h1 - h2) <= 180.0:
        h = 0.5 * (h1 + h2)
    else:
        h = 0.5 * (h1 + h2 + (360.0 if h1 + h2 < 360.0 else -360.0))

    # (15) to (22)
    def cosine(times: float, shift: float) -> float:
        return float(np.cos(np.radians(times * h + shift)))

    t = 1.0 - 0.17 * cosine(1, -30) + 0.24 * cosine(2, 0) + 0.32 * cosine(3, 6)
    t -= 0.20 * cosine(4, -63)
    off = (lightness - 50.0) ** 2
    s_l = 1.0 + 0.015 * off / np.sqrt(20.0 + off)
    s_c, s_h = 1.0 + 0.045 * chroma, 1.0 + 0.015 * chroma * t
    r = -2.0 * seventh(chroma) * np.sin(np.radians(60.0 * np.exp(-(((h - 275.0) / 25.0) ** 2))))
    parts = ((l2 - l1) / s_l, (c2 - c1) / s_c, hue / s_h)
    squares = sum(part**2 for part in parts) + r * parts[1] * parts[2]
    return float(np.sqrt(squares))
