"""Reference illuminances from Radiance (https://www.radiance-online.org), another program than ours.

  python3 to_radiance.py PROJECT [--replicates 8] [--out FILE.json]

Writes the project as a Radiance scene (bands of the spectrum in Radiance's three channels, three bands a run), lets rtrace
calculate the illuminance of every free grid point by pure Monte Carlo (no irradiance cache), several times with the points in
another order, which changes the random numbers, and prints mean, minimum, maximum and uniformity with the half-width of
their 95 % intervals. Radiance is found through PATH, or in the package pyradiance (pip).

Luminance of an opening in direction d is I(d) / projected area, written as a `brightdata` pattern on `light` surfaces: not by
ies2rad, whose flat luminaires are wrong in some recent versions. README.md says what is left out.
"""
import argparse
import concurrent.futures
import importlib.util
import json
import math
import os
import pathlib
import shutil
import subprocess
import tempfile

import numpy as np

import project_file

T95 = {2: 12.71, 3: 4.303, 4: 3.182, 5: 2.776, 6: 2.571, 7: 2.447, 8: 2.365, 12: 2.201, 16: 2.131}
OPTIONS = ("-I -h -faf -aa 0 -ab {bounces} -ad {samples} -as 0 -lr -20 -lw {weight} -dt 0 -dc 1 -ds .1 -dj .95 "
           "-dr {mirrors} -dp 0 -st 0").split()
SYSTEMATIC = 0.001  # bounces, roulette, 0.1 mm, source jitter: bound from R1, R2 and R4 (README.md)


def radiance():
    """(folder of programs, RAYPATH)"""
    if shutil.which("rtrace"):
        return pathlib.Path(shutil.which("rtrace")).parent, os.environ.get("RAYPATH", ".:/usr/local/lib/ray")
    spec = importlib.util.find_spec("pyradiance")
    if not spec:
        raise SystemExit("Radiance is not installed: pip install pyradiance, or put rtrace on the PATH")
    folder = pathlib.Path(spec.origin).parent
    return folder / "bin", f".:{folder / 'lib'}"


def text(values):
    return " ".join(f"{v:.10g}" for v in np.ravel(values))


