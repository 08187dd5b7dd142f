# Renders a reference scene in Blender's Cycles, as reference/README.md of the test data describes: Lambert
# walls, an area lamp of the light's size, box filter, no denoiser, no clamp.
# Called by beside_cycles.py, in Blender's Python:
#   blender -b -t 2 --python cycles_scene.py -- SCENE.scene.json SIDE SAMPLES SEED OUT.npy
# Prints "seconds S", the time of the render call alone.
import json
import math
import os
import sys
import time

import bpy
import numpy
from mathutils import Matrix, Vector


def read_obj(path):
    """Vertices, and the triangles of each material."""
    vertices, triangles, material = [], {}, None
    with open(path) as lines:
        for words in map(str.split, lines):
            if not words:
                continue
            if words[0] == "v":
                vertices.append(tuple(map(float, words[1:4])))
            elif words[0] == "usemtl":
                material = words[1]
            elif words[0] == "f":
                corners = [int(word.split("/")[0]) - 1 for word in words[1:4]]
                triangles.setdefault(material, []).append(corners)
    return vertices, triangles


def read_diffuse(path):
    colors, material = {}, None
    with open(path) as lines:
        for words in map(str.split, lines):
            if words[:1] == ["newmtl"]:
                material = words[1]
            elif words[:1] == ["Kd"]:
                colors[material] = tuple(map(float, words[1:4]))
    return colors


def add(name, data):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def add_mesh(name, vertices, triangles, color):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*color, 1)
    output = nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(diffuse.outputs[0], output.inputs[0])
    used = sorted({corner for triangle in triangles for corner in triangle})
    place = {corner: i for i, corner in enumerate(used)}
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([vertices[i] for i in used], [],
                     [[place[corner] for corner in triangle] for triangle in triangles])
    mesh.materials.append(material)
    add(name, mesh)


def add_lamp(vertices, triangles, radiance):
    corners = [vertices[i] for triangle in triangles for i in triangle]
    low = [min(corner[axis] for corner in corners) for axis in range(3)]
    high = [max(corner[axis] for corner in corners) for axis in range(3)]
    lamp = bpy.data.lights.new("light", "AREA")
    lamp.shape = "RECTANGLE"
    lamp.size, lamp.size_y = high[0] - low[0], high[2] - low[2]
    lamp.energy = 4 * lamp.size * lamp.size_y  # a radiance of 1
    lamp.use_nodes = True
    lamp.node_tree.nodes["Emission"].inputs["Color"].default_value = (*radiance, 1)
    centre = Vector(low).lerp(Vector(high), 0.5)
    add("light", lamp).matrix_world = Matrix.Translation(centre) @ Matrix.Rotation(
        -math.pi / 2, 4, "X")


def add_camera(camera):
    eye, target = Vector(camera["position"]), Vector(camera["target"])
    back = (eye - target).normalized()
    right = Vector(camera["up"]).cross(back).normalized()
    up = back.cross(right)
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit = "VERTICAL"
    lens.angle = math.radians(camera["vertical_fov"])
    lens.clip_start = 0.001
    thing = add("camera", lens)
    thing.matrix_world = Matrix([(*axes, place) for *axes, place in zip(right, up, back, eye)] +
                                [(0, 0, 0, 1)])
    bpy.context.scene.camera = thing


def set_up(side, samples, seed, bounces):
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("black")
    scene.world.color = (0, 0, 0)
    scene.render.engine = "CYCLES"
    scene.render.threads_mode = "FIXED"
    scene.render.threads = 2
    scene.render.resolution_x = scene.render.resolution_y = side
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    cycles = scene.cycles
    cycles.samples, cycles.seed = samples, seed
    cycles.max_bounces = cycles.diffuse_bounces = bounces
    cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_auto_tile = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.light_sampling_threshold = 0
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1


def save(path):
    """The linear picture, rows from the bottom."""
    name = path + ".exr"
    bpy.data.images["Render Result"].save_render(name)
    picture = bpy.data.images.load(name)
    picture.colorspace_settings.name = "Raw"
    width, height = picture.size
    pixels = numpy.array(picture.pixels[:], dtype=numpy.float32).reshape(height, width, 4)
    numpy.save(path, pixels[:, :, :3])
    os.remove(name)


def main(path, side, samples, seed, out):
    with open(path) as file:
        spec = json.load(file)
    model = os.path.join(os.path.dirname(path), spec["model"])
    vertices, triangles = read_obj(model)
    colors = read_diffuse(os.path.splitext(model)[0] + ".mtl")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    for name, members in triangles.items():
        if name != "light":
            add_mesh(name, vertices, members, colors[name])
    add_lamp(vertices, triangles["light"], spec["materials"]["light"]["emission"])
    add_camera(spec["camera"])
    set_up(int(side), int(samples), int(seed), spec["render"]["bounces"])
    start = time.time()
    bpy.ops.render.render()
    print("seconds", time.time() - start, flush=True)
    save(out)


main(*sys.argv[sys.argv.index("--") + 1:])
