#!/usr/bin/env python3
"""Makes the photometric files of this folder and README.md from formulas: no measurement, no manufacturer's data.

Standard library only; the same bytes on every machine. Run it after a change:  python3 luminaires/make_luminaires.py
Each table is scaled so that the exact integral of its bilinear interpolant is the luminaire's flux.
"""
import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
DATE = "2026-11-23"


def rad(degrees):
    return math.radians(degrees)


def steps(first, last, step):
    return [first + i * step for i in range(int(round((last - first) / step)) + 1)]


def ramp(x, low, high):
    """0 below `low`, 1 above `high`, smooth between."""
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


def direction(c, gamma):
    return (math.sin(rad(gamma)) * math.cos(rad(c)), math.sin(rad(gamma)) * math.sin(rad(c)), math.cos(rad(gamma)))


def lobe(c, gamma, axis_c, axis_gamma, beam):
    """cos^n about an axis; `beam` is the full angle between the directions of half the maximum."""
    n = math.log(0.5) / math.log(math.cos(rad(beam / 2)))
    cosine = sum(a * b for a, b in zip(direction(c, gamma), direction(axis_c, axis_gamma)))
    return max(0.0, cosine) ** n


# --- exact flux of the bilinear interpolant -------------------------------------------------------------------------

def linear_weights(degrees, measure):
    """Weights of the angles in the integral of the linear interpolant times sin (gamma), cos (latitude) or 1."""
    weights = [0.0] * len(degrees)
    for i in range(len(degrees) - 1):
        a, b = rad(degrees[i]), rad(degrees[i + 1])
        if measure == "sin":
            zeroth, first = math.cos(a) - math.cos(b), -(b - a) * math.cos(b) + math.sin(b) - math.sin(a)
        elif measure == "cos":
            zeroth, first = math.sin(b) - math.sin(a), (b - a) * math.sin(b) + math.cos(b) - math.cos(a)
        else:
            zeroth, first = b - a, (b - a) ** 2 / 2
        weights[i] += zeroth - first / (b - a)
        weights[i + 1] += first / (b - a)
    return weights


def plane_weights(kind, planes):
    """Weights of the stored planes in the integral over the whole circle (type C) or over H (type B), symmetric copies included."""
    if len(planes) == 1:
        return [2 * math.pi]
    if kind in "AB":
        copies = 2 if planes[0] == 0 else 1
        return [copies * w for w in linear_weights(planes, "cos" if kind == "B" else "1")]
    ascending = [p - 360 for p in planes if p >= 270] + [p for p in planes if p < 270] if planes[0] == 270 else planes
    if ascending[-1] - ascending[0] in (90, 180, 360):
        copies = round(360 / (ascending[-1] - ascending[0]))
        return [copies * w for w in linear_weights(ascending, "1")]
    weights = linear_weights(ascending + [360], "1")  # the last plane before 360 reaches to plane 0
    weights[0] += weights.pop()
    return weights


def integral(kind, planes, vertical, table):
    wh, wv = plane_weights(kind, planes), linear_weights(vertical, {"A": "cos", "B": "1", "C": "sin"}[kind])
    return sum(h * v * value for h, row in zip(wh, table) for v, value in zip(wv, row))


# --- the luminaires -------------------------------------------------------------------------------------------------

GAMMA_DOWN = steps(0, 90, 2.5)
GAMMA_ALL = steps(0, 180, 2.5)
GAMMA_NARROW = steps(0, 20, 0.5) + steps(21, 40, 1) + steps(42.5, 90, 2.5)
QUADRANT = steps(0, 90, 7.5)
HALF = steps(0, 180, 7.5)
FRONT_C90 = steps(90, 270, 7.5)
ROUND = steps(0, 360, 7.5)


def prismatic(c, gamma):
    across = abs(math.sin(rad(c)))
    cut = 62 - 6 * across
    return math.cos(rad(gamma)) ** 1.1 * (1 - 0.97 * ramp(gamma, cut - 12, cut + 8))


def louvre(c, gamma):
    along = abs(math.cos(rad(c)))
    cut = 68 - 10 * along
    batwing = 1 + 0.25 * (1 - along) * math.sin(rad(2 * gamma)) ** 2
    return math.cos(rad(gamma)) * batwing * (1 - ramp(gamma, cut - 14, cut))


def wall_washer(c, gamma):
    return lobe(c, gamma, 0, 38, 44) + 0.25 * lobe(c, gamma, 0, 0, 70)


