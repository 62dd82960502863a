"""Cases 1 to 3, 5, 6, 12, 18, 31, 35, 36: light that comes straight from openings."""
import math

from suite import *

INTERREFLECTION = "interreflection"


def tiny_sphere():
    case = Case(1, "tiny-bright-sphere", "A sphere of 1 mm with 1e9 cd/m2 in a hall",
                "Paths that look for light by direction alone hit it once in 24 million tries: they show nothing, or "
                "fireflies, and clamping those loses the light.", says=INTERREFLECTION, claims={"tree": "says"})
    radius, luminance, height = 1e-3, 1e9, 5.0
    flux = 4 * math.pi ** 2 * radius ** 2 * luminance
    small = {"sphere": {"diameter": 2 * radius}}
    case.project("project.json", objects=[box([0, 0, 0], [50, 50, 10])],
                 luminaires=[lamp([25, 25, height], "diffuse", flux=flux, shape=small)],
                 grids=[points([[25, 25, 0]])])
    case.points("illuminance under it in a black hall", [math.pi * luminance * (radius / height) ** 2],
                "closed form: pi L (r/d)^2")
    case.project("reflecting.json", materials={"grey": grey(0.5)},
                 objects=[{"name": "dome", "shape": "sphere", "center": [0, 0, 0], "radius": 5, "facing": "inward",
                           "material": "grey"}],
                 luminaires=[lamp([0, 0, 0], "diffuse", flux=flux, shape=small)],
                 grids=[points([[0, 0, -4], [0, 4, 0], [2.4, 0, 3.2]], normals=[[0, 0, 1], [0, -1, 0], [-0.6, 0, -0.8]])])
    indirect = flux / (4 * math.pi * 25)  # rho / (1 - rho) = 1
    direct = math.pi * luminance * (radius / 4) ** 2
    case.points("its flux, 39478 lm, after interreflection in a sphere of 5 m, reflectance 0.5", [direct + indirect] * 3,
                "closed form: pi L (r/d)^2 + Phi/A rho/(1 - rho), the same everywhere in a sphere",
                project="reflecting.json", tolerance=2e-4)


def near_a_wall():
    case = Case(2, "a-millimetre-from-a-wall", "A luminaire 1 mm before a wall",
                "Radiosity that samples a patch at its centre gives a 10 cm patch 1621 times its flux; a mesh never gets "
                "fine enough.", says=INTERREFLECTION, claims={"tree": "says"})
    side, gap = 0.6, 1e-3
    x = side / 2 / gap
    corner = 2 * x / math.sqrt(1 + x * x) * math.atan(x / math.sqrt(1 + x * x)) / (2 * math.pi)
    case.project("project.json", objects=[box([0, -1, -1], [2, 1, 1])],
                 luminaires=[lamp([gap, 0, 0], "cosine", flux=1000, aim=[-1, 0, 0], c0=[0, 1, 0],
                                  shape={"rectangle": {"length": side, "width": side}})],
                 grids=[points([[0, 0, 0]], normal=[1, 0, 0])])
    case.points("illuminance behind the centre of a square of 0.6 m", [4 * corner * 1000 / side ** 2],
                "closed form: configuration factor of a parallel rectangle, 0.99999 pi L", tolerance=2e-4)

    rho, radius, intensity = 0.8, 2.0, 1000 / (4 * math.pi)

    # E on the wall I h/(h^2 + r^2)^1.5, its light at 1 m on the axis; r = h sinh(t) spreads the steps.
    def ring(t):
        r = gap * math.sinh(t)
        wall = intensity * gap / (gap * gap + r * r) ** 1.5
        return rho * wall / (1 + r * r) ** 2 * 2 * r * gap * math.cosh(t)

    case.project("spot.json", materials={"white": grey(rho), "black": grey(0)},
                 objects=[dark_room(2.5), {"name": "wall", "shape": "disc", "center": [0, 0, 0], "normal": [1, 0, 0], "radius": radius,
                           "material": "white"}],
                 luminaires=[point_lamp([gap, 0, 0], intensity)], grids=[points([[1, 0, 0]], normal=[-1, 0, 0])])
    case.points("direct and reflected light of a point source 1 mm before a white disc of 2 m radius, at 1 m",
                [intensity / (1 - gap) ** 2 + integral(ring, 0, math.asinh(radius / gap))],
                "integral over the disc: half the flux comes back from a spot of a few millimetres", project="spot.json",
                tolerance=3e-4)


