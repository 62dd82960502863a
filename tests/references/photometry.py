"""LM-63 (type C) and EULUMDAT, read a second way for reference calculations: no code in common with src/photometry.

A Distribution holds candelas over gamma (rows, degrees) and C (columns, 0..360, degrees), bilinear in both angles.
"""
import re

import numpy as np


class Distribution:
    def __init__(self, gamma, c, candela, opening):
        self.gamma, self.c, self.candela, self.opening = gamma, c, candela, opening

    def flux(self):
        """Exact flux of the bilinear interpolant: in gamma by closed form, in C by the trapezoidal rule (exact there)."""
        g = np.radians(self.gamma)
        c = np.radians(self.c)
        # Integral of I sin(gamma) over one interval with I linear: [-I cos] + dI/dg [sin].
        low, high = self.candela[:-1], self.candela[1:]
        slope = (high - low) / (g[1:] - g[:-1])[:, None]
        rows = (low * np.cos(g[:-1])[:, None] - high * np.cos(g[1:])[:, None]
                + slope * (np.sin(g[1:]) - np.sin(g[:-1]))[:, None])
        over_gamma = rows.sum(axis=0)
        return float(((over_gamma[:-1] + over_gamma[1:]) / 2 * np.diff(c)).sum())


def _whole_turn(c, candela):
    """Planes 0..360 from the part that a symmetric file gives (columns of `candela` are planes)."""
    c = list(c)
    planes = {angle: candela[:, i] for i, angle in enumerate(c)}
    if len(c) == 1:
        return np.array([0.0, 360.0]), np.repeat(candela, 2, axis=1)
    first, last = c[0], c[-1]
    if (first, last) == (0, 90):
        for angle in c:
            planes[180 - angle] = planes[angle]
        first, last = 0, 180
    if (first, last) == (90, 270):
        # symmetric about the C90-C270 plane
        for angle in c:
            planes[(540 - angle) % 360] = planes[angle]
        planes[360.0] = planes[0.0] if 0.0 in planes else planes[180.0]
        last = 360
    elif (first, last) == (0, 180):
        for angle in list(planes):
            planes[360 - angle] = planes[angle]
        last = 360
    if last != 360:
        planes[360.0] = planes[0.0]
    angles = sorted(planes)
    return np.array(angles), np.stack([planes[a] for a in angles], axis=1)


def read_lm63(path):
    text = open(path, encoding="latin-1").read()
    head, tilt, rest = re.split(r"(?m)^TILT=(\S+)\s*$", text, maxsplit=1)
    if tilt != "NONE":
        raise ValueError(f"{path}: TILT={tilt} is not read here")
    numbers = [float(word) for word in re.split(r"[\s,]+", rest.strip())]
    lamps, lumens, multiplier, n_gamma, n_c, kind, units = numbers[:7]
    width, length, height, ballast, future = numbers[7:12]
    if int(kind) != 1:
        raise ValueError(f"{path}: photometric type {int(kind)} is not read here")
    if "LM-63-1986" not in text and "LM-63-1991" not in text and text.lstrip().startswith("IESNA"):
        future = 1.0  # not a factor since 1995
    n_gamma, n_c = int(n_gamma), int(n_c)
    at = 13
    gamma = np.array(numbers[at:at + n_gamma])
    c = np.array(numbers[at + n_gamma:at + n_gamma + n_c])
    values = np.array(numbers[at + n_gamma + n_c:at + n_gamma + n_c + n_gamma * n_c]).reshape(n_c, n_gamma).T
    values = values * multiplier * ballast * future
    scale = 0.3048 if int(units) == 1 else 1.0
    w, l, h = width * scale, length * scale, height * scale
    if w < 0 and l < 0:
        opening = {"disc": -w} if h == 0 else {"cylinder": (-w, h)} if h > 0 else {"sphere": -w}
    elif w == l == h == 0:
        opening = {"point": True}
    elif h > 0:
        opening = {"box": (l, w, h)}
    else:
        opening = {"rectangle": (l, w)}
    angles, table = _whole_turn(c, values)
    return Distribution(gamma, angles, table, opening)


def read_eulumdat(path):
    lines = open(path, encoding="latin-1").read().splitlines()
    number = lambda i: float(lines[i - 1].strip().replace(",", "."))
    symmetry, planes, n_gamma = int(number(3)), int(number(4)), int(number(6))
    length, width, height = (number(i) / 1000 for i in (16, 17, 18))
    sets = int(number(26))
    lumens = sum(number(26 + 2 * sets + k) for k in range(1, sets + 1))
    # Each lamp set has six lines, entered as six blocks of `sets` lines; then ten direct ratios.
    start = 26 + 6 * sets + 10
    c = np.array([number(start + k) for k in range(1, planes + 1)])
    gamma = np.array([number(start + planes + k) for k in range(1, n_gamma + 1)])
    given = {0: planes, 1: 1, 2: planes // 2 + 1, 3: planes // 2 + 1, 4: planes // 4 + 1}[symmetry]
    first = start + planes + n_gamma
    values = np.array([number(first + k) for k in range(1, given * n_gamma + 1)]).reshape(given, n_gamma).T
    values = values * lumens / 1000
    if symmetry == 3:
        shift = list(c).index(90)
        c = c[shift:shift + given]
    else:
        c = c[:given] if symmetry else np.append(c, 360.0)
        if symmetry == 0:
            values = np.hstack([values, values[:, :1]])
    angles, table = _whole_turn(c, values)
    if width == 0 and length == 0:
        opening = {"point": True}
    elif width == 0:
        opening = {"disc": length} if height == 0 else {"cylinder": (length, height)}
    elif height > 0:
        opening = {"box": (width, length, height)}  # EULUMDAT: the length lies along C90
    else:
        opening = {"rectangle": (width, length)}
    return Distribution(gamma, angles, table, opening)


def read(path):
    return read_eulumdat(path) if str(path).lower().endswith(".ldt") else read_lm63(path)