def pendant(c, gamma):
    across = abs(math.cos(rad(c)))  # the length lies along C90
    if gamma <= 90:
        return math.cos(rad(gamma)) * (1 - 0.85 * ramp(gamma, 50, 75))
    up = 180 - gamma
    return 0.55 * math.cos(rad(up)) * (1 + 0.9 * across * math.sin(rad(min(up, 90))) ** 2)


def batten(c, gamma):
    # A diffuse tube along C90 gives I = I_perp sin(angle to the tube); its 60 mm spine above keeps 1/4 of the light above.
    y = math.sin(rad(gamma)) * math.sin(rad(c))
    return math.sqrt(max(0.0, 1 - y * y)) * (1 - 0.75 * ramp(gamma, 95, 150))


def high_bay(c, gamma):
    return lobe(0, gamma, 0, 0, 85) * (1 - 0.9 * ramp(gamma, 55, 75))


def street(c, gamma):
    # Road along C0-C180, the throw towards C90.
    value = 0.35 * lobe(c, gamma, 90, 20, 100)
    for side in (12, 168):
        value += lobe(c, gamma, side, 62, 32)
    return value * (1 - ramp(gamma, 74, 86))


def track_spot(c, gamma):
    # Barn doors at C0 (closed most), C90 and C270; open at C180.
    doors = {0: 9, 90: 14, 270: 18}
    value = lobe(0, gamma, 0, 0, 20) + 0.02 * math.cos(rad(min(gamma, 90)))
    for door, edge in doors.items():
        towards = math.cos(rad(c - door))
        if towards > 0:
            value *= 1 - 0.96 * ramp(math.degrees(math.atan(math.tan(rad(min(gamma, 89.9))) * towards)), edge, edge + 8)
    return value


def cove(c, gamma):
    return lobe(c, gamma, 90, 125, 60) + 0.15 * max(0.0, -math.cos(rad(gamma)))


def blackboard(c, gamma):
    return (lobe(c, gamma, 90, 48, 50) + 0.15 * lobe(c, gamma, 90, 10, 90)) * (1 - ramp(gamma, 70, 85))


def globe(c, gamma):
    return 1 - 0.65 * ramp(gamma, 140, 175)


def bollard(c, gamma):
    return math.exp(-((gamma - 72) / 16) ** 2) * (1 - ramp(gamma, 80, 92))


def gimbal(c, gamma):
    return lobe(c, gamma, 30, 25, 36) + 0.01 * math.cos(rad(min(gamma, 90)))


def floodlight(h, v):
    return math.exp(-((h / 38) ** 4)) * (math.exp(-(((v - 3) / (14 if v > 3 else 24)) ** 2)))


def searchlight(h, v):
    return math.exp(-((h / 6) ** 2) - (v / 4) ** 2) + 0.002 * math.exp(-((h / 50) ** 2) - (v / 40) ** 2)


def tube_pendant(c, gamma):
    x = direction(c, gamma)[0]  # the tube lies along C0
    return math.sqrt(max(0.0, 1 - x * x))


def wall_disc(c, gamma):
    x = direction(c, gamma)[0]  # faces C0
    return max(0.0, x) + 0.02 * max(0.0, 1 - abs(x))


def bulkhead(c, gamma):
    x, y, z = direction(c, gamma)
    return math.hypot(0.07 * 0.05 * x, 0.1 * 0.05 * y, 0.1 * 0.07 * z) * (1 - 0.9 * ramp(gamma, 95, 130))


def oval_spot(c, gamma):
    x, y, z = direction(c, gamma)
    return math.exp(-((math.degrees(math.atan2(x, z)) / 24) ** 2) - (math.degrees(math.atan2(y, z)) / 12) ** 2) if z > 0 else 0.0


RECTANGLE, DISC, BOX, SPHERE, CYLINDER = "rectangle", "disc", "box", "sphere", "cylinder"
ELLIPSE, ELLIPSOID, LYING, UPRIGHT = "ellipse", "ellipsoid", "cylinder along C0", "upright disc facing C0"