def grazing():
    case = Case(3, "grazing-receiver", "A source that crosses the receiver's horizon",
                "A source taken as a point, or by the middle of its parts, gives nothing or the half when the horizon "
                "cuts it.")
    angles = [0, 60, 87, 90, 93]
    normals = [[math.sin(math.radians(a)), 0, math.cos(math.radians(a))] for a in angles]
    flux = 4 * math.pi ** 2 * 0.1 ** 2 * 1e4
    case.project("project.json", objects=[dark_room()],
                 luminaires=[lamp([0, 0, 1], "diffuse", flux=flux, shape={"sphere": {"diameter": 0.2}})],
                 grids=[points([[0, 0, 0]] * 5, normals=normals)])
    case.points("a sphere of 0.1 m at 1 m, 1e4 cd/m2, 0, 60, 87, 90 and 93 degrees off the normal",
                [314.159, 157.080, 17.571, 6.6868, 1.1295],
                "closed form with the horizon (Howell B-43), confirmed by quadrature", tolerance=1e-4)
    case.project("panel.json", objects=[dark_room(6)],
                 luminaires=[lamp([0, 0, 2.2], "cosine", flux=math.pi * 5000 * 0.36,
                                  shape={"rectangle": {"length": 1.2, "width": 0.3}})],
                 grids=[points([[x, 0, 0] for x in (0.3, 0.6, 1, 2, 5)], normal=[-1, 0, 0])])
    case.points("a rectangle above upright receivers, the first of which it is cut by the horizon of",
                [48.734, 77.957, 106.759, 100.230, 22.590], "Lambert's contour integral, clipped", project="panel.json",
                tolerance=2e-4)


def furnished(scale=1.0, shift=(0, 0, 0), **more):
    """A room of 6 x 4 x 3 m with a table and a ball; lengths in metres times `scale`, flux times its square."""
    def p(x, y, z):
        return [x * scale + shift[0], y * scale + shift[1], z * scale + shift[2]]

    return dict(materials={"grey": grey(0.5)},
                objects=[box(p(0, 0, 0), p(6, 4, 3), "grey"), box(p(2, 1, 0), p(3.5, 1.8, 0.75), "grey", "table", None),
                         {"name": "ball", "shape": "sphere", "center": p(4.5, 2.5, 1.2), "radius": 0.4 * scale,
                          "material": "grey"}],
                luminaires=[lamp(p(3, 2, 2.9), "cosine", flux=4000 * scale * scale,
                                 shape={"rectangle": {"length": 0.6 * scale, "width": 0.6 * scale}})],
                grids=[plane(p(0, 0, 0.8), [6 * scale, 0, 0], [0, 4 * scale, 0], [6, 4])], accuracy="2 %", **more)


def scale_and_place():
    case = Case(5, "scale-and-place", "One room in millimetres, of 6 mm, of 600 km, and 100 km away",
                "A fixed distance by which rays leave a surface leaks light in small rooms and far from the origin, and "
                "is lost in the rounding of large ones.")
    case.project("project.json", **furnished())
    same = "illuminance stays when lengths grow by s and flux by s^2, and when all is moved"
    case.project("millimetres.json", **furnished(1000), units="mm")
    case.projects["millimetres.json"]["luminaires"][0]["flux"] = 4000
    case.same("written in millimetres", "project.json", "millimetres.json", same, mean=1e-4)
    for name, scale in (("small.json", 1e-3), ("large.json", 1e5)):
        case.project(name, **furnished(scale))
        case.same(f"all lengths times {scale:g}", "project.json", name, same, mean=1e-4)
    case.project("moved.json", **furnished(1, (1e5, -1e5, 1e4)))
    case.same("moved by 100 km", "project.json", "moved.json", same, mean=1e-4)


