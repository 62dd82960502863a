"""Cases 11, 16, 17, 21, 33, 34, 37: light that walls throw to each other."""
import math

from suite import *

LEFT = dict(says="interreflection", claims={"tree": "says"})
SPHERE = {"name": "sphere", "shape": "sphere", "center": [0, 0, 0], "radius": 1, "facing": "inward", "material": "white"}
INSIDE = dict(points=[[0, 0, -0.8], [0, 0.8, 0], [0.48, 0, 0.64]], normals=[[0, 0, 1], [0, -1, 0], [-0.6, 0, -0.8]])

ROOM_A = [[240.202, 278.267, 301.303, 309.672, 310.845], [316.087, 372.749, 404.204, 409.744, 407.574],
          [350.029, 414.305, 449.239, 453.687, 450.193], [324.449, 376.064, 406.691, 415.989, 416.349],
          [303.118, 346.236, 373.780, 385.616, 388.144]]
ROOM_C = [[143.998, 166.560, 181.609, 189.834, 192.388], [175.267, 203.172, 221.458, 231.209, 234.173],
          [191.882, 222.358, 242.230, 252.789, 255.992], [195.045, 225.093, 245.143, 256.094, 259.490],
          [194.154, 223.473, 243.355, 254.415, 257.893]]
CUBE_4M = {0.5: [310.98, 210.24, 161.08], 0.9: [1153.3, 1049.4, 985.6], 0.95: [2196.4, 2092.0, 2025.9]}
CUBE_POINTS = [[2, 2, 0], [2, 0.5, 0], [0.5, 0.5, 0]]
CUBE_SOURCE = "integral equation solved with exact factors and extrapolated, +-2e-4 (validation catalogue I5)"


def cube(case, name, reflectance, room):
    case.project(name, materials={"white": grey(reflectance)}, objects=[room],
                 luminaires=[lamp([2, 2, 2], flux=10000)], grids=[points(CUBE_POINTS)])


def bright_rooms():
    case = Case(11, "bright-rooms", "Closed rooms of reflectance 0.95 and 0.99",
                "A cap of n reflections loses rho^n of the interreflected light: a quarter and more.", **LEFT, fast=False, seconds=60)
    area = 4 * math.pi
    for rho, name in ((0.95, "project.json"), (0.99, "sphere-99.json")):
        case.project(name, materials={"white": grey(rho)}, objects=[SPHERE], luminaires=[lamp([0, 0, 0], flux=1000)],
                     grids=[points(INSIDE["points"], normals=INSIDE["normals"])])
        case.points(f"in a sphere of reflectance {rho}", [1000 / area * (1 / 0.64 + rho / (1 - rho))] * 3,
                    "closed form: Phi/A rho/(1 - rho), the same everywhere in a sphere, and the direct light",
                    project=name, tolerance=2e-4)
    cube(case, "cube.json", 0.95, box([0, 0, 0], [4, 4, 4], "white"))
    case.points("on a face of a cube, reflectance 0.95: middle, edge, corner", CUBE_4M[0.95], CUBE_SOURCE,
                project="cube.json", tolerance=2e-4)


