#include "app/garment_options.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <sstream>

#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/dress/worn_together.h"
#include "sim/pattern/named_file.h"
#include "sim/pattern/pattern_file.h"
#include "sim/session/dress_check.h"

namespace selvedge::app {

namespace {

std::string fault_text(std::string kind) {
    std::replace(kind.begin(), kind.end(), '_', ' ');
    return kind;
}

sim::CriteriaOptions parse_criteria(const std::string& text) {
    sim::CriteriaOptions criteria{.collision = false, .curvature = false, .length = false};
    std::istringstream names(text.empty() ? "," : text);  // no text is a name without letters
    for (std::string name; std::getline(names, name, ',');) {
        if (name == "collision") {
            criteria.collision = true;
        } else if (name == "curvature") {
            criteria.curvature = true;
        } else if (name == "length") {
            criteria.length = true;
        } else {
            throw sim::InputError("", "--criteria", "'" + name + "' is none of collision, curvature, length");
        }
    }
    return criteria;
}

}  // namespace

void add_garment_options(Command& command, GarmentOptions& options) {
    sim::DressOptions& dress = options.dress;
    add_option(command, "GARMENT", options.garment, "Garment file (patterns/FORMAT.md)",
               {.type = "FILE", .is_required = true});
    add_option(command, "--over", options.over, "A garment that is worn over it; may be repeated, from the inside out",
               {.type = "FILE", .takes_one_value = true});
    add_option(command, "--fabric", options.fabric, "A shipped fabric or a fabric file (default: the pattern's)",
               {.type = "NAME|FILE"});
    add_number<double>(command, "--edge-length", sim::kEdgeLengthsCm,
                       "Edge length of the base mesh in cm (default: the pattern's, or 5)", {.type = "CM"},
                       [&dress](double length_cm) { dress.edge_length = length_cm / 100; });
    add_number<int>(command, "--max-level", sim::kLevels, "Times an edge may be halved (default 3)", {.type = "N"},
                    [&dress](int level) { dress.max_level = level; });
    add_number<double>(command, "--shortest-edge", sim::kShortestEdgesCm,
                       "Edges shorter than this, in cm, are not halved (default 2)", {.type = "CM"},
                       [&dress](double length_cm) { dress.shortest_edge = length_cm / 100; });
    add_number<int>(command, "--triangles", sim::kTriangleBudgets,
                    "Number of triangles to keep near, by how much shape they show (default: as many as it takes)",
                    {.type = "N"}, [&dress](int target) { dress.triangle_budget = target; });
    add_flag(command, "--coarse-back-faces", options.coarsens_back_faces,
             "Keep the mesh coarse where the right side of the cloth faces away from the camera, in exports too");
    add_flag(command, "--no-self-collision", "Let the cloth pass through itself, which is faster",
             [&dress] { dress.self_collision = false; });
    add_text_option(command, "--criteria", "What asks for smaller triangles (default collision,curvature,length)",
                    {.type = "NAMES"}, [&dress](const std::string& text) { dress.criteria = parse_criteria(text); });
}

void add_thread_options(Command& command, GarmentOptions& options) {
    add_number<int>(command, "--threads", sim::kThreadCounts,
                    "Threads to use (default: all there are); the result is the same", {.type = "N"},
                    [&options](int threads) { options.threads = threads; });
    add_flag(command, "-q,--quiet", options.is_quiet, "Show no progress, and print only faults");
}

namespace {

// Throws InputError for what `selvedge check` reports too. What is wrong with body and seams shows when they are made.
sim::Pattern load_dressable(const std::filesystem::path& file, const GarmentOptions& options,
                            std::vector<std::string>& notes) {
    const sim::PatternDocument document = sim::load_pattern(file);
    for (const sim::Fault& warning : document.warnings) notes.push_back(describe(warning));
    const sim::Pattern& pattern = document.pattern;
    const sim::DressCheck check{
        .has_fabrics = options.fabric.empty(), .makes_body_and_mesh = false, .edge_length = options.dress.edge_length};
    refuse_undressable(pattern, file.string(), check);
    return pattern;
}

}  // namespace

sim::Pattern load_garments(const GarmentOptions& options, std::vector<std::string>& notes) {
    sim::Pattern pattern = load_dressable(options.garment, options, notes);
    std::vector<sim::Pattern> over;
    for (const std::filesystem::path& file : options.over) over.push_back(load_dressable(file, options, notes));
    return sim::worn_together(std::move(pattern), over, options.garment.string(), notes);
}

std::vector<std::filesystem::path> input_files(const GarmentOptions& options, const BodyOptions& body) {
    std::vector<std::filesystem::path> inputs{options.garment};
    inputs.insert(inputs.end(), options.over.begin(), options.over.end());
    inputs.insert(inputs.end(), options.named.begin(), options.named.end());
    if (body.is_file()) inputs.emplace_back(body.source);
    return inputs;
}

void name_inputs(GarmentOptions& options, BodyOptions& body, PictureOptions& picture, const sim::Pattern& pattern) {
    name_looks(picture, pattern, options.fabric);
    const std::vector<std::string> named = named_files(*picture.pattern);
    options.named.assign(named.begin(), named.end());
    if (body.source.empty()) body.source = pattern.body.empty() ? sim::kDefaultBody : pattern.body;
}

void fill_in(GarmentOptions& options, PictureOptions& picture, const sim::Pattern& pattern) {
    if (!options.fabric.empty()) options.dress.fabric = sim::find_fabric(options.fabric);
    read_looks(picture, pattern, options.fabric, options.garment.string());
    if (options.coarsens_back_faces) options.dress.seen_from = seen_from(picture);
}

void tell_warnings(const std::vector<sim::Fault>& warnings) {
    for (const sim::Fault& warning : warnings) std::fprintf(stderr, "selvedge: note: %s\n", describe(warning).c_str());
}

void print_faults(const sim::DressReport& report) {
    for (const sim::DressFault& fault : report.faults) {
        if (class_of(fault) == sim::FaultClass::DoesNotFit) {
            std::printf("does not fit: %s\n", sim::printable(cause_of(fault)).c_str());
        } else {
            std::printf("defect: %s: %s\n", fault_text(fault.kind).c_str(), sim::printable(cause_of(fault)).c_str());
        }
    }
}

}  // namespace selvedge::app
