"""Blender add-on: dresses the mesh of an armature in a sewing pattern, and brings the garment back as a mesh that
follows the armature. Needs the Python module selvedge in Blender's Python (docs/blender.md)."""

import os
import pathlib
import tempfile
import threading

import bpy
import numpy as np
from bpy.props import EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty

bl_info = {
    "name": "Selvedge: dress a body",
    "author": "Selvedge",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Selvedge",
    "description": "Dress the active armature's mesh in a sewing pattern",
    "category": "Object",
}

# From Blender's axes (z up, a figure looks along -y) to Selvedge's (y up, it looks along +z), for rows of positions.
TO_SELVEDGE = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
TO_BLENDER = TO_SELVEDGE.T
QUARTER_TURN = np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])  # about y


class Refused(Exception):
    """What the user has to change; its text is shown."""


def selvedge_module():
    try:
        import selvedge
        return selvedge
    except ImportError as error:
        raise Refused(f"Blender's Python cannot import selvedge: {error}") from None


def find_body(active):
    """The armature and its largest mesh, of the active object."""
    if active is None:
        raise Refused("select an armature, or a mesh that an armature moves")
    armature = active if active.type == "ARMATURE" else active.find_armature()
    if armature is None:
        raise Refused(f"'{active.name}' is no armature and is moved by none")
    meshes = [one for one in bpy.data.objects if one.type == "MESH" and one.find_armature() == armature
              and "selvedge" not in one]
    if active in meshes:
        return armature, active
    if meshes:
        return armature, max(meshes, key=lambda one: len(one.data.vertices))
    raise Refused(f"'{armature.name}' moves no mesh")


def body_at_rest(armature, mesh):
    """Positions in metres in Selvedge's axes, faces, and the yaw (3, 3) and origin that lead back to the world: those of
    the armature, or the middle of the body if that is away. Modifiers are applied, in the rest pose."""
    before, armature.data.pose_position = armature.data.pose_position, "REST"
    graph = bpy.context.evaluated_depsgraph_get()
    graph.update()
    evaluated = mesh.evaluated_get(graph)
    data = evaluated.to_mesh()
    try:
        x = np.empty(3 * len(data.vertices))
        data.vertices.foreach_get("co", x)
        faces = [list(face.vertices) for face in data.polygons]
        world = np.array(evaluated.matrix_world)
    finally:
        evaluated.to_mesh_clear()
        armature.data.pose_position = before
    placed = x.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3]
    angle = armature.matrix_world.to_euler("XYZ").z
    yaw = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    origin, low, high = np.array(armature.matrix_world.translation), placed.min(axis=0), placed.max(axis=0)
    if np.linalg.norm((origin - (low + high) / 2)[:2]) > 0.2 * (high - low)[2]:
        origin = (low + high) / 2
    return (placed - origin) @ yaw @ TO_SELVEDGE * bpy.context.scene.unit_settings.scale_length, faces, yaw, origin


def write_obj(path, x, faces):
    lines = ["v %.9g %.9g %.9g" % tuple(point) for point in x]
    path.write_text("\n".join(lines + ["f " + " ".join(str(vertex + 1) for vertex in face) for face in faces]))


