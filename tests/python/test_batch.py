"""Many dressings by the program's command batch."""

import os
import unittest
from unittest import mock

from support import InFolder, shipped

import selvedge


class Batch(InFolder):
    def test_the_program_is_found(self):
        self.assertTrue(selvedge.program().is_file())
        with mock.patch.dict(os.environ):
            del os.environ["SELVEDGE_PROGRAM"]
            self.assertEqual(selvedge.program().name, "selvedge")

    def stand_in(self, text):
        path = self.folder / "program"
        path.write_text("#!/bin/sh\n" + text)
        path.chmod(0o755)
        return mock.patch.dict(os.environ, {"SELVEDGE_PROGRAM": str(path)})

    def test_rows_lines_and_failures_come_from_the_command(self):
        seen = []
        out = self.folder / "out"
        bar = 'echo "[##--] 1 of 4  9 a minute" >&2; echo "[####] 4 of 4" >&2'
        row = 'echo "$@" >args; mkdir -p "$4"; echo \'{"name": "one"}\' > "$4/results.jsonl"'.replace(
            ">args", f">{self.folder}/args"
        )
        with self.stand_in(f"{bar}; {row}; exit 1"):
            rows = selvedge.batch("m.json", out, jobs=2, progress=lambda done, line: seen.append((done, line)))
        self.assertEqual(rows, [{"name": "one"}])
        self.assertEqual((self.folder / "args").read_text(), f"batch m.json -o {out} --jobs 2\n")
        self.assertEqual(seen, [(0.25, "[##--] 1 of 4  9 a minute"), (1.0, "[####] 4 of 4")])
        with self.stand_in("echo selvedge: m.json: no >&2; exit 2"), self.assertRaises(selvedge.InputError) as caught:
            selvedge.batch("m.json", out)
        self.assertEqual(str(caught.exception), "m.json: no")
        with self.stand_in("exit 130"), self.assertRaises(KeyboardInterrupt):
            selvedge.batch("m.json", out)
        with self.stand_in("exit 143"), self.assertRaises(RuntimeError):
            selvedge.batch("m.json", out)

    def test_an_exception_in_the_progress_ends_the_command(self):
        with self.stand_in("while true; do echo '[-] 0 of 2' >&2; sleep 0.05; done"), self.assertRaises(KeyError):
            selvedge.batch("m.json", self.folder, progress=lambda done, line: {}["none"])

    def test_a_manifest_of_two_garments(self):
        manifest = self.folder / "manifest.csv"
        manifest.write_text(f"garment,seconds,edge-length\n{shipped('two_squares')},0.1,8\n{shipped('poncho')},0.1,8\n")
        rows = selvedge.batch(manifest, self.folder / "out", jobs=2)
        self.assertEqual(len(rows), 2)


if __name__ == "__main__":
    unittest.main()
