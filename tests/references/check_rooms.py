"""Checks to_radiance.py on the reference rooms R1, R2, R4 of the shared validation folder (GONIOLUX_SHARED).

Prints the difference of mean and points from the published grids: what the exporter, the options and Radiance add.
"""
import json
import os
import pathlib
import sys
import tempfile

import numpy as np

import to_radiance


def project_of(rooms, name):
    room = rooms["rooms"][name]
    materials = {}
    for key, m in rooms["materials"].items():
        materials[key] = ({"model": "lambert", "diffuse": m["reflectance"]} if m["type"] == "lambertian" else
                          {"model": "mirror", "reflectance": m["reflectance"]})
    objects = [{"name": q["name"], "shape": "rectangle", "origin": q["p0"], "u": q["u"], "v": q["v"], "material": q["material"]}
               for q in room["quads"]]
    objects += [{"name": b["name"], "shape": "box", "min": b["min"], "max": b["max"], "material": b["material"]}
                for b in room["boxes"]]
    luminaires = [{"name": l["name"], "photometry": "cosine", "flux": l["flux_lm"], "position": l["center"],
                   "shape": {"rectangle": {"length": l["size"][0], "width": l["size"][1]}}} for l in room["luminaires"]]
    g = room["grid"]
    grid = {"name": "work plane", "origin": [g["x0"], g["y0"], g["z"]], "u": [g["x1"] - g["x0"], 0, 0],
            "v": [0, g["y1"] - g["y0"], 0], "counts": [g["nx"], g["ny"]], "normal": [0, 0, 1]}
    return {"format": "goniolux-project", "version": 1, "materials": materials, "objects": objects, "luminaires": luminaires,
            "grids": [grid]}


def main():
    shared = pathlib.Path(os.environ.get("GONIOLUX_SHARED", pathlib.Path(__file__).resolve().parents[3] / "shared"))
    rooms = json.loads((shared / "validation" / "rooms" / "rooms.json").read_text())
    for name in sys.argv[1:] or ["R1", "R2", "R4"]:
        table = np.genfromtxt(shared / "validation" / "rooms" / f"{name}.csv", delimiter=",", names=True, comments="#")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "project.json"
            path.write_text(json.dumps(project_of(rooms, name)))
            calculation = to_radiance.Calculation(path, 3, folder)
            grid, = calculation.grids
            illuminance = calculation.illuminances(grid["points"], grid["normals"], 4, 1, samples=64)
        expected = table["E_total_lx"]
        value = illuminance.mean(axis=0)
        spread = illuminance.std(axis=0, ddof=1) / 2
        error = value / expected - 1
        print(f"{name}: {len(value)} points, mean {value.mean():.3f} lx ({100 * (value.mean() / expected.mean() - 1):+.3f} %), "
              f"rms {100 * np.sqrt((error ** 2).mean()):.3f} % where Radiance's own noise is "
              f"{100 * np.sqrt(((spread / expected) ** 2).mean()):.3f} %", flush=True)


if __name__ == "__main__":
    main()
