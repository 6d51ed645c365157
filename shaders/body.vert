layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float ambient_visibility;

uniform mat4 camera;

centroid out vec3 v_position;
centroid out vec3 v_normal;
out float v_ambient_visibility;

void main() {
    v_position = position;
    v_normal = normal;
    v_ambient_visibility = ambient_visibility;
    gl_Position = camera * vec4(position, 1.0);
}
