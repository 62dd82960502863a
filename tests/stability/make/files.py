"""Cases 7 to 10 and 30: photometric files, and what stands about a luminaire."""
import math

from suite import *


def ies(table, gammas, planes, lumens=-1, multiplier=1, ballast=1, title="stability"):
    """LM-63-2002, type C, a point; `table`: candelas by plane."""
    def rows(values):
        words = [v if isinstance(v, str) else f"{v:.9g}" for v in values]
        return "\n".join(" ".join(words[i:i + 10]) for i in range(0, len(words), 10))

    return ("IESNA:LM-63-2002\n[TEST] made by tests/stability/make\n[TESTLAB] none\n[ISSUEDATE] 2026\n"
            f"[MANUFAC] none\n[LUMINAIRE] {title}\nTILT=NONE\n"
            f"1 {lumens:g} {multiplier:g} {len(gammas)} {len(planes)} 1 2 0 0 0\n{ballast:g} 1 1\n"
            + rows(gammas) + "\n" + rows(planes) + "\n" + "\n".join(rows(row) for row in table) + "\n")


def narrow_beam():
    case = Case(7, "narrow-beam", "A beam of 1 degree in tables of 0.1 to 5 degrees",
                "Straight lines between the entries of a coarse table multiply the flux by up to 23. Candelas stay as "
                "they are stated; where the flux of the table and the declared one part, that is said.")

    def beam(gamma):
        return 1e5 * math.exp(-math.log(2) * (gamma / 0.5) ** 2)

    # Flux of the beam itself, and of its table with straight lines in between.
    true = integral(lambda g: beam(g) * 2 * math.pi * math.sin(math.radians(g)) * math.pi / 180, 0, 20)
    for step, beyond in ((0.1, False), (0.5, True), (1.0, True), (2.5, True), (5.0, True)):
        gammas = [i * step for i in range(round(10 / step) + 1)] + [90]
        name = f"step-{step:g}"
        case.file(f"{name}.ies", ies([[beam(g) for g in gammas[:-1]] + [0]], gammas, [0], lumens=round(true, 3)))
        case.project(f"{name}.json" if step != 1 else "project.json", objects=[dark_room(11)],
                     luminaires=[lamp([0, 0, 10], f"{name}.ies")],
                     grids=[points([[10 * math.tan(math.radians(g)), 0, 0] for g in (0, 5)])])
        project = f"{name}.json" if step != 1 else "project.json"
        case.points(f"illuminance at 0 and 5 degrees, table step {step:g}",
                    [beam(g) * math.cos(math.radians(g)) ** 3 / 100 for g in (0, 5)], "I cos^3 / h^2 of stated candelas",
                    project=project, tolerance=2e-4, absolute=1e-9)
        case.warned(("a warning that the fluxes part" if beyond else "no warning: the fluxes agree within 2 %")
                    + f", table step {step:g}", "lm|flux", project=project, absent=not beyond)


def dark_and_broken():
    case = Case(8, "dark-and-broken-tables", "A table of zeros; tables with NaN, -1 and inf",
                "0/0 where lights are picked by their flux; one NaN spreads to every pixel. A dark luminaire changes "
                "nothing, a bad number is refused with its line.")
    gammas, planes = [0, 45, 90], [0]
    case.file("dark.ies", ies([[0, 0, 0]], gammas, planes, lumens=1000))
    room = dict(materials={"grey": grey(0.5)}, objects=[box([0, 0, 0], [4, 3, 3], "grey")],
                grids=[plane([0, 0, 0.8], [4, 0, 0], [0, 3, 0], [4, 3])], accuracy="2 %",
                views=[view([0.2, 0.2, 1.6], [3, 2, 1], fov=60, size=12, up=[0, 0, 1])])
    lit = lamp([2, 1.5, 2.5], "cosine", flux=3000, shape={"rectangle": {"length": 0.3, "width": 0.3}})
    case.project("without.json", luminaires=[lit], **room)
    case.project("project.json", luminaires=[lit, lamp([1, 1, 2.5], "dark.ies", name="dark")], **room)
    case.same("the same with and without a dark luminaire", "without.json", "project.json", "0 candelas are no light", exact=True)
    for name, bad in (("nan", "NaN"), ("minus", "-1"), ("infinite", "inf")):
        case.file(f"{name}.ies", ies([[100, bad, 0]], gammas, planes, lumens=1000))
        case.project(f"{name}.json", luminaires=[lamp([2, 1.5, 2.5], f"{name}.ies")], **room)
        case.refused(f"{bad} among the candelas, with the line", rf"{name}\.ies:1[0-9]:", project=f"{name}.json")


