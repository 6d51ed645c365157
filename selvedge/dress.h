#pragma once
// Puts a garment on a body and drapes it until it is at rest: the same bits as `selvedge dress`.
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "selvedge/body.h"
#include "selvedge/export.h"
#include "selvedge/pattern.h"
#include "selvedge/picture.h"

namespace selvedge {

struct DressOptions {
    std::string fabric{};         // a shipped one (fabric_names()) or a file, of all panels; empty: the pattern's
    std::vector<Pattern> over{};  // garments that are worn over it, from the inside out
    double seconds = 12;          // longest simulated time, 0.01 to 600
    std::optional<double> edge_length{};  // m, of the base mesh, 0.005 to 0.3; none: the pattern's, or 0.05
    int max_level = 3;                    // how often an edge may be halved, 0 to 8
    double shortest_edge = 0.02;          // m, shorter ones are not halved, 0.001 to 0.5
    std::optional<int> triangles{};       // number to keep near, 100 to 10'000'000; none: as many as it takes
    bool self_collision = true;           // whether the cloth collides with itself
    // Most threads to use, 1 to 1024, of all that the process dresses at the time; none: one per CPU. The result is the
    // same for any number.
    std::optional<int> threads{};
    // Called on the caller's thread, some times in a second, with what is done, 0 to 1, and what is going on, such as
    // "draping". If it returns false, dress() throws Cancelled.
    std::function<bool(double done, std::string_view phase)> progress{};
};

// A triangle mesh of cloth. At a seam, corners of one vertex have different material coordinates.
struct Mesh {
    std::vector<std::array<float, 3>> positions{};                // m
    std::vector<std::array<float, 3>> normals{};                  // per vertex, unit, to the fabric's right side
    std::vector<std::array<std::uint32_t, 3>> triangles{};        // anticlockwise seen from the right side
    std::vector<std::array<std::array<float, 2>, 3>> material{};  // per corner, m, in the frame of the panel
    std::vector<std::uint16_t> panel{};                           // per triangle: index into panel_names
    std::vector<std::uint8_t> level{};                            // per triangle: how often the base mesh was divided
    std::vector<std::string> panel_names{};
};

// Of a triangle: lengths of the deformed warp and weft minus 1, and by how much the angle between them differs from a
// right angle, rad, unsigned.
struct Strain {
    float warp = 0;
    float weft = 0;
    float shear = 0;
};

// How a dressing ended. The program's exit codes for them: 0, 4, 3.
enum class Verdict { Dressed, DoesNotFit, Defect };

// What is wrong with a dressed garment.
struct DrapeFault {
    Verdict verdict = Verdict::Defect;  // DoesNotFit or Defect
    std::string kind{};                 // "open_seam", "does_not_fit", ...: docs/report.md lists them
    std::string sentence{};             // "too small at the waist (y 1.02 m) by 3.2 cm"
};

// A dressed garment. It does not change; copies share it, and several threads may use it.
class SELVEDGE_API Result {
 public:
    struct Content;  // of the library

    explicit Result(std::shared_ptr<Content> content);
    Result(const Result&);
    Result& operator=(const Result&);
    ~Result();

    Verdict verdict() const;
    const std::vector<DrapeFault>& faults() const;  // empty: a sound drape that fits
    const std::vector<std::string>& notes() const;  // what else the user should know, a sentence each
    bool is_settled() const;                        // came to rest
    const std::string& report() const;              // JSON, as `selvedge dress --report`, without `inputs`

    const Mesh& mesh() const;
    const std::vector<Strain>& strain() const;  // per triangle
    const std::vector<float>& clearance()
        const;  // per vertex: m from the body, negative inside; found when first asked
    // Per vertex: the seams on which it is, indices into pattern().seam_names(), ascending. Found when first asked.
    const std::vector<std::vector<int>>& seams_of_vertices() const;

    const Body& body() const;
    const Pattern& pattern() const;  // with the garments that are worn over it

    Content& content() const { return *content_; }

 private:
    std::shared_ptr<Content> content_;
};

// Dresses a body; without one, the body that the pattern names, or the usual mannequin. Several threads may dress at
// the same time. Throws InputError for what `selvedge dress` refuses, and Cancelled. What is wrong with the drape is in
// Result::faults().
SELVEDGE_API Result dress(const Pattern& pattern, const Body& body, const DressOptions& options = {});
SELVEDGE_API Result dress(const Pattern& pattern, const DressOptions& options = {});

struct ExportOptions {
    Looks looks{};                      // of the textures
    bool has_textures = true;           // in .glb, and in files beside an .obj
    int texture_size_px = 2048;         // of a side, 64 to 16384
    bool has_body = false;              // in the same file: .obj and .glb
    std::optional<double> thickness{};  // m, 0.00001 to 0.05: a closed solid with two sides; none: without
    bool has_fabric_thickness = false;  // instead: as thick as the fabrics are
    std::string surface{};              // the curved surface instead of the triangles, see PictureOptions::surface
};

// Writes the garment as .obj, .glb, .ply or .stl, by the extension, with the bytes of `selvedge dress --export`. Throws
// InputError.
SELVEDGE_API void write_garment(const Result& result, const std::filesystem::path& file,
                                const ExportOptions& options = {});

// The picture of `selvedge dress --render`, drawn in memory without a window; one thread draws at a time. Throws
// InputError, also where no OpenGL is found.
SELVEDGE_API Image draw(const Result& result, const PictureOptions& options = {});

}  // namespace selvedge
