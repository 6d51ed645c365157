#include "sim/repair/find_person.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "sim/body/joint_names.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"

namespace selvedge::sim {
namespace {

using Bounds = Eigen::AlignedBox3d;

constexpr double kWeld = 1e-7;          // of the surface's extent, as floats have: vertices nearer than this are one
constexpr std::size_t kMostTried = 24;  // pieces that are looked at, the largest first: scraps are many and small
constexpr std::size_t kTriedOtherwise = 4;  // of them, if none is a person: the line that says why gets clearer
constexpr std::size_t kFewTriangles = 64;   // of which no person is made

// Why a piece is not of the person.
enum class Fate { Kept, Beyond, Apart, Underfoot, Other };
constexpr std::array<std::pair<const char*, const char*>, 5> kFates{
    {{"", ""},
     {"it reaches beyond the person", "they reach beyond the person"},
     {"it is apart from the person", "they are apart from the person"},
     {"it lies under the person's feet", "they lie under the person's feet"},
     {"it is not of the person", "they are not of the person"}}};

// A piece of the surface, upright.
struct Piece {
    SurfacePiece surface;
    Bounds box;
    double area = 0;
    bool is_bound = false;  // to bones
};

// How far pieces belong to a person, as shares of the stature.
constexpr double kWornMargin = 0.1;   // beside and above a whole person: hats, hair, skirts
constexpr double kShoeMargin = 0.06;  // below: heels
constexpr double kReach = 0.6;        // from the middle of a person of several pieces: spread arms reach 0.5
constexpr double kCell = 1.0 / 320;   // 5 mm: what is nearer to the person than this, or twice it, touches it
constexpr double kUnderfoot = 0.015;  // how far scanned soles sink into a platform

// Which cells of a grid in a space a surface passes through.
class OccupiedCells {
 public:
    OccupiedCells(const Bounds& space, double cell) : low_(space.min()), cell_(cell) {
        for (int k = 0; k < 3; ++k) count_[std::size_t(k)] = int(std::ceil(space.sizes()[k] / cell)) + 1;
        is_occupied_.assign(std::size_t(count_[0]) * std::size_t(count_[1]) * std::size_t(count_[2]), false);
    }

    void add(const Surface& mesh, const SurfacePiece& piece) {
        for (const int t : piece.triangles) {
            const auto [a, b, c] = mesh.triangles[std::size_t(t)];
            const Vec3d &from = mesh.x[std::size_t(a)], to = mesh.x[std::size_t(b)] - from,
                        up = mesh.x[std::size_t(c)] - from;
            const int steps = int(std::clamp(std::max(to.norm(), up.norm()) / cell_, 0.0, double(kMostSteps))) + 1;
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; i + j <= steps; ++j) occupy(from + (i * to + j * up) / steps);
        }
    }

    // Whether a vertex of the piece lies in an occupied cell or beside one.
    bool touches(const Surface& mesh, const SurfacePiece& piece) const {
        return std::ranges::any_of(piece.triangles, [&](int t) {
            const std::array<int, 3>& triangle = mesh.triangles[std::size_t(t)];
            return std::ranges::any_of(triangle, [&](int v) { return is_near(mesh.x[std::size_t(v)]); });
        });
    }

