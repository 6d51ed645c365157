#include "sim/exchange/glb_document.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <string>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/glb_container.h"

namespace selvedge::sim::glb {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

Json number(float value) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    static_cast<void>(error);  // 32 characters hold any float
    return Json::number_as_written(double(value), std::string(digits, end));
}

std::size_t Document::add_view(std::uint64_t bytes, Target target) {
    Json view = Json::object();
    view["buffer"] = 0;
    view["byteOffset"] = size_;
    view["byteLength"] = bytes;
    if (target != Target::None) view["target"] = int(target);
    views_.push_back(std::move(view));
    size_ += bytes;
    return views_.elements().size() - 1;
}

std::size_t Document::describe(std::size_t count, std::size_t bytes_each, Component component, const char* type,
                               Target target) {
    const std::size_t view = add_view(std::uint64_t(count) * bytes_each, target);
    Json accessor = Json::object();
    accessor["bufferView"] = view;
    accessor["componentType"] = int(component);
    accessor["count"] = count;
    accessor["type"] = type;
    accessors_.push_back(std::move(accessor));
    return accessors_.elements().size() - 1;
}

std::size_t Document::describe_sparse(std::size_t count, std::size_t kept, std::size_t indices, std::size_t values,
                                      const char* type) {
    Json accessor = Json::object();
    accessor["componentType"] = int(Component::Float);
    accessor["count"] = count;
    accessor["type"] = type;
    Json& sparse = accessor["sparse"] = Json::object();
    sparse["count"] = kept;
    sparse["indices"]["bufferView"] = indices;
    sparse["indices"]["componentType"] = int(Component::UnsignedInt);
    sparse["values"]["bufferView"] = values;
    accessors_.push_back(std::move(accessor));
    return accessors_.elements().size() - 1;
}

template <class Element>
std::size_t Document::add_kept(std::span<const Element> values, const std::vector<bool>& is_kept, std::size_t kept,
                               const char* type) {
    std::vector<std::uint32_t> indices;
    std::vector<Element> elements;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!is_kept[i] && !(kept == 0 && i == 0)) continue;  // one at least, as the specification has it
        indices.push_back(std::uint32_t(i));
        elements.push_back(is_kept[i] ? values[i] : Element(values[i] * 0));
    }
    append({reinterpret_cast<const char*>(indices.data()), indices.size() * sizeof(std::uint32_t)});
    const std::size_t index_view = add_view(indices.size() * sizeof(std::uint32_t), Target::None);
    append({reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(Element)});
    const std::size_t value_view = add_view(elements.size() * sizeof(Element), Target::None);
    return describe_sparse(values.size(), indices.size(), index_view, value_view, type);
}

std::size_t Document::add_sparse(std::span<const Vec3f> values, const std::vector<bool>& is_kept, Bounds bounds) {
    const auto kept = std::size_t(std::ranges::count(is_kept, true));
    if ((kept + 1) * (sizeof(std::uint32_t) + sizeof(Vec3f)) >= values.size() * sizeof(Vec3f))
        return bounds == Bounds::Given ? add_positions(values) : add_vectors(values);
    const std::size_t index = add_kept(values, is_kept, kept, "VEC3");
    if (bounds == Bounds::None) return index;
    Eigen::AlignedBox3f box;
    box.extend(Vec3f::Zero());  // of what is left out
    for (std::size_t i = 0; i < values.size(); ++i)
        if (is_kept[i]) box.extend(values[i]);
    set_bounds(index, numbers(box.min()), numbers(box.max()));
    return index;
}

std::size_t Document::add_sparse(std::span<const float> values, const std::vector<bool>& is_kept) {
    const auto kept = std::size_t(std::ranges::count(is_kept, true));
    if ((kept + 1) * (sizeof(std::uint32_t) + sizeof(float)) >= values.size() * sizeof(float))
        return add_numbers(values);
    return add_kept(values, is_kept, kept, "SCALAR");
}

std::size_t Document::add_file(std::string_view bytes) {
    constexpr std::size_t kAlignment = 4;  // of the accessors that follow
    Json view = Json::object();
    view["buffer"] = 0;
    view["byteOffset"] = size_;
    view["byteLength"] = bytes.size();
    views_.push_back(std::move(view));
    append(bytes);
    const std::size_t padding = (kAlignment - bytes.size() % kAlignment) % kAlignment;
    append(std::string(padding, '\0'));
    size_ += bytes.size() + padding;
    return views_.elements().size() - 1;
}

