"""Cases 4, 26 to 29, 38, 40: geometry and questions that programs trip over."""
import math
import random

from suite import *
from interreflection import CUBE_4M, CUBE_SOURCE, cube

LEFT = dict(says="interreflection", claims={"tree": "says"})


def coincident():
    case = Case(4, "coincident-surfaces", "Two surfaces in one place, one white, one dark",
                "Which of the two light meets is chance: the answer depends on their order.", claims={"*": "refused"})
    two = [rectangle([0, 0, 0], [4, 0, 0], [0, 4, 0], "white", "white floor"),
           rectangle([1, 1, 0], [2, 0, 0], [0, 2, 0], "dark", "dark floor")]
    for name, order in (("project.json", two), ("other-order.json", two[::-1])):
        case.project(name, materials={"white": grey(0.8), "dark": grey(0.2), "black": grey(0)},
                     objects=[dark_room(3, (2, 2, 2))] + order,
                     luminaires=[point_lamp([2, 2, 2], 1000)], grids=[points([[2, 2, 0.5]], normal=[0, 0, -1])])
        case.refused("two finishes in one place", "same plane|coincid", project=name)


def obj(faces, comment):
    """Faces: lists of corners; corners in common are shared."""
    index, text = {}, ""
    for face in faces:
        for p in face:
            if p not in index:
                index[p] = len(index) + 1
                text += "v {:.9g} {:.9g} {:.9g}\n".format(*p)
    return f"# {comment}\n" + text + "".join("f " + " ".join(str(index[p]) for p in face) + "\n" for face in faces)


def faces_of_a_cube(cuts):
    """Triangles of a cube of 4 m that looks inward, each face cut at these places both ways."""
    def quad(a, b, c, d):
        return [(a, b, c), (a, c, d)]

    triangles = []
    for axis in range(3):
        for end, inward in ((0.0, True), (4.0, False)):
            for s, t in zip(cuts, cuts[1:]):
                for u, v in zip(cuts, cuts[1:]):
                    def corner(p, q):
                        place = [0.0, 0.0, 0.0]
                        place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = end, p, q
                        return tuple(place)

                    four = [corner(s, u), corner(t, u), corner(t, v), corner(s, v)]
                    triangles += quad(*(four if inward else four[::-1]))
    return triangles


MESH = {"name": "room", "shape": "mesh", "file": "room.obj", "facing": "inward", "material": "white"}


def zero_area():
    case = Case(26, "zero-area", "Triangles without area, one of them luminous",
                "Their normals are 0/0: NaN in pixels and sums.", **LEFT)
    cube_faces = faces_of_a_cube([0.0, 2.0, 4.0])
    bad = [((0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (4.0, 0.0, 0.0)), ((0.0, 2.0, 4.0), (0.0, 2.0, 4.0), (0.0, 4.0, 4.0))]
    panel = [((1.0, 1.0, 3.9), (1.0, 3.0, 3.9), (3.0, 3.0, 3.9)), ((1.0, 1.0, 3.9), (3.0, 3.0, 3.9), (3.0, 1.0, 3.9))]
    glowing_bad = [((1.0, 1.0, 3.9), (2.0, 2.0, 3.9), (3.0, 3.0, 3.9))]
    case.file("room.obj", obj(cube_faces, "cube of 4 m"))
    case.file("panel.obj", obj(panel, "luminous panel"))
    case.file("room-bad.obj", obj(cube_faces + bad, "cube of 4 m and two triangles without area"))
    case.file("panel-bad.obj", obj(panel + glowing_bad, "luminous panel and a triangle without area"))
    for name, suffix in (("clean.json", ""), ("project.json", "-bad")):
        case.project(name, materials={"white": grey(0.5), "glow": grey(0, exitance_lm_m2=1000)},
                     objects=[{**MESH, "file": f"room{suffix}.obj"},
                              {"name": "panel", "shape": "mesh", "file": f"panel{suffix}.obj", "material": "glow"}],
                     grids=[plane([0, 0, 1], [4, 0, 0], [0, 4, 0], [4, 4])], accuracy="2 %")
    case.same("with and without them", "clean.json", "project.json", "no area, no light", exact=True)


def slivers():
    case = Case(27, "slivers", "A closed room of triangles 10000 times as long as wide",
                "A margin in the test for hits drops thin triangles, and the room leaks.", **LEFT)
    cuts = [0.0, 0.0004, 1.0, 1.0004, 2.0, 2.0004, 3.0, 3.9996, 4.0]
    case.file("room.obj", obj(faces_of_a_cube(cuts), "cube of 4 m with strips of 0.4 mm"))
    cube(case, "project.json", 0.9, MESH)
    case.points("on a face of a cube, reflectance 0.9: middle, edge, corner", CUBE_4M[0.9], CUBE_SOURCE, tolerance=2e-4)
    case.warned("no hole is found", "leave the scene", absent=True)


def flipped():
    case = Case(28, "flipped-normals", "A room with faces turned at random, and luminous faces turned over",
                "One-sided finishes go black; a luminous face that looks the wrong way lights the ceiling.", **LEFT)
    chance = random.Random(28)
    faces = [f if chance.random() < 0.5 else f[::-1] for f in faces_of_a_cube([0.0, 1.0, 2.0, 3.0, 4.0])]
    case.file("room.obj", obj(faces, "cube of 4 m, faces turned at random"))
    cube(case, "project.json", 0.5, {**MESH, "facing": "outward"})
    case.points("on a face of a cube, reflectance 0.5: middle, edge, corner", CUBE_4M[0.5], CUBE_SOURCE, tolerance=2e-4)
    u, v = [1, 0, 0], [0, 1, 0]
    for name, a, b in (("panel.json", u, v), ("panel-turned.json", v, u)):
        case.project(name, materials={"glow": grey(0, exitance_lm_m2=1000 * math.pi), "black": grey(0)},
                     objects=[dark_room(), rectangle([-0.5, -0.5, 1], a, b, "glow", "panel")], grids=[points([[0, 0, 0]])])
        x = 0.5 / math.sqrt(1.25)
        case.points(f"under a luminous face whose front looks {'up' if a == u else 'down'}",
                    [1000 * 4 * x * math.atan(x)], "a luminous surface shines to both sides: pi L x configuration factor",
                    project=name, tolerance=2e-4)


def open_glass():
    case = Case(29, "open-glass", "A glass body with a missing face",
                "Inside and outside are counted wrong: parts are black, or bend light at random.", claims={"*": "refused"})
    low, high = -0.5, 0.5
    p = [[x, y, z] for z in (low, high) for y in (low, high) for x in (low, high)]
    faces = [[0, 2, 3, 1], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]]  # no top
    case.project("project.json", materials={"glass": {"model": "dielectric", "ior": 1.5}, "black": grey(0)},
                 objects=[dark_room(), {"name": "block", "shape": "polyhedron", "vertices": p, "faces": faces, "material": "glass"}],
                 luminaires=[lamp([0, 0, 2], "diffuse", flux=1000, shape={"sphere": {"diameter": 0.2}})],
                 grids=[points([[0, 0, -1]])])
    case.refused("a body of glass must be closed", "not closed|open")


