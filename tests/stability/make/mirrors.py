"""Cases 13, 19, 20, 22, 39: mirrors, and finishes that filter light."""
import csv
import math
from pathlib import Path

from suite import *

BY_MIRRORS = "mirror"
DATA = Path(__file__).resolve().parents[3] / "data" / "cie"


def mirror(reflectance):
    return {"model": "mirror", "reflectance": reflectance}


def caustic():
    case = Case(13, "caustic", "A point source in the focus of a mirror", "Paths cannot meet a point: its light by a curved "
                "mirror is lost.", says=BY_MIRRORS, claims={"tree": "says"})
    f, candela, rho, top = 0.1, 100.0, 0.9, 1.1
    case.project("project.json", materials={"mirror": mirror(rho), "black": grey(0)},
                 objects=[dark_room(1.5), {"name": "dish", "shape": "quadric", "xx": 1, "yy": 1, "z": -4 * f, "size": 1,
                           "min": [-0.3, -0.3, -0.01], "max": [0.3, 0.3, 0.2], "material": "mirror"}],
                 luminaires=[point_lamp([0, 0, f], candela)],
                 grids=[points([[r, 0, top] for r in (0.0, 0.05, 0.1, 0.2)], normal=[0, 0, -1])])
    d = top - f
    case.points("a plane 1 m above, 0, 0.05, 0.1 and 0.2 m off the axis",
                [rho * candela / (f * (1 + (r / (2 * f)) ** 2)) ** 2 + candela * d / (d * d + r * r) ** 1.5
                 for r in (0.0, 0.05, 0.1, 0.2)],
                "closed form: parallel beam rho I/(f^2 (1 + (r/2f)^2)^2), and the direct light", tolerance=1e-3)


def table(name, column=None):
    rows = [row for row in (DATA / name).read_text().splitlines() if not row.startswith("#")]
    reader = list(csv.reader(rows))
    index = reader[0].index(column) if column else 2
    return {float(row[0]): float(row[index] or 0) for row in reader[1:]}


def at(curve, w):
    """Straight between the entries of a table, nothing beyond."""
    keys = sorted(curve)
    if w < keys[0] or w > keys[-1]:
        return 0.0
    for a, b in zip(keys, keys[1:]):
        if w <= b:
            return curve[a] + (curve[b] - curve[a]) * (w - a) / (b - a)
    return curve[keys[-1]]


def photopic_share(power, reflectance, lines=()):
    """Share of the luminous flux that a reflectance leaves, by steps of 0.05 nm."""
    v = table("cie1931_2deg.csv", "ybar")
    keys, whole, left = sorted(v), 0.0, 0.0
    for i in range(len(keys) - 1):
        for k in range(20):
            w = keys[i] + (k + 0.5) / 20
            flux = power(w) * (v[keys[i]] + (v[keys[i + 1]] - v[keys[i]]) * (k + 0.5) / 20) / 20
            whole += flux
            left += flux * reflectance(w)
    for w, energy in lines:
        whole += energy * at(v, w)
        left += energy * at(v, w) * reflectance(w)
    return left / whole


def by_a_mirror(case, name, reflectance, spectrum, **more):
    """A lamp at 2 m over a mirror, a receiver at 1 m that looks down: it sees the lamp's image alone."""
    case.project(name, materials={"mirror": mirror(reflectance), "black": grey(0)},
                 objects=[dark_room(), rectangle([-3, -3, 0], [6, 0, 0], [0, 6, 0], "mirror", "mirror")],
                 luminaires=[point_lamp([0, 0, 2], 1000, spectrum=spectrum)], grids=[points([[0.5, 0, 1]], normal=[0, 0, -1])],
                 **more)
    return 1000 * 3 / 9.25 ** 1.5


def sampled(f, first, last, step):
    count = round((last - first) / step)
    nodes = [round(first + i * step, 6) for i in range(count + 1)]
    curve = {w: round(f(w), 6) for w in nodes}

    def straight(w):
        i = min(max(int((w - first) / step), 0), count - 1)
        t = min(max((w - nodes[i]) / step, 0), 1)
        return curve[nodes[i]] * (1 - t) + curve[nodes[i + 1]] * t

    return {"wavelengths": nodes, "values": [curve[w] for w in nodes]}, straight


def sodium_line():
    case = Case(19, "line-and-narrow-filter", "Sodium light on a finish with a notch of 10 nm",
                "A fixed grid of wavelengths misses the notch, the line, or both: 0.97 for 0.05.", says=BY_MIRRORS,
                claims={"tree": "says"})
    notch, straight = sampled(lambda w: 1 - 0.95 * math.exp(-((w - 589.3) / 5) ** 2), 559.3, 619.3, 0.5)
    image = by_a_mirror(case, "project.json", notch, {"lines": [[589.3, 1]], "continuum": 0})
    case.points("one line at 589.3 nm", [image * 0.05], "the notch's reflectance at the line, 0.05", tolerance=2e-4)
    by_a_mirror(case, "daylight.json", notch, "CIE D65")
    d65 = table("illuminant_d65.csv", "D65")
    case.points("the same notch in daylight", [image * photopic_share(lambda w: at(d65, w), straight)],
                "sum over S V rho by 0.05 nm", project="daylight.json", tolerance=5e-4)