void Document::set_bounds(std::size_t accessor, Json low, Json high) {
    accessors_.elements()[accessor]["min"] = std::move(low);
    accessors_.elements()[accessor]["max"] = std::move(high);
}

// number() gives at most 15 characters: a sign, nine digits with a point, an exponent.
Json Document::longest_number() {
    return Json::number_as_written(0, "-0.000000000e-38");
}

Json Document::longest_bounds() const {
    return Json::array({longest_number(), longest_number(), longest_number()});
}

std::size_t Document::add_positions(std::span<const Vec3f> x) {
    const std::size_t index = add_vectors(x);
    const Eigen::AlignedBox3f box = box_around(x);
    if (is_plan_)
        set_bounds(index, longest_bounds(), longest_bounds());
    else
        set_bounds(index, numbers(box.min()), numbers(box.max()));
    return index;
}

std::size_t Document::add_indices(std::span<const std::array<std::uint32_t, 3>> triangles) {
    const std::span<const std::uint32_t> flat(triangles.front().data(), triangles.size() * 3);
    return add(flat, Component::UnsignedInt, "SCALAR", Target::Indices);
}

std::size_t Document::add_numbers(std::span<const float> values, Target target) {
    return add(values, Component::Float, "SCALAR", target);
}

std::size_t Document::add_times(std::span<const float> ascending) {
    const std::size_t index = add_numbers(ascending);
    set_bounds(index, Json::array({number(ascending.front())}), Json::array({number(ascending.back())}));
    return index;
}

std::size_t Document::plan(std::size_t count, std::size_t bytes_each, Component component, const char* type) {
    SELVEDGE_ASSERT(is_plan_);
    const std::size_t index = describe(count, bytes_each, component, type, Target::Vertices);
    set_bounds(index, longest_bounds(), longest_bounds());
    return index;
}

std::size_t Document::plan_sparse_vectors(std::size_t count, Bounds bounds) {
    SELVEDGE_ASSERT(is_plan_);
    const std::size_t indices = add_view(0, Target::None);
    const std::size_t values = add_view(std::uint64_t(count) * sizeof(Vec3f), Target::None);
    const std::size_t index = describe_sparse(count, count, indices, values, "VEC3");
    if (bounds == Bounds::Given) set_bounds(index, longest_bounds(), longest_bounds());
    return index;
}

std::size_t Document::plan_sparse_numbers(std::size_t count, std::size_t kept) {
    SELVEDGE_ASSERT(is_plan_);
    const std::size_t all = std::min(count * sizeof(float), (kept + 1) * (sizeof(std::uint32_t) + sizeof(float)));
    const std::size_t indices = add_view(0, Target::None), values = add_view(all, Target::None);
    return describe_sparse(count, count, indices, values, "SCALAR");
}

std::size_t Document::plan_numbers(std::size_t count) {
    SELVEDGE_ASSERT(is_plan_);
    const std::size_t index = describe(count, sizeof(float), Component::Float, "SCALAR", Target::None);
    set_bounds(index, longest_bounds(), longest_bounds());
    return index;
}

std::string Document::finish(Json root) {
    root["accessors"] = std::move(accessors_);
    root["bufferViews"] = std::move(views_);
    Json buffer = Json::object();
    buffer["byteLength"] = size_;
    root["buffers"] = Json::array({std::move(buffer)});
    return write_json(root, -1);
}

std::string container(Json root, Document document) {
    SELVEDGE_ASSERT(document.buffer().size() == document.size());
    std::string json = document.finish(std::move(root));
    return container(std::move(json), document.buffer());
}

Json root_object() {
    Json asset = Json::object();
    asset["generator"] = "Selvedge";
    asset["version"] = "2.0";
    Json root = Json::object();
    root["asset"] = std::move(asset);
    root["scene"] = 0;
    return root;
}

Json scene_of(std::vector<Json> nodes) {
    Json scene = Json::object();
    scene["nodes"] = Json::array(std::move(nodes));
    return Json::array({std::move(scene)});
}

void add_panel_materials(const std::vector<PanelPart>& parts, Json& materials) {
    for (const PanelPart& part : parts) {
        Json surface = Json::object();
        surface["metallicFactor"] = 0;
        surface["roughnessFactor"] = 1;
        Json material = Json::object();
        material["name"] = part.name;
        material["doubleSided"] = true;
        material["pbrMetallicRoughness"] = std::move(surface);
        materials.push_back(std::move(material));
    }
}

