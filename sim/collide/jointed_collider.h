#pragma once
// Collider of a body that is taken apart: a fixed trunk, and limbs as pieces. Each limb can be left out, turned about
// the joint at which it was cut off, or given another shape. Its contacts are those of the union of all parts.
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "sim/body/body.h"
#include "sim/collide/body_collider.h"
#include "sim/collide/collider.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

class ContentStore;

// A closed surface, in the frame of the body, that turns about its joint.
struct BodyPiece {
    Body surface;
    Vec3d joint = Vec3d::Zero();  // m
};

class JointedCollider final : public Collider {
 public:
    // Pre: the surfaces are closed. interrupt, store: see BodyCollider.
    JointedCollider(Body trunk, const std::vector<BodyPiece>& pieces, const std::function<void()>& interrupt = {},
                    const ContentStore* store = nullptr);

    // Turns a piece from where the body has it. After it the contact caches of cloths are invalid (forget_contacts).
    void turn(std::size_t piece, const Eigen::Quaternionf& turn) { pieces_[piece].turn = turn; }
    // Moves the vertices of a piece to these points (m), as many as it has. The same holds for contact caches.
    void reshape(std::size_t piece, std::span<const Vec3f> points);

    // The signed distance from a piece as it is turned, m; at most `reach` is exact, and more is returned as `reach`.
    float distance_to_piece(std::size_t piece, const Vec3f& p, float reach) const;
    // Whether the segment meets the surface of a piece as it is turned.
    bool meets_piece(std::size_t piece, const Vec3f& from, const Vec3f& to) const;
    std::size_t piece_count() const { return pieces_.size(); }

    Contact contact(const Vec3f& p) const override;
    void contacts(std::span<ContactBlock> blocks, float reach) const override;
    void contacts_apart(std::span<ContactBlock> blocks, std::span<const std::uint16_t> trunk_only,
                        float reach) const override;
    bool costs_by_slot() const override { return true; }
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override;
    float band() const override { return trunk_.band(); }
    float max_error() const override { return trunk_.max_error(); }

 private:
    struct Piece {
        SurfaceBvh surface;
        Vec3f joint;
        Eigen::Quaternionf turn = Eigen::Quaternionf::Identity();

        Vec3f to_rest(const Vec3f& p) const { return joint + turn.conjugate() * (p - joint); }
    };

    void add_pieces(ContactBlock& block, unsigned slots, float reach) const;
    void take_nearer(const Piece& piece, const Vec3f& p, float reach, Contact& contact) const;

    Body trunk_body_;  // outlives trunk_
    BodyCollider trunk_;
    std::vector<Piece> pieces_;
};

}  // namespace selvedge::sim
