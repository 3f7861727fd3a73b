#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A tube wrung by CalculiX beyond the onset of its folds: a foreign check of the wrung tube.

  wrung_calculix.py THINNESS PRESSURE LAST_DEG STEP_DEG [ROUND ALONG] [--length=L] [--gent=J,SHARE]
                    [--profile=R:T,R:T,...] [--ends=FIRST,LAST] [--dynamic=FROM,TO] [--report]

THINNESS is t/R, PRESSURE p R / (G t). Writes tube.inp into the working folder, runs `ccx` on it and prints one
line a step: angle, torque / (2 pi G t R^2), least lumen radius / R, its place, waves and their amplitude / R, kinetic
energy over torque x angle / 2; --report prints a finished run again. Needs
Python and CalculiX (Debian: calculix-ccx) alone.

The tube: R 1, L 6 or as given, G 1, nu 0.49, C3D20R, one element through the wall. Neo-Hookean, or Gent's law with
the limit J: CalculiX has no such law, so Yeoh's with the slope that differs least up to I - 3 = SHARE J. A profile:
radius and thickness at equal steps from the held end, over R and t. Ends: radii to which they are widened as the
pressure comes, over R. Lower end held, upper end turned
as a rigid circle, the length kept. Follower pressure, half inside and half as suction outside, so that its resultant
is p R. Seed: harmonics n = 2 to 6, each 2 % of the thickness. Every angle in balance (*STATIC) up to FROM_DEG; beyond
it *DYNAMIC (implicit, alpha damping), density 1, so slowly that it is in balance but where it snaps into its folds:
under pressure a static run does not pass that place.
"""
import cmath
import math
import os
import re
import subprocess
import sys

NU = 0.49
SEED = 0.02  # relative to the thickness, for each harmonic
TIME = 5.0  # per degree while moving; a shear wave takes 6 from end to end


class Tube:
    """Nodes (R, theta, z at half steps: round, along, through) and elements of a tube of wall."""

    def __init__(self, thinness, length, profile, around, along):
        self.thinness, self.length, self.around, self.along = thinness, length, around, along
        self.profile = profile or [(1.0, 1.0)]
        self.number, self.place, self.elements = {}, [], []
        for a in range(along):
            for c in range(around):
                self.elements.append([self.node(2 * c + y, 2 * a + z, x) for x, y, z in (
                    (0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
                    (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
                    (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1))])

    def node(self, i, j, k):
        i %= 2 * self.around
        if (i, j, k) not in self.number:
            theta, share = math.pi * i / self.around, j / (2 * self.along)
            middle, thickness = self.wall(share)
            radius = middle + self.thinness * thickness * (k / 2 - 0.5)
            for n in range(2, 7):
                radius += SEED * self.thinness * math.sin(math.pi * share) * math.cos(
                    n * theta - 0.7 * self.length * share * n / 3 + 1.3 * n * n)
            self.number[i, j, k] = len(self.place) + 1
            self.place.append((radius * math.cos(theta), radius * math.sin(theta), self.length * share))
        return self.number[i, j, k]

    def wall(self, share):
        """Radius and thickness at a share of the length."""
        along = share * (len(self.profile) - 1)
        below = min(int(along), max(len(self.profile) - 2, 0))
        above = min(below + 1, len(self.profile) - 1)
        return [a + (along - below) * (b - a) for a, b in zip(self.profile[below], self.profile[above])]

    def face(self, j):
        return [v for (_, row, _), v in self.number.items() if row == j]

    def rings(self):
        """Pairs of nodes, inside and outside, round each row of corners."""
        return [[(self.number[i, 2 * a, 0], self.number[i, 2 * a, 2]) for i in range(2 * self.around)]
                for a in range(self.along + 1)]


def named(out, name, nodes):
    out.write('*NSET,NSET=%s\n' % name)
    for first in range(0, len(nodes), 10):
        out.write(','.join(map(str, nodes[first:first + 10])) + ',\n')


def solved(matrix, right):
    """Three equations of three unknowns."""
    rows = [row + [value] for row, value in zip(matrix, right)]
    for i in range(3):
        pivot = max(range(i, 3), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(3):
            if k != i:
                share = rows[k][i] / rows[i][i]
                rows[k] = [a - share * b for a, b in zip(rows[k], rows[i])]
    return [rows[i][3] / rows[i][i] for i in range(3)]


def yeoh(limit, most):
    """Constants of Yeoh's law for G 1: its slope is Gent's within the least largest relative error."""
    shares = [most * i / 200 for i in range(201)]
    weights = [1.0] * len(shares)
    for _ in range(200):
        terms = [[(1 - x) * x ** k for k in range(3)] for x in shares]
        slope = solved([[sum(w * v[i] * v[j] for v, w in zip(terms, weights)) for j in range(3)] for i in range(3)],
                       [sum(w * v[i] for v, w in zip(terms, weights)) for i in range(3)])
        errors = [abs(sum(c * t for c, t in zip(slope, v)) - 1) for v in terms]
        weights = [w * (error / max(errors) + 1e-3) ** 0.3 for w, error in zip(weights, errors)]
        weights = [w / max(weights) for w in weights]
    return [c / (2 * (k + 1) * limit ** k) for k, c in enumerate(slope)]


def write(tube, pressure, gent, ends, last, stride, pace, settled):
    foot, head = ((ends[end] if ends else tube.profile[-end][0]) / tube.profile[-end][0] for end in (0, 1))
    with open('tube.inp', 'w', encoding='ascii') as out:
        out.write('*NODE,NSET=ALL\n')
        for number, place in enumerate(tube.place, 1):
            out.write('%d,%.10g,%.10g,%.10g\n' % (number, *place))
        cosine = len(tube.place) + 1  # its displacement is cos(angle) - 1, that of the next node sin(angle)
        out.write('%d,0,0,0\n%d,0,0,0\n' % (cosine, cosine + 1))
        out.write('*ELEMENT,TYPE=C3D20R,ELSET=WALL\n')
        for number, nodes in enumerate(tube.elements, 1):
            out.write('%d,%s,\n%s\n' % (number, ','.join(map(str, nodes[:10])), ','.join(map(str, nodes[10:]))))
        named(out, 'FOOT', tube.face(0))
        top = tube.face(2 * tube.along)
        named(out, 'TOP', top)
        named(out, 'HAND', [cosine, cosine + 1])
        named(out, 'RINGS', [v for ring in tube.rings() for pair in ring for v in pair])
        out.write('*EQUATION\n')
        for v in top:
            x, y, _ = tube.place[v - 1]
            out.write('3\n%d,1,1.,%d,1,%.12g,%d,1,%.12g\n' % (v, cosine, -x, cosine + 1, y))
            out.write('3\n%d,2,1.,%d,1,%.12g,%d,1,%.12g\n' % (v, cosine, -y, cosine + 1, -x))
        bulk = 2 * (1 + NU) / (3 * (1 - 2 * NU))
        out.write('*MATERIAL,NAME=M\n')
        if gent:
            out.write('*HYPERELASTIC,YEOH\n%.10g,%.10g,%.10g,' % tuple(yeoh(*gent)))
            out.write('%.10g,1e10,1e10\n' % (2 / bulk))
        else:
            out.write('*HYPERELASTIC,NEO HOOKE\n0.5,%.10g\n' % (2 / bulk))
        out.write('*DENSITY\n1.\n')
        out.write('*SOLID SECTION,ELSET=WALL,MATERIAL=M\n')
        out.write('*BOUNDARY\nFOOT,3,3\nTOP,3,3\nHAND,2,3\n')
        for name, value in (('COSINE', lambda x: head * math.cos(x) - 1), ('SINE', lambda x: head * math.sin(x))):
            out.write('*AMPLITUDE,NAME=%s,TIME=TOTAL TIME\n0,0\n' % name)
            for half in range(round(2 * last) + 1):
                out.write('%.10g,%.12g\n' % (1 + 0.5 * half * pace, value(math.radians(0.5 * half))))
        # *DYNAMIC requires requesting the energy.
        printed = ('*NODE PRINT,NSET=RINGS\nU\n*NODE PRINT,NSET=TOP\nRF\n'
                   '*EL PRINT,ELSET=WALL,TOTALS=ONLY\nELSE\n*END STEP\n')
        load = pressure * tube.thinness / 2
        hand = ('*BOUNDARY,AMPLITUDE=COSINE\n%d,1,1,1.\n*BOUNDARY,AMPLITUDE=SINE\n%d,1,1,1.\n' % (cosine, cosine + 1))
        out.write('*STEP,NLGEOM\n*STATIC\n%s*BOUNDARY\n' % ('0.1,1.,1e-4,0.1\n' + hand if ends else '1.,1.\n'))
        if not ends:
            out.write('HAND,1,1\n')
        for v in tube.face(0):
            out.write('%d,1,1,%.10g\n%d,2,2,%.10g\n' % (
                v, (foot - 1) * tube.place[v - 1][0], v, (foot - 1) * tube.place[v - 1][1]))
        if pressure:
            out.write('*DLOAD\nWALL,P6,%.10g\nWALL,P4,%.10g\n' % (load, -load))
        out.write(printed)
        early, late = settled
        for start, stop, moving in ((0.0, early, False), (early, late, True), (late, last, False)):
            if stop <= start:
                continue
            out.write('*STEP,NLGEOM,INC=20000\n*CONTROLS,PARAMETERS=TIME INCREMENTATION\n10,14,9,30,12,4,,8,,\n')
            out.write('*DYNAMIC,ALPHA=-0.3\n' if moving else '*STATIC\n')
            out.write('%.10g,%.10g,%.3g,%.10g\n' % (stride * pace * (0.1 if moving else 1.0), (stop - start) * pace,
                                                   1e-5 * stride * pace, stride * pace))
            out.write(hand + printed)


def moments(path):
    """Yields what is printed for each time: the time, {what: {node: values}}."""
    head = re.compile(r'\s*(displacements|forces).* time\s+(\S+)')
    now, tables, table = -1.0, {}, {}
    with open(path, encoding='ascii') as lines:
        for line in lines:
            found = head.match(line)
            words = line.split()
            if found:
                if float(found.group(2)) != now and len(tables) > 1:
                    yield now, tables
                    tables = {}
                now, table = float(found.group(2)), {}
                tables[found.group(1)] = table
            elif len(words) == 4 and words[0].isdigit():
                table[int(words[0])] = [float(w) for w in words[1:]]
    if len(tables) > 1:
        yield now, tables


def area(ring):
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1]))


def report(tube, ends, pace):
    head = ends[1] / tube.profile[-1][0] if ends else 1.0
    unit = 2 * math.pi * tube.thinness
    count = 2 * tube.around
    flat = area([[math.cos(math.pi * i / tube.around), math.sin(math.pi * i / tube.around)] for i in range(count)])
    before, earlier = None, 1.0
    for time, tables in moments('tube.dat'):
        at = {v: [p + u for p, u in zip(tube.place[v - 1], moved)] for v, moved in tables['displacements'].items()}
        rings = [[[(a + b) / 2 for a, b in zip(at[inner], at[outer])] for inner, outer in ring]
                 for ring in tube.rings()]
        angle = (time - 1) / pace
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        torque = head * sum((c * x - s * y) * f[1] - (s * x + c * y) * f[0]
                     for (x, y, _), f in ((tube.place[v - 1], f) for v, f in tables['forces'].items()))
        lumen = [math.sqrt(max(area(ring), 0.0) / flat) / tube.wall(j / tube.along)[0] for j, ring in enumerate(rings)]
        waist = min(range(len(lumen)), key=lumen.__getitem__)
        waves = max((abs(sum(math.hypot(p[0], p[1]) * cmath.exp(-2j * math.pi * n * i / count)
                             for i, p in enumerate(ring))) * 2 / count, n) for ring in rings for n in range(2, 10))
        kinetic = 0.0
        if pace > 1 and before and time > earlier:
            mass = unit * tube.length / (count * len(rings))
            kinetic = 0.5 * mass * sum(((a - b) / (time - earlier)) ** 2 for ring, old in zip(rings, before)
                                       for p, q in zip(ring, old) for a, b in zip(p, q))
        before, earlier = rings, time
        work = 0.5 * torque * math.radians(angle)
        moving = kinetic / work if work > 0 else 0.0
        print('%6.2f torque %.4f lumen %.3f at %.2f waves %d of %.3f moving %.1e' % (
            angle, torque / unit, lumen[waist], waist / tube.along, waves[1], waves[0], moving), flush=True)


def main():
    numbers = [float(w) for w in sys.argv[1:] if not w.startswith('--')]
    options = dict(w[2:].split('=') for w in sys.argv if w.startswith('--') and '=' in w)
    dynamic, gent, ends = ([float(v) for v in options.get(name, '').split(',') if v]
                           for name in ('dynamic', 'gent', 'ends'))
    profile = [tuple(map(float, place.split(':'))) for place in options.get('profile', '').split(',') if place]
    thinness, pressure, last, stride = numbers[:4]
    around, along = (int(w) for w in numbers[4:6]) if len(numbers) > 4 else (20, 18)
    settled = [angle + 0.23 for angle in dynamic] or [last, last]  # between the entries of the table of angles
    pace = TIME if dynamic else 1.0
    tube = Tube(thinness, float(options.get('length', 6)), profile, around, along)
    if '--report' not in sys.argv:
        write(tube, pressure, gent, ends, last, stride, pace, settled)
        with open('tube.log', 'w', encoding='utf-8') as log:
            subprocess.run(['ccx', 'tube'], stdout=log, stderr=log, check=False,
                           env=dict(os.environ, OMP_NUM_THREADS='1'))
    report(tube, ends, pace)


if __name__ == '__main__':
    main()