class Scene:
    """Radiance description of one triple of bands."""

    def __init__(self, folder, reader, bands):
        self.folder, self.bands = folder, bands
        self.lines, self.count = [], 0
        self.materials = reader.materials()
        for name, (kind, values) in self.materials.items():
            rgb = text(values[bands])
            if kind == "lambert":
                self.lines.append(f"void plastic {self.id(name)} 0 0 5 {rgb} 0 0")
            else:
                self.lines.append(f"void mirror {self.id(name)} 0 0 3 {rgb}")
        surfaces, _ = reader.objects()
        for surface in surfaces:
            self.surface(self.id(surface[-1]), surface)
        for index, luminaire in enumerate(reader.luminaires()):
            self.luminaire(index, luminaire)
        (folder / "scene.rad").write_text("\n".join(self.lines) + "\n")

    def id(self, name):
        return "m_" + "".join(ch if ch.isalnum() else "_" for ch in name)

    def add(self, modifier, kind, reals):
        self.count += 1
        self.lines.append(f"{modifier} {kind} s{self.count} 0 0 {len(reals)} {text(reals)}")

    def surface(self, modifier, s):
        if s[0] == "polygon":
            self.add(modifier, "polygon", np.ravel(s[1]))
        elif s[0] == "sphere":
            self.add(modifier, "sphere", [*s[1], s[2]])
        elif s[0] == "cylinder":
            self.add(modifier, "cylinder", [*s[1], *s[2], s[3]])
        elif s[0] == "cone":
            self.add(modifier, "cone", [*s[1], *s[2], s[3], s[4]])
        elif s[0] == "disc":
            self.add(modifier, "ring", [*s[1], *s[2], 0, s[3]])

    def luminaire(self, index, l):
        """A `light` whose radiance is 1 per band times flux share, modified by the pattern I / projected area."""
        x, y, z, p = l["c0"], l["c90"], l["aim"], l["position"]
        (shape, size), = l["opening"].items()
        name = f"l{index}"
        # Cosines of the emitted direction -D with the luminaire's axes.
        dot = lambda a: f"-(Dx*{a[0]:.12g}+Dy*{a[1]:.12g}+Dz*{a[2]:.12g})"
        absolute = lambda e: f"Sqrtp({e}*{e})"
        if shape == "tube":
            length, diameter, axis = size
            axis = axis / np.linalg.norm(axis)
        area = {"rectangle": lambda: f"{size[0] * size[1]:.12g}*az",
                "disc": lambda: f"{math.pi / 4 * size ** 2:.12g}*az",
                "sphere": lambda: f"{math.pi / 4 * size ** 2:.12g}",
                "point": lambda: f"{math.pi / 4 * 0.002 ** 2:.12g}",
                "box": lambda: f"({size[0] * size[1]:.12g}*az+{size[0] * size[2]:.12g}*ay+{size[1] * size[2]:.12g}*ax)",
                "cylinder": lambda: f"({math.pi / 4 * size[0] ** 2:.12g}*az+{size[0] * size[1]:.12g}*Sqrtp(1-az*az))",
                "tube": lambda: f"({length * diameter:.12g}*Sqrtp(1-{dot(axis)}*{dot(axis)}))"}[shape]()
        modifier = "void"
        luminance = l["factor"]
        if l["distribution"] is None:  # uniform luminance: flux = pi L A
            whole = {"rectangle": lambda: 2 * size[0] * size[1], "disc": lambda: math.pi / 2 * size ** 2,
                     "sphere": lambda: math.pi * size ** 2,
                     "box": lambda: 2 * (size[0] * size[1] + size[0] * size[2] + size[1] * size[2]),
                     "cylinder": lambda: math.pi * size[0] * (size[0] / 2 + size[1]),
                     "tube": lambda: math.pi * length * diameter}[shape]()
            luminance *= l["flux"] / (math.pi * whole)
        else:
            d = l["distribution"]
            table = self.folder / f"{self.id(l['type'])}.dat"
            if not table.exists():
                table.write_text(
                    f"2\n0 0 {len(d.gamma)}\n{text(d.gamma)}\n0 0 {len(d.c)}\n{text(d.c)}\n"
                    + "\n".join(text(row) for row in d.candela) + "\n")
            (self.folder / f"{name}.cal").write_text(
                "Sqrtp(q) : sqrt(if(q, q, 0));\nclip(q) : if(q-1, 1, if(-1-q, -1, q));\n"
                f"cx = {dot(x)};\ncy = {dot(y)};\ncz = {dot(z)};\n"
                f"ax = {absolute('cx')};\nay = {absolute('cy')};\naz = {absolute('cz')};\n"
                "gam = Acos(clip(cz))*57.29577951308232;\n"
                "raw = atan2(cy, cx)*57.29577951308232;\nplane = if(raw, raw, raw+360);\n"
                f"area = {area};\nlum(v) = if(area-1e-12, v/area, 0);\n")
            self.lines.append(f"void brightdata {name}_p 5 lum {table.name} {name}.cal gam plane 0 0")
            modifier = f"{name}_p"
            luminance *= l["scale"]
        material = f"{name}_m"
        self.lines.append(f"{modifier} light {material} 0 0 3 {text(luminance * l['shares'][self.bands])}")
        both = l["distribution"] is None or bool(
            np.any(l["distribution"].candela[l["distribution"].gamma > 90.001] > 0))
        front = p + 1e-4 * z
        if shape == "rectangle":
            u, v = size[0] / 2 * x, size[1] / 2 * y
            # Counter-clockwise seen from where the light goes.
            ring = lambda q: [q - u - v, q - u + v, q + u + v, q + u - v]
            if np.dot(np.cross(ring(p)[1] - ring(p)[0], ring(p)[2] - ring(p)[1]), z) < 0:
                ring_front = lambda q: ring(q)[::-1]
            else:
                ring_front = ring
            self.add(material, "polygon", np.ravel(ring_front(front)))
            if both:
                self.add(material, "polygon", np.ravel(ring_front(p - 1e-4 * z)[::-1]))
        elif shape == "disc":
            self.add(material, "ring", [*front, *z, 0, size / 2])
            if both:
                self.add(material, "ring", [*(p - 1e-4 * z), *-z, 0, size / 2])
        elif shape in ("sphere", "point"):
            self.add(material, "sphere", [*p, (size if shape == "sphere" else 0.002) / 2])
        elif shape == "tube":
            self.add(material, "cylinder", [*(p - length / 2 * axis), *(p + length / 2 * axis), diameter / 2])
        elif shape == "cylinder":
            a, b = p - size[1] / 2 * z, p + size[1] / 2 * z
            self.add(material, "cylinder", [*a, *b, size[0] / 2])
            self.add(material, "ring", [*a, *-z, 0, size[0] / 2])
            self.add(material, "ring", [*b, *z, 0, size[0] / 2])
        elif shape == "box":
            for axis1, axis2, axis3, (s1, s2, s3) in ((x, y, z, size), (y, z, x, (size[1], size[2], size[0])),
                                                     (z, x, y, (size[2], size[0], size[1]))):
                for side in (1, -1):
                    q = p + side * s3 / 2 * axis3
                    u, v = s1 / 2 * axis1, s2 / 2 * axis2
                    corners = [q - u - v, q + u - v, q + u + v, q - u + v]
                    if np.dot(np.cross(corners[1] - corners[0], corners[2] - corners[1]), side * axis3) < 0:
                        corners.reverse()
                    self.add(material, "polygon", np.ravel(corners))


def trace(folder, programs, environment, points, normals, seed, options):
    order = np.random.default_rng(seed).permutation(len(points))
    rays = "\n".join(text(np.append(points[i], normals[i])) for i in order) + "\n"
    out = subprocess.run([str(programs / "rtrace"), *options, "scene.oct"], input=rays.encode(), cwd=folder,
                         env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=True)
    values = np.frombuffer(out.stdout, np.float32).reshape(len(points), 3).astype(float)
    result = np.empty((len(points), 3))
    result[order] = values
    return result


