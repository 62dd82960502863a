#!/usr/bin/env python3
"""Independent reference for the sample projects: a small path tracer in numpy that shares no code with Goniolux.

    scene_tracer.py PROJECT_FOLDER [--paths 200000] [--seed 1] [--point GRID:INDEX ...]

Prints, for every grid of the project, the mean illuminance over its points (those inside solids left out) with the half-width
of its 95 % interval from 20 independent batches, and the same for single points. Maintained values, lx.

What it understands: boxes without transforms, spheres, upright cones, cylinders; lambert and mirror; luminaires as rectangles
facing down, spheres, tubes along x and points, with "cosine", "diffuse", {"cosine_power": n}; panel-600.ies is the formula that
its file was made from, I = I0 cos(gamma). Method: one wavelength per path, drawn from V(lambda) times the sources' spectrum;
next-event estimation at every diffuse hit; emitters hit by chance count after mirrors only. Unbiased: Russian roulette, no
bound on depth. Needs Python 3 with numpy; used while developing, not by the tests.
"""
import argparse, csv, json, math, os, re
import numpy as np

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
EPS = 1e-6
WAVE = np.arange(380.0, 781.0, 5.0)


def read_columns(path):
    rows = []
    for line in open(path, encoding="utf-8"):
        fields = re.split(r"[,;\s]+", line.strip())
        try:
            rows.append([float(f) for f in fields])
        except ValueError:
            continue
    return np.array(rows)


def cie_table(name, column):
    header = None
    rows = []
    for line in open(os.path.join(ROOT, "data", "cie", name), encoding="utf-8"):
        if line.startswith("#"):
            continue
        fields = line.strip().split(",")
        if header is None:
            header = [f.strip() for f in fields]
            continue
        rows.append([float(f) for f in fields])
    rows = np.array(rows)
    return np.interp(WAVE, rows[:, 0], rows[:, header.index(column) if isinstance(column, str) else column], 0, 0)


def curve(spectrum):
    """Reflectance at WAVE."""
    if isinstance(spectrum, (int, float)):
        return np.full(WAVE.shape, float(spectrum))
    if isinstance(spectrum, dict):
        return np.interp(WAVE, spectrum["wavelengths"], spectrum["values"])
    table = read_columns(os.path.join(ROOT, "materials", spectrum))
    return np.interp(WAVE, table[:, 0], table[:, 1])


def source(spectrum):
    """Share of luminous flux at each of WAVE."""
    if spectrum is None:
        power = np.ones(WAVE.shape)
    elif isinstance(spectrum, dict):
        power = WAVE ** -5.0 / np.expm1(1.438776877e7 / (WAVE * spectrum["blackbody"]))
    else:
        power = cie_table("illuminants.csv", spectrum[4:])
    weight = power * cie_table("cie1931_2deg.csv", 2)
    return weight / weight.sum()


def load(folder):
    text = open(os.path.join(folder, "project.json"), encoding="utf-8").read()
    return json.loads("\n".join(line for line in text.split("\n") if not line.startswith("//")))


