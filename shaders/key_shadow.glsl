// The key light with its soft shadow. After shadow.glsl and light.glsl.
uniform sampler2D shadow_mask;  // by pixel: how much of the key light is seen, and at which depth from the light

// 0..1: how much of the key light is seen: of the nine places about the pixel that shadow_mask holds, that which is
// most likely this one.
float key_visibility(vec3 x, vec3 normal) {
    float depth = shadow_place(x, normal).z;
    ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(shadow_mask, 0) - 1;
    vec2 best = texelFetch(shadow_mask, at, 0).rg;
    float near = 0.001 / shadow_width;
    int others = abs(best.y - depth) < 4.0 * near ? 0 : 9;  // a count, not a branch, which software GL does not take
    for (int i = 0; i < others; ++i) {
        ivec2 step_px = ivec2(i % 3 - 1, i / 3 - 1);
        vec2 other = texelFetch(shadow_mask, clamp(at + step_px, ivec2(0), last), 0).rg;
        if (abs(other.y - depth) + near < abs(best.y - depth)) best = other;
    }
    return best.x;
}

vec3 lit(Surface surface, vec3 x) { return lit_by(surface, x, key_visibility(x, surface.normal)); }
