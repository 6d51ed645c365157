layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float ambient_visibility;

uniform mat4 camera;
uniform float shrink;  // m: in depth, the surface lies so much deeper

centroid out vec3 v_position;
centroid out vec3 v_normal;
out float v_ambient_visibility;

void main() {
    v_position = position;
    v_normal = normal;
    v_ambient_visibility = ambient_visibility;
    gl_Position = camera * vec4(position, 1.0);
    vec4 inside = camera * vec4(position - shrink * normal, 1.0);
    gl_Position.z = inside.z / inside.w * gl_Position.w;
}
