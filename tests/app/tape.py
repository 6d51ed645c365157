"""A tape measure for bodies in OBJ: prints girths in cm, and compares them with the fit table of a report. It shares no
code with the program: it cuts the surface by planes and takes the convex hull of the loops.

Usage: tape.py BODY.obj [REPORT.json]

All but sleeves are found from the surface alone, for a person who stands, as docs/report.md says: the crotch is where
legs part, the armpits are where the trunk is suddenly wider. A sleeve is measured in the plane that the report names,
which must be square to the arm: no plane that leans against it gives a clearly smaller girth. Prints a line per measure:
name, tape, table ("-": none); the exit code is 1 if a table's girth differs by more than 0.5 cm.
"""
import json
import math
import sys

TOLERANCE = 0.5  # cm


def read_obj(path):
    points, triangles = [], []
    with open(path) as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append(tuple(map(float, words[1:4])))
            elif words[:1] == ["f"]:
                ids = [int(word.split("/")[0]) - 1 for word in words[1:]]
                triangles += [(ids[0], ids[k], ids[k + 1]) for k in range(1, len(ids) - 1)]
    return points, triangles


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def unit(a):
    length = math.sqrt(dot(a, a))
    return (a[0] / length, a[1] / length, a[2] / length)


def hull(points):
    """The convex hull by gift wrapping in both directions of x (Andrew 1979)."""
    def half(ordered):
        chain = []
        for p in ordered:
            while len(chain) > 1 and ((chain[-1][0] - chain[-2][0]) * (p[1] - chain[-1][1])
                                      <= (chain[-1][1] - chain[-2][1]) * (p[0] - chain[-1][0])):
                chain.pop()
            chain.append(p)
        return chain[:-1]
    ordered = sorted(set(points))
    return half(ordered) + half(ordered[::-1])


def girth_of(points):
    corners = hull(points)
    return sum(math.dist(corners[i - 1], corners[i]) for i in range(len(corners)))


class Loop:
    """A loop of a cut: its points in the plane, m, relative to the plane's point."""

    def __init__(self, points):
        self.points = points
        twice, x, y = 0.0, 0.0, 0.0
        for i in range(len(points)):
            (ax, ay), (bx, by) = points[i - 1], points[i]
            part = ax * by - bx * ay
            twice, x, y = twice + part, x + (ax + bx) * part, y + (ay + by) * part
        self.area = abs(twice) / 2
        self.centre = (x / (3 * twice), y / (3 * twice)) if twice else points[0]
        self.xs = [p[0] for p in points]

    def holds(self, x, y):
        inside = False
        for i in range(len(self.points)):
            (ax, ay), (bx, by) = self.points[i - 1], self.points[i]
            if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
                inside = not inside
        return inside


def cut(points, triangles, point, normal):
    normal = unit(normal)
    across = unit(cross(normal, (0, 0, 1) if abs(normal[2]) < 0.9 else (1, 0, 0)))
    if across[0] < 0:
        across = (-across[0], -across[1], -across[2])
    other = cross(normal, across)
    height = {}
    neighbours, place = {}, {}
    for triangle in triangles:
        for v in triangle:
            if v not in height:
                height[v] = dot(normal, minus(points[v], point))
        ends = []
        for k in range(3):
            a, b = sorted((triangle[k], triangle[(k + 1) % 3]))
            if (height[a] > 0) == (height[b] > 0):
                continue
            ends.append((a, b))
            if (a, b) not in place:
                t = height[a] / (height[a] - height[b])
                x = minus([points[a][c] + t * (points[b][c] - points[a][c]) for c in range(3)], point)
                place[(a, b)] = (dot(across, x), dot(other, x))
        if ends:
            neighbours.setdefault(ends[0], []).append(ends[1])
            neighbours.setdefault(ends[1], []).append(ends[0])
    loops, seen = [], set()
    for start in neighbours:
        at, chain = start, []
        while at is not None and at not in seen:
            seen.add(at)
            chain.append(place[at])
            at = next((edge for edge in neighbours[at] if edge not in seen), None)
        if len(chain) > 2:
            loops.append(Loop(chain))
    return sorted((loop for loop in loops if loop.area > 1e-7), key=lambda loop: -loop.area)


