"""Prints the width and height in mm of each rectangle (operator re) on the first page of a PDF that Cairo wrote, in order.

Usage: pdf_rectangles.py FILE.pdf
"""
import re
import sys
import zlib


def content_streams(data):
    for match in re.finditer(rb"stream\r?\n", data):
        end = data.find(b"endstream", match.end())
        try:
            yield zlib.decompress(data[match.end():end])
        except zlib.error:
            continue


def main():
    with open(sys.argv[1], "rb") as file:
        data = file.read()
    number = rb"(-?[0-9.]+)"
    for stream in content_streams(data):
        # Cairo turns y down by the first matrix of a page, and scales nothing.
        if not re.match(rb"\s*1 0 0 -1 0 [0-9.]+ cm", stream):
            continue
        for values in re.findall(rb"\s".join([number] * 4) + rb"\s+re", stream):
            width, height = float(values[2]), float(values[3])
            print("%.4f %.4f" % (abs(width) * 25.4 / 72, abs(height) * 25.4 / 72))
        return


main()
