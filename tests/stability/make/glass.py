"""Cases 14, 15, 23, 24, 25, 32: light through glass and water."""
import math

from suite import *

GLASS = "glass|mirrors|truncat|reflections"


def glass(n=1.5, **more):
    return {"model": "dielectric", "ior": n, **more}


def panel(z, size=1.0, material="panel", name="panel"):
    return rectangle([-size / 2, -size / 2, z], [size, 0, 0], [0, size, 0], material, name)


PANEL = {"panel": grey(0, exitance_lm_m2=100 * math.pi)}


def water():
    case = Case(14, "through-water", "A point source over a pool of water",
                "Shadow rays end at the surface of the water: the bottom is dark.", says=GLASS,
                claims={"tree": "says"})
    n, height, depth, candela = 1.33, 1.0, 0.5, 1000.0
    case.project("project.json", materials={"water": glass(n), "black": grey(0)},
                 objects=[box([-10, -10, -depth], [10, 10, 0], "water", "pool", None),
                          rectangle([-10, -10, -depth - 1e-4], [20, 0, 0], [0, 20, 0], "black", "bottom")],
                 luminaires=[point_lamp([0, 0, height], candela)], grids=[points([[0, 0, -depth]])])
    case.projects["project.json"]["objects"] = [
        {"name": "pool", "shape": "box", "min": [-10, -10, -depth], "max": [10, 10, 0],
         "materials": {"*": "water", "floor": "black", "walls": "black"}}]
    radii, values = [], []
    for degrees in (0, 20, 40, 60):
        t = math.radians(degrees)
        tt = math.asin(math.sin(t) / n)
        radii.append(height * math.tan(t) + depth * math.tan(tt))
        through = 1 - sum(fresnel(n, degrees)) / 2
        if degrees == 0:
            values.append(candela * through / (height + depth / n) ** 2)
            continue
        # Flux of a ring of directions over the ring that it falls on.
        slope = height / math.cos(t) ** 2 + depth / math.cos(tt) ** 2 * math.cos(t) / (n * math.cos(tt))
        values.append(candela * through * math.sin(t) / (radii[-1] * slope))
    case.projects["project.json"]["grids"] = [points([[r, 0, -depth] for r in radii])]
    case.points("the bottom, at the nadir and where rays of 20, 40 and 60 degrees arrive", values,
                "closed form: ring of directions to ring of the bottom, Snell and Fresnel; 517.608 lx at the nadir",
                tolerance=5e-4)


def only_through_a_pane():
    case = Case(15, "only-through-a-pane", "A light that is seen through glass only",
                "Shadow rays stop at glass.", says=GLASS, claims={"tree": "says"})
    candela = 1000.0
    for name, thick in (("project.json", False), ("solid.json", True)):
        pane = (box([-2, -2, 1.5], [2, 2, 1.506], "glass", "pane", None) if thick else
                rectangle([-2, -2, 1.5], [4, 0, 0], [0, 4, 0], "glass", "pane"))
        case.project(name, materials={"glass": glass(1.5, **({} if thick else {"thickness_m": 0.006})), "black": grey(0)},
                     objects=[dark_room(), pane], luminaires=[point_lamp([0, 0, 3], candela)], grids=[points([[0, 0, 0]])])
    case.points("under a thin pane, in line", [candela / 9 * 12 / 13], "I/d^2 x 0.923077, n = 1.5 at normal incidence")
    r, t = 0.04, 0.006
    solid = sum((1 - r) ** 2 * r ** (2 * k) * candela / (3 - t + (2 * k + 1) * t / 1.5) ** 2 for k in range(12))
    case.points("under the same pane as a solid of 6 mm", [solid],
                "sum over the reflections inside; each has its apparent distance", project="solid.json", tolerance=5e-4)


def light_guide():
    case = Case(23, "light-guide", "A glass rod of 10 mm and 1 m, seen through at 45 degrees",
                "53 total reflections: a limit of depth makes it black, no limit overflows the stack.", says=GLASS,
                claims={"tree": "says"})
    case.project("project.json", materials={"glass": glass(), **PANEL},
                 objects=[box([0, -0.005, -0.005], [1, 0.005, 0.005], "glass", "rod", None),
                          rectangle([1.02, -0.5, -0.5], [0, 1, 0], [0, 0, 1], "panel", "panel")],
                 views=[view([-0.02, 0, -0.02], [0, 0, 0], fov=0.5, size=32, up=[0, 0, 1])])
    case.seen("luminance through the rod, of a panel of 100 cd/m2", "eye", [16, 16], 100 * slab(1.5, 45),
              "53.45 total reflections lose nothing; (1 - R)/(1 + R) of each polarisation. 0.5 %: light without "
              "polarisation has (1 - R)/(1 + R) of their mean", tolerance=5e-3, radius=12)


