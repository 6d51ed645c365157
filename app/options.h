#pragma once
// Command-line options that several subcommands share: the body, the camera, the curved surface; and checks of output
// paths before the work begins.
#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/output/view_choice.h"
#include "sim/dress/prepared_body.h"
#include "sim/repair/load_body.h"

namespace selvedge::app {

class Command;

using render::SurfaceChoice;

struct BodyOptions {
    std::string source;  // "mannequin[:bust=92,...]" or a file; empty: none
    sim::LoadBodyOptions load{.must_be_person = true};

    bool is_file() const;
};

// Adds -b,--body, --body-unit and --body-up. Validates a mannequin's measurements while parsing.
// `options` must outlive the parsing.
void add_body_options(Command& command, BodyOptions& options, const std::string& help);

// sim::make_body() of these options. Pre: options.source is not empty.
sim::MadeBody make_body(const BodyOptions& options, const sim::ContentStore* store = nullptr);

// Options to draw the cloth as a curved surface (thesis ch. 6).

// Adds --surface, --surface-soft-cap, --surface-level, --surface-normals and --back-face-coarsening; validates them
// while parsing. `choice` must outlive the parsing.
void add_surface_options(Command& command, SurfaceChoice& choice);

// Checks of output files, made before a subcommand starts long work.

// Extensions for check_output(). Those of meshes: sim::mesh_extensions().
inline constexpr std::array<std::string_view, 1> kPictureExtensions{".png"};
inline constexpr std::array<std::string_view, 1> kGarmentExtensions{".json"};

// Throws InputError if the folder is missing or not writable, if the path exists and is not a regular file, or if its
// extension is not in the list (case-insensitive; an empty list allows any).
void check_output(const std::filesystem::path& path, std::span<const std::string_view> extensions = {});

// Throws InputError if two outputs are the same file, or if an output is also an input.
void check_distinct(const std::vector<std::filesystem::path>& outputs,
                    const std::vector<std::filesystem::path>& inputs);

}  // namespace selvedge::app
