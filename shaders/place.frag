centroid in vec3 v_position;  // centroid: sampled inside the triangle, also where it covers only a part of the pixel
centroid in vec3 v_normal;

uniform int is_two_sided;

out vec4 place;

void main() {
    vec3 normal = normalize(v_normal) * (is_two_sided != 0 && !gl_FrontFacing ? -1.0 : 1.0);
    place = shadow_place(v_position, normal);
    if (dot(normal, to_key) <= 0.0) place.w = -1.0;  // faces away from the key light: no search for blockers
}
