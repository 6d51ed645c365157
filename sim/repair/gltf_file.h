#pragma once
// A glTF 2.0 file as its JSON and its buffers (Khronos, "glTF 2.0 Specification"), for what is looked at before assimp
// reads it. Nothing in it is trusted: what is broken is absent.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "sim/core/json.h"

namespace selvedge::sim::gltf {

// Members of a JSON value, which may be anything. nullptr: there is none.
const Json* member(const Json* value, std::string_view key);
const Json* element(const Json* value, std::optional<std::size_t> index);
// nullopt if it is not a whole number that may count something.
std::optional<std::size_t> index_of(const Json* value);

// The same of a member that has a default, which is taken where the member is absent.
std::optional<std::size_t> index_or(const Json* value, std::size_t absent);

// The bytes of a number in an accessor, by its componentType. nullopt: there is no such type.
std::optional<std::size_t> component_bytes(std::size_t type);

// The numbers of an accessor, as they are stored.
struct Numbers {
    static constexpr std::size_t kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                                 kUnsignedInt = 5125, kFloat = 5126;  // componentType

    std::string_view bytes;
    std::size_t count = 0;  // of elements
    std::size_t width = 0;  // numbers in an element
    std::size_t stride = 0;
    std::size_t type = 0;  // componentType

    // What is not a float is not scaled.
    double at(std::size_t element, std::size_t k) const;
};

class File {
 public:
    // Pre: the content of that .gltf or .glb file, which stays. Throws InputError if it has no JSON.
    File(const std::filesystem::path& path, std::string_view content);
    File(Json root, std::string_view buffer);  // with one buffer, which stays

    const Json& root() const { return root_; }
    // Empty if it is not there. The files that a .gltf names are read when they are asked for.
    std::string_view buffer(std::size_t index);
    // Of a buffer view, or of the part of a buffer that an extension names in the same way. nullopt: it does not lie in
    // its buffer.
    std::optional<std::string_view> view_bytes(const Json* view);
    // nullopt if the accessor is broken, sparse, or does not lie in its view.
    std::optional<Numbers> numbers(const Json* accessor);

 private:
    std::string read_buffer(const Json* buffer, std::size_t index) const;

    std::filesystem::path folder_;
    std::string_view binary_;  // of a .glb
    Json root_;
    std::map<std::size_t, std::string> buffers_;
};

}  // namespace selvedge::sim::gltf
