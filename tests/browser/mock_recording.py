# SPDX-License-Identifier: GPL-3.0-or-later
"""A made-up recording of a twist and a made-up organ, in the containers that the server sends."""
import json
import math
import struct
from array import array

RATE_HZ = 60
LENGTH_S = 20.0
FRAMES = int(RATE_HZ * LENGTH_S) + 1
TARGET_DEG = 180.0
LENGTH_MM = 220.0
ROUND, ALONG = 48, 90
SHARED = 12  # displacements of the body
POSES = 19  # of the organ, one every ten degrees: frames lie between two of them

TYPES = {"f32": "f", "i16": "h", "u16": "H", "u32": "I", "u8": "B", "i8": "b"}


def container(meta, arrays):
    """`arrays`: name -> (type, array.array)."""
    head, body = [], b""
    for name, (kind, values) in arrays.items():
        body += b"\0" * (-len(body) % 4)
        head.append({"name": name, "type": kind, "offset": len(body), "count": len(values)})
        body += values.tobytes()
    text = json.dumps({"meta": meta, "arrays": head}).encode()
    text += b" " * (-(8 + len(text)) % 4)
    return b"TRS1" + struct.pack("<I", len(text)) + text + body


def eased(x):
    x = min(max(x, 0.0), 1.0)
    return x * x * (3.0 - 2.0 * x)


def angle_deg(time_s):
    """Grips at 2 s, turns to 150 degrees, waits, on to the target, holds, lets go at 17 s."""
    up = 150.0 * eased((time_s - 2.5) / 5.0) + 32.0 * eased((time_s - 9.0) / 3.0)
    back = 2.0 * eased((time_s - 12.5) / 1.0)
    loose = 182.0 * eased((time_s - 17.0) / 1.5)
    return max(0.0, up - back - loose)


def held(time_s):
    return 2.0 <= time_s < 17.0


def tool_pose(time_s):
    """The tip lies on the organ's front while it is held; the shaft leads towards the viewer."""
    away = 70.0 * (1.0 - eased(time_s / 2.0)) + 60.0 * eased((time_s - 17.0) / 2.0)
    turn = math.radians(0.5 * angle_deg(time_s)) if held(time_s) else 0.0
    lean = math.radians(-20.0)
    roll = (math.cos(turn), 0.0, 0.0, math.sin(turn))
    tilt = (math.cos(lean), math.sin(lean), 0.0, 0.0)
    w = tilt[0] * roll[0]
    quaternion = (w, tilt[1] * roll[0], -tilt[1] * roll[3], tilt[0] * roll[3])
    return (6.0, 12.0, 24.0 + away, *quaternion)


def recording(length_s=LENGTH_S, picture=True):
    frames = int(RATE_HZ * length_s) + 1
    times = [i / RATE_HZ for i in range(frames)]
    angles = [angle_deg(t) for t in times]
    torque = [0.0045 * a * (1.0 + 0.0012 * a) + 0.02 * math.sin(9.0 * t) * held(t) for a, t in zip(angles, times)]
    force = [held(t) * (1.4 + 0.008 * a + 0.25 * math.sin(5.0 * t)) for a, t in zip(angles, times)]
    poses = array("f")
    for t in times:
        poses.extend(tool_pose(t))
    return container(
        {"rate_hz": RATE_HZ, "frames": frames, "length_us": round(1e6 * length_s), "picture": picture},
        {
            "angle_deg": ("f32", array("f", angles)),
            "torque_Nm": ("f32", array("f", torque)),
            "force_N": ("f32", array("f", force)),
            "force_low_N": ("f32", array("f", [0.93 * f for f in force])),
            "force_high_N": ("f32", array("f", [1.06 * f for f in force])),
            "target_deg": ("f32", array("f", [TARGET_DEG] * frames)),
            "tool": ("f32", poses),
            "closed": ("u8", array("B", [255 * held(t) for t in times])),
            "held": ("u8", array("B", [held(t) for t in times])),
        },
    )


def ring(along, turned_rad):
    """A section of the tube: wider in the middle, bent a little, with folds."""
    y = LENGTH_MM * (along - 0.5)
    middle = (14.0 * math.sin(2.6 * along), y, 10.0 * math.sin(math.pi * along))
    points = []
    for i in range(ROUND):
        around = 2.0 * math.pi * i / ROUND
        radius = 17.0 + 13.0 * math.sin(math.pi * along) ** 2 + 1.6 * math.sin(42.0 * along) * math.sin(around / 2) ** 2
        a = around + turned_rad
        # Twisted tissue narrows.
        radius *= 1.0 - 0.0022 * math.degrees(turned_rad) * math.exp(-((along - 0.62) / 0.22) ** 2)
        points.append((middle[0] + radius * math.sin(a), middle[1], middle[2] + radius * math.cos(a)))
    return points