def way_back(x, body):
    """Rotation and translation from where Selvedge has the body, on the floor and facing the front, to where it was."""
    sample = body[:: max(1, len(body) // 300)]
    points = x[:: max(1, len(x) // 4000)]
    best, turn = None, np.eye(3)
    for _ in range(4):
        turned = body @ turn.T
        shift = (x.min(axis=0) + x.max(axis=0) - turned.min(axis=0) - turned.max(axis=0)) / 2
        shift[1] = x[:, 1].min() - turned[:, 1].min()
        apart = np.linalg.norm((sample @ turn.T + shift)[:, None] - points[None], axis=2).min(axis=1).mean()
        if best is None or apart < best[0]:
            best = (apart, turn, shift)
        turn = QUARTER_TURN @ turn
    return best[1], best[2]


def read_garment(path):
    """Of an OBJ of Selvedge: positions, faces, texture coordinates, and material coordinates in metres by corner."""
    x, packed, faces, corners, panels, charts = [], [], [], [], [], []
    for line in path.read_text().splitlines():
        word, _, rest = line.partition(" ")
        if word == "v":
            x.append([float(one) for one in rest.split()])
        elif word == "vt":
            packed.append([float(one) for one in rest.split()])
        elif word == "g":
            charts.append((1.0, 0, 0.0, 0.0))
        elif line.startswith("# chart "):
            charts[-1] = tuple(float(one) for one in line.split()[2:])
        elif word == "f":
            parts = [one.split("/") for one in rest.split()]
            faces.append([int(one[0]) - 1 for one in parts])
            corners.append([int(one[1]) - 1 for one in parts])
            panels.append(len(charts) - 1)
    uv, chart = np.array(packed)[np.array(corners)], np.array(charts)[np.array(panels)]
    material = (uv - chart[:, None, 2:4]) / chart[:, None, 0:1]
    turned = chart[:, 1] == 1
    material[turned] = np.stack([material[turned][..., 1], -material[turned][..., 0]], axis=-1)
    return np.array(x), faces, uv, material


class Job:
    """One dressing, which needs nothing of Blender while it runs, so that it may run on a thread of its own."""

    def __init__(self, settings, x, faces, yaw, origin):
        self.arguments = {"edge_length": settings.edge_length, "max_level": settings.max_level,
                          "fabric": settings.fabric or None}
        self.pattern = bpy.path.abspath(settings.pattern)
        self.tartan, self.texture_size = settings.tartan, int(settings.texture_size)
        self.x, self.faces, self.yaw, self.origin = x, faces, yaw, origin
        self.folder = tempfile.TemporaryDirectory(prefix="selvedge-")
        self.done, self.stage, self.is_cancelled, self.error = 0.0, "body", False, None

    def tell(self, done, stage):
        self.done, self.stage = done, stage
        if self.is_cancelled:
            raise Refused("cancelled")

    def run(self):
        try:
            self.dress()
        except Exception as error:  # shown to the user by whoever started the job
            self.error = error

    def dress(self):
        selvedge = selvedge_module()
        folder = pathlib.Path(self.folder.name)
        write_obj(folder / "body.obj", self.x, self.faces)
        body = selvedge.load_body(folder / "body.obj", unit="m", up="y")
        pattern = selvedge.load_pattern(self.pattern)
        pattern.tartan = self.tartan or pattern.tartan
        self.result = selvedge.dress(pattern, body, progress=self.tell, **self.arguments)
        self.result.export(folder / "garment.obj", texture_size=self.texture_size)
        turn, shift = way_back(self.x, body.vertices)
        x, self.faces, self.uv, self.material = read_garment(folder / "garment.obj")
        self.positions = (x @ turn.T + shift) @ TO_BLENDER


def make_material(name, picture):
    """Of the garment's baked cloth; the picture is packed into the file."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Roughness"].default_value = 0.85
    if picture.exists():
        node = material.node_tree.nodes.new("ShaderNodeTexImage")
        node.image = bpy.data.images.load(str(picture))
        node.image.pack()
        material.node_tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    return material


def make_garment(job, armature, mesh):
    """The garment's object: UVs, material, the body's weights, and the armature that moves it."""
    data = bpy.data.meshes.new(name := pathlib.Path(job.pattern).stem)
    x = job.positions / bpy.context.scene.unit_settings.scale_length @ job.yaw.T + job.origin
    data.from_pydata(x.tolist(), [], job.faces)
    for layer, uv in (("UVMap", job.uv), ("Material", job.material)):
        data.uv_layers.new(name=layer).data.foreach_set("uv", np.ascontiguousarray(uv, dtype=np.float32).ravel())
    data.polygons.foreach_set("use_smooth", [True] * len(data.polygons))
    data.materials.append(make_material(name, pathlib.Path(job.folder.name, "garment_colour.png")))
    data.update()
    garment = bpy.data.objects.new(name, data)
    garment["selvedge"] = str(job.result.report["outcome"])
    bpy.context.collection.objects.link(garment)
    bind(garment, armature, mesh)
    return garment


def bind(garment, armature, mesh):
    """Gives it the weights of the nearest skin, in the rest pose in which it was dressed, and the armature."""
    before, armature.data.pose_position = armature.data.pose_position, "REST"
    bpy.context.view_layer.update()
    transfer = garment.modifiers.new("Weights", "DATA_TRANSFER")
    transfer.object, transfer.use_vert_data = mesh, True
    transfer.data_types_verts, transfer.vert_mapping = {"VGROUP_WEIGHTS"}, "POLYINTERP_NEAREST"
    with bpy.context.temp_override(object=garment, active_object=garment, selected_objects=[garment]):
        bpy.ops.object.datalayout_transfer(modifier=transfer.name)
        bpy.ops.object.modifier_apply(modifier=transfer.name)
    armature.data.pose_position = before
    garment.modifiers.new("Armature", "ARMATURE").object = armature
    garment.parent, garment.matrix_parent_inverse = armature, armature.matrix_world.inverted()


class SELVEDGE_settings(bpy.types.PropertyGroup):
    pattern: StringProperty(name="Pattern", subtype="FILE_PATH", description="A garment file of Selvedge or GarmentCode")
    fabric: StringProperty(name="Fabric", description="A shipped one or a file; empty: the pattern's")
    tartan: StringProperty(name="Tartan", description="A shipped one or a threadcount; empty: the pattern's")
    edge_length: FloatProperty(name="Mesh size", default=0.05, min=0.005, max=0.3, precision=3, description="Metres")
    max_level: IntProperty(name="Refinement", default=3, min=0, max=8, description="Times an edge may be halved")
    texture_size: EnumProperty(name="Texture", default="2048", items=[(n, n + " px", "") for n in ("1024", "2048", "4096")])


class SELVEDGE_OT_dress(bpy.types.Operator):
    """Dress the active armature's mesh in the pattern, in its rest pose; Esc cancels"""

    bl_idname = "object.selvedge_dress"
    bl_label = "Dress"
    bl_options = {"REGISTER", "UNDO"}

    def started(self, context):
        settings = context.scene.selvedge
        try:
            selvedge_module()
            if not os.path.isfile(bpy.path.abspath(settings.pattern)):
                raise Refused("choose the file of a pattern")
            self.armature, self.mesh = find_body(context.active_object)
            self.job = Job(settings, *body_at_rest(self.armature, self.mesh))
        except Refused as error:
            self.report({"ERROR"}, str(error))
        return hasattr(self, "job")

    def end(self, context):
        """The garment, or a report of what was wrong."""
        with self.job.folder:
            if self.job.error is not None:
                self.report({"ERROR"}, str(self.job.error))
                return {"CANCELLED"}
            garment = make_garment(self.job, self.armature, self.mesh)
        faults = [fault["kind"].replace("_", " ") for fault in self.job.result.faults]
        text = f"{garment.name}: {garment['selvedge']}, {len(garment.data.polygons)} triangles"
        self.report({"WARNING"} if faults else {"INFO"}, ", ".join([text, *faults]))
        return {"FINISHED"}

    def execute(self, context):  # without a window, and when it is done again: waits
        if not self.started(context):
            return {"CANCELLED"}
        self.job.run()
        return self.end(context)

    def invoke(self, context, event):  # with a window: on a thread of its own
        if not self.started(context):
            return {"CANCELLED"}
        self.thread = threading.Thread(target=self.job.run)
        self.thread.start()
        self.timer = context.window_manager.event_timer_add(0.2, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            self.job.is_cancelled = True
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        if self.thread.is_alive():
            context.workspace.status_text_set(f"Selvedge: {self.job.stage} {self.job.done:.0%}   Esc: cancel")
            return {"RUNNING_MODAL"}
        context.window_manager.event_timer_remove(self.timer)
        context.workspace.status_text_set(None)
        return self.end(context)


class SELVEDGE_PT_panel(bpy.types.Panel):
    bl_label, bl_space_type, bl_region_type, bl_category = "Dress", "VIEW_3D", "UI", "Selvedge"

    def draw(self, context):
        for name in SELVEDGE_settings.__annotations__:
            self.layout.prop(context.scene.selvedge, name)
        self.layout.operator(SELVEDGE_OT_dress.bl_idname)


CLASSES = (SELVEDGE_settings, SELVEDGE_OT_dress, SELVEDGE_PT_panel)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.selvedge = PointerProperty(type=SELVEDGE_settings)


def unregister():
    del bpy.types.Scene.selvedge
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
