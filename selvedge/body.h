#pragma once
// Bodies that are dressed: mannequins from measurements, and surfaces from files.
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "selvedge/export.h"

namespace selvedge {

// A body: a closed surface, in metres; y up, +z to the front, +x to the body's left, the floor at y = 0. It does not
// change; copies share it, and several threads may use it.
class SELVEDGE_API Body {
 public:
    struct Content;  // of the library

    explicit Body(std::shared_ptr<const Content> content);
    Body(const Body&);
    Body& operator=(const Body&);
    ~Body();

    const std::string& name() const;
    std::vector<std::array<double, 3>> positions() const;         // of its vertices, m
    std::vector<std::array<std::uint32_t, 3>> triangles() const;  // anticlockwise seen from outside
    std::map<std::string, double> measures() const;  // of a mannequin: as measured on its surface, m; of others empty
    double height() const;                           // of the highest point over the floor, m
    std::vector<std::string> notes() const;  // a sentence per measure that was not met, and per repair of a file

    const Content& content() const { return *content_; }

 private:
    std::shared_ptr<const Content> content_;
};

enum class Sex { Female, Male };

struct MannequinOptions {
    Sex sex = Sex::Female;
    // Lengths and girths by name, m: height, inseam, waist_height, shoulder, arm; bust, underbust, waist, high_hip,
    // hip, neck, biceps, elbow, forearm, wrist, thigh, mid_thigh, knee, calf, ankle. Those that are absent follow from
    // the others.
    std::map<std::string, double> measures{};
    int resolution = 2;              // steps of subdivision, 1 to 4
    std::optional<double> stance{};  // rad, of each leg outward from the vertical; none: 0.016
};

// Throws InputError for a name that is no measure, and for a value out of its range.
SELVEDGE_API Body make_mannequin(const MannequinOptions& options = {});

// As the command's --body takes it: "mannequin:sex=female,bust=92,waist=74" (cm), or a file. Throws InputError.
SELVEDGE_API Body make_body(const std::string& text);

enum class LengthUnit { Auto, Metres, Decimetres, Centimetres, Millimetres, Inches, Feet, Poser };
enum class UpAxis { Auto, Y, Z };

struct BodyFileOptions {
    LengthUnit unit = LengthUnit::Auto;  // of the file; Auto: by the person's size
    UpAxis up = UpAxis::Auto;            // its axis that points up
};

// Reads OBJ, glTF, GLB or FBX and repairs the surface. The file is parsed in a child process, which is a fork of the
// caller's without exec. Throws InputError if it cannot be read, holds no person, or its surface cannot be closed.
SELVEDGE_API Body load_body(const std::filesystem::path& file, const BodyFileOptions& options = {});

// Writes the surface as .obj, .glb, .ply or .stl, by the extension. Throws InputError.
SELVEDGE_API void write_body(const Body& body, const std::filesystem::path& file);

}  // namespace selvedge
