#pragma once
// Reads binary glTF in tests, by the specification and without the writer's code.
#include <gtest/gtest.h>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "sim/core/json.h"

namespace selvedge::sim {

inline std::uint32_t word_at(const std::string& bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

struct Container {
    Json root;
    std::string buffer;
};

// Splits the container into its chunks and checks it against chapter 4.4 of the glTF 2.0 specification.
inline Container open(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word_at(bytes, 4), 2U);
    EXPECT_EQ(word_at(bytes, 8), bytes.size());
    const std::size_t json_length = word_at(bytes, 12);
    EXPECT_EQ(json_length % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    const std::size_t binary = 20 + json_length;
    EXPECT_EQ(word_at(bytes, binary) % 4, 0U);
    EXPECT_EQ(bytes.substr(binary + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(binary + 8 + word_at(bytes, binary), bytes.size());
    return {parse_json(bytes.substr(20, json_length), "test.glb"), bytes.substr(binary + 8)};
}

inline std::size_t index_of(const Json& json, const char* key) {
    return std::size_t(json.find(key)->number());
}

inline std::size_t element_bytes(const Json& accessor) {
    const int component = int(accessor.find("componentType")->number());
    const std::string type = accessor.find("type")->string();
    const std::size_t count = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
    return count * (component == 5123 ? 2 : 4);
}

inline void expect_sound_view(const Container& file, const Json& owner, std::size_t bytes) {
    const Json& view = file.root.find("bufferViews")->elements().at(index_of(owner, "bufferView"));
    EXPECT_EQ(index_of(view, "byteOffset") % 4, 0U);
    EXPECT_LE(index_of(view, "byteOffset") + index_of(view, "byteLength"), file.buffer.size());
    EXPECT_EQ(bytes, index_of(view, "byteLength"));
}

// Each accessor fills its buffer views; each view is inside the buffer at an offset that is a multiple of 4.
inline void expect_sound_accessors(const Container& file) {
    EXPECT_EQ(index_of(file.root.find("buffers")->elements()[0], "byteLength"), file.buffer.size());
    for (const Json& accessor : file.root.find("accessors")->elements()) {
        const Json* sparse = accessor.find("sparse");
        if (sparse == nullptr) {
            expect_sound_view(file, accessor, index_of(accessor, "count") * element_bytes(accessor));
            continue;
        }
        const std::size_t count = index_of(*sparse, "count");
        EXPECT_GE(count, 1U);
        EXPECT_LT(count, index_of(accessor, "count"));
        EXPECT_EQ(index_of(*sparse->find("indices"), "componentType"), 5125U);
        expect_sound_view(file, *sparse->find("indices"), 4 * count);
        expect_sound_view(file, *sparse->find("values"), count * element_bytes(accessor));
    }
}

template <class Number>
Number number_at(const Container& file, const Json& owner, std::size_t index) {
    const Json& view = file.root.find("bufferViews")->elements().at(index_of(owner, "bufferView"));
    Number value = 0;
    std::memcpy(&value, file.buffer.data() + index_of(view, "byteOffset") + index * sizeof value, sizeof value);
    return value;
}

// All numbers of an accessor of floats, those that it leaves out too.
inline std::vector<float> floats_of(const Container& file, const Json& accessor) {
    const std::size_t each = element_bytes(accessor) / sizeof(float);
    std::vector<float> floats(index_of(accessor, "count") * each, 0.0F);
    const Json* sparse = accessor.find("sparse");
    for (std::size_t i = 0; sparse == nullptr && i < floats.size(); ++i)
        floats[i] = number_at<float>(file, accessor, i);
    for (std::size_t k = 0; sparse != nullptr && k < index_of(*sparse, "count"); ++k) {
        const std::size_t at = number_at<std::uint32_t>(file, *sparse->find("indices"), k);
        for (std::size_t i = 0; i < each; ++i)
            floats.at(at * each + i) = number_at<float>(file, *sparse->find("values"), k * each + i);
    }
    return floats;
}

inline const Json& accessor_of(const Container& file, const Json& owner, const char* key) {
    return file.root.find("accessors")->elements().at(index_of(owner, key));
}

inline float float_at(const Container& file, const Json& accessor, std::size_t index) {
    return floats_of(file, accessor)[index];
}

}  // namespace selvedge::sim
