"""What the style tests check, as data: who may include whom, who owns which package, how long things may be."""

# The table of docs/architecture.md. A room may always include itself.
MAY_INCLUDE = {
    "sim/core": [],
    "sim/pattern": ["sim/core"],
    "sim/exchange": ["sim/core", "sim/pattern", "sim/mesh", "sim/body"],
    "sim/mesh": ["sim/core", "sim/pattern"],
    "sim/adaptive": ["sim/core", "sim/mesh"],
    "sim/body": ["sim/core"],
    "sim/cloth": ["sim/core", "sim/mesh", "sim/adaptive", "sim/body", "sim/pattern"],
    "sim/tartan": ["sim/core", "sim/pattern", "sim/mesh"],
    "sim/dress": ["sim/core", "sim/pattern", "sim/exchange", "sim/mesh", "sim/adaptive", "sim/body", "sim/cloth",
                  "sim/tartan"],
    "render/image": ["sim/core"],
    "render/surface": ["sim/core", "sim/mesh", "sim/adaptive", "sim/body"],
    "render/scene": ["sim/core", "render/image", "render/surface", "sim/mesh", "sim/body", "sim/tartan"],
    "render/gl": ["sim/core", "render/image"],
    "render": ["sim/core", "sim/mesh", "sim/body", "sim/tartan", "render/image", "render/surface", "render/scene",
               "render/gl"],
    "editor": ["sim/core", "sim/pattern", "sim/mesh", "sim/dress", "sim/body", "sim/tartan", "render/image",
               "render/surface", "render/scene"],
}
MAY_INCLUDE_EVERYTHING = ["app", "bench", "tests"]

# Beginning of an included name -> the only places (beginnings of a path) that may include it; and the tests, which may
# judge by any tool.
PACKAGE_OWNERS = {
    "nlohmann/": ["sim/core/json"],
    "assimp/": ["sim/body/", "sim/exchange/"],
    "tiny_gltf": ["sim/exchange/"],
    "tbb/": ["sim/core/parallel"],
    "oneapi/": ["sim/core/parallel"],
    "png.h": ["render/image/"],
    "CLI/": ["app/"],
    "CGAL/": ["sim/mesh/"],
    "GL/": ["render/gl/"],
    "EGL/": ["render/gl/"],
    "glad/": ["render/gl/"],
    "GLFW/": ["app/window"],
    "imgui": ["editor/", "app/ui_draw"],
    "gtest/": [],
}

SOURCE_FOLDERS = ["sim", "render", "editor", "app", "bench", "tests"]
SOURCE_SUFFIXES = [".h", ".cpp"]
TEXT_FOLDERS = SOURCE_FOLDERS + ["shaders", "cmake", "scripts", ".ci", "docs"]
TEXT_SUFFIXES = SOURCE_SUFFIXES + [".py", ".cmake", ".txt", ".md", ".glsl", ".vert", ".frag", ".sh", ""]

MAX_FILE_LINES = 450
MAX_FUNCTION_LINES = 60  # fails above; a function should fit on one screen
LONG_FUNCTION_LINES = 45  # is named above, and does not fail
CLANG_FORMAT_VERSION = 14  # others break lines elsewhere

# Written so that no pattern finds itself.
FORBIDDEN_TEXT = {
    r"\b(?:TO[D]O|FIX[M]E|X[X]X)\b": "an open end: do it, or write an issue",
    r"(?<![\w.])/(?:wor[k]|hom[e]|roo[t]|tm[p]|var/tm[p])/": "a path of one machine",
}