class Calculation:
    """Illuminances of points in a project's scene, by rtrace."""

    def __init__(self, project, n_bands, folder, workers=2):
        self.programs, raypath = radiance()
        self.environment = {**os.environ, "RAYPATH": raypath, "PATH": f"{self.programs}:{os.environ['PATH']}"}
        self.reader = project_file.Reader(project, n_bands)
        self.grids = self.reader.grids(self.reader.objects()[1])
        self.workers, self.folders = workers, []
        for first in range(0, n_bands, 3):
            place = pathlib.Path(folder) / f"bands{first}"
            place.mkdir()
            Scene(place, self.reader, list(range(first, first + 3)))
            with open(place / "scene.oct", "wb") as octree:
                subprocess.run([str(self.programs / "oconv"), "scene.rad"], cwd=place, env=self.environment, stdout=octree,
                               check=True)
            self.folders.append(place)

    def illuminances(self, points, normals, replicates, seed, bounces=12, samples=64, weight=1e-3, mirrors=2):
        """Array replicates x points, lx."""
        options = [o.format(bounces=bounces, samples=samples, weight=weight, mirrors=mirrors) for o in OPTIONS]
        total = np.zeros((replicates, len(points)))
        with concurrent.futures.ThreadPoolExecutor(self.workers) as pool:
            jobs = [(r, pool.submit(trace, place, self.programs, self.environment, points, normals, seed + 100 * r + k, options))
                    for k, place in enumerate(self.folders) for r in range(replicates)]
            for r, job in jobs:
                total[r] += job.result().sum(axis=1)
        return total


def interval(values, axis=0):
    """Mean over replicates and the statistical half-width of its 95 % interval."""
    n = values.shape[axis]
    return values.mean(axis=axis), T95[n] * values.std(axis=axis, ddof=1) / math.sqrt(n)


def summary(calculation, grid, replicates, extremes=True, **options):
    """mean, min, max, u0 = min / mean with 95 % half-widths: replicates, and what the options leave out."""
    points, normals = grid["points"], grid["normals"]
    # A grid of few points gets more samples at each: its mean is then about as sharp as that of a large one.
    options["samples"] = int(options.get("samples", 64) * min(8, max(1, 600 / len(points))))
    first = calculation.illuminances(points, normals, replicates, 1, **options)
    mean, half_mean = interval(first.mean(axis=1))
    half_mean += SYSTEMATIC * mean
    result = [("mean", float(mean), float(half_mean), "lx")]
    if not extremes:
        return result
    # The extreme of noisy values lies too far out: candidates are calculated afresh, with more samples.
    order = first.mean(axis=0).argsort()
    for name, candidates, pick in (("min", order[:10], np.argmin), ("max", order[-10:], np.argmax)):
        again = calculation.illuminances(points[candidates], normals[candidates], 8, 5000,
                                         **{**options, "samples": 8 * options["samples"]})
        value, half = interval(again)
        k = pick(value)
        pooled = float(np.sqrt((half ** 2).mean()))  # of ten candidates: steadier than one point's own
        result.append((name, float(value[k]), 1.5 * pooled + SYSTEMATIC * float(value[k]), "lx"))
    low, half_low = result[1][1], result[1][2]
    result.append(("u0", low / mean, low / mean * (half_low / low + half_mean / mean), "1"))
    return result


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("project")
    parser.add_argument("--replicates", type=int, default=4)
    parser.add_argument("--bands", type=int, default=3, help="a multiple of 3; more where materials are coloured")
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--bounces", type=int, default=12)
    parser.add_argument("--weight", type=float, default=1e-3)
    parser.add_argument("--mirrors", type=int, default=2, help="longest chain of mirrors between luminaire and surface")
    parser.add_argument("--mean-only", action="store_true", help="no minimum, maximum and uniformity")
    parser.add_argument("--out", help="write the values as expected.json")
    arguments = parser.parse_args()
    values = []
    with tempfile.TemporaryDirectory() as folder:
        calculation = Calculation(arguments.project, arguments.bands, folder)
        for grid in calculation.grids:
            for name, value, half, unit in summary(calculation, grid, arguments.replicates, bounces=arguments.bounces,
                                                   samples=arguments.samples, weight=arguments.weight,
                                                   mirrors=arguments.mirrors, extremes=not arguments.mean_only):
                print(f"{grid['name']:24s} {name:5s} {value:10.4f} +- {half:.4f} {unit}", flush=True)
                values.append({"grid": grid["name"], "quantity": name, "value": float(f"{value:.5g}"),
                               "half_width": float(f"{half:.2g}"), "unit": unit})
    if arguments.out:
        source = (f"Radiance rtrace, pure Monte Carlo (-ab {arguments.bounces} -ad {arguments.samples}), {arguments.replicates} "
                  f"replicates, {arguments.bands} spectral bands, on the scene written by tests/references/to_radiance.py")
        pathlib.Path(arguments.out).write_text(
            json.dumps({"format": "goniolux-expected", "version": 1, "source": source, "values": values}, indent=2) + "\n")


if __name__ == "__main__":
    main()
