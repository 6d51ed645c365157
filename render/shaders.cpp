#include "render/shaders.h"

#include <span>

#include "sim/core/assert.h"
#include "sim/core/embedded.h"

namespace selvedge {

std::span<const EmbeddedFile> shader_files();

namespace {

ShaderText find_shader(std::string_view name) {
    for (const EmbeddedFile& file : shader_files()) {
        if (file.name == "shaders/" + std::string(name)) return {std::string(name), std::string(file.text)};
    }
    SELVEDGE_ASSERT(!"a shader of that name is embedded");
    return {};
}

std::vector<ShaderText> find_shaders(std::initializer_list<std::string_view> names) {
    std::vector<ShaderText> texts;
    for (const std::string_view name : names) texts.push_back(find_shader(name));
    return texts;
}

}  // namespace

Program make_program(const GladGLContext& gl, std::initializer_list<std::string_view> vertex,
                     std::initializer_list<std::string_view> fragment) {
    return Program(gl, find_shaders(vertex), find_shaders(fragment));
}

}  // namespace selvedge
