#include "render/depth_pass.h"

#include <algorithm>
#include <cmath>

#include "render/gl/gl.h"
#include "render/shaders.h"
#include "sim/core/assert.h"

namespace selvedge {
namespace {

GLsizeiptr byte_size(std::size_t count, std::size_t size) {
    return static_cast<GLsizeiptr>(count * size);
}

}  // namespace

Bounds bounds_of(const std::vector<Vec3f>& points) {
    SELVEDGE_ASSERT(!points.empty());
    Vec3f low = points.front(), high = points.front();
    for (const Vec3f& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    Bounds bounds{.centre = (low + high) / 2, .radius = 0};
    for (const Vec3f& point : points) bounds.radius = std::max(bounds.radius, (point - bounds.centre).norm());
    bounds.radius = std::max(bounds.radius * 1.02F, 0.01F);
    return bounds;
}

Eigen::Matrix4f parallel_matrix(const Bounds& bounds, const Vec3f& direction) {
    const Vec3f helper = std::abs(direction.y()) < 0.9F ? Vec3f(Vec3f::UnitY()) : Vec3f(Vec3f::UnitX());
    const Vec3f right = helper.cross(direction).normalized();
    const Vec3f up = direction.cross(right);
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.block<1, 3>(0, 0) = right.transpose() / bounds.radius;
    matrix.block<1, 3>(1, 0) = up.transpose() / bounds.radius;
    matrix.block<1, 3>(2, 0) = -direction.transpose() / bounds.radius;
    matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * bounds.centre;
    return matrix;
}

DepthPass::DepthPass(const GladGLContext& gl, const Casters& casters, int side_px)
    : gl_(gl),
      side_px_(side_px),
      index_count_(static_cast<int>(casters.triangles.size() * 3)),
      program_(make_program(gl, {"depth.vert"}, {"depth.frag"})),
      vertex_array_(gl),
      positions_(gl),
      indices_(gl),
      depth_(gl),
      framebuffer_(gl) {
    gl.BindVertexArray(vertex_array_.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, positions_.id());
    gl.BufferData(GL_ARRAY_BUFFER, byte_size(casters.x.size(), sizeof(Vec3f)), casters.x.data(), GL_STATIC_DRAW);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), nullptr);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, byte_size(casters.triangles.size(), sizeof(casters.triangles[0])),
                  casters.triangles.data(), GL_STATIC_DRAW);

    gl.BindTexture(GL_TEXTURE_2D, depth_.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, side_px, side_px, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    SELVEDGE_ASSERT(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void DepthPass::draw(const Eigen::Matrix4f& matrix) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl_.Viewport(0, 0, side_px_, side_px_);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    program_.use();
    program_.set("camera", matrix);
    gl_.BindVertexArray(vertex_array_.id());
    gl_.DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

std::vector<float> DepthPass::read() const {
    std::vector<float> depths(static_cast<std::size_t>(side_px_) * static_cast<std::size_t>(side_px_));
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl_.ReadPixels(0, 0, side_px_, side_px_, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    return depths;
}

}  // namespace selvedge
