"""Writes a body with thick thighs, which touch or overlap: a copy of a body in OBJ that stands upright on parted legs.

Usage: thick_thighs.py BODY.obj THICK.obj OVERLAP_MM [THICKER]

Thighs are widened about their middles by the share THICKER (default 0.2), then moved to the middle until they overlap by that where they are
nearest to each other; below zero, so much apart.
"""
import math
import sys

THICKER = float(sys.argv[4]) if len(sys.argv) > 4 else 0.2
HIGHEST, THIGH, KNEE = 0.60, 0.44, 0.28  # of the stature: from where to where they are widened
TRUNK = 0.12                             # of the stature, half of its width: beyond are the hands


def smooth(x, low, high):
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


def main():
    source, target, overlap = sys.argv[1], sys.argv[2], float(sys.argv[3]) / 1000
    with open(source) as file:
        lines = file.read().split("\n")
    points = {i: list(map(float, line.split()[1:4])) for i, line in enumerate(lines) if line.startswith("v ")}
    floor = min(p[1] for p in points.values())
    stature = max(p[1] for p in points.values()) - floor
    share = {i: (p[1] - floor) / stature for i, p in points.items()}
    thigh = [p for i, p in points.items() if abs(share[i] - 0.4) < 0.01 and abs(p[0]) < TRUNK * stature]
    middle = [(min(abs(p[c]) if c == 0 else p[c] for p in thigh) + max(abs(p[c]) if c == 0 else p[c] for p in thigh)) / 2
              for c in (0, 2)]
    for i, (x, y, z) in points.items():
        if abs(x) > TRUNK * stature and share[i] > THIGH or x == 0:
            continue
        more = THICKER * smooth(share[i], KNEE, THIGH) * (1 - smooth(share[i], THIGH + 0.04, HIGHEST))
        inner = 1 - smooth(share[i], THIGH, THIGH + 0.03) if abs(x) < middle[0] else 1
        points[i] = [x + math.copysign((abs(x) - middle[0]) * more * inner, x), y, z + (z - middle[1]) * more]
    nearest = min(abs(p[0]) for i, p in points.items() if 0.3 < share[i] < THIGH)
    for i, (x, y, z) in points.items():
        if x != 0 and not (abs(x) > TRUNK * stature and share[i] > THIGH):
            shift = (nearest + overlap / 2) * (1 - smooth(share[i], THIGH, THIGH + 0.03))
            points[i] = [x - math.copysign(shift, x), y, z]
    for i, point in points.items():
        lines[i] = "v %.6f %.6f %.6f" % tuple(point)
    with open(target, "w") as file:
        file.write("\n".join(lines))


if __name__ == "__main__":
    main()
