#pragma once
// A GLSL program: its sources compiled and linked, its uniforms set by name.
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/vec.h"

struct GladGLContext;

namespace selvedge {

struct ShaderText {
    std::string name;  // for errors
    std::string text;
};

class Program {
 public:
    // The texts of a stage are joined under one #version line. Throws std::runtime_error with the compiler's words.
    Program(const GladGLContext& gl, const std::vector<ShaderText>& vertex, const std::vector<ShaderText>& fragment);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const;

    // Pre: in use. A uniform that the program does not read is passed over.
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const Vec2f& value) const;
    void set(const char* uniform, const Vec3f& value) const;
    void set(const char* uniform, const Eigen::Matrix4f& value) const;

 private:
    int location(const char* uniform) const;

    const GladGLContext& gl_;
    unsigned id_ = 0;
};

}  // namespace selvedge
