"""What all cases are made of: a list of cases, project files, and the files that they refer to."""
import json
import math
from pathlib import Path

CASES = []
DEFAULT_SECONDS = 10


class Case:
    """One row of cases.json and its folder. `claims`: what each solver must at least do, "*" for all that are not named.

    right: every figure within its interval, to the accuracy asked for.  wide: the same, but the interval is wider.
    says: the figure is off, and the results' "left_out" names what is missing (the expression `says`).
    refused: nothing is calculated, and the message says why.

    `open_defects`: what falls short of its claim and is known to: solver, outcome and why. A test turns red when it passes.
    """

    def __init__(self, number, name, title, breaks, says="", claims=None, fast=True, seconds=DEFAULT_SECONDS,
                 open_defects=None):
        self.number, self.folder, self.title, self.breaks = number, f"{number:02}-{name}", title, breaks
        self.says, self.claims, self.fast, self.seconds = says, {"*": "right", **(claims or {})}, fast, seconds
        self.open_defects = open_defects or {}
        self.projects, self.files, self.checks = {}, {}, []
        CASES.append(self)

    def project(self, name, **parts):
        self.projects[name] = project(f"{self.number:02} {self.title}", **parts)
        return name

    def file(self, name, text):
        self.files[name] = text

    # What is checked. `tolerance`: relative, how well the reference is known (or, as stated, what the physics left out
    # on purpose may do); `source`: where the reference is from.
    def points(self, what, values, source, project="project.json", grid="g", tolerance=1e-4, absolute=0.0, **more):
        self.checks.append({"kind": "points", "what": what, "project": project, "grid": grid, "values": list(values),
                            "tolerance": tolerance, "absolute": absolute, "source": source, **more})

    def weighted(self, what, weights, value, source, project="project.json", grid="g", tolerance=1e-4):
        self.checks.append({"kind": "weighted", "what": what, "project": project, "grid": grid, "weights": list(weights),
                            "value": value, "tolerance": tolerance, "absolute": 0.0, "source": source})

    def seen(self, what, view, pixel, value, source, project="project.json", tolerance=1e-4, radius=0):
        self.checks.append({"kind": "seen", "what": what, "project": project, "view": view, "pixel": list(pixel),
                            "radius": radius, "value": value, "tolerance": tolerance, "absolute": 0.0, "source": source})

    def same(self, what, project, other, source, exact=False, mean=None, grid="g"):
        check = {"kind": "same", "what": what, "project": project, "other": other, "grid": grid, "exact": exact,
                 "source": source}
        if mean is not None:
            check["mean_tolerance"] = mean
        self.checks.append(check)

    def refused(self, what, message, project="project.json"):
        self.checks.append({"kind": "refused", "what": what, "project": project, "message": message,
                            "source": "no answer exists"})

    def warned(self, what, message, project="project.json", absent=False):
        self.checks.append({"kind": "warned", "what": what, "project": project, "message": message, "absent": absent,
                            "source": "the check of the project"})

    def add(self, kind, what, source, **more):
        self.checks.append({"kind": kind, "what": what, "source": source, **more})


def project(name, objects, luminaires=(), grids=(), materials=None, accuracy="1 %", views=(), observers=(), units=None,
            settings=None, image="5 %"):
    document = {"format": "goniolux-project", "version": 1, "name": name}
    if units:
        document["units"] = units
    document["materials"] = materials or {"black": grey(0)}
    document["objects"] = list(objects)
    document["luminaires"] = list(luminaires) or [switched_off(grids, views)]
    if grids:
        document["grids"] = list(grids)
    if observers:
        document["observers"] = list(observers)
    if views:
        document["views"] = list(views)
    document["settings"] = {"accuracy": {"grid": accuracy, "image": image}, **(settings or {})}
    return document


def switched_off(grids, views):
    """A project has a luminaire; where surfaces shine by themselves it is off."""
    place = views[0]["eye"] if views else grids[0].get("origin") or grids[0]["points"][0]
    return lamp(place, name="off", flux=1, dimming=0)


def grey(reflectance, **more):
    return {"model": "lambert", "diffuse": reflectance, **more}


def box(low, high, material="black", name="room", facing="inward", **more):
    return {"name": name, "shape": "box", "min": low, "max": high, **({"facing": facing} if facing else {}),
            "material": material, **more}