class Person:
    """Who stands upright, m."""

    def __init__(self, path):
        self.points, self.triangles = read_obj(path)
        heights = [p[1] for p in self.points]
        self.floor, self.stature = min(heights), max(heights) - min(heights)
        self.slabs = {}
        for triangle in self.triangles:
            ys = [self.points[v][1] for v in triangle]
            for slab in range(math.floor(min(ys) * 100), math.floor(max(ys) * 100) + 1):
                self.slabs.setdefault(slab, []).append(triangle)

    def level(self, y):
        return cut(self.points, self.slabs.get(math.floor(y * 100), []), (0, y, 0), (0, 1, 0))

    def at(self, share):
        return self.floor + share * self.stature

    def trunk(self, y):
        loops = [loop for loop in self.level(y) if abs(loop.centre[0]) < 0.1 * self.stature]
        return [p for loop in loops if loop.area > 0.35 * loops[0].area for p in loop.points]

    def girth(self, y):
        points = self.trunk(y)
        return girth_of(points) if points else 0

    def width(self, y):
        xs = [p[0] for p in self.trunk(y)]
        return max(xs) - min(xs) if xs else 0

    def legs(self, y):
        """Two loops of similar area on either side, if the legs are apart at this level."""
        loops = self.level(y)[:2]
        apart = len(loops) == 2 and loops[1].area > 0.5 * loops[0].area and loops[0].centre[0] * loops[1].centre[0] < 0
        return sorted(loops, key=lambda loop: -loop.centre[0]) if apart else []

    def crotch(self):
        low, high = self.at(0.33), self.at(0.6)
        while low < high and self.legs(low):
            low += 0.005
        low -= 0.005
        for step in (0.001, 0.0002):
            while self.legs(low + step):
                low += step
        return low

    def waist(self):
        return min((self.at(0.57 + 0.0025 * i) for i in range(46)), key=self.girth)

    def armpit(self, waist):
        step, y = 0.002, waist
        width = self.width(y)
        while y < self.at(1):
            wider = self.width(y + step)
            if wider > 1.15 * width:
                return y
            y, width = y + step, wider
        return None


def between(low, high):
    return [low + (high - low) * i / 60 for i in range(61)]


def sleeve(person, row):
    """None if the plane that the report names is not square to the arm."""
    point, normal = row["plane_point_m"], row["plane_normal"]

    def girth(direction):
        loops = [loop for loop in cut(person.points, person.triangles, point, direction) if loop.holds(0, 0)]
        return girth_of(loops[0].points) if loops else math.inf

    across = unit(cross(normal, (0, 0, 1) if abs(normal[2]) < 0.9 else (1, 0, 0)))
    other = cross(normal, across)
    square = girth(normal)
    for way in (across, other):
        for lean in (-0.2, 0.2):
            leaning = girth(tuple(normal[c] + lean * way[c] for c in range(3)))
            if leaning < square - TOLERANCE / 100:
                return None
    return square


def measure(path, rows):
    person = Person(path)
    waist, crotch = person.waist(), person.crotch()
    armpit = person.armpit(waist)
    girths = {"waist": person.girth(waist)}
    if armpit:
        high, low = armpit - 0.015 * person.stature, armpit - 0.07 * person.stature
        girths["bust"] = max(person.girth(y) for y in between(max(low, waist), high))
    girths["hip"] = max(person.girth(y) for y in between(crotch + 0.02, person.at(0.56)))
    legs = person.legs(crotch - 0.03)
    for side, leg in zip(("left", "right"), legs):
        girths[side + "_thigh"] = girth_of(leg.points)
    for side in ("left", "right"):
        name = side + "_sleeve"
        if rows.get(name, {}).get("body_girth_m") is not None:
            girths[name] = sleeve(person, rows[name])
    return girths


def main():
    rows = {}
    if len(sys.argv) > 2:
        with open(sys.argv[2]) as file:
            rows = {row["measure"]: row for row in json.load(file)["fit"]}
    girths = measure(sys.argv[1], rows)
    wrong = 0
    for name in ("bust", "waist", "hip", "left_sleeve", "right_sleeve", "left_thigh", "right_thigh"):
        tape, table = girths.get(name), rows.get(name, {}).get("body_girth_m")
        texts = ["-" if value is None else f"{100 * value:.1f}" for value in (tape, table)]
        is_wrong = table is not None and (tape is None or abs(tape - table) * 100 > TOLERANCE)
        wrong += is_wrong
        print(name, *texts, *(["differ"] if is_wrong else []))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