    // Whether occupied cells lie above the middle of the box, below it, and to all four sides.
    bool enclose(const Bounds& box) const {
        const std::array<int, 3> middle{cell_of(box.center(), 0), cell_of(box.center(), 1), cell_of(box.center(), 2)};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const int step : {-1, 1}) {
                std::array<int, 3> at = middle;
                while (is_inside(at[0], at[1], at[2]) && !is_occupied_[index(at[0], at[1], at[2])]) at[axis] += step;
                if (!is_inside(at[0], at[1], at[2])) return false;
            }
        }
        return true;
    }

 private:
    static constexpr int kMostSteps = 256;  // along an edge: of a piece in the space, which has fewer cells

    int cell_of(const Vec3d& p, int axis) const {
        return int(std::floor(std::clamp((p[axis] - low_[axis]) / cell_, -2.0, double(count_[std::size_t(axis)]) + 2)));
    }
    bool is_inside(int i, int j, int k) const {
        return i >= 0 && j >= 0 && k >= 0 && i < count_[0] && j < count_[1] && k < count_[2];
    }
    std::size_t index(int i, int j, int k) const {
        return (std::size_t(i) * std::size_t(count_[1]) + std::size_t(j)) * std::size_t(count_[2]) + std::size_t(k);
    }
    void occupy(const Vec3d& p) {
        const int i = cell_of(p, 0), j = cell_of(p, 1), k = cell_of(p, 2);
        if (is_inside(i, j, k)) is_occupied_[index(i, j, k)] = true;
    }
    bool is_near(const Vec3d& p) const {
        for (int di = -1; di <= 1; ++di)
            for (int dj = -1; dj <= 1; ++dj)
                for (int dk = -1; dk <= 1; ++dk) {
                    const int i = cell_of(p, 0) + di, j = cell_of(p, 1) + dj, k = cell_of(p, 2) + dk;
                    if (is_inside(i, j, k) && is_occupied_[index(i, j, k)]) return true;
                }
        return false;
    }

    Vec3d low_;
    double cell_;
    std::array<int, 3> count_{};
    std::vector<bool> is_occupied_;
};

class PersonFinder {
 public:
    PersonFinder(const Surface& raw, const PersonQuestion& question) : raw_(raw), question_(question) {
        mesh_ = raw;
        Bounds box;
        for (const Vec3d& p : raw.x) box.extend(p);
        constexpr double kLeast = 1e-12;  // in the file's unit
        weld_distance_ = std::max(kLeast, raw.x.empty() ? 0 : kWeld * box.sizes().maxCoeff());
        RepairReport report;
        weld_surface(mesh_, weld_distance_, report);
        file_x_ = mesh_.x;
        for (SurfacePiece& surface : find_pieces(mesh_.triangles))
            pieces_.push_back({.surface = std::move(surface), .box = {}});
        if (question.is_bound.empty()) return;
        for (Piece& piece : pieces_) {
            piece.is_bound = std::ranges::all_of(piece.surface.triangles, [&](int t) {
                return std::ranges::all_of(mesh_.triangles[std::size_t(t)], [&](int v) {
                    return question.is_bound[std::size_t(mesh_.origin[std::size_t(v)])];
                });
            });
        }
    }

    PersonSearch find(const std::vector<Bone>& bones) {
        std::vector<Stance> stances{{.up = question_.first_up}};
        if (question_.may_be_other_up)
            stances.push_back({.up = question_.first_up == UpAxis::Z ? UpAxis::Y : UpAxis::Z});
        // Who faces a side is as deep as people are wide.
        for (std::size_t i = 0, count = stances.size(); i < count; ++i)
            stances.push_back({.up = stances[i].up, .quarter_turns = 1});
        // A whole person in any of them is one; a part, as a dress form, only in the first.
        PersonSearch found = find_in(stances.front(), bones);
        for (std::size_t i = 1; i < stances.size() && !found.likeness.is_whole(); ++i) {
            PersonSearch here = find_in(stances[i], bones);
            if (here.likeness.is_whole()) found = std::move(here);
        }
        if (found.likeness.is_person()) return turned_to_front(std::move(found), bones);
        if (stands_otherwise())
            found.likeness.lacks = "a person in it lies on a side or stands on its head: turn it upright";
        return found;
    }

 private:
    PersonSearch find_in(const Stance& stance, const std::vector<Bone>& bones) {
        turn([&](const Vec3d& p) { return stance(p); });
        skeleton_ = skeleton_box(bones, stance);
        bones_ = bones;
        for (Bone& bone : bones_) bone.joint = stance(bone.joint);
        PersonSearch found = find_upright();
        found.stance = stance;
        found.has_skeleton = !skeleton_.isEmpty();
        return found;
    }

    // 1 from our left, +x, to the front; 2 from the back.
    PersonSearch turned_to_front(PersonSearch found, const std::vector<Bone>& bones) {
        const std::optional<Vec2d> shown = skeleton_faces(bones, found.stance);
        if (!shown && !found.likeness.faces) return found;
        const Vec2d& faces = shown ? *shown : *found.likeness.faces;
        const bool is_sideways = std::abs(faces.x()) > std::abs(faces.y());
        const int turns = is_sideways ? (faces.x() > 0 ? 1 : 3) : faces.y() > 0 ? 0 : 2;
        if (turns == 0) return found;
        return find_in({.up = found.stance.up, .quarter_turns = (found.stance.quarter_turns + turns) % 4}, bones);
    }

