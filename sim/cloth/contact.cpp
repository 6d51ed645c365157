#include "sim/cloth/contact.h"

#include <algorithm>
#include <cmath>

#include "sim/body/collider.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/kernels.h"

namespace selvedge {
namespace {

// By how much a distance is taken to be too large, m: never less than the collider says.
float slack_margin(const Collider& body) {
    constexpr float kLeast = 0.0007F;
    return std::max(kLeast, body.max_error());
}

Vec4f mixed(const std::vector<Vec4f>& points, const ContactSample& sample) {
    Vec4f sum = points[sample.vertices[0]] * sample.shares[0] + points[sample.vertices[1]] * sample.shares[1] +
                points[sample.vertices[2]] * sample.shares[2];
    sum.w() = 0;
    return sum;
}

// Moves the sample's vertices so that the sample moves by `shift`, each in proportion to its share of it. What is moved
// only every so many sub-steps gains as much less speed by it.
void move_sample(SolverState& solver, const ContactSample& sample, const Vec4f& shift, float still) {
    std::array<float, 3> shares{};
    float sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        shares[i] = solver.points[sample.vertices[i]].w() > 0 ? sample.shares[i] : 0.0F;
        sum += shares[i] * shares[i];
    }
    if (sum <= 0) return;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec4f moved = shift * (shares[i] / sum);
        solver.points[sample.vertices[i]] += moved;
        solver.before[sample.vertices[i]] += moved * still;
    }
}

// Coulomb: the tangential move since the last sub-step shrinks by up to friction times the depth.
void apply_contact(SolverState& solver, const ContactSample& sample, const Vec4f& normal, float depth, float friction,
                   float still) {
    move_sample(solver, sample, normal * depth, still);
    const Vec4f moved = mixed(solver.points, sample) - mixed(solver.before, sample);
    const Vec4f tangential = moved - normal * moved.dot(normal);
    const float length = tangential.norm();
    if (friction <= 0 || length <= 1e-12F) return;
    move_sample(solver, sample, tangential * -std::min(1.0F, friction * depth / length), still);
}

void push_off_floor(SolverState& solver, const ContactSample& sample, const ContactOptions& options, float still) {
    const float depth = options.offset - (mixed(solver.points, sample).y() - options.floor);
    if (depth > 0) {
        apply_contact(solver, sample, Vec4f::UnitY(), depth, sample.friction * options.friction_scale, still);
    }
}

// The samples that must ask, and where they are.
void find_asking_samples(const SolverState& solver, ContactState& contacts) {
    contacts.asking.clear();
    for (std::size_t i = 0; i < contacts.samples.size(); ++i) {
        ContactSample& sample = contacts.samples[i];
        const Vec4f x = mixed(solver.points, sample);
        if (sample.slack > 0 && (x - sample.asked_at).squaredNorm() < sample.slack * sample.slack) continue;
        sample.asked_at = x;
        contacts.asking.push_back(static_cast<std::uint32_t>(i));
    }
}

// One after the other, each from where those before have moved it: what it is too deep is less by that.
void reply_to_sample(SolverState& solver, ContactSample& sample, const Contact& said, const ContactOptions& options,
                     float margin, float still) {
    if (sample.slack == ContactSample::kNew) still = 1;  // what it stands in so deep it has not run into
    sample.slack = said.distance - options.offset - margin;
    if (said.distance >= options.offset) return;
    const Vec4f normal = padded(said.normal);
    const float moved = normal.dot(mixed(solver.points, sample) - sample.asked_at);
    const float depth = options.offset - said.distance - moved;
    if (depth > 0) apply_contact(solver, sample, normal, depth, sample.friction * options.friction_scale, still);
}

void refresh_friction(const Cloth& cloth, std::vector<float>& friction) {
    friction.assign(cloth.x.size() + 1, 0.0F);
    for (const LeafTriangle& triangle : cloth.mesh.leaf_triangles()) {
        const float mu = static_cast<float>(cloth.fabrics[triangle.panel].friction);
        for (const VertexId v : triangle.v) friction[v.value] = std::max(friction[v.value], mu);
    }
}

void add_edges(const Cloth& cloth, float spacing, const std::vector<float>& friction,
               std::vector<ContactSample>& samples) {
    for (const LeafEdge& edge : cloth.mesh.leaf_edges()) {
        const int count = static_cast<int>(std::ceil(edge.rest_length / spacing)) - 1;
        for (int i = 1; i <= count; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(count + 1);
            samples.push_back({.vertices = {edge.a.value, edge.b.value, edge.b.value},
                               .shares = {1 - t, t, 0},
                               .friction = std::max(friction[edge.a.value], friction[edge.b.value])});
        }
    }
}

float longest_edge(const std::array<Vec2f, 3>& u) {
    return std::sqrt(std::max({(u[1] - u[0]).squaredNorm(), (u[2] - u[1]).squaredNorm(), (u[0] - u[2]).squaredNorm()}));
}

void add_triangles(const Cloth& cloth, float least_edge, std::vector<ContactSample>& samples) {
    constexpr float kThird = 1.0F / 3.0F;
    for (const LeafTriangle& triangle : cloth.mesh.leaf_triangles()) {
        if (longest_edge(triangle.u) < least_edge) continue;
        samples.push_back({.vertices = {triangle.v[0].value, triangle.v[1].value, triangle.v[2].value},
                           .shares = {kThird, kThird, kThird},
                           .friction = static_cast<float>(cloth.fabrics[triangle.panel].friction)});
    }
}