def rectangle(origin, u, v, material="black", name="plane"):
    return {"name": name, "shape": "rectangle", "origin": origin, "u": u, "v": v, "material": material}


def dark_room(size=4.0, center=(0, 0, 0), material="black"):
    """A black box about an open scene: nothing comes back from it, and grids lie inside the scene."""
    return box([c - size for c in center], [c + size for c in center], material, "dark")


def lamp(position, photometry="isotropic", name="lamp", **more):
    return {"name": name, "photometry": photometry, "position": position, **more}


def point_lamp(position, candela, **more):
    return lamp(position, flux=4 * math.pi * candela, shape="point", **more)


def points(list_of_points, normal=None, normals=None, name="g", **more):
    grid = {"name": name, "points": list_of_points}
    if normals:
        grid["normals"] = normals
    else:
        grid["normal"] = normal or [0, 0, 1]
    return {**grid, **more}


def plane(origin, u, v, counts, normal=None, name="g"):
    return {"name": name, "origin": origin, "u": u, "v": v, "counts": counts, "normal": normal or [0, 0, 1]}


def view(eye, target, fov=1e-3, size=9, up=None, name="eye", **more):
    return {"name": name, "eye": eye, "target": target, "up": up or [0, 1, 0], "fov": fov, "width": size, "height": size,
            **more}


def integral(f, a, b, n=4000):
    """Simpson's rule."""
    h = (b - a) / n
    return h / 3 * sum((1 if i in (0, n) else 4 if i % 2 else 2) * f(a + i * h) for i in range(n + 1))


def fresnel(n, degrees):
    """Reflectances (s, p) of a surface from air to index n."""
    t = math.radians(degrees)
    c, ct = math.cos(t), math.sqrt(1 - (math.sin(t) / n) ** 2)
    return ((c - n * ct) / (c + n * ct)) ** 2, ((n * c - ct) / (n * c + ct)) ** 2


def slab(n, degrees):
    """Transmittance of a clear slab for unpolarised light: both polarisations through, then their mean."""
    return sum((1 - r) / (1 + r) for r in fresnel(n, degrees)) / 2


def line(value, indent=0):
    """JSON with short things on one line."""
    flat = json.dumps(value)
    if len(flat) + indent <= 118 or not isinstance(value, (dict, list)):
        return flat
    pad = " " * (indent + 2)
    if isinstance(value, dict):
        rows = [f"{pad}{json.dumps(k)}: {line(v, indent + 2 + len(k) + 4)}" for k, v in value.items()]
        return "{\n" + ",\n".join(rows) + "\n" + " " * indent + "}"
    if all(not isinstance(v, (dict, list)) for v in value):
        rows, row = [], pad
        for v in value:
            text = json.dumps(v) + ", "
            if len(row) + len(text) > 118:
                rows.append(row.rstrip())
                row = pad
            row += text
        rows.append(row.rstrip(", "))
        return "[\n" + "\n".join(rows) + "\n" + " " * indent + "]"
    return "[\n" + ",\n".join(pad + line(v, indent + 2) for v in value) + "\n" + " " * indent + "]"


def rounded(value):
    """Ten digits are enough, and read better."""
    if isinstance(value, float):
        return int(value) if value == int(value) and abs(value) < 1e15 else float(f"{value:.10g}")
    if isinstance(value, dict):
        return {k: rounded(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(v) for v in value]
    return value


def write(root):
    root = Path(root)
    table = []
    for case in sorted(CASES, key=lambda c: c.number):
        folder = root / "cases" / case.folder
        folder.mkdir(parents=True, exist_ok=True)
        for name, document in case.projects.items():
            (folder / name).write_text(line(rounded(document)) + "\n")
        for name, text in case.files.items():
            (folder / name).write_text(text)
        wanted = set(case.projects) | set(case.files)
        for stale in folder.iterdir():
            if stale.name not in wanted:
                stale.unlink()
        table.append({"case": case.number, "folder": case.folder, "title": case.title, "breaks": case.breaks,
                      "says": case.says, "claims": case.claims, "fast": case.fast, "seconds": case.seconds,
                      "open_defects": {solver: {"outcome": outcome, "why": why}
                                       for solver, (outcome, why) in case.open_defects.items()},
                      "checks": case.checks})
    (root / "cases.json").write_text(line(rounded({"cases": table})) + "\n")
