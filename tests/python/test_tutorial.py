"""The examples of docs/python.md, run one after the other, and the pictures that they make."""

import os
import re
import unittest

from support import SOURCE, InFolder

BLOCK = re.compile(r"^```python\n(.*?)^```$", re.DOTALL | re.MULTILINE)


class Tutorial(InFolder):
    def test_its_examples_run(self):
        page = SOURCE / "docs/python.md"
        text = page.read_text(encoding="utf-8")
        blocks = list(BLOCK.finditer(text))
        self.assertGreater(len(blocks), 5)
        (self.folder / "patterns").symlink_to(SOURCE / "patterns")
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        names = {}
        for block in blocks:
            line = text.count("\n", 0, block.start(1))
            exec(compile("\n" * line + block.group(1), str(page), "exec"), names)
        kept = os.environ.get("SELVEDGE_KEEP_PICTURES")
        for name in ("tshirt.png", "strain.png", "poncho.png", "tshirt.glb", "skirt.json"):
            self.assertGreater((self.folder / name).stat().st_size, 500, name)
            if kept and name.endswith(".png"):
                os.replace(self.folder / name, os.path.join(kept, name))
        self.assertTrue(names["result"].settled)
        self.assertLess(abs(names["result"].contact_force[:, 1].sum() / -names["weight"] - 1), 0.1)


if __name__ == "__main__":
    unittest.main()