def two_rooms():
    case = Case(6, "two-rooms", "Two rooms, a wall without thickness between, a lamp in one",
                "Photon maps and irradiance caches take light from beyond the wall; so do rays that start on the wrong "
                "side of an edge.")
    case.project("project.json", materials={"white": grey(0.8)},
                 objects=[box([0, 0, 0], [8, 4, 3], "white"), rectangle([4, 0, 0], [0, 4, 0], [0, 0, 3], "white", "wall")],
                 luminaires=[lamp([3.9, 0.1, 2.9], flux=5000)],
                 grids=[plane([4, 0, 0.5], [4, 0, 0], [0, 4, 0], [10, 8]),
                        points([[4.001, 0.001, 0.001], [4.001, 2, 2.999], [4.0001, 3.9999, 1.5], [4.001, 2, 1.5]],
                               normal=[-1, 0, 0], name="at the wall")])
    for grid, count in (("g", 80), ("at the wall", 4)):
        case.points(f"the dark room, grid \"{grid}\"", [0] * count, "no way for light", grid=grid, tolerance=0)


def meters_in_the_scene():
    case = Case(12, "meters-in-the-scene", "Ten more measuring planes in the room",
                "Where meters are surfaces, each passage eats a transparent reflection, and light is lost.")
    case.project("project.json", **furnished())
    parts = furnished()
    parts["grids"] = parts["grids"] + [plane([0, 0, 0.2 + 0.25 * i], [6, 0, 0], [0, 4, 0], [2, 2], name=f"meter {i}")
                                       for i in range(10)]
    case.project("metered.json", **parts)
    case.same("the same numbers with ten more grids", "project.json", "metered.json", "meters are no surfaces", exact=True)


def thousand_luminaires():
    case = Case(18, "thousand-luminaires", "1024 luminaires, one on each square metre",
                "Picking one light out of N evenly has a variance that grows with N.")
    count, height, candela = 32, 3.0, 100.0
    spots = [[16 + (i + 0.5) / 4, 16 + (j + 0.5) / 4, 0] for j in range(4) for i in range(4)]

    def illuminance(p):  # I0 cos^2 h / d^3 of a Lambertian point, summed
        return sum(candela * (height / math.sqrt(d2)) ** 2 / d2
                   for i in range(count) for j in range(count)
                   for d2 in [(i + 0.5 - p[0]) ** 2 + (j + 0.5 - p[1]) ** 2 + height ** 2])

    case.project("project.json", objects=[rectangle([0, 0, 0], [count, 0, 0], [0, count, 0])],
                 luminaires=[lamp([0.5, 0.5, height], "cosine", flux=math.pi * candela, shape="point",
                                  array={"counts": [count, count], "u": [1, 0, 0], "v": [0, 1, 0]})],
                 grids=[points(spots)])
    case.points("illuminance at 16 points of the middle square, near pi I0 a square metre",
                [illuminance(p) for p in spots], "sum over all luminaires", tolerance=1e-5)


def near_field_of_parts():
    case = Case(31, "near-field-of-parts", "A 1.2 m uplight whose distribution is dark about the zenith",
                "Every element of the opening gets the distribution of the whole, so that near it light comes from "
                "directions of zero intensity of the whole: a choice, to be stated and calculated as stated.")
    side, candela, edge = 1.2, 100.0, 174.0
    diagram = [[0, 0], [90, 0], [91, candela], [173, candela], [edge, 0], [180, 0]]

    def intensity(gamma):
        for (a, ia), (b, ib) in zip(diagram, diagram[1:]):
            if gamma <= b:
                return ia + (ib - ia) * (gamma - a) / (b - a)
        return 0.0

    def illuminance(h):
        n, total = 1200, 0.0
        step = side / 2 / n
        for i in range(n):
            for j in range(i + 1):  # an eighth of the square
                x, y = (i + 0.5) * step, (j + 0.5) * step
                d2 = x * x + y * y + h * h
                cosine = h / math.sqrt(d2)
                total += (1 if i != j else 0.5) * intensity(180 - math.degrees(math.acos(cosine))) * cosine / d2
        return total * 8 * step * step / side ** 2

    heights = [1.0, 3.0, 6.0, 9.0]
    case.project("project.json", objects=[dark_room(10)],
                 luminaires=[lamp([0, 0, 0], {"goniometric": {"c0": diagram}}, shape={"rectangle": {"length": side,
                                                                                                    "width": side}})],
                 grids=[points([[0, 0, h] for h in heights], normal=[0, 0, -1])])
    case.points("the ceiling's centre 1, 3, 6 and 9 m above", [illuminance(h) for h in heights],
                "integral over the opening of I(gamma) cos / (A d^2); dark where 0.85 m < h tan 6 deg", tolerance=3e-4)


