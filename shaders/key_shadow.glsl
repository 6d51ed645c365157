// Lighting with the key light's soft shadow. Include after shadow.glsl and light.glsl.
uniform sampler2D shadow_mask;  // per pixel: visibility of the key light; depth of the position as seen from the light

// Visibility of the key light at x, 0..1. The mask holds one position per pixel; of the 3 x 3 pixels around
// this one, takes the one whose depth is closest to that of x.
float key_visibility(vec3 x, vec3 normal) {
    float depth = shadow_place(x, normal).z;
    ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(shadow_mask, 0) - 1;
    vec2 best = texelFetch(shadow_mask, at, 0).rg;
    float near = 0.001 / shadow_width;
    int others = abs(best.y - depth) < 4.0 * near ? 0 : 9;  // a loop count: software GL executes both sides of a branch
    for (int i = 0; i < others; ++i) {
        ivec2 step_px = ivec2(i % 3 - 1, i / 3 - 1);
        vec2 other = texelFetch(shadow_mask, clamp(at + step_px, ivec2(0), last), 0).rg;
        if (abs(other.y - depth) + near < abs(best.y - depth)) best = other;
    }
    return best.x;
}

vec3 lit(Surface surface, vec3 x) { return lit_by(surface, x, key_visibility(x, surface.normal)); }
