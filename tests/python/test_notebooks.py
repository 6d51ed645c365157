"""What a notebook shows, without a notebook."""

import copy
import unittest
import xml.etree.ElementTree

import numpy as np
from support import QUICK, shipped, two_squares

import selvedge


class Notebooks(unittest.TestCase):
    def test_a_result_shows_its_picture_its_verdict_and_its_faults(self):
        result = selvedge.dress(shipped("two_squares"), selvedge.mannequin(resolution=1), **QUICK)
        png = result._repr_png_()
        self.assertTrue(png.startswith(b"\x89PNG"))
        self.assertIs(png, result._repr_png_())  # drawn once
        text = result._repr_html_()
        self.assertIn("not at rest", text)
        self.assertIn(result.faults[0]["kind"], text)
        self.assertIn("data:image/png;base64,", text)

    def test_a_body_shows_its_picture_and_its_girths(self):
        body = selvedge.mannequin(resolution=1, bust=0.9)
        self.assertTrue(body._repr_png_().startswith(b"\x89PNG"))
        self.assertIn("bust 90 cm", body._repr_html_())

    def test_a_pattern_shows_its_sheet_and_its_faults(self):
        pattern = selvedge.load_pattern(shipped("tshirt"))
        text = pattern._repr_html_()
        sheet = text[text.index("<svg") : text.index("</svg>") + 6]
        root = xml.etree.ElementTree.fromstring(sheet)
        self.assertIn("viewBox", root.attrib)
        self.assertNotIn("width", root.attrib)
        broken = two_squares()
        broken.name = "<b>"
        broken.seams[0].second = ("bakc", 4)
        self.assertIn("bakc", broken._repr_html_())
        self.assertIn("&lt;b&gt;", broken._repr_html_())

    def test_copies_are_like_what_they_are_copies_of(self):
        body = selvedge.mannequin(resolution=1)
        result = selvedge.dress(shipped("two_squares"), body, **QUICK)
        pattern = selvedge.load_pattern(shipped("two_squares"))
        for copied in (copy.copy, copy.deepcopy):
            np.testing.assert_array_equal(copied(result).positions, result.positions)
            np.testing.assert_array_equal(copied(body).vertices, body.vertices)
            self.assertEqual(copied(pattern).check(), pattern.check())


if __name__ == "__main__":
    unittest.main()
