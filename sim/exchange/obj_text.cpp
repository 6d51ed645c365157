#include "sim/exchange/obj_text.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "sim/exchange/mesh_cache.h"
#include "sim/exchange/mesh_file.h"
#include "sim/exchange/number_text.h"

namespace selvedge::sim {

namespace {

constexpr std::string_view kGrainComment = "# grain_angle ";
constexpr std::string_view kOffsetComment = "# sett_offset ";
constexpr std::string_view kChartComment = "# chart ";

// The name with blanks replaced by '_', because OBJ separates names at blanks.
std::string one_word(const std::string& name) {
    std::string word;
    for (const char c : name)
        word += std::isspace(static_cast<unsigned char>(c)) || std::iscntrl(static_cast<unsigned char>(c)) ? '_' : c;
    return word.empty() ? "unnamed" : word;
}

void append_points(std::string& text, const std::vector<Vec3f>& x, const std::vector<Vec3f>& normals) {
    for (const Vec3f& p : x) append_vector(text, "v", p);
    for (const Vec3f& normal : normals) append_vector(text, "vn", normal);
}

// Appends "position/texture/normal", or "position//normal" without a texture coordinate; indices start at 1.
void append_corner(std::string& text, std::size_t vertex, std::optional<std::size_t> texture, std::size_t normal) {
    text += ' ';
    append_number(text, vertex + 1);
    text += '/';
    if (texture) append_number(text, *texture + 1);
    text += '/';
    append_number(text, normal + 1);
}

// The numbers of texture coordinates and of normals written so far.
struct Written {
    std::size_t textures = 0;
    std::size_t normals = 0;
};

// "# chart SCALE TURNED OFFSET_U OFFSET_V"
void append_chart(std::string& text, const UvChart& chart) {
    text += kChartComment;
    append_number(text, chart.scale);
    text += chart.is_turned ? " 1 " : " 0 ";
    append_number(text, chart.offset.x());
    text += ' ';
    append_number(text, chart.offset.y());
    text += '\n';
}

// normals: of the mesh's vertices. A corner at which its vertex's normal looks to the wrong side gets a normal of its
// own, so that every corner's normal looks to the right side.
// A part with a chart gets the packed texture coordinates, else the metric ones.
void append_part(std::string& text, const PanelPart& part, const std::vector<Vec3f>& normals, Written& written) {
    for (const Vec2f& u : part.chart ? packed_uv(part) : part.u) append_vector(text, "vt", u);
    std::vector<std::size_t> normal_of;  // by vertex of the part
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
        normal_of.push_back(part.is_turned[i] ? written.normals++ : part.vertices[i]);
        if (part.is_turned[i]) append_vector(text, "vn", Vec3f(-normals[part.vertices[i]]));
    }
    text += "g " + one_word(part.name) + '\n';
    text += kGrainComment;
    append_number(text, part.grain_angle);
    text += '\n';
    if (!part.sett_offset.isZero(0))
        append_vector(text, kOffsetComment.substr(0, kOffsetComment.size() - 1), part.sett_offset);
    if (part.chart) append_chart(text, *part.chart);
    for (const auto& triangle : part.triangles) {
        text += 'f';
        for (const std::uint32_t corner : triangle)
            append_corner(text, part.vertices[corner],
                          part.u.empty() ? std::nullopt : std::optional(written.textures + corner), normal_of[corner]);
        text += '\n';
    }
    written.textures += part.u.size();
}

// Calls take(group, rest of the line) for each line that begins with `comment`; group: the current group's name.
template <class Take>
void for_each_comment(std::string_view text, std::string_view comment, const Take& take) {
    std::string group;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        if (line.starts_with("g ")) group = line.substr(2);
        if (line.starts_with(comment)) take(group, line.substr(comment.size()));
    }
}

// Parses a number at the start of `text` and removes it, with a blank before it. Returns nullopt if there is none or it
// is not finite.
template <class Number = float>
std::optional<Number> take_number(std::string_view& text) {
    if (text.starts_with(' ')) text.remove_prefix(1);
    Number number = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    if (result.ec != std::errc() || !std::isfinite(number)) return {};
    text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()));
    return number;
}

void append_body(std::string& text, const Body& body, std::size_t first_vertex, std::size_t first_normal) {
    const DrawMesh mesh = body_mesh(body);
    append_points(text, mesh.x, mesh.normals);
    text += "g " + one_word(body.name.empty() ? "body" : body.name) + '\n';
    for (const auto& triangle : mesh.triangles) {
        text += 'f';
        for (const std::uint32_t v : triangle) append_corner(text, first_vertex + v, std::nullopt, first_normal + v);
        text += '\n';
    }
}

