#include "app/surface_options.h"

#include <charconv>
#include <string>

#include "sim/body/body_collider.h"
#include "sim/core/error.h"

namespace selvedge {
namespace {

using Text = const std::string&;

std::optional<int> parse_level(Text text) {
    if (text == "adaptive") return std::nullopt;
    int level = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), level);
    if (error != std::errc() || end != text.data() + text.size() || level < 0 || level > kMostSurfaceLevel) {
        throw InputError(
            "", "--surface-level",
            "'" + text + "' is neither adaptive nor a level from 0 to " + std::to_string(kMostSurfaceLevel));
    }
    return level;
}

SurfaceKind parse_kind(Text text) {
    if (const auto kind = parse_surface_kind(text)) return *kind;
    throw InputError("", "--surface", "'" + text + "' is none of " + kSurfaceKindNames);
}

LightNormals parse_normals(Text text) {
    if (text == "recomputed") return LightNormals::Recomputed;
    if (text == "interpolated") return LightNormals::Interpolated;
    throw InputError("", "--surface-normals", "'" + text + "' is none of recomputed, interpolated");
}

}  // namespace

void add_surface_options(CLI::App& command, SurfaceChoice& choice) {
    const auto add = [&](const char* name, Text help, const std::function<void(Text)>& read) {
        return command.add_option_function<std::string>(name, read, help)->group("Surface");
    };
    CLI::Option* kind = add("--surface",
                            std::string("Draw the cloth as a curved surface over its triangles: ") + kSurfaceKindNames +
                                " (default: the triangles themselves)",
                            [&](Text text) { choice.kind = parse_kind(text); })
                            ->type_name("KIND");
    add("--surface-level", "How often its edges are halved: 0 to 6, or adaptive (default adaptive, to 3)",
        [&](Text text) { choice.level = parse_level(text); })
        ->type_name("N|adaptive")
        ->needs(kind);
    add("--surface-normals", "What lights it: recomputed from the surface, or interpolated (default recomputed)",
        [&](Text text) { choice.light_normals = parse_normals(text); })
        ->type_name("WHICH")
        ->needs(kind);
    command
        .add_flag("--back-face-coarsening", choice.coarsens_back_faces,
                  "Keep coarse what is turned away, in pictures of an adaptive surface")
        ->group("Surface")
        ->needs(kind);
}

PlainMesh drawn_mesh(const PlainMesh& garment, const Body* body, const SurfaceChoice& choice,
                     const std::optional<ViewPoint>& view) {
    if (!choice.kind) return garment;
    CurvedMeshOptions options{.kind = *choice.kind, .level = choice.level, .light_normals = choice.light_normals};
    if (choice.coarsens_back_faces) options.view = view;
    std::optional<BodyCollider> collider;
    if (body != nullptr) options.move.body = &collider.emplace(*body);
    try {
        return curved_mesh(garment, options);
    } catch (const InputError& error) {
        throw InputError("", "--surface", error.place() + ": " + error.problem());
    }
}

}  // namespace selvedge