def lights_off():
    case = Case(35, "lights-off", "An open scene with its lights off",
                "A grey default sky adds some percent to everything that is weak.")
    scene = [rectangle([0, 0, 0], [4, 0, 0], [0, 3, 0], "white", "floor"), box([1, 1, 0], [2, 2, 1], "white", "block", None)]
    for name, lamps in (("project.json", [lamp([2, 1.5, 2.5], flux=3000, dimming=0)]),
                        ("glossy.json", [lamp([2, 1.5, 2.5], "cosine", flux=3000, dimming=0,
                                              shape={"rectangle": {"length": 0.6, "width": 0.6}})])):
        case.project(name, materials={"white": grey(0.8)}, objects=scene, luminaires=lamps,
                     grids=[plane([0, 0, 0.5], [4, 0, 0], [0, 3, 0], [8, 6])], views=[view([2, -3, 2], [2, 1.5, 0], fov=60)])
        case.points("a lamp dimmed to 0", [None if 1 < (i % 8 + 0.5) / 2 < 2 and 1 < (i // 8 + 0.5) / 2 < 2 else 0
                                           for i in range(48)], "nothing shines", project=name, tolerance=0)
        case.seen("the same as a picture", "eye", [4, 4], 0, "nothing shines", project=name, tolerance=0)


def dim_beside_bright():
    case = Case(36, "dim-beside-bright", "0.2 lx beside a patch of 1e5 lx",
                "Integer image channels have steps of 1.5 lx there; sampling that looks at the brightest stops early.")
    dim, spot = 0.8, 4e5  # cd, at 2 m
    case.project("project.json", materials={"floor": grey(0.2)},
                 objects=[rectangle([-2, -3, 0], [8, 0, 0], [0, 6, 0], "floor", "floor")],
                 luminaires=[point_lamp([0, 0, 2], dim, name="emergency"),
                             lamp([3, 0, 2], {"goniometric": {"c0": [[0, spot], [1.5, spot], [2, 0], [90, 0]]}}, "spot",
                                  shape="point")],
                 grids=[points([[0, 0, 0], [3, 0, 0]])],
                 views=[view([1.5, 0, 1.5], [1.5, 0, 0], size=64, projection="orthographic", span=4)])
    del case.projects["project.json"]["views"][0]["fov"]
    bright = spot / 4 + dim * 2 / (9 + 4) ** 1.5
    case.points("illuminance under the emergency light and in the patch", [dim / 4, bright], "inverse square and cosine")
    case.seen("luminance of the floor under the emergency light, in one picture with the patch", "eye", [8, 32],
              0.2 / math.pi * dim * 2 / (0.03125 ** 2 * 2 + 4) ** 1.5, "inverse square, cosine, rho/pi", tolerance=5e-3)
    # The pixel is the square from the patch's middle to 62.5 mm beside it, across the patch's edge.
    n, pixel, mean = 400, 4 / 64, 0.0
    for i in range(n):
        for k in range(n):
            x, y = (i + 0.5) / n * pixel, (k + 0.5) / n * pixel
            degrees = math.degrees(math.atan(math.hypot(x, y) / 2))
            candela = spot * min(1.0, max(0.0, (2 - degrees) / 0.5))
            mean += (candela * 2 / (x * x + y * y + 4) ** 1.5 + dim * 2 / ((3 + x) ** 2 + y * y + 4) ** 1.5) / n ** 2
    case.seen("mean luminance of a pixel across the patch's edge", "eye", [56, 32], 0.2 / math.pi * mean,
              "inverse square, cosine, rho/pi, by squares of 0.16 mm", tolerance=5e-3)


def make():
    for build in (tiny_sphere, near_a_wall, grazing, scale_and_place, two_rooms, meters_in_the_scene, thousand_luminaires,
                  near_field_of_parts, lights_off, dim_beside_bright):
        build()