def overlap():
    case = Case(24, "glass-in-water", "Glass that overlaps the water about it",
                "The index is multiplied twice, or a gap of air makes the reflection 16 times as large.", says=GLASS)

    def stack(*indices):
        through, back = 1.0, 0.0  # of the interfaces so far, symmetric
        for a, b in zip(indices, indices[1:]):
            r = ((a - b) / (a + b)) ** 2
            factor = 1 / (1 - back * r)
            through, back = through * (1 - r) * factor, back + through ** 2 * r * factor
        return through

    def bodies(order):
        both = {"water": box([-1, -1, 0], [1, 1, 0.1], "water", "water", None),
                "glass": box([-1, -1, 0.0999], [1, 1, 0.2], "glass", "glass", None)}
        return [both[name] for name in order]

    for name, order in (("project.json", ("water", "glass")), ("other-order.json", ("glass", "water"))):
        case.project(name, materials={"glass": glass(1.5), "water": glass(1.33), **PANEL},
                     objects=bodies(order) + [panel(0.5)], views=[view([0, 0, -1], [0, 0, 0], fov=0.1, size=32)])
        case.seen(f"luminance of a panel of 100 cd/m2 through both, first {order[0]}", "eye", [16, 16],
                  100 * stack(1, 1.33, 1.5, 1), "three interfaces: R 0.020060, 0.003608, 0.04, and between them",
                  project=name, tolerance=1e-3, radius=12)


def close_panes():
    case = Case(25, "panes-ten-micrometres-apart", "Two panes with 10 micrometres of air between",
                "The distance by which rays leave a surface skips a face, and the light leaves bent.", says=GLASS)
    t, gap = 0.005, 1e-5
    panes = [box([-2, -2, 0], [2, 2, t], "glass", "first", None),
             box([-2, -2, t + gap], [2, 2, 2 * t + gap], "glass", "second", None)]
    case.project("project.json", materials={"glass": glass(), **PANEL}, objects=panes + [panel(0.5)],
                 views=[view([0, 0, -1], [0, 0, 0], fov=0.1, size=32)])
    case.seen("luminance of a panel of 100 cd/m2 at normal incidence", "eye", [16, 16], 100 * 0.96 / 1.12,
              "four faces: (1 - R)/(1 + 3R)", tolerance=1e-3, radius=12)
    # At 45 degrees: the line of sight is moved aside by each pane, and goes on in its direction.
    inside = math.asin(math.sin(math.pi / 4) / 1.5)
    x = 2 - 2 * t * (1 - math.tan(inside))
    strip = rectangle([x - 0.001, -0.1, 1], [0.002, 0, 0], [0, 0.2, 0], "panel", "strip")
    case.project("aslant.json", materials={"glass": glass(), **PANEL}, objects=panes + [strip],
                 views=[view([0, 0, -1], [1, 0, 0], fov=0.01, size=32)])
    rs, rp = fresnel(1.5, 45)
    mean = (rs + rp) / 2
    case.seen("a strip of 2 mm where the line of sight of 45 degrees must end", "eye", [16, 16],
              100 * (1 - mean) ** 4, "Snell's law in both panes, straight through. 3 %: the light that is reflected "
              "between the faces lands beside the strip or on it", project="aslant.json", tolerance=0.03, radius=12)


def grazing_glass():
    case = Case(32, "grazing-glass", "A pane at 80 to 89 degrees",
                "Schlick's formula, one passage, or polarisations that are averaged first: 0.163 or 0.246 at 85 degrees.",
                says=GLASS)
    n, candela = 1.52, 1000.0
    for degrees in (60, 80, 85, 89):
        t = math.radians(degrees)
        a, b = math.cos(t), math.sin(t)
        name = "project.json" if degrees == 85 else f"at-{degrees}.json"
        case.project(name, materials={"glass": glass(n, thickness_m=0.006), "black": grey(0)},
                     objects=[dark_room(5), rectangle([0, -4, -4], [0, 8, 0], [0, 0, 8], "glass", "pane")],
                     luminaires=[point_lamp([-a, -b, 0], candela)], grids=[points([[a, b, 0]], normal=[-a, -b, 0])])
        case.points(f"in line behind a pane of n = 1.52 at {degrees} degrees", [candela / 4 * slab(n, degrees)],
                    "(1 - R)/(1 + R) of each polarisation, their mean; 0.245646 at 85 degrees", project=name,
                    tolerance=1e-3)


def make():
    for build in (water, only_through_a_pane, light_guide, overlap, close_panes, grazing_glass):
        build()
