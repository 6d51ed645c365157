layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float openness;

uniform mat4 camera;

centroid out vec3 v_position;
centroid out vec3 v_normal;
out float v_openness;

void main() {
    v_position = position;
    v_normal = normal;
    v_openness = openness;
    gl_Position = camera * vec4(position, 1.0);
}
