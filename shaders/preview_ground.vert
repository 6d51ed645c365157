// A soft dark spot on the ground below the body. A strip of four vertices, without a buffer.
uniform mat4 camera;
uniform vec3 ground_centre;
uniform vec2 ground_reach;  // m, along x and z

out vec2 v_place;

void main() {
    v_place = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    vec3 at = ground_centre + vec3(v_place.x * ground_reach.x, 0.0, -v_place.y * ground_reach.y);
    gl_Position = camera * vec4(at, 1.0);
}