def uplight_spot():
    case = Case(16, "uplight-spot", "A 2 degree spot on a white ceiling lights a black room",
                "Blotches, or nothing: the small second source on the ceiling is missed by a few gathering rays.", **LEFT)
    rho, ceiling, height = 0.8, 5.0, 4.5
    diagram = [[0, 1], [1, 1], [1.00001, 0], [90, 0]]

    def intensity(g):
        return 1.0 if g <= 1 else max(0.0, (1.00001 - g) / 0.00001)

    whole = (integral(lambda g: math.sin(math.radians(g)), 0, 1) +
             integral(lambda g: intensity(g) * math.sin(math.radians(g)), 1, 1.00001)) * 2 * math.pi * math.pi / 180
    peak = 1000 / whole
    places = [0.0, 1.0, 2.5, 5.0]

    def illuminance(x):  # from every element of the spot
        rings, spokes, total = 60, 48, 0.0
        for i in range(rings):
            gamma = (i + 0.5) / rings
            r = height * math.tan(math.radians(gamma))
            lit = rho / math.pi * peak * math.cos(math.radians(gamma)) ** 3 / height ** 2
            area = 2 * math.pi * r * height / math.cos(math.radians(gamma)) ** 2 * math.radians(1 / rings) / spokes
            for k in range(spokes):
                a = 2 * math.pi * (k + 0.5) / spokes
                d2 = (x - r * math.cos(a)) ** 2 + (r * math.sin(a)) ** 2 + ceiling ** 2
                total += lit * area * ceiling ** 2 / d2 ** 2
        return total

    case.project("project.json", materials={"white": grey(rho), "black": grey(0)},
                 objects=[box([-6, -6, 0], [6, 6, ceiling], "black", materials={"ceiling": "white"})],
                 luminaires=[lamp([0, 0, ceiling - height], {"goniometric": {"c0": diagram}}, flux=1000, aim=[0, 0, 1],
                                  shape="point")],
                 grids=[points([[x, 0, 0] for x in places])])
    case.points("the floor 0, 1, 2.5 and 5 m from the nadir", [illuminance(x) for x in places],
                "integral over the spot; 800 lm / (pi 25 m2) at the nadir", tolerance=5e-4)
    case.project("many.json", materials={"white": grey(rho), "black": grey(0)},
                 objects=case.projects["project.json"]["objects"], luminaires=case.projects["project.json"]["luminaires"],
                 grids=[plane([-5, -5, 0], [10, 0, 0], [0, 10, 0], [8, 8])])
    case.points("the same over 64 points of the floor",
                [illuminance(math.hypot(-5 + 1.25 * (i + 0.5), -5 + 1.25 * (j + 0.5))) for j in range(8) for i in range(8)],
                "integral over the spot", project="many.json", tolerance=5e-4)


def work_plane(table):
    return [table[min(i, 8 - i)][min(j, 8 - j)] for j in range(9) for i in range(9)]


def room_of_the_catalogue(case, z, aim):
    case.project("project.json", materials={"ceiling": grey(0.7), "walls": grey(0.5), "floor": grey(0.2)},
                 objects=[box([0, 0, 0], [6, 4, 3], "walls", materials={"floor": "floor", "ceiling": "ceiling"})],
                 luminaires=[lamp([1.5, 1, z], "cosine", flux=math.pi * 1000, aim=aim, shape="point",
                                  array={"counts": [2, 2], "u": [3, 0, 0], "v": [0, 2, 0]})],
                 grids=[plane([0, 0, 0.8], [6, 0, 0], [0, 4, 0], [9, 9])])


def indirect_only():
    case = Case(17, "indirect-only", "A room lit by its ceiling alone",
                "An ambient guess, or too few gathering rays, is all the light there is.", **LEFT)
    room_of_the_catalogue(case, 2, [0, 0, 1])
    case.points("81 points of the work plane", work_plane(ROOM_C),
                "integral equation with exact factors, extrapolated, +-6e-5 (validation catalogue 3.5 C)", tolerance=2e-4)


def edges_and_corners():
    case = Case(37, "edges-and-corners", "A work plane to the walls",
                "Densities of photons are wrong by a half in corners: their kernel reaches over the edge.", **LEFT)
    room_of_the_catalogue(case, 2.8, [0, 0, -1])
    case.points("81 points of the work plane", work_plane(ROOM_A),
                "integral equation with exact factors, extrapolated, +-6e-5 (validation catalogue 3.5 A)", tolerance=2e-4)


def ranges_of_spectra():
    case = Case(21, "ranges-of-spectra", "Spectra given from 360 to 830 nm and from 380 to 780 nm",
                "Normalised over different ranges, white light on grey paint comes out at 0.9 of what it is.", **LEFT)
    value = [1000 / (4 * math.pi) * (1 / 0.64 + 1)] * 3
    for name, spectrum, reflectance in (
            ("project.json", [360, 830], 0.5), ("narrow-lamp.json", [380, 780], 0.5),
            ("narrow-paint.json", [360, 830], {"wavelengths": [380, 780], "values": [0.5, 0.5]})):
        case.project(name, materials={"white": grey(reflectance)}, objects=[SPHERE],
                     luminaires=[lamp([0, 0, 0], flux=1000, spectrum={"wavelengths": spectrum, "values": [1, 1]})],
                     grids=[points(INSIDE["points"], normals=INSIDE["normals"])])
        case.points("sphere of reflectance 0.5" + {"project.json": "", "narrow-lamp.json": ", lamp from 380 to 780 nm",
                                                   "narrow-paint.json": ", paint from 380 to 780 nm"}[name], value,
                    "closed form: Phi/A (rho/(1 - rho) + (R/r)^2)", project=name)


