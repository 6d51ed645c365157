"""Reads animation caches with Blender and compares them with expected.json in the same folder.

    blender --background --factory-startup --python-exit-code 1 --python check_in_blender.py -- FOLDER

The folder holds cache.pc2, cache.obj, cache.glb and expected.json: "first_frame", "pc2" and "glb": for each frame the
positions in the order of the file.
"""
import json
import pathlib
import sys

import bpy
import numpy  # of Debian's python3-numpy, which Blender's glTF importer needs

if not hasattr(numpy, "bool"):
    numpy.bool = bool  # numpy 1.24 dropped the name, which the importer of Blender 3.4 uses

TOLERANCE = 1e-5  # m


def distance(a, b):
    return sum((x - y) ** 2 for x, y in zip(a, b)) ** 0.5


def compare(what, positions, expected):
    if len(positions) != len(expected):
        raise SystemExit(f"{what}: {len(positions)} vertices, not {len(expected)}")
    worst = max(distance(a, b) for a, b in zip(positions, expected))
    if not worst < TOLERANCE:
        raise SystemExit(f"{what}: a vertex is {worst} m off")


def check_pc2(folder, expected):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.obj_import(filepath=str(folder / "cache.obj"))
    (garment,) = [o for o in bpy.context.scene.objects if o.type == "MESH"]
    modifier = garment.modifiers.new("cache", "MESH_CACHE")
    modifier.cache_format = "PC2"
    modifier.filepath = str(folder / "cache.pc2")
    modifier.frame_start = expected["first_frame"]
    for i, frame in enumerate(expected["pc2"]):
        bpy.context.scene.frame_set(expected["first_frame"] + i)
        evaluated = garment.evaluated_get(bpy.context.evaluated_depsgraph_get())
        compare(f"cache.pc2, frame {i}", [tuple(v.co) for v in evaluated.data.vertices], frame)


def check_glb(folder, expected):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(folder / "cache.glb"))
    (garment,) = [o for o in bpy.context.scene.objects if o.type == "MESH"]
    keys = garment.data.shape_keys
    if len(keys.key_blocks) != len(expected["glb"]):
        raise SystemExit(f"cache.glb: {len(keys.key_blocks)} shape keys, not {len(expected['glb'])}")
    for i, (key, frame) in enumerate(zip(keys.key_blocks, expected["glb"])):
        y_up = [(p.co[0], p.co[2], -p.co[1]) for p in key.data]  # Blender's z is up
        compare(f"cache.glb, frame {i}", y_up, frame)
    if keys.animation_data is None or keys.animation_data.action is None:
        raise SystemExit("cache.glb: the weights are not animated")


def main():
    folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
    expected = json.loads((folder / "expected.json").read_text())
    check_pc2(folder, expected)
    check_glb(folder, expected)
    print("the caches are read as they were written")


main()