// What the collider says of `count` points, sixteen by sixteen; the last block is filled up with the last point.
template <class PointAt>
void ask(std::vector<ContactBlock>& blocks, std::size_t count, const PointAt& point_at, const Collider& body,
         float reach) {
    blocks.resize((count + kBlock - 1) / kBlock);
    for (std::size_t i = 0; i < blocks.size() * kBlock; ++i) {
        const Vec4f& p = point_at(std::min(i, count - 1));
        ContactBlock& block = blocks[i / kBlock];
        block.x[i % kBlock] = p.x();
        block.y[i % kBlock] = p.y();
        block.z[i % kBlock] = p.z();
    }
    body.contacts(blocks, reach);
}

}  // namespace

void refresh_contacts(Cloth& cloth, const ContactOptions& options) {
    constexpr float kAskNow = -1;
    ContactState& contacts = cloth.contacts;
    contacts.asked.resize(cloth.x.size() + 1, Vec4f(0, 0, 0, kAskNow));
    refresh_friction(cloth, contacts.friction);
    contacts.samples.clear();
    add_edges(cloth, options.sample_spacing, contacts.friction, contacts.samples);
    add_triangles(cloth, options.sampled_edge, contacts.samples);
}

void forget_contacts(Cloth& cloth) {
    for (Vec4f& asked : cloth.contacts.asked) asked.w() = -1;
    for (ContactSample& sample : cloth.contacts.samples) sample.slack = ContactSample::kNew;
}

void push_out_samples(Cloth& cloth, const Collider& body, const ContactOptions& options) {
    SolverState& solver = cloth.solver;
    ContactState& contacts = cloth.contacts;
    const float still = 1 - 1 / static_cast<float>(options.sample_interval);
    const float margin = slack_margin(body);
    find_asking_samples(solver, contacts);
    if (contacts.asking.empty()) return;
    const auto asked_at = [&](std::size_t i) -> const Vec4f& { return contacts.samples[contacts.asking[i]].asked_at; };
    ask(contacts.blocks, contacts.asking.size(), asked_at, body, options.offset);
    for (std::size_t i = 0; i < contacts.asking.size(); ++i) {
        const ContactBlock& block = contacts.blocks[i / kBlock];
        const std::size_t at = i % kBlock;
        const Contact said{block.distance[at], Vec3f(block.nx[at], block.ny[at], block.nz[at])};
        reply_to_sample(solver, contacts.samples[contacts.asking[i]], said, options, margin, still);
    }
}

void hold_vertices(Cloth& cloth, const Kernels& loops, const Collider& body, float longest_move,
                   const ContactOptions& options) {
    ContactState& contacts = cloth.contacts;
    SolverState& solver = cloth.solver;
    contacts.asking.resize(solver.points.size() + kBlock);
    const std::size_t count = loops.hold_moves(
        floats(solver.points), floats(solver.before), floats(contacts.asked), solver.points.size() - 1,
        {.longest_move = longest_move, .floor = options.floor + options.offset}, contacts.asking.data());
    if (count == 0) return;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t v = contacts.asking[i] / 4;
        if (solver.points[v].y() >= options.floor + options.offset) continue;
        push_off_floor(solver, {.vertices = {v, v, v}, .shares = {1, 0, 0}, .friction = contacts.friction[v]}, options,
                       0);
    }
    const std::uint32_t spare = static_cast<std::uint32_t>(4 * (solver.points.size() - 1));
    std::fill_n(contacts.asking.begin() + static_cast<std::ptrdiff_t>(count), kBlock, spare);
    const auto point_at = [&](std::size_t i) -> const Vec4f& { return solver.points[contacts.asking[i] / 4]; };
    ask(contacts.blocks, (count + kBlock - 1) / kBlock * kBlock, point_at, body, options.offset);
    const float margin = slack_margin(body);
    for (std::size_t i = 0; i < contacts.blocks.size(); ++i) {
        const ContactBlock& block = contacts.blocks[i];
        const ContactReply said{.x = block.x.data(),
                                .y = block.y.data(),
                                .z = block.z.data(),
                                .distance = block.distance.data(),
                                .nx = block.nx.data(),
                                .ny = block.ny.data(),
                                .nz = block.nz.data(),
                                .offset = options.offset,
                                .margin = margin,
                                .friction_scale = options.friction_scale};
        loops.reply(said, &contacts.asking[i * kBlock], contacts.friction.data(), floats(solver.before),
                    floats(solver.points), floats(contacts.asked));
    }
}

Vec3f outside(const Vec3f& x, const Vec3f& outward, const Collider& body, float offset) {
    constexpr float kReach = 0.05F;  // m
    const Contact contact = body.contact(x);
    if (contact.distance >= offset) return x;
    const Vec3f nearest = x + contact.normal * (offset - contact.distance);
    if (contact.normal.dot(outward) >= 0 || outward.squaredNorm() <= 0) return nearest;
    const Vec3f direction = outward.normalized();
    const auto ahead = body.first_hit(x, x + direction * kReach);
    if (ahead) return ahead->point + direction * offset;
    const auto behind = body.first_hit(x, x - direction * kReach);
    return behind && contact.distance > 0 ? Vec3f(behind->point + direction * offset) : nearest;
}

}  // namespace selvedge