std::string colour_file(const GarmentExport& content) {
    return one_word(content.name) + "_colour.png";
}

std::string normal_file(const GarmentExport& content) {
    return one_word(content.name) + "_normal.png";
}

std::string material_file(const GarmentExport& content) {
    return one_word(content.name) + ".mtl";
}

constexpr const char* kGarmentMaterial = "garment";

}  // namespace

std::string garment_obj(const DrawMesh& mesh, const GarmentExport& content) {
    const bool has_textures = !content.textures.base_colour.empty();
    std::string text = "# Selvedge garment: metres, y up; vt = ";
    text += has_textures
                ? "panels packed in the unit square; (vt - OFFSET) / SCALE of \"# chart SCALE TURNED OFFSET\", then "
                  "turned a quarter clockwise if TURNED is 1, = material coordinates in metres"
                : "material coordinates in metres";
    text += "; grain_angle in rad, sett_offset in metres\n";
    if (has_textures) text += "mtllib " + material_file(content) + "\nusemtl " + kGarmentMaterial + '\n';
    const std::vector<Vec3f> normals = vertex_normals(mesh);
    append_points(text, mesh.x, normals);
    Written written{.normals = normals.size()};
    std::vector<PanelPart> parts = split_by_panel(mesh);
    if (has_textures) pack_panels(parts, content.atlas);
    for (const PanelPart& part : parts) append_part(text, part, normals, written);
    if (content.body == nullptr) return text;
    if (has_textures) text += "usemtl body\n";
    append_body(text, *content.body, mesh.x.size(), written.normals);
    return text;
}

std::vector<FileBeside> files_beside_obj(const GarmentExport& content) {
    const GarmentTextures& textures = content.textures;
    if (textures.base_colour.empty()) return {};
    std::string materials = "# Selvedge\n";
    const auto add = [&](std::string_view name, std::string_view diffuse) {
        ((((materials += "newmtl ") += name) += "\nKa 0 0 0\nKd ") += diffuse) +=
            "\nKs 0.02 0.02 0.02\nNs 10\nillum 2\n";
    };
    add(kGarmentMaterial, "1 1 1");
    materials += "map_Kd " + colour_file(content) + '\n';
    if (!textures.normal.empty()) materials += "norm " + normal_file(content) + '\n';
    if (content.body != nullptr) add("body", "0.63 0.52 0.44");
    std::vector<FileBeside> files{{colour_file(content), textures.base_colour}};
    if (!textures.normal.empty()) files.push_back({normal_file(content), textures.normal});
    files.push_back({material_file(content), materials});
    return files;
}

std::string body_obj(const Body& body) {
    std::string text = "# Selvedge body: metres, y up\n";
    append_body(text, body, 0, 0);
    return text;
}

std::vector<std::pair<std::string, float>> grain_angles_in_obj(std::string_view text) {
    std::vector<std::pair<std::string, float>> angles;
    for_each_comment(text, kGrainComment, [&](const std::string& group, std::string_view numbers) {
        if (const std::optional<float> angle = take_number(numbers)) angles.emplace_back(group, *angle);
    });
    return angles;
}

std::vector<std::pair<std::string, Vec2f>> sett_offsets_in_obj(std::string_view text) {
    std::vector<std::pair<std::string, Vec2f>> offsets;
    for_each_comment(text, kOffsetComment, [&](const std::string& group, std::string_view numbers) {
        const std::optional<float> weft = take_number(numbers);
        const std::optional<float> warp = take_number(numbers);
        if (weft && warp) offsets.emplace_back(group, Vec2f(*weft, *warp));
    });
    return offsets;
}

std::vector<std::pair<std::string, UvChart>> charts_in_obj(std::string_view text) {
    std::vector<std::pair<std::string, UvChart>> charts;
    for_each_comment(text, kChartComment, [&](const std::string& group, std::string_view numbers) {
        const std::optional<double> scale = take_number<double>(numbers), turned = take_number<double>(numbers),
                                    u = take_number<double>(numbers), v = take_number<double>(numbers);
        if (!scale || !turned || !u || !v) return;
        const UvChart chart{.scale = *scale, .is_turned = *turned != 0, .offset = {*u, *v}};
        if (is_sound(chart)) charts.emplace_back(group, chart);
    });
    return charts;
}

}  // namespace selvedge::sim