def shape(turn_deg):
    """All vertices at one angle: the upper half is turned, the lower one stays."""
    coordinates = array("f")
    for j in range(ALONG):
        along = j / (ALONG - 1)
        share = eased((along - 0.25) / 0.45)
        for point in ring(along, math.radians(turn_deg) * share):
            coordinates.extend(point)
    return coordinates


def quads(rows, columns, first=0):
    index = array("I")
    for j in range(rows - 1):
        for i in range(columns):
            a, b = first + j * columns + i, first + j * columns + (i + 1) % columns
            c, d = a + columns, b + columns
            index.extend((a, b, d, a, d, c))
    return index


def organ():
    """(how it was moved, its body)."""
    angles = [angle_deg(i / RATE_HZ) for i in range(0, FRAMES, 2)]
    step = 10.0
    shapes = [shape(step * k) for k in range(POSES)]
    mean = shapes[0]
    size, known = len(mean), POSES - 1
    # Each component contributes to every shape, like the server's; the mix is orthogonal.
    mix = [[math.sqrt(2.0 / known) * math.cos(math.pi * (k + 0.5) * (m + 0.5) / known) for k in range(known)] for m in range(known)]
    steps = [[one[i] - mean[i] for i in range(size)] for one in shapes[1:]]
    mixed = [[sum(row[k] * steps[k][i] for k in range(known)) for i in range(size)] for row in mix]
    largest = 1e-6 + max(max(map(abs, one)) for one in mixed)
    basis = array("h")
    for one in mixed:
        basis.extend(round(32767.0 * value / largest) for value in one)
    weights = array("f")
    for angle in angles:
        near = [max(0.0, 1.0 - abs(angle - step * k) / step) for k in range(1, POSES)]
        weights.extend(sum(row[k] * near[k] for k in range(known)) for row in mix)
    colour = array("B")
    for j in range(ALONG):
        for i in range(ROUND):
            tone = 0.5 + 0.5 * math.sin(0.9 * j + 2.2 * math.sin(0.5 * i))
            colour.extend((round(196 + 14 * tone), round(112 + 22 * tone), round(104 + 20 * tone)))
    tool_index, tool_mean, parts = tool()
    times = array("I", (round(2000 * i / RATE_HZ) for i in range(len(angles))))
    moved = container({"components": known - SHARED, "frames": len(angles), "body": "body",
                       "scale": [largest / 32767.0] * (known - SHARED)},
                      {"basis": ("i16", basis[SHARED * size:]), "weights": ("f32", weights), "time_ms": ("u32", times)})
    body = container({"vertices": ROUND * ALONG, "around": ROUND, "components": SHARED,
                      "scale": [largest / 32767.0] * SHARED,
                      "tool": {"parts": parts, "pivot_mm": [0.0, 0.0, 20.0], "opening_deg": 25.0}},
                     {"index": ("u32", quads(ALONG, ROUND)), "mean": ("f32", mean), "basis": ("i16", basis[:SHARED * size]),
                      "colour": ("u8", colour), "tool_index": ("u32", tool_index), "tool_mean": ("f32", tool_mean)})
    return moved, body


def tool():
    """Tip at the origin, shaft along +z: a tube and two half cones."""
    columns = 20
    index, mean, parts = array("I"), array("f"), []
    for name, stations in (
        ("shaft", ((20.0, 2.0), (24.0, 2.5), (250.0, 2.5), (250.0, 0.01))),
        ("upper_jaw", ((0.0, 0.3), (2.0, 1.5), (20.0, 2.2))),
        ("lower_jaw", ((0.0, 0.3), (2.0, 1.5), (20.0, 2.2))),
    ):
        first = len(mean) // 3
        for z, radius in stations:
            for i in range(columns):
                a = 2.0 * math.pi * i / columns
                x, y = radius * math.sin(a), radius * math.cos(a)
                if name != "shaft":
                    y = abs(y) if name == "upper_jaw" else -abs(y)
                mean.extend((x, y, z))
        piece = quads(len(stations), columns, first)
        parts.append({"name": name, "first": first, "count": len(mean) // 3 - first})
        index.extend(piece)
    return index, mean, parts