LUMINAIRES = [
    dict(file="panel-600.ies", title="Recessed LED panel 600 x 600, opal", use="offices, as the plain case: luminance equal in all directions",
         flux=3600, watts=30, opening=(RECTANGLE, 0.6, 0.6, 0), horizontal=[0], vertical=GAMMA_DOWN,
         shape=lambda c, g: math.cos(rad(g)), how="I = I0 cos(gamma)"),
    dict(file="panel-600-microprismatic.ies", title="Recessed LED panel 600 x 600, micro-prismatic", edition="IES:LM-63-2019",
         use="offices with screens: little light above 65 degrees", flux=4000, watts=31, opening=(RECTANGLE, 0.6, 0.6, 0),
         horizontal=QUADRANT, vertical=GAMMA_DOWN, shape=prismatic, how="cos^1.1 with a smooth cut-off between 44 and 70 degrees, earlier across C90"),
    dict(file="louvre-4x18.ies", title="Recessed louvre luminaire 4 x 18 W T8", edition="IESNA:LM-63-1995", use="offices before LED",
         flux=0.68 * 5400, lamps=4, lamp_lumens=1350, watts=88, opening=(RECTANGLE, 0.58, 0.58, 0), horizontal=QUADRANT,
         vertical=GAMMA_DOWN, shape=louvre, how="cosine with a weak batwing across the lamps, shielded from 54 degrees along and 68 across; light output ratio 0.68"),
    dict(file="downlight-15.ies", title="LED downlight, 15 degree beam", use="accents from high ceilings", flux=900, watts=10,
         opening=(DISC, 0.075, 0.075, 0), horizontal=[0], vertical=GAMMA_NARROW, shape=lambda c, g: lobe(0, g, 0, 0, 15), how="cos^n(gamma), half intensity at 7.5 degrees"),
    dict(file="downlight-30.ies", title="LED downlight, 30 degree beam", use="circulation, accents", flux=1500, watts=15,
         opening=(DISC, 0.1, 0.1, 0), horizontal=[0], vertical=GAMMA_NARROW, shape=lambda c, g: lobe(0, g, 0, 0, 30), how="cos^n(gamma), half intensity at 15 degrees"),
    dict(file="downlight-60.ies", title="LED downlight, 60 degree beam", edition="IESNA:LM-63-1995", use="general lighting of low rooms", flux=2000, watts=18,
         opening=(DISC, 0.15, 0.15, 0), horizontal=[0], vertical=GAMMA_DOWN, shape=lambda c, g: lobe(0, g, 0, 0, 60), how="cos^n(gamma), half intensity at 30 degrees"),
    dict(file="downlight-gimbal.ldt", title="Gimbal downlight, turned", use="a luminaire without any symmetry; EULUMDAT symmetry code 0", flux=1200, watts=13,
         opening=(DISC, 0.11, 0.11, 0), isym=0, horizontal=steps(0, 345, 15), vertical=GAMMA_DOWN, shape=gimbal, how="cos^n lobe of 36 degrees aimed at C 30, gamma 25, and 1 % stray light"),
    dict(file="wall-washer.ies", title="Recessed wall washer, throw towards C0", use="galleries: an even wall", flux=2200, watts=22,
         opening=(RECTANGLE, 0.17, 0.17, 0), horizontal=HALF, vertical=GAMMA_DOWN, shape=wall_washer, how="cos^n lobe of 44 degrees aimed at C 0, gamma 38, and a weak wide lobe below"),
    dict(file="blackboard.ies", title="Asymmetric linear luminaire, throw towards C90", use="blackboards, shelves", flux=4200, watts=36,
         opening=(RECTANGLE, 1.2, 0.1, 0), horizontal=FRONT_C90, vertical=GAMMA_DOWN, shape=blackboard, how="cos^n lobe of 50 degrees aimed at C 90, gamma 48, a wide lobe below, shielded above 70 degrees"),
    dict(file="cove-uplight.ies", title="Cove uplight, throw towards C90 and up", use="ceilings from a cove", flux=2600, watts=24,
         opening=(RECTANGLE, 1.2, 0.06, 0), horizontal=FRONT_C90, vertical=steps(90, 180, 2.5), shape=cove, how="cos^n lobe of 60 degrees aimed at C 90, gamma 125; nothing below 90 degrees"),
    dict(file="linear-pendant.ldt", title="Linear pendant, up and down", use="offices, meeting rooms", flux=5200, watts=42,
         opening=(RECTANGLE, 1.2, 0.06, 0), isym=4, horizontal=QUADRANT, vertical=GAMMA_ALL, shape=pendant, how="cosine cut at 50 to 75 degrees below; a cosine widened across the length above"),
    dict(file="batten-t8.ldt", title="Bare batten 1 x 36 W T8", use="corridors, stores; the tube is the opening", flux=0.95 * 3350, lamps=1, lamp_lumens=3350,
         watts=43, opening=(BOX, 1.2, 0.026, 0.026), isym=4, horizontal=QUADRANT, vertical=GAMMA_ALL, shape=batten,
         how="I = I_perp sin(angle to the tube), reduced to a quarter above by the spine; light output ratio 0.95"),
    dict(file="high-bay.ldt", title="LED high bay", use="halls from 6 m", flux=20000, watts=140, opening=(DISC, 0.35, 0.35, 0), isym=1,
         horizontal=[0], vertical=GAMMA_DOWN, shape=high_bay, how="cos^n(gamma) of 85 degrees with a cut-off at 55 to 75 degrees"),
    dict(file="street.ldt", title="Street luminaire", use="roads along C0-C180, throw towards C90; EULUMDAT symmetry code 3", flux=6000, watts=45,
         opening=(RECTANGLE, 0.25, 0.2, 0), isym=3, horizontal=steps(0, 355, 5), vertical=GAMMA_DOWN, shape=street, how="two lobes of 32 degrees at gamma 62, C 12 and 168, and a wide lobe; no light above 86 degrees"),
    dict(file="wall-light.ldt", title="Wall light, throw towards C0", use="stairs, facades; EULUMDAT symmetry code 2", flux=700, watts=8,
         opening=(RECTANGLE, 0.2, 0.08, 0.03), isym=2, horizontal=steps(0, 345, 15), vertical=GAMMA_ALL, shape=lambda c, g: lobe(c, g, 0, 55, 75) + 0.3 * lobe(c, g, 0, 150, 60), how="a lobe of 75 degrees at C 0, gamma 55, and a weaker one upwards"),
    dict(file="track-spot.ies", title="Track spot with barn doors", use="galleries, shops: a beam with unequal edges", flux=1100, watts=14,
         opening=(DISC, 0.08, 0.08, 0), horizontal=ROUND, vertical=GAMMA_NARROW, shape=track_spot, how="cos^n of 20 degrees, cut smoothly by doors at C 0 (9 degrees), C 90 (14) and C 270 (18)"),
    dict(file="globe.ies", title="Opal globe 300 mm on a base", use="entrances, historic rooms", flux=1800, watts=20, opening=(SPHERE, 0.3, 0.3, 0.3),
         horizontal=[0], vertical=GAMMA_ALL, shape=globe, how="equal in all directions, reduced to a third towards the base above"),
    dict(file="bollard.ies", title="Bollard with a ring lens", use="paths", flux=450, watts=9, opening=(CYLINDER, 0.16, 0.16, 0.12), horizontal=[0],
         vertical=GAMMA_ALL, shape=bollard, how="a ring about gamma 72 degrees, no light above 92 degrees"),
    dict(file="floodlight-b.ies", title="Floodlight, photometry type B", use="facades, sports; type B angles (H, V)", flux=12000, watts=100, type="B",
         opening=(RECTANGLE, 0.3, 0.25, 0), horizontal=steps(0, 90, 5), vertical=steps(-90, -30, 10) + steps(-27.5, 27.5, 2.5) + steps(30, 90, 10),
         shape=floodlight, how="exp(-(H/38)^4) wide, exp(-(V/14)^2) above and exp(-(V/24)^2) below its aim of V 3"),
    dict(file="searchlight-a.ies", title="Searchlight, photometry type A", use="signals, towers; type A angles (H, V)", flux=9000, watts=90, type="A",
         opening=(DISC, 0.4, 0.4, 0), horizontal=steps(-90, -30, 10) + steps(-25, -12.5, 2.5) + steps(-11, 11, 1) + steps(12.5, 25, 2.5) + steps(30, 90, 10),
         vertical=steps(-90, -30, 10) + steps(-25, -12.5, 2.5) + steps(-11, 11, 1) + steps(12.5, 25, 2.5) + steps(30, 90, 10), shape=searchlight,
         how="exp(-(H/6)^2 - (V/4)^2) and 0.2 % of a wide lobe"),
    dict(file="tube-pendant.ies", title="Bare LED retrofit tube 1.2 m, pendant", use="workshops, kitchens; the tube is the opening", flux=1900, watts=15,
         opening=(LYING, 1.2, 0.028, 0.028), horizontal=QUADRANT, vertical=GAMMA_ALL, shape=tube_pendant, how="I = I_perp sin(angle to the tube)"),
    dict(file="wall-disc.ies", title="Round wall light, faces C0", use="corridors, stairs", flux=1300, watts=13, opening=(UPRIGHT, 0.28, 0.28, 0.28), horizontal=HALF,
         vertical=GAMMA_ALL, shape=wall_disc, how="cosine about C0, gamma 90, and 2 % around its rim"),
    dict(file="bulkhead-oval.ies", title="Oval bulkhead, opal", use="cellars, porches", flux=800, watts=10, opening=(ELLIPSOID, 0.2, 0.14, 0.1), horizontal=QUADRANT,
         vertical=GAMMA_ALL, shape=bulkhead, how="projected area of its ellipsoid, shaded by its base above"),
    dict(file="downlight-oval.ies", title="Downlight, oval beam", use="aisles, tables", flux=1400, watts=14, opening=(ELLIPSE, 0.14, 0.08, 0), horizontal=QUADRANT,
         vertical=GAMMA_NARROW, shape=oval_spot, how="exp(-(x/24)^2 - (y/12)^2) of the angles x along C0 and y along C90"),
]