    // Whether a piece is a person if another axis points up than those that files have.
    bool stands_otherwise() {
        using Turn = Vec3d (*)(const Vec3d&);
        skeleton_ = {};
        constexpr std::array<Turn, 4> kTurns{[](const Vec3d& p) { return Vec3d(-p.x(), -p.y(), p.z()); },
                                             [](const Vec3d& p) { return Vec3d(p.x(), -p.z(), p.y()); },
                                             [](const Vec3d& p) { return Vec3d(-p.y(), p.x(), p.z()); },
                                             [](const Vec3d& p) { return Vec3d(p.y(), -p.x(), p.z()); }};
        for (const Turn& other : kTurns) {
            for (const int quarter_turns : {0, 1}) {
                const Stance yaw{.quarter_turns = quarter_turns};
                turn([&](const Vec3d& p) { return yaw(other(p)); });
                for (const std::size_t i : largest_pieces(kTriedOtherwise))
                    if (is_large(i) && likeness_of({i}).is_whole()) return true;
            }
        }
        return false;
    }

    // How a point of the file goes to where the pieces are looked at.
    template <class Turn>
    void turn(const Turn& turned) {
        for (std::size_t v = 0; v < file_x_.size(); ++v) mesh_.x[v] = turned(file_x_[v]);
        for (Piece& piece : pieces_) {
            piece.box = {};
            for (const int t : piece.surface.triangles)
                for (const int v : mesh_.triangles[std::size_t(t)]) piece.box.extend(mesh_.x[std::size_t(v)]);
            piece.area = area(mesh_.x, mesh_.triangles, piece.surface);
        }
    }

    bool is_large(std::size_t piece) const { return pieces_[piece].surface.triangles.size() >= kFewTriangles; }

    // Where the joints of a person are; empty if the bones are not a person's.
    static Bounds skeleton_box(const std::vector<Bone>& bones, const Stance& stance) {
        Bounds box;
        const JointBones joints = find_joints(bones);
        for (const Joint needed :
             {Joint::Hips, Joint::LeftUpperLeg, Joint::RightUpperLeg, Joint::LeftUpperArm, Joint::RightUpperArm})
            if (!joints.has(needed)) return box;
        for (const int bone : joints.bone)
            if (bone >= 0) box.extend(stance(bones[std::size_t(bone)].joint));
        return box;
    }

    // x and z of where a person with these bones faces: from its right to its left, a quarter turn on. None: the bones
    // are not a person's, or do not stand.
    static std::optional<Vec2d> skeleton_faces(const std::vector<Bone>& bones, const Stance& stance) {
        const JointBones joints = find_joints(bones);
        Vec3d to_left = Vec3d::Zero();
        for (const auto& [left, right] : {std::pair(Joint::LeftUpperLeg, Joint::RightUpperLeg),
                                          std::pair(Joint::LeftUpperArm, Joint::RightUpperArm)}) {
            if (!joints.has(left) || !joints.has(right)) return std::nullopt;
            to_left += stance(bones[std::size_t(joints[left])].joint) - stance(bones[std::size_t(joints[right])].joint);
        }
        constexpr double kLevel = 0.5;  // of its length, at most, upward: the line between hips, and between shoulders
        if (!(std::abs(to_left.y()) < kLevel * to_left.norm())) return std::nullopt;
        return Vec2d(-to_left.z(), to_left.x());
    }

    // The surface of some pieces, turned outward.
    Body body_of(const std::vector<std::size_t>& parts) const {
        Body body;
        std::vector<int> place(mesh_.x.size(), -1);
        for (const std::size_t i : parts) {
            const SurfacePiece& piece = pieces_[i].surface;
            const bool is_inward = signed_volume6(mesh_.x, mesh_.triangles, piece) < 0;
            for (const int t : piece.triangles) {
                std::array<int, 3> triangle = mesh_.triangles[std::size_t(t)];
                if (is_inward) std::swap(triangle[1], triangle[2]);
                for (int& v : triangle) {
                    int& at = place[std::size_t(v)];
                    if (at < 0) {
                        at = int(body.x.size());
                        body.x.push_back(mesh_.x[std::size_t(v)]);
                    }
                    v = at;
                }
                body.triangles.push_back(triangle);
            }
        }
        return body;
    }

