#include "sim/collide/jointed_collider.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace selvedge::sim {
namespace {

// Distance from the bounding box of a surface, m; 0 inside.
float distance_to_box(const SurfaceBvh& surface, const Vec3f& p) {
    return (surface.low() - p).cwiseMax(p - surface.high()).cwiseMax(0.0F).norm();
}

// The largest depth that a point in the bounding box can have inside the surface, m: its distance from the box's faces.
float deepest_in_box(const SurfaceBvh& surface, const Vec3f& p) {
    return (p - surface.low()).cwiseMin(surface.high() - p).minCoeff();
}

}  // namespace

JointedCollider::JointedCollider(Body trunk, const std::vector<BodyPiece>& pieces,
                                 const std::function<void()>& interrupt, const ContentStore* store)
    : trunk_body_(std::move(trunk)), trunk_(trunk_body_, {}, interrupt, store) {
    for (const BodyPiece& piece : pieces)
        pieces_.push_back({SurfaceBvh(piece.surface), piece.joint.cast<float>(), Eigen::Quaternionf::Identity()});
}

void JointedCollider::reshape(std::size_t piece, std::span<const Vec3f> points) {
    SurfaceBvh& surface = pieces_[piece].surface;
    surface.sweep_to(points);
    surface.arrive();
    surface.sweep_to(points);  // its boxes then hold only where it is
}

float JointedCollider::distance_to_piece(std::size_t piece, const Vec3f& p, float reach) const {
    const Piece& one = pieces_[piece];
    const auto closest = one.surface.closest(one.to_rest(p), std::numeric_limits<float>::infinity());
    return closest ? std::min(closest->distance, reach) : reach;
}

bool JointedCollider::meets_piece(std::size_t piece, const Vec3f& from, const Vec3f& to) const {
    const Piece& one = pieces_[piece];
    return one.surface.first_hit(one.to_rest(from), one.to_rest(to)).has_value();
}

// Beyond `reach` the result may be too small: then it is the distance from the piece's box, or as far as was searched.
void JointedCollider::take_nearer(const Piece& piece, const Vec3f& p, float reach, Contact& contact) const {
    constexpr float kMargin = 0.001F;  // m, so that a distance of exactly the reach is found
    constexpr float kFar = 0.05F;      // m, searched in the box: contact caches last longer with a larger distance
    const Vec3f at = piece.to_rest(p);
    const float from_box = distance_to_box(piece.surface, at);
    if (from_box >= contact.distance) return;
    if (from_box > reach) {
        contact.distance = from_box;
        return;
    }
    const float deepest = from_box > 0 ? 0 : deepest_in_box(piece.surface, at) + kMargin;
    const float searched = from_box > 0 ? reach + kMargin : std::max({reach + kMargin, kFar, deepest});
    const auto closest = piece.surface.closest(at, std::max(deepest, std::min(searched, contact.distance + kMargin)));
    if (!closest) {
        contact.distance = std::min(contact.distance, searched);
    } else if (closest->distance < contact.distance) {
        contact = {closest->distance, piece.turn * closest->normal};
    }
}

Contact JointedCollider::contact(const Vec3f& p) const {
    Contact contact = trunk_.contact(p);
    for (const Piece& piece : pieces_) take_nearer(piece, p, band(), contact);
    return contact;
}

void JointedCollider::contacts(std::span<ContactBlock> blocks, float reach) const {
    trunk_.contacts(blocks, reach);
    for (ContactBlock& block : blocks) add_pieces(block, 0xFFFF, reach);
}

void JointedCollider::contacts_apart(std::span<ContactBlock> blocks, std::span<const std::uint16_t> trunk_only,
                                     float reach) const {
    trunk_.contacts(blocks, reach);
    for (std::size_t b = 0; b < blocks.size(); ++b) add_pieces(blocks[b], ~unsigned{trunk_only[b]}, reach);
}

void JointedCollider::add_pieces(ContactBlock& block, unsigned slots, float reach) const {
    for (std::size_t i = 0; i < kContactLanes; ++i) {
        if ((slots >> i & 1U) == 0) continue;
        Contact contact{block.distance[i], {block.nx[i], block.ny[i], block.nz[i]}};
        for (const Piece& piece : pieces_) take_nearer(piece, block.point(i), reach, contact);
        block.set(i, contact);
    }
}

std::optional<SurfaceHit> JointedCollider::first_hit(const Vec3f& from, const Vec3f& to) const {
    std::optional<SurfaceHit> first = trunk_.first_hit(from, to);
    for (const Piece& piece : pieces_) {
        std::optional<SurfaceHit> hit = piece.surface.first_hit(piece.to_rest(from), piece.to_rest(to));
        if (!hit || (first && first->fraction <= hit->fraction)) continue;
        hit->point = from + hit->fraction * (to - from);
        hit->normal = piece.turn * hit->normal;
        first = hit;
    }
    return first;
}

}  // namespace selvedge::sim