def few_samples():
    case = Case(20, "lines-and-few-samples", "Fluorescent light and five lines with 9 samples",
                "Point samples fall beside the lines: white paint is coloured, and finishes are wrong by 9 to 22 "
                "CIEDE2000.", says=BY_MIRRORS, claims={"tree": "says"})
    s = lambda c, w: lambda l: 1 / (1 + math.exp(-(l - c) / w))
    curves = {"white": lambda l: 0.5, "cyan": lambda l: 0.05 + 0.85 * (1 - s(565, 8)(l)),
              "overlap": lambda l: (0.05 + 0.85 * (1 - s(565, 8)(l))) * (0.05 + 0.85 * s(515, 8)(l)),
              "comb": lambda l: 0.5 + 0.45 * math.sin(2 * math.pi * l / 60)}
    fl11 = table("illuminants.csv", "FL11")
    lines = [[405, 0.3], [436, 0.6], [546, 1.0], [578, 0.25], [611, 0.8]]
    for source, spectrum in (("fl11", "CIE FL11"), ("lines", {"lines": lines, "continuum": 0.004})):
        for name, f in curves.items():
            curve, straight = sampled(f, 380, 780, 2)
            share = (photopic_share(lambda w: at(fl11, w), straight) if source == "fl11"
                     else photopic_share(lambda w: 0.004, straight, lines))
            for scheme, settings in (("nine", {"spectral": {"scheme": "uniform", "samples": 9}}), ("auto", None)):
                file = f"{source}-{name}-{scheme}.json"
                if (source, name, scheme) == ("fl11", "white", "nine"):
                    file = "project.json"
                image = by_a_mirror(case, file, 0.5 if name == "white" else curve, spectrum, settings=settings)
                case.points(f"{name} under {source}, {scheme}", [image * share], "sum over S V rho by 0.05 nm",
                            project=file, tolerance=1e-6 if name == "white" else 5e-4)


def parallel_mirrors():
    case = Case(22, "parallel-mirrors", "A lamp and an eye between mirrors of 0.88 to 0.99",
                "A depth of 15 loses a half and more; without a limit the time must stay bounded.",
                says="mirror|truncat|reflections", claims={"tree": "says"})

    def images(rho, source=0.7, receiver=1.2, gap=2.0, height=2.0, candela=1000.0):
        total = 0.0
        for k in range(-20000, 20001):  # unfolded: 2 gap k + source after |2k| reflections, 2 gap k - source after |2k - 1|
            for x, count in ((2 * gap * k + source, abs(2 * k)), (2 * gap * k - source, abs(2 * k - 1))):
                total += rho ** count * candela * height / (height ** 2 + (x - receiver) ** 2) ** 1.5
        return total

    for rho in (0.88, 0.95, 0.99):
        name = "project.json" if rho == 0.95 else f"rho-{100 * rho:.0f}.json"
        case.project(name, materials={"mirror": mirror(rho), "black": grey(0)},
                     objects=[dark_room(), rectangle([0, -1, -0.1], [0, 2, 0], [0, 0, 3.1], "mirror", "left"),
                              rectangle([2, -1, -0.1], [0, 2, 0], [0, 0, 3.1], "mirror", "right")],
                     luminaires=[point_lamp([0.7, 0, 2], 1000)], grids=[points([[1.2, 0, 0]])])
        case.points(f"illuminance between mirrors of {rho}", [images(rho)], "sum over all images", project=name,
                    tolerance=1e-5)
        name = f"seen-{100 * rho:.0f}.json"
        count = 30 if rho < 0.9 else 100
        case.project(name, materials={"mirror": mirror(rho), "panel": grey(0, exitance_lm_m2=100 * math.pi)},
                     objects=[rectangle([0, -1, 0], [0, 2, 0], [0, 0, 3], "mirror", "left"),
                              rectangle([2, -1, 0], [0, 2, 0], [0, 0, 3], "mirror", "right"),
                              rectangle([0, -1, 3], [2, 0, 0], [0, 2, 0], "panel", "ceiling")],
                     views=[view([1, 0, 1], [1 - 2 * count, 0, 3], size=16, up=[0, 0, 1])])
        case.seen(f"a ceiling of 100 cd/m2 after {count} reflections of {rho}", "eye", [8, 8], 100 * rho ** count,
                  f"rho^{count} x 100 cd/m2", project=name, tolerance=1e-3, radius=6)


def lamp_in_mirrors():
    case = Case(39, "lamp-in-mirrors", "A lamp far brighter than white, after ten mirrors of 0.5",
                "A cut-off that takes everything for no brighter than white drops its image, which is brighter than the "
                "room.")
    luminance, radius, rho = 1e6, 0.04, 0.5
    case.project("project.json", materials={"mirror": mirror(rho), "white": grey(0.8)},
                 objects=[rectangle([0, -1, 0], [0, 2, 0], [0, 0, 3], "mirror", "left"),
                          rectangle([2, -1, 0], [0, 2, 0], [0, 0, 3], "mirror", "right"),
                          rectangle([0, -1, 0], [2, 0, 0], [0, 2, 0], "white", "floor")],
                 luminaires=[lamp([1, 0, 2], "diffuse", flux=4 * math.pi ** 2 * radius ** 2 * luminance,
                                  shape={"sphere": {"diameter": 2 * radius}})],
                 views=[view([1, 0, 1], [-19, 0, 2], fov=0.02, size=16, up=[0, 0, 1])],
                 settings={"tree": {"cutoff": 0.01}})
    case.seen("the lamp's tenth image", "eye", [8, 8], luminance * rho ** 10, "rho^10 x 1e6 cd/m2", tolerance=1e-3, radius=6)


def make():
    for build in (caustic, sodium_line, few_samples, parallel_mirrors, lamp_in_mirrors):
        build()