def metal_furnace():
    case = Case(33, "metal-furnace", "A rough white metal in a furnace",
                "One reflection between the facets is not all: 69 % of the light is lost at roughness 1; a highlight that "
                "is not normalised gains light.", **LEFT, fast=False)
    for alpha in (0.3, 1.0):
        name = "project.json" if alpha == 1.0 else "smoother.json"
        case.project(name, materials={"glow": grey(0, exitance_lm_m2=100 * math.pi),
                                      "metal": {"model": "conductor", "ior": 1, "k": 2000, "roughness": alpha}},
                     objects=[box([-2, -2, -2], [2, 2, 2], "glow"),
                              {"name": "ball", "shape": "sphere", "center": [0, 0, 0], "radius": 0.5, "material": "metal"}],
                     grids=[points([[0, 0, 1.2], [1.4, 0, 0]], normals=[[0, 0, -1], [-1, 0, 0]])], image="20 %",
                     views=[view([-1.6, 0, 0], [0, 0, 0], fov=30, size=48, up=[0, 0, 1])])
        case.points(f"light that the ball throws back, roughness {alpha:g}", [100 * math.pi] * 2,
                    "furnace: all luminances are 100 cd/m2; 1 % for the compensation's fit", project=name, tolerance=0.01)
        case.seen(f"the ball, roughness {alpha:g}", "eye", [24, 24], 100, "furnace; 1 % for the compensation's fit",
                  project=name, tolerance=0.01, radius=20)


def icosahedron():
    golden = (1 + math.sqrt(5)) / 2
    v = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0), (0, -1, golden), (0, 1, golden),
         (0, -1, -golden), (0, 1, -golden), (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1)]
    length = math.sqrt(1 + golden ** 2)
    v = [tuple(c / length for c in p) for p in v]
    f = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
         (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7),
         (9, 8, 1)]
    return v, f


def facets_with_smooth_normals():
    case = Case(34, "facets-with-smooth-normals", "A room of 20 facets whose file has the normals of a sphere",
                "Shading by interpolated normals makes or loses light where they disagree with the facets.", **LEFT)
    v, f = icosahedron()
    text = "# regular icosahedron in the unit sphere, with the sphere's normals\n"
    text += "".join(f"v {x:.15g} {y:.15g} {z:.15g}\n" for x, y, z in v)
    text += "".join(f"vn {-x:.15g} {-y:.15g} {-z:.15g}\n" for x, y, z in v)
    text += "".join(f"f {a + 1}//{a + 1} {c + 1}//{c + 1} {b + 1}//{b + 1}\n" for a, b, c in f)
    case.file("ball.obj", text)
    a, b, c = (v[i] for i in f[0])
    u, w = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
    cross = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]]
    size = math.sqrt(sum(x * x for x in cross))
    inward = [-x / size for x in cross]
    # Radon's seven points: exact for polynomials of degree 5 (Stroud, T2: 5-1).
    s = math.sqrt(15)
    one, two = (6 - s) / 21, (6 + s) / 21
    bary = [(1 / 3, 1 / 3, 1 / 3)] + [p for q in (one, two) for p in ((1 - 2 * q, q, q), (q, 1 - 2 * q, q), (q, q, 1 - 2 * q))]
    weights = [9 / 40] + [(155 - s) / 1200] * 3 + [(155 + s) / 1200] * 3
    rho = 0.8
    case.project("project.json", materials={"white": grey(rho)},
                 objects=[{"name": "ball", "shape": "mesh", "file": "ball.obj", "facing": "inward", "material": "white"}],
                 luminaires=[lamp([0, 0, 0], flux=1000)],
                 grids=[points([[sum(p[k] * q[i] for k, q in enumerate((a, b, c))) for i in range(3)] for p in bary],
                               normal=inward)])
    case.weighted("mean over one of 20 equal facets", weights, 1000 / (20 * size / 2 * (1 - rho)),
                  "closed form: Phi/(A (1 - rho)) with the area of the facets; cubature of degree 5", tolerance=2e-3)


def make():
    for build in (bright_rooms, uplight_spot, indirect_only, ranges_of_spectra, metal_furnace,
                  facets_with_smooth_normals, edges_and_corners):
        build()
