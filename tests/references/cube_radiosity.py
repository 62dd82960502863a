#!/usr/bin/env python3
"""Independent reference for projects/validation/cube: radiosity of a cube of equal diffuse faces with a point source at its
centre, where all six faces have the same solution. Needs Python 3 with numpy; used while developing, not by the tests.

    cube_radiosity.py [--patches 24 36 54] [--inset 1e-6]

Method: one face is cut into M x M patches that narrow towards the edges, where the solution bends. The exitance of the
*indirect* part is constant per patch; the exchange of a point with a patch is the exact contour integral (Lambert), that of the
direct light is integrated by Gauss points on each patch. The points A to F are gathered from the solved patches, again with
exact factors, so that points a hair from an edge need no special care. Printed for several M: their spread is the error.
"""
import argparse
import math
import numpy as np

SIDE, INTENSITY, RHO = 10.0, 50000.0, 2.0 / 3.0


def corner_parallel(a, b, c):
    """Factor of a receiver to a parallel rectangle a x b with one corner on its axis at distance c (signed a, b)."""
    p, q = np.sqrt(a * a + c * c), np.sqrt(b * b + c * c)
    return (a / p * np.arctan2(b, p) + b / q * np.arctan2(a, q)) / (2 * math.pi)


def corner_perpendicular(a, b, c):
    """Factor of a receiver, facing +c, to a rectangle in the plane at distance b > 0 beside it: along from 0 to a, up to c."""
    r = np.sqrt(b * b + c * c)
    return (np.arctan2(a, b) - b / r * np.arctan2(a, r)) / (2 * math.pi)


def factors(points, edges):
    """Exchange of points (x, y) on a face z = 0 with the patches of the five others, by patch index of a face."""
    m = len(edges) - 1
    x, y = points[:, 0], points[:, 1]
    total = np.zeros((len(points), m, m))
    # Opposite face: patch (i, j) spans edges[i..i+1] x edges[j..j+1] at height SIDE.
    ex, ey = edges[None, :] - x[:, None], edges[None, :] - y[:, None]
    c = corner_parallel(ex[:, :, None], ey[:, None, :], SIDE)
    total += c[:, 1:, 1:] - c[:, :-1, 1:] - c[:, 1:, :-1] + c[:, :-1, :-1]
    # The four faces beside: coordinate along the common edge, and height z. The solution is symmetric, so only the order counts.
    for along, distance in ((y, x), (y, SIDE - x), (x, y), (x, SIDE - y)):
        ea = edges[None, :] - along[:, None]
        c = corner_perpendicular(ea[:, :, None], distance[:, None, None], edges[None, None, :])
        total += c[:, 1:, 1:] - c[:, :-1, 1:] - c[:, 1:, :-1] + c[:, :-1, :-1]
    return total.reshape(len(points), m * m)


def direct(x, y):
    h = SIDE / 2
    return INTENSITY * h / ((x - h) ** 2 + (y - h) ** 2 + h * h) ** 1.5


def solve(m, targets):
    # Patch edges crowd towards the rims: cosine spacing.
    edges = SIDE / 2 * (1 - np.cos(np.pi * np.arange(m + 1) / m))
    middles = (edges[1:] + edges[:-1]) / 2
    cx, cy = np.meshgrid(middles, middles, indexing="ij")
    centres = np.stack([cx.ravel(), cy.ravel()], 1)
    nodes, weights = np.polynomial.legendre.leggauss(4)
    half = (edges[1:] - edges[:-1]) / 2
    gx = middles[:, None] + half[:, None] * nodes  # m x 4
    e0 = np.einsum("iajb,a,b->ij", direct(gx[:, :, None, None], gx[None, None, :, :]), weights / 2, weights / 2).ravel()
    matrix = factors(centres, edges)
    exitance = np.linalg.solve(np.eye(m * m) - RHO * matrix, RHO * e0)
    area = np.outer(half * 2, half * 2).ravel()
    mean = (exitance * area).sum() / area.sum() / RHO
    return direct(targets[:, 0], targets[:, 1]) + factors(targets, edges) @ exitance, mean


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--patches", type=int, nargs="+", default=[24, 36, 54])
    arguments.add_argument("--inset", type=float, default=1e-6)
    options = arguments.parse_args()
    rim = SIDE - options.inset
    targets = np.array([[5, 5], [5, 7.5], [7.5, 7.5], [5, rim], [7.5, rim], [rim, rim]])
    exact = 4 * math.pi * INTENSITY / (6 * SIDE * SIDE * (1 - RHO))
    print("exact mean", exact)
    for m in options.patches:
        values, mean = solve(m, targets)
        print(m, "mean", round(mean, 3), "E lx", np.round(values, 3), "L cd/m2", np.round(values * RHO / math.pi, 3))


if __name__ == "__main__":
    main()
