#include "app/body_buffers.h"

#include <algorithm>
#include <string>

#include "sim/core/error.h"
#include "sim/core/file_extension.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/core/percent_decoded.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

void add_buffers_of(const Path& gltf, std::vector<Path>& files) {
    const sim::Json json = sim::read_json(gltf);
    const sim::Json* buffers = json.is_object() ? json.find("buffers") : nullptr;
    if (buffers == nullptr || !buffers->is_array()) return;
    for (const sim::Json& buffer : buffers->elements()) {
        const sim::Json* uri = buffer.is_object() ? buffer.find("uri") : nullptr;
        if (uri == nullptr || !uri->is_string() || uri->string().starts_with("data:")) continue;
        for (const std::string& name : {uri->string(), sim::percent_decoded(uri->string())}) {
            const Path file = sim::folder_of(gltf) / name;
            if (sim::file_exists(file) && std::ranges::find(files, file) == files.end()) files.push_back(file);
        }
    }
}

}  // namespace

std::vector<Path> buffers_beside(const Path& body) {
    std::vector<Path> files;
    if (sim::lower_extension(body) != ".gltf") return files;
    try {
        add_buffers_of(body, files);
    } catch (const sim::InputError&) {  // the body is reported where it is read
    }
    return files;
}

}  // namespace selvedge::app