def symmetries():
    case = Case(9, "planes-and-symmetries", "One plane; planes to 90, 180, 90 to 270, 360 degrees",
                "Readers do not expect a single plane, or mirror the wrong half.")
    gammas = [0, 30, 60, 90]
    height, radius = 3.0, 3.0 * math.tan(math.radians(30))
    ring = [[radius * math.cos(a), radius * math.sin(a), 0] for a in (k * math.pi / 4 for k in range(8))]

    def table(f, planes):
        return [[100 * f(math.radians(c)) * math.cos(math.radians(g)) for g in gammas[:-1]] + [0] for c in planes]

    def steps(a, b):
        return list(range(a, b + 1, 45))

    kinds = {"one": (lambda c: 2.0, [[0]]), "both": (lambda c: 2 + math.cos(2 * c), [steps(0, 90), steps(0, 180),
                                                                                       steps(0, 360)]),
             "c0": (lambda c: 2 + math.cos(c), [steps(0, 180), steps(0, 360)]),
             "c90": (lambda c: 2 + math.sin(c), [steps(90, 270), steps(0, 360)])}
    for kind, (f, choices) in kinds.items():
        for planes in choices:
            name = f"{kind}-{planes[0]}-{planes[-1]}"
            case.file(f"{name}.ies", ies(table(f, planes), gammas, planes))
            case.project(f"{name}.json" if name != "one-0-0" else "project.json", objects=[dark_room()],
                         luminaires=[lamp([0, 0, height], f"{name}.ies")], grids=[points(ring)])
            values = [100 * f(k * math.pi / 4) * math.cos(math.radians(30)) ** 4 / height ** 2 for k in range(8)]
            case.points(f"eight azimuths, planes {planes[0]} to {planes[-1]} degrees", values, "I(C, 30) cos^3 / h^2",
                        project=f"{name}.json" if name != "one-0-0" else "project.json", tolerance=1e-6)


def factors_of_a_file():
    case = Case(10, "factors-of-a-file", "Multiplier 2, ballast factor 0.9, lumens -1",
                "The multiplier is used twice, or not; -1 lumens (absolute photometry) is taken for a fault.")
    case.file("absolute.ies", ies([[100, 100, 100]], [0, 90, 180], [0], multiplier=2, ballast=0.9))
    case.project("project.json", objects=[dark_room()], luminaires=[lamp([0, 0, 2], "absolute.ies")],
                 grids=[points([[0, 0, 0], [0, 2, 0]])])
    case.points("illuminance below and at 45 degrees", [180 / 4, 180 / 8 * math.sqrt(0.5)],
                "I = 100 cd x 2 x 0.9; inverse square and cosine", tolerance=1e-6)


def housing():
    case = Case(30, "housing", "A luminaire with a model of its housing about it",
                "The file's light is the light that has left the housing; the housing's model shades it once more.",
                says="inside")
    shape = {"rectangle": {"length": 1.2, "width": 0.3}}
    height, luminance = 2.0, 3000 / (math.pi * 0.36)
    x, y = 0.6 / height, 0.15 / height
    sx, sy = math.sqrt(1 + x * x), math.sqrt(1 + y * y)
    factor = 2 / math.pi * (x / sx * math.atan(y / sx) + y / sy * math.atan(x / sy))
    body = box([-0.62, -0.17, height], [0.62, 0.17, height + 0.08], "white", "housing", None)
    for name, z in (("project.json", height), ("inside.json", height + 0.04)):
        case.project(name, materials={"white": grey(0.8), "black": grey(0)}, objects=[dark_room(), body],
                     luminaires=[lamp([0, 0, z], "cosine", flux=3000, shape=shape)],
                     grids=[points([[0, 0, 0]])])
        where = "at its mouth" if z == height else "in its middle, as photometric centres are"
        h = z
        x, y = 0.6 / h, 0.15 / h
        sx, sy = math.sqrt(1 + x * x), math.sqrt(1 + y * y)
        factor = 2 / math.pi * (x / sx * math.atan(y / sx) + y / sy * math.atan(x / sy))
        case.points(f"light below a box about the luminaire, which is {where}", [math.pi * luminance * factor],
                    "closed form: configuration factor of the opening; the housing's share is in the file", project=name,
                    tolerance=2e-4)


def make():
    for build in (narrow_beam, dark_and_broken, symmetries, factors_of_a_file, housing):
        build()