# What a project gives as "spectrum" with a luminaire of this folder; the rest is LED of 4000 K.
SPECTRA = {"louvre-4x18": "CIE FL2", "batten-t8": "CIE FL11", "globe": "CIE LED-B1", "downlight-15": "CIE LED-B2", "downlight-30": "CIE LED-B2",
           "downlight-gimbal": "CIE LED-B2", "track-spot": "CIE LED-B2", "wall-light": "CIE LED-B2", "bollard": "CIE LED-B2", "floodlight-b": "CIE HP1"}


def significant(value):
    return f"{value:.6g}"


def wrapped(values, width=100):
    lines, line = [], ""
    for text in map(significant, values):
        if line and len(line) + 1 + len(text) > width:
            lines.append(line)
            line = text
        else:
            line = f"{line} {text}" if line else text
    return lines + [line]


def stored_planes(lum):
    """The planes that EULUMDAT stores, out of all that it lists."""
    planes, isym = lum["horizontal"], lum.get("isym")
    mc = len(planes)
    return {None: planes, 0: planes, 1: planes, 2: planes[:mc // 2 + 1], 3: planes[3 * mc // 4:] + planes[:mc // 4 + 1], 4: planes}[isym]


def table_of(lum):
    """(planes stored, candelas) with the flux exact for the interpolant."""
    planes = stored_planes(lum)
    table = [[lum["shape"](h, v) for v in lum["vertical"]] for h in planes]
    total = integral(lum.get("type", "C"), planes, lum["vertical"], table)
    scale = lum["flux"] / total
    return planes, [[value * scale for value in row] for row in table]


def lm63(lum):
    planes, table = table_of(lum)
    edition = lum.get("edition", "IESNA:LM-63-2002")
    shape, length, width, height = lum["opening"]
    dimensions = {RECTANGLE: (width, length, 0), BOX: (width, length, height), DISC: (-width, -width, 0),
                  SPHERE: (-width, -width, -width), CYLINDER: (-width, -width, height), ELLIPSE: (-width, -length, 0),
                  ELLIPSOID: (-width, -length, -height), LYING: (-width, length, -height), UPRIGHT: (-width, 0, -height)}[shape]
    if shape == DISC and edition.endswith("1995"):
        dimensions = (-width, 0, 0)  # that edition's circle
    lamps, lumens = lum.get("lamps", 1), lum.get("lamp_lumens", -1)
    lines = [edition, "[TEST] none: made by formula, not measured", "[TESTLAB] none", f"[ISSUEDATE] {DATE}", "[MANUFAC] Goniolux",
             f"[LUMCAT] {lum['file'].rsplit('.', 1)[0]}", f"[LUMINAIRE] {lum['title']}",
             f"[LAMP] {'LED' if lumens < 0 else f'{lamps} x {lumens} lm'}", f"[OTHER] Made by luminaires/make_luminaires.py: {lum['how']}.",
             f"[_TOTALLUMINAIRELUMENS] {significant(lum['flux'])}", "TILT=NONE",
             f"{lamps} {lumens} 1 {len(lum['vertical'])} {len(planes)} { {'A': 3, 'B': 2}.get(lum.get('type'), 1)} 2 " + " ".join(map(significant, dimensions)),
             f"1 1 {significant(lum['watts'])}"]
    if edition.endswith("2019"):
        lines[-1] = f"1 1.0001 {significant(lum['watts'])}"  # file generation type: computer simulation
    lines += wrapped(lum["vertical"]) + wrapped(planes)
    for row in table:
        lines += wrapped(row)
    return "\r\n".join(lines) + "\r\n"


def eulumdat(lum):
    planes, table = table_of(lum)
    isym = lum["isym"]
    listed = lum["horizontal"]
    if isym == 4:
        step = planes[1] - planes[0]
        listed = steps(0, 360 - step, step)
    shape, length, width, height = lum["opening"]
    lamp_flux = lum.get("lamps", 1) * lum.get("lamp_lumens", lum["flux"])
    absolute = "lamp_lumens" not in lum
    gammas = lum["vertical"]
    below = [g for g in gammas if g <= 90]
    downward = integral("C", planes, below, [row[:len(below)] for row in table]) / lum["flux"]
    round_shape = shape in (DISC, CYLINDER)
    mm = [significant(1000 * x) for x in (length, 0 if round_shape else width, height)]
    fields = ["Goniolux", 1 if isym == 1 else 2 if isym == 4 else 3, isym, len(listed), significant(listed[1] - listed[0]) if len(listed) > 1 else 0,
              len(gammas), significant(gammas[1] - gammas[0]), "none: made by formula", lum["title"], lum["file"].rsplit(".", 1)[0],
              lum["file"], f"{DATE} make_luminaires.py", mm[0], mm[1], significant(1000 * max(height, 0.05)), mm[0], mm[1]] + [mm[2]] * 4 + [
              significant(round(100 * downward, 2)), significant(100 * lum["flux"] / lamp_flux), 1, 0, 1,
              -1 if absolute else lum["lamps"], "LED" if absolute else f"T8 {significant(lum['lamp_lumens'])} lm", significant(lamp_flux), "4000", "80", significant(lum["watts"])]
    fields += [0] * 10 + [significant(a) for a in listed] + [significant(g) for g in gammas]
    fields += [significant(value * 1000 / lamp_flux) for row in table for value in row]
    return "\r\n".join(map(str, fields)) + "\r\n"


def readme():
    lines = ["# Luminaires", "",
             "Photometric files that Goniolux makes itself: `python3 luminaires/make_luminaires.py` writes them all, and this page. They are formulas, not",
             "measurements, and no manufacturer's product; each is scaled so that the exact flux of its interpolated table is the flux below.", "",
             "The length of an opening lies along C0 in LM-63 (`.ies`) and along C90 in EULUMDAT (`.ldt`). Look at one with",
             "`goniolux luminaire luminaires/panel-600.ies`.", "",
                          "`spectrum` is what to give in a project with it (CIE 15 and CIE 251 illuminants: FL2 is a halophosphate lamp, FL11 a triphosphor with its",
             "mercury lines, LED-B phosphor LEDs, HP1 sodium); a photometric file of these two formats carries none.", "",
             "[More of them](traced.md) come from tracing light through modelled reflectors, louvres and diffusers.", "",
             "| file | what it is | for | flux, lm | W | symmetry | opening, m | spectrum | how it was made |", "|---|---|---|---|---|---|---|---|---|"]
    for lum in LUMINAIRES:
        shape, length, width, height = lum["opening"]
        size = f"{shape} {significant(length)}" + ("" if shape in (DISC, SPHERE) else f" x {significant(width)}" if shape in (RECTANGLE, BOX, ELLIPSE, ELLIPSOID, LYING) else "")
        if height and shape not in (SPHERE, LYING, UPRIGHT):
            size += f", {significant(height)} high"
        if "isym" in lum:
            kind = {0: "none (Isym 0)", 1: "rotational (Isym 1)", 2: "C0-C180 (Isym 2)", 3: "C90-C270 (Isym 3)", 4: "quadrant (Isym 4)"}[lum["isym"]]
        elif "type" in lum:
            kind = {"A": "none (type A)", "B": "lateral (type B)"}[lum["type"]]
        else:
            kind = {(0, 0): "rotational", (0, 90): "quadrant", (0, 180): "C0-C180", (90, 270): "C90-C270", (0, 360): "none"}[(lum["horizontal"][0], lum["horizontal"][-1])]
        lines.append(f"| `{lum['file']}` | {lum['title']} | {lum['use']} | {significant(lum['flux'])} | {significant(lum['watts'])} | {kind} | {size} | {SPECTRA.get(lum['file'].rsplit('.', 1)[0], 'CIE LED-B3')} | {lum['how']} |")
    return "\n".join(lines) + "\n"


def main():
    for lum in LUMINAIRES:
        text = eulumdat(lum) if lum["file"].endswith(".ldt") else lm63(lum)
        (HERE / lum["file"]).write_bytes(text.encode("ascii"))
    (HERE / "README.md").write_text(readme(), encoding="utf-8")


if __name__ == "__main__":
    main()
