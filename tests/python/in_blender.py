"""Runs in Blender: dresses the mannequin, exported by selvedge with its bones, by the add-on; checks the garment.
Arguments after "--": the add-on, a pattern, a folder for the picture."""

import pathlib
import sys

import bpy
import numpy as np

addon, pattern, folder = (pathlib.Path(one) for one in sys.argv[sys.argv.index("--") + 1 :])
np.bool = bool  # Blender 3.4's importer of glTF asks NumPy for it
import selvedge  # noqa: E402


def positions(thing):
    graph = bpy.context.evaluated_depsgraph_get()
    graph.update()
    data = thing.evaluated_get(graph).data
    x = np.empty(3 * len(data.vertices))
    data.vertices.foreach_get("co", x)
    world = np.array(thing.evaluated_get(graph).matrix_world)
    return x.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3]


bpy.ops.wm.read_factory_settings(use_empty=True)
body = selvedge.mannequin(resolution=2)
body.export(folder / "body.glb")
bpy.ops.preferences.addon_enable(module="io_scene_gltf2")
bpy.ops.import_scene.gltf(filepath=str(folder / "body.glb"))
armature = next(one for one in bpy.data.objects if one.type == "ARMATURE")
armature.location = (0.7, -0.4, 0.2)  # not where Selvedge would put it
armature.rotation_mode = "XYZ"
armature.rotation_euler.z = 0.3
bpy.ops.object.select_all(action="DESELECT")
bpy.context.view_layer.objects.active = armature
armature.select_set(True)

sys.path.insert(0, str(addon.parent))
import selvedge_dress  # noqa: E402

selvedge_dress.register()
try:
    bpy.ops.object.selvedge_dress()
    raise AssertionError("no pattern, and no error")
except RuntimeError as error:
    assert "choose the file of a pattern" in str(error), error

settings = bpy.context.scene.selvedge
settings.pattern, settings.edge_length, settings.max_level = str(pattern), 0.05, 2
settings.texture_size = "1024"
before = set(bpy.data.objects)
assert bpy.ops.object.selvedge_dress() == {"FINISHED"}
(garment,) = set(bpy.data.objects) - before

x = positions(garment)
skin = next(one for one in bpy.data.objects if one.type == "MESH" and one.find_armature() == armature and one != garment)
assert garment["selvedge"] == "dressed", garment["selvedge"]
low, high = x.min(axis=0) - armature.location, x.max(axis=0) - armature.location
print("the shirt from %.2f to %.2f m over the feet" % (low[2], high[2]))
assert 0.6 < low[2] < 1.0 and 1.25 < high[2] < 1.4 and abs(low[0] + high[0]) < 0.2, (low, high)
from mathutils import Vector  # noqa: E402
from mathutils.bvhtree import BVHTree  # noqa: E402

graph = bpy.context.evaluated_depsgraph_get()
tree = BVHTree.FromObject(skin, graph)
inverse = skin.matrix_world.inverted()
depths = []
for point in x[::3]:
    here = inverse @ Vector(point)
    on, normal, _, _ = tree.find_nearest(here)
    depths.append((here - on).dot(normal))
print("deepest vertex in the body: %.1f mm, mean distance %.1f mm" % (1000 * min(depths), 1000 * np.mean(depths)))
assert min(depths) > -0.002 and np.mean(depths) < 0.05

assert [layer.name for layer in garment.data.uv_layers] == ["UVMap", "Material"]
uv = np.empty(2 * len(garment.data.loops))
garment.data.uv_layers["Material"].data.foreach_get("uv", uv)
uv = uv.reshape(-1, 3, 2)
corners = np.array([list(one.vertices) for one in garment.data.polygons])
sides = np.linalg.norm(uv - np.roll(uv, 1, axis=1), axis=2)
drawn = np.linalg.norm(x[corners] - np.roll(x[corners], 1, axis=1), axis=2)
assert 0.95 < np.median(drawn / sides) < 1.05, np.median(drawn / sides)  # metres of cloth
assert garment.material_slots[0].material.node_tree.nodes.get("Image Texture").image.packed_file

names = [bone.name for bone in armature.pose.bones]
upper = [bone for bone in armature.pose.bones if bone.name in garment.vertex_groups]
assert upper, names
upper[0].location.x += 0.1
moved = positions(garment)
print("weights of", len(upper), "bones; moved by up to %.0f mm" % (1000 * np.linalg.norm(moved - x, axis=1).max()))
assert np.linalg.norm(moved - x, axis=1).max() > 0.05
upper[0].location.x -= 0.1

# A picture, as an artist would make a first one.
scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.cycles.samples = 24
scene.cycles.use_denoising = False
scene.render.resolution_x, scene.render.resolution_y = 480, 640
centre = x.mean(axis=0)
camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
scene.collection.objects.link(camera)
scene.camera = camera
camera.location = (armature.location.x + 1.1, armature.location.y - 3.0, armature.location.z + 1.3)
track = camera.constraints.new("TRACK_TO")
track.target, track.track_axis, track.up_axis = armature, "TRACK_NEGATIVE_Z", "UP_Y"
empty = bpy.data.objects.new("Middle", None)
empty.location = (armature.location.x, armature.location.y, armature.location.z + 1.0)
scene.collection.objects.link(empty)
track.target = empty
sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
sun.data.energy = 3
sun.rotation_euler = (0.7, 0.2, 0.5)
scene.collection.objects.link(sun)
scene.world = bpy.data.worlds.new("World")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.5, 0.5, 0.55, 1)
scene.view_settings.view_transform = "Standard"
scene.render.filepath = str(folder / "dressed.png")
bpy.ops.render.render(write_still=True)
print("the garment is dressed in Blender")
