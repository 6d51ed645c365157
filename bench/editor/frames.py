#!/usr/bin/env python3
"""Times the editor's frames in a real window while a garment of 30 panels is looked at, edited, draped and orbited.

    bench/editor/frames.py build/release/selvedge

needs Xvfb and xdotool. Makes the garment (the T-shirt, and a skirt of 24 gores), drives the window with mouse and keys,
and prints for each phase the quantiles of what `--frame-times` wrote. Times are of this machine in this hour: its load
is printed with them.
"""
import argparse
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
GORES = 24
WAIST_CM, HEM_CM, LENGTH_CM, WAIST_HEIGHT_CM = 78, 220, 50, 104
FITTING = (730, 420)  # in the 3D view of the window of 1280x800


def gore(i):
    """Half way round the body and on, its top at the waist, seen from outside."""
    angle = 2 * math.pi * i / GORES
    radius = 1.1 * WAIST_CM / (2 * math.pi)
    top, hem = WAIST_CM / GORES / 2, HEM_CM / GORES / 2
    return {"translation": [round(radius * math.sin(angle), 3), WAIST_HEIGHT_CM, round(radius * math.cos(angle), 3)],
            "rotation": [0, round(math.degrees(angle), 3), 0],
            "vertices": [[-hem, -LENGTH_CM], [hem, -LENGTH_CM], [top, 0], [-top, 0]],
            "edges": [{"endpoints": [k, (k + 1) % 4]} for k in range(4)]}


def pattern(edge_length_cm):
    garment = json.loads((ROOT / "patterns/tshirt.json").read_text())
    panels, stitches = garment["pattern"]["panels"], garment["pattern"]["stitches"]
    for i in range(GORES):
        panels[f"gore{i}"] = gore(i)
        stitches.append([{"panel": f"gore{i}", "edge": 1}, {"panel": f"gore{(i + 1) % GORES}", "edge": 3}])
    garment["pattern"].pop("panel_order", None)
    garment["selvedge"]["edge_length"] = edge_length_cm
    return garment


def corner_px(program, file, folder):
    """Where the front's lower corner is seen, by a script that plays the same editor without a window."""
    script = pathlib.Path(folder) / "where.script"
    script.write_text("frames 5\nwhere vertex front 0\n")
    said = subprocess.run([program, "edit", file, "--script", script, "--state", f"{folder}/other"], check=True,
                          capture_output=True, text=True).stdout
    return [round(float(word)) for word in said.split()]


class Window:
    def __init__(self, program, folder, arguments):
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1280x800x24"],
                                       pass_fds=[write_end], stderr=subprocess.DEVNULL)
        self.environment = dict(os.environ, DISPLAY=":" + os.read(read_end, 16).decode().strip())
        self.program = subprocess.Popen([program, "edit", *arguments, "--state", f"{folder}/state", "--scale", "1",
                                         "--frame-times", f"{folder}/times.csv"], env=self.environment)
        self.times = pathlib.Path(folder) / "times.csv"
        while len(self.rows()) < 5:
            time.sleep(0.2)

    def hands(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True)

    def key(self, name):
        self.hands("keydown", name, "sleep", 0.08, "keyup", name)

    def rows(self):
        """Times of each whole row, ms."""
        if not self.times.exists():
            return []
        return [[float(x) for x in line.split(",")[1:]] for line in self.times.read_text().splitlines(True)[1:]
                if line.endswith("\n")]

    def move_for(self, seconds, around, reach):
        """Round and round, with a step each 10 ms."""
        words = []
        for i in range(int(seconds * 100)):
            angle = i * 0.06
            words += ["mousemove", round(around[0] + reach * math.cos(angle)),
                      round(around[1] + reach * math.sin(angle)), "sleep", 0.01]
        self.hands(*words)

    def drag_for(self, seconds, around, button):
        self.hands("mousemove", *around, "mousedown", button)
        self.move_for(seconds, around, 40)
        self.hands("mouseup", button)

    def title(self):
        found = subprocess.run(["xdotool", "search", "--name", "Selvedge$", "getwindowname"], env=self.environment,
                               capture_output=True, text=True)
        return found.stdout.strip()

    def end(self):
        self.program.kill()
        self.server.kill()


def quantiles(rows):
    totals = sorted(row[0] for row in rows)
    at = lambda share: totals[min(len(totals) - 1, int(share * len(totals)))]
    parts = [statistics.median(row[k] for row in rows) for k in range(1, 5)]
    return [len(totals), at(0.5), at(0.95), at(0.99), totals[-1], *parts]


def measure(window, seconds, corner):
    def phase(name, act):
        before = len(window.rows())
        act()
        rows = window.rows()[before:]
        redrawn = sum(row[2] > 0.5 for row in rows) / len(rows)
        print(f"| {name} | {len(rows) / seconds:.0f} | " + " | ".join(f"{q:.1f}" for q in quantiles(rows)[1:]) +
              f" | {100 * redrawn:.0f} | {os.getloadavg()[0]:.1f} |", flush=True)

    def drag_corner():
        window.drag_for(seconds, corner, 1)
        if "*" not in window.title():
            sys.exit("nothing was edited: the corner is not where it was looked for")

    def start_again():
        window.hands("mousemove", *FITTING)
        window.hands("key", "ctrl+r", "sleep", 0.5)
        window.key("space")
        time.sleep(1.5)

    print("| phase | frames/s | median | 95 % | 99 % | max | ui | scenes | draw | swap | scene anew, % | load |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    time.sleep(3)
    phase("drag a point, placed", drag_corner)
    phase("orbit, placed", lambda: window.drag_for(seconds, FITTING, 3))
    start_again()
    phase("it drapes", lambda: time.sleep(seconds))
    start_again()
    phase("orbit while it drapes", lambda: window.drag_for(seconds, FITTING, 3))
    start_again()
    phase("drag a point while it drapes", drag_corner)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--seconds", type=float, default=6, help="of each phase")
    parser.add_argument("--edge-length", type=float, default=5, help="of the base mesh, cm")
    parser.add_argument("--screenshot", help="of the window at the end")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "thirty_panels.json"
        file.write_text(json.dumps(pattern(options.edge_length)))
        corner = corner_px(options.program, file, folder)
        window = Window(options.program, folder, [str(file)])
        try:
            measure(window, options.seconds, corner)
            if options.screenshot:
                subprocess.run(["import", "-window", "root", options.screenshot], env=window.environment, check=True)
        finally:
            window.end()


if __name__ == "__main__":
    main()