namespace {

Json texture_at(std::size_t index) {
    Json texture = Json::object();
    texture["index"] = index;
    return texture;
}

Json trilinear_sampler() {
    constexpr int kLinear = 9729, kLinearMipmapLinear = 9987, kClampToEdge = 33071;
    Json sampler = Json::object();
    sampler["magFilter"] = kLinear;
    sampler["minFilter"] = kLinearMipmapLinear;
    sampler["wrapS"] = kClampToEdge;
    sampler["wrapT"] = kClampToEdge;
    return sampler;
}

}  // namespace

void add_textures(const GarmentTextures& textures, Json& materials, Json& root, Document& document) {
    Json images = Json::array(), all = Json::array();
    const auto add = [&](const std::string& png, const char* name) {
        Json image = Json::object();
        image["bufferView"] = document.add_file(png);
        image["mimeType"] = "image/png";
        image["name"] = name;
        Json texture = Json::object();
        texture["sampler"] = 0;
        texture["source"] = images.elements().size();
        images.push_back(std::move(image));
        all.push_back(std::move(texture));
        return all.elements().size() - 1;
    };
    if (!textures.base_colour.empty()) {
        const std::size_t index = add(textures.base_colour, "base colour");
        for (Json& material : materials.elements())
            material["pbrMetallicRoughness"]["baseColorTexture"] = texture_at(index);
    }
    if (!textures.normal.empty()) {
        const std::size_t index = add(textures.normal, "normal");
        for (Json& material : materials.elements()) material["normalTexture"] = texture_at(index);
    }
    if (images.elements().empty()) return;
    root["samplers"] = Json::array({trilinear_sampler()});
    root["images"] = std::move(images);
    root["textures"] = std::move(all);
}

std::vector<Vec3f> positions_of(const PanelPart& part, const std::vector<Vec3f>& x) {
    std::vector<Vec3f> part_x;
    part_x.reserve(part.vertices.size());
    for (const std::uint32_t v : part.vertices) part_x.push_back(x[v]);
    return part_x;
}

std::vector<Vec3f> normals_of(const PanelPart& part, const std::vector<Vec3f>& normals) {
    std::vector<Vec3f> part_normals = positions_of(part, normals);
    for (std::size_t i = 0; i < part_normals.size(); ++i)
        if (part.is_turned[i]) part_normals[i] = -part_normals[i];
    return part_normals;
}

namespace {

// v points down in glTF.
std::size_t add_uv(std::vector<Vec2f> uv, Document& document) {
    for (Vec2f& v : uv) v.y() = 1 - v.y();
    return document.add(std::span<const Vec2f>(uv), Component::Float, "VEC2", Target::Vertices);
}

Json chart_json(const UvChart& chart) {
    Json json = Json::object();
    json["scale"] = chart.scale;
    json["turned"] = chart.is_turned;
    json["offset"] = Json::array({chart.offset.x(), chart.offset.y()});
    return json;
}

}  // namespace

Json panel_primitive(const PanelPart& part, std::size_t material, const std::vector<Vec3f>& x,
                     const std::vector<Vec3f>& normals, Document& document) {
    Json attributes = Json::object();
    attributes["POSITION"] = document.add_positions(positions_of(part, x));
    attributes["NORMAL"] = document.add_vectors(normals_of(part, normals));
    std::size_t set = 0;
    if (part.chart) attributes["TEXCOORD_" + std::to_string(set++)] = add_uv(packed_uv(part), document);
    if (!part.u.empty()) attributes["TEXCOORD_" + std::to_string(set)] = add_uv(part.u, document);
    Json extras = Json::object();
    extras["panel"] = part.name;
    extras["grain_angle"] = number(part.grain_angle);
    if (!part.sett_offset.isZero(0)) extras["sett_offset"] = numbers(part.sett_offset);
    if (part.chart) extras["chart"] = chart_json(*part.chart);
    Json primitive = Json::object();
    primitive["attributes"] = std::move(attributes);
    primitive["indices"] = document.add_indices(part.triangles);
    primitive["material"] = material;
    primitive["extras"] = std::move(extras);
    return primitive;
}

}  // namespace selvedge::sim::glb
