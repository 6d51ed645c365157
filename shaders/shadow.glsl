// Projects a position into the key light's depth map.
uniform vec3 to_key;
uniform mat4 shadow_matrix;         // world space to 0..1 on all three axes
uniform float shadow_width;         // m, width and depth covered by the shadow map
uniform float shadow_map_side;      // px

// xyz: position in the map, 0..1, offset along the normal and towards the light against self-shadowing.
// w: how its depth changes across the map if the surface goes on as a plane; plane_slope() unpacks it.
// (Receiver plane: Isidoro 2006)
vec4 shadow_place(vec3 x, vec3 normal) {
    float facing = clamp(dot(normal, to_key), 0.2, 1.0);
    float texel = shadow_width / shadow_map_side;
    vec3 at = (shadow_matrix * vec4(x + normal * max(0.004, 2.0 * texel), 1.0)).xyz;
    at.z = min(at.z - max(0.002, texel) / shadow_width, 0.9999);  // the ground extends beyond the map's depth
    vec3 seen = normalize(mat3(shadow_matrix) * normal);
    vec2 slope = clamp(seen.xy / facing, -5.0, 5.0);
    vec2 steps = floor((slope + 5.0) * 409.5 + 0.5);  // 0 to 4095, so that both are exact in one float
    return vec4(at, steps.x * 4096.0 + steps.y);
}