    // With the bones of a person that these parts are the surface of: they show where it ends under its clothes.
    PersonLikeness likeness_of(const std::vector<std::size_t>& parts) {
        Body body = body_of(parts);
        if (fit_skeleton(parts)) body.bones = bones_;
        cuts_ += cuts_of_likeness(body);
        if (cuts_ > question_.most_cuts)
            throw InputError(question_.file, "",
                             "its triangles are too long and too many to look for a person among them");
        return person_likeness(body);
    }

    // By area, the largest first.
    std::vector<std::size_t> largest_pieces(std::size_t most) const {
        std::vector<std::size_t> order(pieces_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t i) { return pieces_[i].area; });
        order.resize(std::min(order.size(), most));
        return order;
    }

    PersonSearch find_upright() {
        PersonSearch found;
        std::vector<std::size_t> persons;
        for (const std::size_t i : largest_pieces(kMostTried)) {
            if (!is_large(i)) continue;
            PersonLikeness likeness = likeness_of({i});
            if (!likeness.is_person() || (found.likeness.is_whole() && !likeness.is_whole())) continue;
            if (likeness.is_whole() && !found.likeness.is_whole()) persons.clear();
            if (persons.empty()) found.likeness = std::move(likeness);
            persons.push_back(i);
        }
        if (persons.empty() || is_part_of(persons.front())) return find_in_pieces();
        check_alone(persons);
        const std::size_t main = persons.front();
        const int on_it = mesh_.triangles[std::size_t(pieces_[main].surface.triangles.front())][0];
        found.on_the_person = file_x_[std::size_t(on_it)];
        keep_what_is_worn(main, found);
        return found;
    }

    // A trunk alone is a person without limbs, but not where a skeleton in it shows them.
    bool is_part_of(std::size_t piece) const {
        if (!fit_skeleton({piece})) return false;
        Bounds near = pieces_[piece].box;
        const Vec3d margin = Vec3d::Constant(kWornMargin * skeleton_.sizes().y());
        return !near.extend(Vec3d(near.min() - margin)).extend(Vec3d(near.max() + margin)).contains(skeleton_);
    }

    // Persons inside each other are one in two layers; beside each other, nobody knows which is meant.
    void check_alone(const std::vector<std::size_t>& persons) const {
        const Bounds& first = pieces_[persons.front()].box;
        for (const std::size_t i : persons) {
            const Bounds common = first.intersection(pieces_[i].box);
            const double smaller = std::min(first.volume(), pieces_[i].box.volume());
            constexpr double kSame = 0.5;  // of the smaller box
            if (!common.isEmpty() && common.volume() > kSame * smaller) continue;
            throw InputError(question_.file, "",
                             "it holds " + count_text(persons.size(), "person") + ": leave one of them in the file");
        }
    }

    // The space in which what belongs to a person of this one piece lies.
    Bounds space_round(std::size_t main, const PersonLikeness& likeness) const {
        const Stature& stature = likeness.stature;
        const double height = stature.height();
        Bounds space = pieces_[main].box;
        const double beside = likeness.is_whole() ? kWornMargin * height : 0;
        space.min() -= Vec3d(beside, 0, beside);
        space.max() += Vec3d(beside, 0, beside);
        if (!likeness.is_whole()) {
            const Vec3d middle = space.center();
            const Vec3d reach(kReach * height, 0, kReach * height);
            space.extend(Vec3d(middle - reach)).extend(Vec3d(middle + reach));
        }
        space.min().y() = stature.floor - kShoeMargin * height;
        space.max().y() = stature.crown + kWornMargin * height;
        return space;
    }

    // Leaves out what does not belong to the person of one piece.
    void keep_what_is_worn(std::size_t main, PersonSearch& found) const {
        const double height = found.likeness.stature.height();
        const Bounds space = space_round(main, found.likeness);
        OccupiedCells near(space, kCell * height);
        near.add(mesh_, pieces_[main].surface);
        std::vector<Fate> fate(pieces_.size(), Fate::Kept);
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (i == main) continue;
            const Bounds& box = pieces_[i].box;
            if (!space.contains(box))
                fate[i] = space.intersects(box) ? Fate::Beyond : Fate::Apart;
            else if (found.likeness.stature.has_legs &&
                     box.max().y() < found.likeness.stature.floor + kUnderfoot * height)
                fate[i] = Fate::Underfoot;
        }
        // What touches the person or is in it, as eyes are, belongs to it; if it is not whole, also what
        // touches that.
        std::vector<bool> is_worn(pieces_.size(), false);
        is_worn[main] = true;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (!pieces_[i].is_bound || !fit_skeleton({i})) continue;
            is_worn[i] = true;
            fate[i] = Fate::Kept;
        }
        constexpr int kMostRounds = 8;  // from the person outward: a head, its hair, a pin in that
        bool is_changed = true;
        for (int round = 0; round < kMostRounds && is_changed; ++round) {
            is_changed = false;
            for (std::size_t i = 0; i < pieces_.size(); ++i) {
                if (is_worn[i] || fate[i] != Fate::Kept) continue;
                if (!near.touches(mesh_, pieces_[i].surface) && !near.enclose(pieces_[i].box)) continue;
                is_worn[i] = is_changed = true;
                if (!found.likeness.is_whole()) near.add(mesh_, pieces_[i].surface);
            }
        }
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (!is_worn[i] && fate[i] == Fate::Kept) fate[i] = Fate::Apart;
        leave_out(fate, found);
    }

    // A person whose parts are pieces: all pieces but the widest, one after the other, until what is left is a person.
    PersonSearch find_in_pieces() {
        PersonSearch found;
        std::vector<std::size_t> parts;
        const bool are_bound = !skeleton_.isEmpty() && most_are_bound();
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (!are_bound || pieces_[i].is_bound) parts.push_back(i);
        std::ranges::stable_sort(parts, std::ranges::less(),
                                 [&](std::size_t i) { return pieces_[i].box.diagonal().norm(); });
        std::vector<Fate> fate(pieces_.size(), Fate::Other);
        for (const std::size_t i : parts) fate[i] = Fate::Kept;
        for (std::size_t tried = 0; !parts.empty() && tried < kMostTried; ++tried) {
            PersonLikeness likeness = likeness_of(parts);
            if (fit_skeleton(parts)) show_person(parts, likeness);
            if (tried == 0 || likeness.is_person()) found.likeness = std::move(likeness);
            if (found.likeness.is_person()) break;
            fate[parts.back()] = Fate::Other;
            parts.pop_back();
        }
        if (!found.likeness.is_person()) return found;
        drop_platform(parts, fate);
        leave_out(fate, found);
        return found;
    }

    // A person as its skeleton shows it, and whole if the parts reach beyond both ends of that.
    void show_person(const std::vector<std::size_t>& parts, PersonLikeness& likeness) const {
        likeness.lacks.clear();
        Bounds all;
        for (const std::size_t i : parts) all.extend(pieces_[i].box);
        if (all.min().y() > skeleton_.min().y() || all.max().y() < skeleton_.max().y()) return;
        likeness.stature = {.floor = all.min().y(), .crown = all.max().y()};
    }

    bool most_are_bound() const {
        double bound = 0, all = 0;
        for (const Piece& piece : pieces_) {
            bound += piece.is_bound ? piece.area : 0;
            all += piece.area;
        }
        return bound > all / 2;
    }

    // Whether there is a person's skeleton, and the surface of that person can reach so far.
    bool fit_skeleton(const std::vector<std::size_t>& parts) const {
        if (skeleton_.isEmpty()) return false;
        const double margin = kReach * skeleton_.sizes().y();
        Bounds space(skeleton_.min() - Vec3d::Constant(margin), skeleton_.max() + Vec3d::Constant(margin));
        return std::ranges::all_of(parts, [&](std::size_t i) { return space.contains(pieces_[i].box); });
    }

    // A person of several pieces stands on what lies wholly below all others.
    void drop_platform(const std::vector<std::size_t>& parts, std::vector<Fate>& fate) const {
        if (parts.size() < 3) return;
        Bounds all;
        double lowest = std::numeric_limits<double>::infinity(), second = lowest;
        for (const std::size_t i : parts) {
            const double bottom = pieces_[i].box.min().y();
            second = std::min(second, std::max(lowest, bottom));
            lowest = std::min(lowest, bottom);
            all.extend(pieces_[i].box);
        }
        for (const std::size_t i : parts) {
            const Bounds& box = pieces_[i].box;
            const double others = box.min().y() > lowest ? lowest : second;
            if (box.max().y() < others + kUnderfoot * all.sizes().y()) fate[i] = Fate::Underfoot;
        }
    }

    // fate: per piece.
    void leave_out(const std::vector<Fate>& fate, PersonSearch& found) const {
        for (const Fate one : {Fate::Beyond, Fate::Apart, Fate::Underfoot, Fate::Other}) {
            std::size_t pieces = 0, triangles = 0;
            for (std::size_t i = 0; i < pieces_.size(); ++i) {
                if (fate[i] != one) continue;
                ++pieces;
                triangles += pieces_[i].surface.triangles.size();
            }
            const auto& [singular, plural] = kFates[std::size_t(one)];
            const std::string of_triangles = " of " + count_text(triangles, "triangle");
            if (pieces == 1) found.left_out.push_back("a piece" + of_triangles + ": " + singular);
            if (pieces > 1)
                found.left_out.push_back(std::to_string(pieces) + " pieces" + of_triangles + " together: " + plural);
        }
        if (found.left_out.empty()) return;
        const std::vector<std::vector<std::size_t>> pieces_at = pieces_of_raw_vertices();
        for (const std::array<int, 3>& triangle : raw_.triangles)
            found.is_kept.push_back(fate[piece_of(triangle, pieces_at)] == Fate::Kept);
    }

    // Several pieces may meet at a place.
    std::vector<std::vector<std::size_t>> pieces_of_raw_vertices() const {
        const std::vector<int> same = weld(raw_.x, weld_distance_);
        std::vector<std::vector<std::size_t>> pieces_at(raw_.x.size());
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            for (const int t : pieces_[i].surface.triangles)
                for (const int v : mesh_.triangles[std::size_t(t)]) {
                    std::vector<std::size_t>& here =
                        pieces_at[std::size_t(same[std::size_t(mesh_.origin[std::size_t(v)])])];
                    if (here.empty() || here.back() != i) here.push_back(i);
                }
        }
        for (std::size_t v = 0; v < same.size(); ++v) pieces_at[v] = pieces_at[std::size_t(same[v])];
        return pieces_at;
    }

    // The piece at all corners of a triangle; that at one of them if none is, as where triangles were left out.
    static std::size_t piece_of(const std::array<int, 3>& triangle,
                                const std::vector<std::vector<std::size_t>>& pieces_at) {
        const auto at = [&](std::size_t k) -> const std::vector<std::size_t>& {
            return pieces_at[std::size_t(triangle[k])];
        };
        const auto is_at = [&](std::size_t k, std::size_t piece) {
            return std::ranges::find(at(k), piece) != at(k).end();
        };
        for (const std::size_t piece : at(0))
            if (is_at(1, piece) && is_at(2, piece)) return piece;
        for (std::size_t k = 0; k < 3; ++k)
            if (!at(k).empty()) return at(k).front();
        return 0;
    }

    const Surface& raw_;
    const PersonQuestion& question_;
    Surface mesh_;               // welded and cut; x: upright
    std::vector<Vec3d> file_x_;  // of its vertices, in the file's axes
    double weld_distance_ = 0;
    std::vector<Piece> pieces_;
    Bounds skeleton_;          // of a person, as the pieces are turned: where its joints are; empty: there is none
    std::vector<Bone> bones_;  // with their joints there
    double cuts_ = 0;          // of triangles, so far
};

}  // namespace

PersonSearch find_person(const Surface& surface, const std::vector<Bone>& bones, const PersonQuestion& question) {
    return PersonFinder(surface, question).find(bones);
}

}  // namespace selvedge::sim