class Scene:
    def __init__(self, project):
        self.boxes, self.solids, self.mirror, self.rho = [], [], [], []
        index = {}
        for name, material in project["materials"].items():
            index[name] = len(self.rho)
            self.mirror.append(material["model"] == "mirror")
            self.rho.append(curve(material.get("diffuse", material.get("reflectance"))))
        index["black"] = len(self.rho)
        self.mirror.append(False)
        self.rho.append(np.zeros(WAVE.shape))
        self.rho, self.mirror = np.array(self.rho), np.array(self.mirror)
        for o in project["objects"]:
            if o["shape"] == "box":
                own, parts = o.get("materials", {}), []
                for part in ("xmin", "xmax", "ymin", "ymax", "floor", "ceiling"):
                    group = own.get("walls") if part[0] in "xy" else None
                    parts.append(index[own.get(part) or group or own.get("*") or o.get("material")])
                self.boxes.append((np.array(o["min"], float), np.array(o["max"], float), np.array(parts), "facing" in o, -1))
            else:
                self.solids.append((o, index[o["material"]], -1))
        self.read_luminaires(project, index["black"])

    def read_luminaires(self, project, black):
        self.lamps, spectra = [], []
        for l in project["luminaires"]:
            array = l.get("array", {"counts": [1, 1]})
            share = source(l.get("spectrum"))
            if not any(np.array_equal(share, s) for s in spectra):
                spectra.append(share)
            which = [i for i, s in enumerate(spectra) if np.array_equal(share, s)][0]
            for j in range(array["counts"][1]):
                for i in range(array["counts"][0]):
                    center = np.array(l["position"], float) + i * np.array(array.get("u", [0, 0, 0])) + j * np.array(array.get("v", [0, 0, 0]))
                    photometry, shape = l["photometry"], l.get("shape", "point")
                    if photometry == "panel-600.ies":
                        photometry, shape = "cosine", {"rectangle": {"length": 0.6, "width": 0.6}}
                    power = 1 if photometry == "cosine" else None if photometry == "diffuse" else photometry["cosine_power"]
                    flux = l["flux"] * l.get("maintenance", 1) * l.get("dimming", 1)
                    lamp = {"c": center, "aim": np.array(l.get("aim", [0, 0, -1]), float), "n": power, "flux": flux, "which": which}
                    if isinstance(shape, dict):
                        lamp["kind"], size = next(iter(shape.items()))
                        lamp.update(size)
                    else:
                        lamp["kind"] = "point"
                    number = len(self.lamps)
                    if lamp["kind"] == "rectangle":  # a sheet just below the ceiling, so that it hides what it covers
                        half = np.array([lamp["length"] / 2, lamp["width"] / 2, 0])
                        self.boxes.append((center - half - [0, 0, 2e-7], center + half - [0, 0, 1e-7], np.full(6, black), False, number))
                    elif lamp["kind"] == "sphere":
                        self.solids.append(({"shape": "sphere", "center": center, "radius": lamp["diameter"] / 2}, black, number))
                    elif lamp["kind"] == "tube":
                        half = np.array([lamp["length"] / 2, 0, 0])
                        self.solids.append(({"shape": "cylinder", "base": center - half, "top": center + half, "radius": lamp["diameter"] / 2}, black, number))
                    self.lamps.append(lamp)
        self.spectra = np.array(spectra)
        self.pick = self.spectra.mean(axis=0)

    # ------------------------------------------------------------------ geometry
    def solid_hits(self, o, origin, direction):
        """Nearest t > EPS and normal for a sphere, cylinder or cone (with caps)."""
        n = len(origin)
        best, normal = np.full(n, np.inf), np.zeros((n, 3))

        def offer(t, valid, make):
            take = valid & (t > EPS) & (t < best)
            if take.any():
                best[take] = t[take]
                normal[take] = make(origin[take] + t[take, None] * direction[take])

        if o["shape"] == "sphere":
            p, r = origin - np.array(o["center"], float), o["radius"]
            b = (p * direction).sum(1)
            disc = b * b - ((p * p).sum(1) - r * r)
            root = np.sqrt(np.maximum(disc, 0))
            for t in (-b - root, -b + root):
                offer(t, disc > 0, lambda x: (x - np.array(o["center"])) / r)
            return best, normal
        base = np.array(o["base"], float)
        axis = np.array(o["top"], float) - base if "top" in o else np.array([0, 0, o["height"]], float)
        height = np.linalg.norm(axis)
        axis = axis / height
        r0 = o["radius"]
        r1 = o.get("top_radius", 0) if o["shape"] == "cone" else r0
        slope = (r1 - r0) / height
        p = origin - base
        ph, dh = p @ axis, direction @ axis
        pr, dr = p - ph[:, None] * axis, direction - dh[:, None] * axis
        a = (dr * dr).sum(1) - (slope * dh) ** 2
        k = r0 + slope * ph
        b = (pr * dr).sum(1) - slope * dh * k
        c = (pr * pr).sum(1) - k * k
        disc = b * b - a * c
        safe = np.where(np.abs(a) > 1e-14, a, 1e-14)
        root = np.sqrt(np.maximum(disc, 0))
        for t in ((-b - root) / safe, (-b + root) / safe):
            h = ph + t * dh

            def side(x):
                q = x - base
                radial = q - (q @ axis)[:, None] * axis
                out = radial / np.maximum(np.linalg.norm(radial, axis=1), 1e-12)[:, None] - slope * axis
                return out / np.linalg.norm(out, axis=1)[:, None]

            offer(t, (disc > 0) & (h >= 0) & (h <= height), side)
        for h, r, sign in ((0.0, r0, -1.0), (height, r1, 1.0)):
            with np.errstate(divide="ignore", invalid="ignore"):
                t = (h - ph) / dh
                x = pr + t[:, None] * dr
                inside = (x * x).sum(1) <= r * r
            offer(t, inside, lambda q, s=sign: np.broadcast_to(s * axis, q.shape))
        return best, normal

    def intersect(self, origin, direction, limit=None):
        """Nearest hit: t, normal against the ray, material, lamp (-1). With `limit`: whether anything is nearer than that."""
        n = len(origin)
        best = np.full(n, np.inf) if limit is None else limit - EPS
        blocked = np.zeros(n, bool)
        normal, material, lamp = np.zeros((n, 3)), np.full(n, -1), np.full(n, -1)
        with np.errstate(divide="ignore"):
            inverse = 1.0 / np.where(direction == 0, 1e-300, direction)
        for low, high, parts, _, number in self.boxes:
            t0, t1 = (low - origin) * inverse, (high - origin) * inverse
            near3, far3 = np.minimum(t0, t1), np.maximum(t0, t1)
            near, far = near3.max(1), far3.min(1)
            outside = near > EPS
            t = np.where(outside, near, far)
            hit = (near <= far) & (t > EPS) & (t < best)
            if limit is not None:
                blocked |= hit
                continue
            if not hit.any():
                continue
            i = np.flatnonzero(hit)
            axis = np.where(outside[i], near3[i].argmax(1), far3[i].argmin(1))
            best[i] = t[i]
            d = direction[i, axis]
            normal[i] = 0
            normal[i, axis] = -np.sign(d)
            upper = np.where(outside[i], d < 0, d > 0)
            material[i] = parts[2 * axis + upper]
            lamp[i] = number
        for o, m, number in self.solids:
            t, out = self.solid_hits(o, origin, direction)
            hit = t < best
            if limit is not None:
                blocked |= hit
                continue
            best[hit], material[hit], lamp[hit] = t[hit], m, number
            normal[hit] = out[hit] * -np.sign((out[hit] * direction[hit]).sum(1))[:, None]
        return blocked if limit is not None else (best, normal, material, lamp)

    # ------------------------------------------------------------------ light
    def luminance(self, lamp, away):
        """cd/m2 of an opening in directions `away` from it (per unit of the spectral share)."""
        if lamp["n"] is None:  # tube or other with equal luminance all over its side
            return np.full(len(away), lamp["flux"] / (math.pi * math.pi * lamp["diameter"] * lamp["length"]))
        cosine = np.maximum(away @ lamp["aim"], 0)
        candela = lamp["flux"] * (lamp["n"] + 1) / (2 * math.pi) * cosine ** lamp["n"]
        if lamp["kind"] == "sphere":
            return candela / (math.pi * lamp["diameter"] ** 2 / 4)
        return candela / np.maximum(lamp["length"] * lamp["width"] * cosine, 1e-12)

    def direct(self, x, normal, wave, rng, every=False):
        """Estimate of the illuminance from all lamps, one sample of one lamp drawn for each point, or of every lamp."""
        n = len(x)
        total = np.zeros(n)
        # Near lamps more often: a batten 12 mm above its tube gets its light from that one.
        centres, flux = np.array([l["c"] for l in self.lamps]), np.array([l["flux"] for l in self.lamps])
        share = flux / (((x[:, None, :] - centres) ** 2).sum(2) + 0.1)
        share = 0.9 * share / share.sum(1, keepdims=True) + 0.1 / len(flux)
        which = (share.cumsum(1) < rng.random((n, 1))).sum(1).clip(max=len(flux) - 1)
        for number, lamp in enumerate(self.lamps):
            i = np.arange(n) if every else np.flatnonzero(which == number)
            if len(i) == 0:
                continue
            p, u = x[i], rng.random((len(i), 2))
            if lamp["kind"] == "point":
                v = lamp["c"] - p
                d = np.linalg.norm(v, axis=1)
                w = v / d[:, None]
                cosine = np.maximum(-w @ lamp["aim"], 0)
                value = lamp["flux"] * (lamp["n"] + 1) / (2 * math.pi) * cosine ** lamp["n"] / d ** 2
                value *= np.maximum((w * normal[i]).sum(1), 0)
            elif lamp["kind"] == "sphere":
                v, r = lamp["c"] - p, lamp["diameter"] / 2
                d = np.linalg.norm(v, axis=1)
                axis = v / d[:, None]
                top = np.sqrt(np.maximum(1 - (r / d) ** 2, 0))
                ct = 1 - u[:, 0] * (1 - top)
                st = np.sqrt(np.maximum(1 - ct * ct, 0))
                a, b = perpendiculars(axis)
                w = ct[:, None] * axis + st[:, None] * (np.cos(2 * math.pi * u[:, 1])[:, None] * a + np.sin(2 * math.pi * u[:, 1])[:, None] * b)
                value = self.luminance(lamp, -w) * np.maximum((w * normal[i]).sum(1), 0) * 2 * math.pi * (1 - top)
                bb = (w * v).sum(1)
                d = bb - np.sqrt(np.maximum(bb * bb - d * d + r * r, 0))
            elif lamp["kind"] == "rectangle":
                q = lamp["c"] + np.stack([(u[:, 0] - 0.5) * lamp["length"], (u[:, 1] - 0.5) * lamp["width"], np.full(len(i), -3e-7)], 1)
                v = q - p
                d = np.linalg.norm(v, axis=1)
                w = v / d[:, None]
                value = self.luminance(lamp, -w) * np.maximum((w * normal[i]).sum(1), 0) * np.maximum(w[:, 2], 0)
                value *= lamp["length"] * lamp["width"] / d ** 2
            else:
                d, w, value = self.tube(lamp, p, normal[i], u)
            lit = value > 0
            k = i[lit]
            if len(k):
                hidden = self.intersect(x[k], w[lit], d[lit])
                total[k] += np.where(hidden, 0, value[lit] / (1 if every else share[k, number]) * self.spectra[lamp["which"]][wave[k]] / self.pick[wave[k]])
        return total

    def tube(self, lamp, p, normal, u):
        """A tube along x: equal angles along its axis and on the side that faces p, so that points close to it, such as the
        batten above, meet no 1/d^2 (Kulla and Fajardo, "Importance sampling techniques for path tracing in participating
        media", 2012: equi-angular sampling)."""
        r, v = lamp["diameter"] / 2, p - lamp["c"]
        across = np.hypot(v[:, 1], v[:, 2])
        across = np.maximum(across, r * (1 + 1e-9))
        low, high = np.arctan((-lamp["length"] / 2 - v[:, 0]) / across), np.arctan((lamp["length"] / 2 - v[:, 0]) / across)
        along = across * np.tan(low + u[:, 0] * (high - low))
        half = np.arccos(r / across)
        angle = np.arctan2(v[:, 2], v[:, 1]) + (2 * u[:, 1] - 1) * half
        facing = np.stack([np.zeros(len(p)), np.cos(angle), np.sin(angle)], 1)
        q = lamp["c"] + (r + 3e-7) * facing
        q[:, 0] = p[:, 0] + along
        w = q - p
        d = np.linalg.norm(w, axis=1)
        w = w / d[:, None]
        area_per_chance = (high - low) * (across ** 2 + along ** 2) / across * 2 * half * r
        value = self.luminance(lamp, -w) * np.maximum((w * normal).sum(1), 0) * np.maximum(-(w * facing).sum(1), 0)
        return d, w, value * area_per_chance / d ** 2

    # ------------------------------------------------------------------ transport
    def illuminance(self, x, normal, rng):
        """One path per point: estimates of the illuminance at x, facing normal."""
        n = len(x)
        wave = rng.choice(len(WAVE), size=n, p=self.pick)
        total = self.direct(x, normal, wave, rng, every=True)
        weight = np.ones(n)
        active, origin, facing = np.arange(n), x.copy(), normal.copy()
        direction = cosine_directions(facing, rng)
        specular = np.zeros(n, bool)
        for bounce in range(100000):
            t, out, material, lamp = self.intersect(origin, direction)
            for number in np.unique(lamp[specular & (lamp >= 0)]):
                k = np.flatnonzero(specular & (lamp == number))
                entry = self.lamps[number]
                glow = self.luminance(entry, -direction[k]) * (1.0 if entry["kind"] != "rectangle" else (out[k, 2] < 0))
                total[active[k]] += weight[k] * math.pi * glow * self.spectra[entry["which"]][wave[active[k]]] / self.pick[wave[active[k]]]
            rho = self.rho[material, wave[active]]
            # Illuminance of the first surface gives pi L of it = rho E: each diffuse bounce multiplies by rho.
            weight = weight * rho
            hit = origin + t[:, None] * direction
            mirror = self.mirror[material]
            live = (weight > 0) & np.isfinite(t)
            roulette = np.ones(len(active)) if bounce < 2 else np.clip(rho, 0.05, 0.95)
            live &= rng.random(len(active)) < roulette
            weight = weight / roulette
            active, weight, hit, out, mirror, direction = (a[live] for a in (active, weight, hit, out, mirror, direction))
            if len(active) == 0:
                return total
            start = hit + EPS * out
            k = np.flatnonzero(~mirror)
            if len(k):
                total[active[k]] += weight[k] * self.direct(start[k], out[k], wave[active[k]], rng)
            reflected = direction - 2 * (direction * out).sum(1)[:, None] * out
            direction = np.where(mirror[:, None], reflected, cosine_directions(out, rng))
            origin, facing, specular = start, out, mirror


