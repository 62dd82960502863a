"""A project file as plain Python values: the part of the format that reference calculations need, read a second way.

Lengths in metres. Spectra become values in `bands`: equal parts of the luminous flux, so that a sum over bands of
illuminances, each computed with the band's reflectances, is the illuminance.
"""
import json
import math
import pathlib
import re

import numpy as np

import photometry

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
UNITS = {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "ft": 0.3048, "in": 0.0254}
WAVELENGTHS = np.arange(360.0, 831.0)


def load_json(path):
    """JSON with // comments (not inside strings)."""
    text = pathlib.Path(path).read_text(encoding="utf-8")
    text = re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*|/\*.*?\*/', lambda m: m.group(1) or "", text, flags=re.S)
    return json.loads(text)


def read_columns(path):
    rows = []
    for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines():
        line = line.split("#")[0].strip()
        if not line:
            continue
        try:
            rows.append([float(x) for x in re.split(r"[\s,;]+", line)])
        except ValueError:
            continue  # column titles
    return np.array(rows)


def luminous_efficiency():
    table = read_columns(REPOSITORY / "data" / "cie" / "cie1931_2deg.csv")
    return np.interp(WAVELENGTHS, table[:, 0], table[:, 2], left=0, right=0)


class Reader:
    def __init__(self, path, n_bands):
        path = pathlib.Path(path)
        self.file = path / "project.json" if path.is_dir() else path
        self.folder = self.file.parent
        self.json = load_json(self.file)
        self.unit = UNITS[self.json.get("units", "m")]
        self.n_bands = n_bands
        self.v = luminous_efficiency()
        self._choose_bands()

    # ------------------------------------------------------------------ spectra
    def find(self, name, folder):
        for place in (self.folder / name, REPOSITORY / folder / name):
            if place.exists():
                return place
        raise FileNotFoundError(name)

    def curve(self, spectrum):
        """Values at WAVELENGTHS of a SPECTRUM."""
        if isinstance(spectrum, (int, float)):
            return np.full_like(WAVELENGTHS, float(spectrum))
        if isinstance(spectrum, dict) and "wavelengths" in spectrum:
            return np.interp(WAVELENGTHS, spectrum["wavelengths"], spectrum["values"])
        if isinstance(spectrum, dict) and "blackbody" in spectrum:
            metres = WAVELENGTHS * 1e-9
            power = 1 / (metres ** 5 * np.expm1(1.4388e-2 / (metres * spectrum["blackbody"])))
            return power / power.max()
        if isinstance(spectrum, str) and spectrum.startswith("CIE "):
            return self.illuminant(spectrum[4:])
        if isinstance(spectrum, str):
            table = read_columns(self.find(spectrum, "materials"))
            return np.interp(WAVELENGTHS, table[:, 0], table[:, 1])
        raise ValueError(f"spectrum {spectrum!r} is not read here")

    def illuminant(self, name):
        if name == "E":
            return np.ones_like(WAVELENGTHS)
        if name == "A":
            return self.curve({"blackbody": 2856 * 1.4388 / 1.435})
        if name == "D65":
            table = read_columns(REPOSITORY / "data" / "cie" / "illuminant_d65.csv")
            return np.interp(WAVELENGTHS, table[:, 0], table[:, 1])
        path = REPOSITORY / "data" / "cie" / "illuminants.csv"
        titles = next(line for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("nm"))
        column = [t.strip() for t in titles.split(",")].index(name)
        table = read_columns(path)
        return np.interp(WAVELENGTHS, table[:, 0], table[:, column], left=0, right=0)

    def _choose_bands(self):
        curves = [self.curve(l.get("spectrum", 1.0)) for l in self.json.get("luminaires", [])]
        mean = sum(c * self.v / (c * self.v).sum() for c in curves)
        share = np.cumsum(mean) / mean.sum()
        self.band = np.minimum((share * self.n_bands).astype(int), self.n_bands - 1)
        self.mean_source = mean

    def in_bands(self, spectrum):
        """Mean value per band, weighted by the luminous flux of the mean source."""
        curve = self.curve(spectrum)
        return np.array([(curve * self.mean_source)[self.band == b].sum() / self.mean_source[self.band == b].sum()
                         for b in range(self.n_bands)])

    def flux_shares(self, spectrum):
        luminous = self.curve(spectrum) * self.v
        return np.array([luminous[self.band == b].sum() for b in range(self.n_bands)]) / luminous.sum()

    # ------------------------------------------------------------------ materials
    def materials(self):
        result = {}
        for name, m in self.json.get("materials", {}).items():
            if "exitance_lm_m2" in m:
                raise ValueError(f"material {name}: emitting surfaces are not read here")
            if m["model"] == "lambert":
                result[name] = ("lambert", self.in_bands(m.get("diffuse", 0.5)))
            elif m["model"] == "mirror":
                result[name] = ("mirror", self.in_bands(m["reflectance"]))
            else:
                raise ValueError(f"material {name}: model {m['model']} is not read here")
        return result

    # ------------------------------------------------------------------ objects
    def transform(self, steps):
        matrix = np.eye(4)
        for step in steps or []:
            m = np.eye(4)
            if "translate" in step:
                m[:3, 3] = self.unit * np.array(step["translate"])
            elif "rotate" in step:
                r = step["rotate"]
                a = np.array(r["axis"], float) / np.linalg.norm(r["axis"])
                angle = math.radians(r["degrees"])
                k = np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])
                m[:3, :3] = np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k
                center = self.unit * np.array(r.get("center", [0, 0, 0]))
                m[:3, 3] = center - m[:3, :3] @ center
            elif "scale" in step:
                m[:3, :3] = np.diag(np.broadcast_to(step["scale"], 3).astype(float))
            matrix = m @ matrix
        return matrix

    def objects(self):
        """Surfaces in the world: ("polygon", points, material) and ("cylinder", base, top, radius, material), ("sphere",
        centre, radius, material), ("disc", centre, normal, radius, material); and solids for the inside test."""
        surfaces, solids = [], []
        for o in self.json["objects"]:
            matrix = self.transform(o.get("transform"))
            put = lambda p: (matrix @ np.append(self.unit * np.array(p, float), 1))[:3]
            scale = np.linalg.norm(matrix[:3, 0])
            named = o.get("materials", {})
            pick = lambda *parts: next((named[p] for p in parts if p in named), named.get("*", o.get("material")))
            shape = o["shape"]
            if shape == "box":
                low, high = np.array(o["min"], float), np.array(o["max"], float)
                corner = lambda k: put([high[i] if k >> i & 1 else low[i] for i in range(3)])
                faces = {"floor": (0, 2, 3, 1), "ceiling": (4, 5, 7, 6), "xmin": (0, 4, 6, 2), "xmax": (1, 3, 7, 5),
                         "ymin": (0, 1, 5, 4), "ymax": (2, 6, 7, 3)}
                inward = o.get("facing") == "inward"
                for part, f in faces.items():
                    material = pick(part) if part in ("floor", "ceiling") else pick(part, "walls")
                    surfaces.append(("polygon", [corner(k) for k in (f[::-1] if inward else f)], material))
                if not inward:
                    solids.append(("box", np.linalg.inv(matrix), self.unit * low, self.unit * high))
            elif shape == "rectangle":
                p, u, v = (np.array(o[k], float) for k in ("origin", "u", "v"))
                surfaces.append(("polygon", [put(p), put(p + u), put(p + u + v), put(p + v)], pick("surface")))
            elif shape == "polygon":
                if o.get("holes"):
                    raise ValueError(f"{o['name']}: holes are not read here")
                surfaces.append(("polygon", [put(p) for p in o["vertices"]], pick("surface")))
            elif shape in ("disc", "sphere", "cylinder"):
                radius = self.unit * scale * (o["radius"] if "radius" in o else o["diameter"] / 2)
                if shape == "sphere":
                    surfaces.append(("sphere", put(o["center"]), radius, pick("surface")))
                    solids.append(("sphere", put(o["center"]), radius))
                elif shape == "disc":
                    normal = matrix[:3, :3] @ np.array(o.get("normal", [0, 0, 1]), float)
                    surfaces.append(("disc", put(o["center"]), normal, radius, pick("surface")))
                else:
                    base = np.array(o["base"], float)
                    axis = np.array(o.get("axis", [0, 0, 1]), float)
                    top = np.array(o["top"], float) if "top" in o else base + o["height"] * axis / np.linalg.norm(axis)
                    surfaces.append(("cylinder", put(base), put(top), radius, pick("side")))
                    caps = o.get("caps", "both")
                    if caps in ("both", "bottom"):
                        surfaces.append(("disc", put(base), put(base) - put(top), radius, pick("bottom")))
                    if caps in ("both", "top"):
                        surfaces.append(("disc", put(top), put(top) - put(base), radius, pick("top")))
                    if caps == "both":
                        solids.append(("cylinder", put(base), put(top), radius))
            elif shape == "cone":
                base, axis = np.array(o["base"], float), np.array(o.get("axis", [0, 0, 1]), float)
                top = np.array(o["top"], float) if "top" in o else base + o["height"] * axis / np.linalg.norm(axis)
                ends = [(put(base), put(base) - put(top), self.unit * scale * o["radius"], "bottom"),
                        (put(top), put(top) - put(base), self.unit * scale * o.get("top_radius", 0), "top")]
                surfaces.append(("cone", put(base), put(top), ends[0][2], ends[1][2], pick("side")))
                for place, normal, radius, part in ends:
                    if radius > 0 and o.get("caps", "both") in ("both", part):
                        surfaces.append(("disc", place, normal, radius, pick(part)))
                solids.append(("cone", put(base), put(top), ends[0][2], ends[1][2]))
            else:
                raise ValueError(f"{o['name']}: shape {shape} is not read here")
        return surfaces, solids

    # ------------------------------------------------------------------ luminaires
    def luminaires(self):
        """Elements: dict(position, aim, c0, c90, opening, distribution or None (uniform luminance), flux, factor, shares)."""
        result = []
        for l in self.json.get("luminaires", []):
            aim = np.array(l.get("aim", [0, 0, -1]), float)
            aim /= np.linalg.norm(aim)
            c0 = np.array(l.get("c0", [1, 0, 0] if abs(aim[0]) < 0.999999 else [0, 1, 0]), float)
            c0 -= aim * c0.dot(aim)
            c0 /= np.linalg.norm(c0)
            turn = math.radians(l.get("turn", 0))
            c0 = math.cos(turn) * c0 + math.sin(turn) * np.cross(aim, c0)
            c90 = np.cross(c0, aim)
            distribution, flux, opening = None, l.get("flux"), None
            kind = l["photometry"]
            if kind == "cosine":
                gamma = np.linspace(0, 180, 721)
                table = np.maximum(np.cos(np.radians(gamma)), 0)[:, None].repeat(2, axis=1)
                distribution = photometry.Distribution(gamma, np.array([0.0, 360.0]), table, None)
            elif kind == "isotropic":
                distribution = photometry.Distribution(np.array([0.0, 180.0]), np.array([0.0, 360.0]), np.ones((2, 2)), None)
            elif isinstance(kind, dict) and "cosine_power" in kind:
                gamma = np.linspace(0, 180, 1801)
                lobe = np.maximum(np.cos(np.radians(gamma)), 0) ** kind["cosine_power"]
                distribution = photometry.Distribution(gamma, np.array([0.0, 360.0]), lobe[:, None].repeat(2, axis=1), None)
            elif kind != "diffuse":
                if not isinstance(kind, str):
                    raise ValueError(f"{l['name']}: photometry {kind} is not read here")
                distribution = photometry.read(self.find(kind, "luminaires"))
                opening = distribution.opening
            shape = l.get("shape", "auto")
            if shape == "point":
                opening = {"point": True}
            elif shape != "auto":
                (name, s), = shape.items()
                d = {k: self.unit * v for k, v in s.items() if k != "axis"}
                opening = {"rectangle": lambda: {"rectangle": (d["length"], d["width"])},
                           "disc": lambda: {"disc": d["diameter"]},
                           "sphere": lambda: {"sphere": d["diameter"]},
                           "box": lambda: {"box": (d["length"], d["width"], d["height"])},
                           "cylinder": lambda: {"cylinder": (d["diameter"], d["height"])},
                           "tube": lambda: {"tube": (d["length"], d["diameter"], np.array(s["axis"], float))}}[name]()
            scale = 1.0
            if distribution is not None:
                scale = flux / distribution.flux() if flux else 1.0
                flux = flux or distribution.flux()
            array = l.get("array", {"counts": [1, 1], "u": [0, 0, 0], "v": [0, 0, 0]})
            for j in range(array["counts"][1]):
                for i in range(array["counts"][0]):
                    position = np.array(l["position"], float) + i * np.array(array["u"], float) + j * np.array(
                        array.get("v", [0, 0, 0]), float)
                    result.append(dict(type=l["name"], position=self.unit * position, aim=aim, c0=c0, c90=c90, opening=opening,
                                       distribution=distribution, scale=scale, flux=flux,
                                       factor=l.get("maintenance", 1.0) * l.get("dimming", 1.0),
                                       shares=self.flux_shares(l.get("spectrum", 1.0))))
        return result

    # ------------------------------------------------------------------ grids
    def grids(self, solids):
        """dict(name, points, normals) of illuminance grids; points inside solids are left out."""
        result = []
        for g in self.json.get("grids", []):
            if g.get("quantity", "illuminance") != "illuminance":
                continue
            if "points" in g:
                points = self.unit * np.array(g["points"], float)
                normals = np.broadcast_to(np.array(g.get("normals", g.get("normal", [0, 0, 1])), float), points.shape)
            else:
                n, m = g["counts"]
                o, u, v = (self.unit * np.array(g[k], float) for k in ("origin", "u", "v"))
                points = np.array([o + (i + 0.5) / n * u + (j + 0.5) / m * v for j in range(m) for i in range(n)])
                normals = np.broadcast_to(np.array(g.get("normal", [0, 0, 1]), float), points.shape)
            free = np.array([not any(inside(s, p) for s in solids) for p in points])
            result.append(dict(name=g["name"], points=points[free], normals=normals[free], free=free))
        return result


def inside(solid, p, margin=1e-6):
    if solid[0] == "box":
        q = (solid[1] @ np.append(p, 1))[:3]
        return bool(np.all(q > solid[2] + margin) and np.all(q < solid[3] - margin))
    if solid[0] == "sphere":
        return np.linalg.norm(p - solid[1]) < solid[2] - margin
    axis = solid[2] - solid[1]
    t = (p - solid[1]).dot(axis) / axis.dot(axis)
    radius = solid[3] + t * (solid[4] - solid[3]) if solid[0] == "cone" else solid[3]
    return bool(0 < t < 1 and np.linalg.norm(p - solid[1] - t * axis) < radius - margin)
