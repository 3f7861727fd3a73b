#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bars held at both faces, for HeldEnds: writes CalculiX's input, runs `ccx`, writes NAME.json.

held_bars.py [NAME...]   (needs ccx, numpy; in an empty folder; a bar takes 5 to 40 s)
The bars are those of BARS: length in mm, half axes at a share of the length, bend and turn of the axes in degrees.
"""
import json
import subprocess
import sys

import numpy as np

SHEAR, POISSON = 0.01, 0.45  # N/mm2
TURN = np.radians(1.0)
CORE, RINGS = 6, 4  # cells across the core of a section, rings around it


def constant(a, b):
    return lambda share: (a, b)


def waist(share):
    radius = 28.0 * (1.0 - 0.45 * np.exp(-(((share - 0.5) / 0.08) ** 2)))
    return radius, radius


# length, layers, half axes (in the plane of the bend, across it), bend, turn of the axes along the bar
BARS = {
    "held_ellipse": (180, 20, constant(33, 12), 0, 0),
    "held_ellipse_bent": (180, 20, constant(33, 12), 75, 0),
    "held_ellipse_bent_across": (180, 20, constant(12, 33), 75, 0),
    "held_ellipse_turning": (240, 24, constant(33, 12), 0, 90),
    "held_ellipse_stubby": (120, 16, constant(30, 18), 60, 0),
    "held_waist": (240, 36, waist, 0, 0),
}


def section():
    """Unit disc: a square core blown up between square and disc, and rings; points and quadrilaterals."""
    grid = np.linspace(-1, 1, CORE + 1)
    points, at = [], {}
    for j, y in enumerate(grid):
        for i, x in enumerate(grid):
            at[i, j] = len(points)
            flat = 0.5 * np.array([x, y]) / np.sqrt(2)
            round_ = 0.5 * np.array([x * np.sqrt(1 - y * y / 2), y * np.sqrt(1 - x * x / 2)])
            points.append(0.5 * (flat + round_))
    edge = [(i, 0) for i in range(CORE)] + [(CORE, j) for j in range(CORE)]
    edge += [(CORE - i, CORE) for i in range(CORE)] + [(0, CORE - j) for j in range(CORE)]
    rings = [[at[e] for e in edge]]
    for r in range(1, RINGS + 1):
        ring = []
        for c in range(4 * CORE):
            angle = -0.75 * np.pi + 2 * np.pi * c / (4 * CORE)
            outer = np.array([np.cos(angle), np.sin(angle)])
            ring.append(len(points))
            points.append(points[rings[0][c]] * (1 - r / RINGS) + outer * r / RINGS)
        rings.append(ring)
    quads = [(at[i, j], at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]) for j in range(CORE) for i in range(CORE)]
    for r in range(RINGS):
        for c in range(4 * CORE):
            d = (c + 1) % (4 * CORE)
            quads.append((rings[r][c], rings[r + 1][c], rings[r + 1][d], rings[r][d]))
    return np.array(points), quads


def middle(a, b):
    """Middle of an edge of the mesh of the disc; on the circle where both ends are."""
    point = (np.array(a) + np.array(b)) / 2
    if min(np.hypot(*a[:2]), np.hypot(*b[:2])) > 1 - 1e-9:
        point[:2] /= np.hypot(*point[:2])
    return tuple(point)


def frame(length, bend, along):
    if bend == 0:
        return np.array([0, 0, along]), np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), np.array([0, 0, 1.0])
    radius = length / np.radians(bend)
    t = along / radius
    return (np.array([radius * (1 - np.cos(t)), 0, radius * np.sin(t)]), np.array([np.cos(t), 0, -np.sin(t)]),
            np.array([0, 1.0, 0]), np.array([np.sin(t), 0, np.cos(t)]))


def solve(name):
    length, layers, axes, bend, turn = BARS[name]
    disc, quads = section()
    keys, local, hexes = {}, [], []

    def node(u, v, w):
        key = (round(u, 9), round(v, 9), round(w, 9))
        if key not in keys:
            keys[key] = len(local)
            local.append((u, v, w))
        return keys[key]

    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    for k in range(layers):
        for quad in quads:
            corners = [(*disc[q], length * (k + up) / layers) for up in (0, 1) for q in quad]
            middles = [middle(corners[a], corners[b]) for a, b in edges]
            hexes.append([node(*p) for p in corners + middles])
    places = []
    for u, v, w in local:
        centre, e1, e2, _ = frame(length, bend, w)
        a, b = axes(w / length)
        t = np.radians(turn) * w / length
        places.append(centre + (a * u * np.cos(t) - b * v * np.sin(t)) * e1 + (a * u * np.sin(t) + b * v * np.cos(t)) * e2)
    places, local = np.array(places), np.array(local)
    lower, upper = np.where(local[:, 2] < 1e-9)[0], np.where(local[:, 2] > length - 1e-9)[0]
    centre, _, _, tangent = frame(length, bend, length)
    with open(name + ".inp", "w") as f:
        f.write("*NODE,NSET=NALL\n" + "".join("%d,%.9g,%.9g,%.9g\n" % (i + 1, *p) for i, p in enumerate(places)))
        f.write("*ELEMENT,TYPE=C3D20R,ELSET=EALL\n")
        for i, h in enumerate(hexes):
            row = [str(n) for n in [i + 1] + [v + 1 for v in h]]
            f.write(",".join(row[:11]) + ",\n" + ",".join(row[11:]) + "\n")
        for label, nodes in (("BOT", lower), ("TOP", upper)):
            f.write("*NSET,NSET=%s\n" % label + "".join("%d\n" % (n + 1) for n in nodes))
        f.write("*MATERIAL,NAME=M\n*ELASTIC\n%.9g,%.9g\n" % (2 * SHEAR * (1 + POISSON), POISSON))
        f.write("*SOLID SECTION,ELSET=EALL,MATERIAL=M\n*STEP\n*STATIC\n*BOUNDARY\nBOT,1,3\n")
        for n in upper:
            move = np.cross(tangent, places[n] - centre) * TURN
            f.write("".join("%d,%d,%d,%.10g\n" % (n + 1, a + 1, a + 1, move[a]) for a in range(3)))
        f.write("*NODE PRINT,NSET=TOP\nRF\n*NODE PRINT,NSET=NALL\nU\n*END STEP\n")
    subprocess.run(["ccx", name], check=True, stdout=subprocess.DEVNULL)
    moment, moved, table = np.zeros(3), np.zeros_like(places), None
    for line in open(name + ".dat"):
        if "forces" in line or "displacements" in line:
            table = line
        words = line.split()
        if len(words) == 4 and table:
            n, value = int(words[0]) - 1, np.array([float(w) for w in words[1:]])
            if "forces" in table:
                moment += np.cross(places[n] - centre, value)
            else:
                moved[n] = value
    stations, turns = np.unique(np.round(local[:, 2], 6)), []
    for s in stations:
        here = np.abs(local[:, 2] - s) < 1e-5
        _, e1, e2, _ = frame(length, bend, s)
        p, d = places[here] - places[here].mean(0), moved[here] - moved[here].mean(0)
        p, d = np.c_[p @ e1, p @ e2], np.c_[d @ e1, d @ e2]
        turns.append((p[:, 0] * d[:, 1] - p[:, 1] * d[:, 0]).sum() / (p ** 2).sum() / TURN)
    result = {"T": round(float(moment @ tangent), 9), "th": TURN, "nodes": len(places),
              "zs": [round(float(s), 6) for s in stations], "prof": [round(float(t), 8) for t in turns]}
    json.dump(result, open(name + ".json", "w"))
    print(name, len(places), "nodes,", moment @ tangent / TURN, "N mm/rad")


for bar in sys.argv[1:] or BARS:
    solve(bar)