def perpendiculars(n):
    helper = np.where(np.abs(n[:, 2:3]) < 0.9, np.array([[0, 0, 1.0]]), np.array([[1.0, 0, 0]]))
    a = np.cross(helper, n)
    a /= np.linalg.norm(a, axis=1)[:, None]
    return a, np.cross(n, a)


def cosine_directions(n, rng):
    u = rng.random((len(n), 2))
    a, b = perpendiculars(n)
    r, angle = np.sqrt(u[:, 0]), 2 * math.pi * u[:, 1]
    return (r * np.cos(angle))[:, None] * a + (r * np.sin(angle))[:, None] * b + np.sqrt(1 - u[:, 0])[:, None] * n


def grid_points(scene, grid):
    if "points" in grid:
        points = np.array(grid["points"], float)
    else:
        i, j = np.meshgrid(np.arange(grid["counts"][0]), np.arange(grid["counts"][1]))
        points = (np.array(grid["origin"], float) + ((i.ravel() + 0.5) / grid["counts"][0])[:, None] * np.array(grid["u"], float)
                  + ((j.ravel() + 0.5) / grid["counts"][1])[:, None] * np.array(grid["v"], float))
    free = np.ones(len(points), bool)
    for low, high, _, inward, number in scene.boxes:
        if not inward and number < 0:
            free &= ~((points > low) & (points < high)).all(1)
    for o, _, number in scene.solids:
        if o["shape"] == "sphere":
            free &= np.linalg.norm(points - np.array(o["center"]), axis=1) > o["radius"]
        elif "height" in o:
            q = points - np.array(o["base"], float)
            share = q[:, 2] / o["height"]
            r = o["radius"] if o["shape"] == "cylinder" else o["radius"] + share * (o.get("top_radius", 0) - o["radius"])
            free &= ~((share > 0) & (share < 1) & (np.hypot(q[:, 0], q[:, 1]) < r))
    return points, free


