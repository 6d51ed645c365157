#pragma once
// Finds the person among the pieces of an imported surface: not its largest piece, which may be the platform of a
// scanner, a floor, a room or a sphere that holds a rig's bones, but the one that looks like a person
// (sim/body/person_likeness.h). A person of several pieces is found by taking away the widest ones that are not of it.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/person_likeness.h"
#include "sim/repair/surface_repair.h"

namespace selvedge::sim {

enum class UpAxis { Auto, Y, Z };

// How a file's axes are turned to ours. Z up follows the convention of Blender and CAD: the body faces -y.
struct Stance {
    UpAxis up = UpAxis::Y;
    int quarter_turns = 0;  // about the vertical, after that: 1 turns what faces our left, +x, to the front

    Vec3d operator()(const Vec3d& p) const {
        Vec3d turned = up == UpAxis::Z ? Vec3d(p.x(), p.z(), -p.y()) : p;
        for (int i = 0; i < quarter_turns; ++i) turned = Vec3d(-turned.z(), turned.y(), turned.x());
        return turned;
    }
};

struct PersonSearch {
    PersonLikeness likeness;    // of what was found, in that stance, in the file's unit; why it is no person otherwise
    Stance stance;              // in which the person stands and faces the front
    bool has_skeleton = false;  // of a person
    std::vector<bool> is_kept;  // per triangle of the surface; empty: all
    std::vector<std::string> left_out;   // one description with the reason for each kind of piece
    std::optional<Vec3d> on_the_person;  // a vertex of the person's own piece, in the file's axes and unit; none: the
                                         // person is of several pieces, or was not found
};

// Surface and bones are in the file's unit and axes. first_up: Y or Z, the axis that is tried first; the other is tried
// if it may be. A skeleton with the joints of a person shows one whatever its surface is like, and what is bound to it
// belongs to the person, as far as a person reaches. Throws InputError with `file` if several persons stand beside each
// other, or if the search takes too long.
struct PersonQuestion {
    std::string file;
    UpAxis first_up = UpAxis::Y;
    bool may_be_other_up = true;
    std::vector<bool> is_bound{};  // per vertex: whether bones move it; empty: none

    // Triangles that are cut by planes before the search ends: about two seconds. Those of a body of games or of a
    // scan are short: 600,000 are cut at most.
    double most_cuts = 2e7;
};
PersonSearch find_person(const Surface& surface, const std::vector<Bone>& bones, const PersonQuestion& question);

}  // namespace selvedge::sim