def glare_extremes():
    case = Case(38, "glare-extremes", "Glare of a 5 mm LED, of luminaires behind the eye and at the edge of its field, "
                "before a black background", "The logarithm of 0, a position index outside its table: NaN or infinity.")
    def led(position):
        return lamp(position, "diffuse", flux=50, shape={"sphere": {"diameter": 0.005}})

    eye = [0, 0, 1.2]
    dark = [box([-3, -3, 0], [3, 3, 3])]
    grey_room = dict(materials={"grey": grey(0.5)}, objects=[box([-3, -3, 0], [3, 3, 3], "grey")])
    observers = [{"name": "o", "eye": eye, "direction": [1, 0, 0], "quantity": "ugr"}]
    some = [points([[1, 1, 0.8]])]
    for name, parts, place, what in (
            ("project.json", grey_room, [2, 0, 1.3], "a 5 mm LED at 2 m"),
            ("behind.json", grey_room, [-2, 0, 1.3], "a luminaire behind the eye"),
            ("edge.json", grey_room, [0.5, 0, 2.7], "at T/R = 3"),
            ("black.json", dict(objects=dark), [2, 0, 1.3], "before a black background")):
        case.project(name, luminaires=[led(place)], grids=some, observers=observers, **parts)
        case.add("finite", f"{what}: a number, or a sentence that there is none", "no NaN, no infinity", project=name,
                 observer="o")


def repeated():
    case = Case(40, "repeated-runs", "The same run again, on one thread and on two",
                "Races, or random numbers that belong to a thread.")
    case.project("project.json", materials={"grey": grey(0.5), "mirror": {"model": "mirror", "reflectance": 0.8}},
                 objects=[box([0, 0, 0], [4, 3, 3], "grey", materials={"xmin": "mirror"}),
                          {"name": "ball", "shape": "sphere", "center": [2.5, 1, 0.5], "radius": 0.4, "material": "grey"}],
                 luminaires=[lamp([2, 1.5, 2.8], "cosine", flux=3000, shape={"rectangle": {"length": 0.6, "width": 0.6}})],
                 grids=[plane([0, 0, 0.8], [4, 0, 0], [0, 3, 0], [9, 7])], accuracy="3 %",
                 views=[view([3.8, 2.8, 1.6], [1, 1, 1], fov=70, size=24, up=[0, 0, 1])])
    case.add("repeated", "all numbers, with 1 and with 2 threads", "same seed, same bytes", project="project.json", grid="g",
             view="eye")


def make():
    for build in (coincident, zero_area, slivers, flipped, open_glass, glare_extremes, repeated):
        build()