def estimate(scene, points, normal, paths, rng):
    batches, size = 20, paths // 20
    means = []
    for _ in range(batches):
        # Every point equally often as far as it goes, the rest at random.
        order = np.concatenate([np.tile(np.arange(len(points)), size // len(points)), rng.permutation(len(points))[:size % len(points)]])
        x = points[order]
        means.append(scene.illuminance(x, np.broadcast_to(normal, x.shape).copy(), rng).mean())
    means = np.array(means)
    return means.mean(), 2.093 * means.std(ddof=1) / math.sqrt(batches)  # Student's t, 19 degrees of freedom


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("project")
    arguments.add_argument("--paths", type=int, default=200000)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--point", action="append", default=[])
    options = arguments.parse_args()
    project = load(options.project)
    scene = Scene(project)
    rng = np.random.default_rng(options.seed)
    values = []
    for grid in project["grids"]:
        points, free = grid_points(scene, grid)
        normal = np.array(grid.get("normal", [0, 0, 1]), float)
        mean, half = estimate(scene, points[free], normal, options.paths, rng)
        values.append({"grid": grid["name"], "quantity": "mean", "value": round(mean, 3), "half_width": round(half, 3), "unit": "lx"})
        for wanted in options.point:
            name, index = wanted.rsplit(":", 1)
            if name == grid["name"]:
                mean, half = estimate(scene, points[[int(index)]], normal, options.paths // 2, rng)
                values.append({"grid": name, "quantity": "point", "index": int(index), "value": round(mean, 3), "half_width": round(half, 3), "unit": "lx"})
    print("\n".join(json.dumps(value) for value in values))


if __name__ == "__main__":
    main()
