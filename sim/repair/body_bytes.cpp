#include "sim/repair/body_bytes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace selvedge::sim {
namespace {

void write(FlatWriter& writer, const Vec3d& v) {
    for (const double coordinate : v) writer.value(coordinate);
}
void write(FlatWriter& writer, const Eigen::Quaterniond& q) {
    for (const double part : q.coeffs()) writer.value(part);
}
void read(FlatReader& reader, Vec3d& v) {
    for (double& coordinate : v) coordinate = reader.value<double>();
}
void read(FlatReader& reader, Eigen::Quaterniond& q) {
    for (double& part : q.coeffs()) part = reader.value<double>();
}

template <class Value>
void write(FlatWriter& writer, const Keys<Value>& keys) {
    writer.list(keys.times);
    writer.list(keys.values);
}
template <class Value>
void read(FlatReader& reader, Keys<Value>& keys) {
    keys.times = reader.list<double>();
    keys.values = reader.list<Value>();
    if (keys.times.size() != keys.values.size()) reader.refuse();
}

bool is_finite(const std::vector<Vec3d>& points) {
    return std::ranges::all_of(points, [](const Vec3d& x) { return x.allFinite(); });
}

bool is_sound(const Body& body) {
    const std::size_t vertices = body.x.size(), bones = body.bones.size();
    if (!is_finite(body.x) || !is_finite(body.bind)) return false;
    if (!body.bind.empty() && body.bind.size() != vertices) return false;
    if (!body.skin.empty() && body.skin.size() != vertices) return false;
    for (const std::array<int, 3>& triangle : body.triangles) {
        if (std::ranges::any_of(triangle, [&](int v) { return v < 0 || std::size_t(v) >= vertices; })) return false;
    }
    for (std::size_t i = 0; i < bones; ++i) {
        if (body.bones[i].parent >= int(i) || body.bones[i].parent < -1) return false;
    }
    for (const SkinWeights& skin : body.skin) {
        for (std::size_t k = 0; k < 4; ++k) {
            if (skin.bones[k] >= bones) return false;
        }
    }
    return true;
}

}  // namespace

void write(FlatWriter& writer, const Bone& bone) {
    writer.text(bone.name);
    writer.value(bone.parent);
    write(writer, bone.joint);
    write(writer, bone.rest.rotation);
    write(writer, bone.rest.translation);
    write(writer, bone.rest.scale);
    for (const double part : bone.inverse_bind.matrix().reshaped()) writer.value(part);
}
void read(FlatReader& reader, Bone& bone) {
    bone.name = reader.text();
    bone.parent = reader.value<int>();
    read(reader, bone.joint);
    read(reader, bone.rest.rotation);
    read(reader, bone.rest.translation);
    read(reader, bone.rest.scale);
    for (double& part : bone.inverse_bind.matrix().reshaped()) part = reader.value<double>();
}

void write(FlatWriter& writer, const Clip& clip) {
    writer.text(clip.name);
    writer.value(clip.seconds);
    writer.each(clip.tracks, [&](const Track& track) {
        writer.value(track.bone);
        write(writer, track.rotation);
        write(writer, track.translation);
        write(writer, track.scale);
    });
}
void read(FlatReader& reader, Clip& clip) {
    clip.name = reader.text();
    clip.seconds = reader.value<double>();
    clip.tracks = reader.each<Track>([&](Track& track) {
        track.bone = reader.value<int>();
        read(reader, track.rotation);
        read(reader, track.translation);
        read(reader, track.scale);
    });
}

std::string to_bytes(const Body& body) {
    FlatWriter writer;
    writer.text(body.name);
    writer.list(body.x);
    writer.list(body.triangles);
    writer.each(body.bones, [&](const Bone& bone) { write(writer, bone); });
    writer.list(body.skin);
    writer.text(body.made_from);
    writer.text(body.file);
    writer.value(body.lift);
    for (const double part : body.frame.matrix().reshaped()) writer.value(part);
    writer.list(body.bind);
    return writer.bytes();
}

std::optional<Body> body_from_bytes(std::string_view bytes) {
    FlatReader reader(bytes);
    Body body;
    body.name = reader.text();
    body.x = reader.list<Vec3d>();
    body.triangles = reader.list<std::array<int, 3>>();
    body.bones = reader.each<Bone>([&](Bone& bone) { read(reader, bone); });
    body.skin = reader.list<SkinWeights>();
    body.made_from = reader.text();
    body.file = reader.text();
    body.lift = reader.value<double>();
    for (double& part : body.frame.matrix().reshaped()) part = reader.value<double>();
    body.bind = reader.list<Vec3d>();
    if (!reader.is_sound() || !reader.is_at_end() || !is_sound(body)) return std::nullopt;
    return body;
}

}  // namespace selvedge::sim
