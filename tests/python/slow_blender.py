"""The add-on in Blender, without a window: in_blender.py, which Blender runs."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(SOURCE / "tests/support"))
import skips

if not shutil.which("blender"):
    skips.skip_program("python.blender", "blender is not installed")
addon = SOURCE / "blender/selvedge_dress.py"
assert len(addon.read_text(encoding="utf-8").splitlines()) <= 300
with tempfile.TemporaryDirectory() as folder:
    script = SOURCE / "tests/python/in_blender.py"
    command = ["blender", "--background", "--factory-startup", "--python-use-system-env", "--python-exit-code", "1",
               "--python", script, "--", addon, SOURCE / "patterns/tshirt.json", folder]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=900)
    kept = os.environ.get("SELVEDGE_KEEP_PICTURES")
    if kept and done.returncode == 0:
        shutil.copy(pathlib.Path(folder, "dressed.png"), kept)
print("\n".join(line for line in (done.stdout + done.stderr).splitlines() if not line.startswith("Fra:")))
sys.exit(done.returncode != 0 or "the garment is dressed in Blender" not in done.stdout)
