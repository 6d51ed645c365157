// Projects a position into the key light's depth map.
uniform vec3 to_key;
uniform mat4 shadow_matrix;         // world space to 0..1 on all three axes
uniform float shadow_width;         // m, width and depth covered by the shadow map
uniform float shadow_map_side;      // px

// xyz: position in the map, 0..1, offset along the normal and towards the light against self-shadowing.
// w: tangent of the angle between normal and light (slope of the surface as seen from the light).
vec4 shadow_place(vec3 x, vec3 normal) {
    float facing = clamp(dot(normal, to_key), 0.2, 1.0);
    float texel = shadow_width / shadow_map_side;
    vec3 at = (shadow_matrix * vec4(x + normal * max(0.004, 2.0 * texel), 1.0)).xyz;
    at.z = min(at.z - max(0.002, texel) / shadow_width, 0.9999);  // the ground extends beyond the map's depth
    return vec4(at, sqrt(1.0 - facing * facing) / facing);
}
