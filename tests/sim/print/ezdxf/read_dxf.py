"""Prints what ezdxf reads in a DXF of Selvedge: a line per block with its name, the vertices and the box of its sewing line
(layer 14), and the numbers of notches, turn points, drill points and records.

Usage: read_dxf.py FILE.dxf
"""
import sys

import ezdxf


def main():
    document = ezdxf.readfile(sys.argv[1])
    audit = document.audit()
    print("errors", len(audit.errors))
    for block in document.blocks:
        if block.name.startswith(("*", "$")):
            continue
        lines = [e for e in block if e.dxftype() == "POLYLINE" and e.dxf.layer == "14"]
        points = [vertex.dxf.location for vertex in lines[0].vertices]
        xs, ys = [p.x for p in points], [p.y for p in points]
        marks = [e for e in block if e.dxftype() == "POINT"]
        records = [e for e in block if e.dxftype() == "TEXT" and e.dxf.text.startswith("SELVEDGE")]
        print(block.name, len(points), "%.4f %.4f %.4f %.4f" % (min(xs), min(ys), max(xs), max(ys)),
              sum(m.dxf.layer in ("4", "80", "81", "82", "83") for m in marks),
              sum(m.dxf.layer == "13" for m in marks), len(records))


main()
