// Percentage-closer soft shadows: visibility of the key light at each pixel's position, 0..1, and the position's depth
// as seen from the light, by which key_shadow.glsl finds the matching pixel. Edges are softer for more distant
// blockers. This is a pass of its own because surfaces have triangles hardly larger than a pixel, and GL shades whole
// blocks of pixels for each of them.
uniform sampler2D places;            // shadow_place() of shadow.glsl; w < 0: faces away from the light, or is empty
uniform sampler2DShadow shadow_map;  // shadow_depth, with comparison and linear filter
uniform sampler2D shadow_depth;
uniform sampler2D shadow_nearest;    // smallest depth within shadow_reach, on a coarse grid
uniform float shadow_reach;          // m, search radius for blockers, and largest blur radius
uniform float shadow_width;          // m, covered by the map

out vec2 mask;

const int kBlockerTaps = 24;
const int kShadowTaps = 40;
const float kLightSize = 0.10;   // blur radius / distance from blocker to surface
const float kLeastBlur = 0.003;  // m, smallest blur radius

// Vogel's spiral spreads the points of a disc evenly: each is turned by the golden angle from the previous one.
const mat2 kGoldenTurn = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);

// See shadow_place().
vec2 plane_slope(float packed_steps) {
    return vec2(floor(packed_steps / 4096.0), mod(packed_steps, 4096.0)) / 409.5 - 5.0;
}

// Of the plane through a position, and before what is empty.
float plane_depth(vec3 at, vec2 slope, vec2 aside) { return min(at.z + dot(slope, aside), 0.9999); }

// Blockers between a position and the light. x: number of taps with a blocker, y: mean depth of these blockers.
// taps = 0 skips the search: software GL executes both sides of a branch, but no iterations of an empty loop.
vec2 find_blockers(vec3 at, float radius, vec2 slope, int taps) {
    float sum = 0.0, count = 0.0;
    vec2 way = vec2(1.0, 0.0);
    for (int i = 0; i < taps; ++i) {
        vec2 aside = radius * (float(i) + 0.5) / float(kBlockerTaps) * way;  // denser within: a hem's shadow is narrow
        float depth = textureLod(shadow_depth, at.xy + aside, 0.0).r;
        float is_before = step(depth, plane_depth(at, slope, aside));
        sum += depth * is_before;
        count += is_before;
        way = kGoldenTurn * way;
    }
    return vec2(count, sum / max(count, 1.0));
}

float lit_share(vec3 at, float radius, vec2 slope, int taps) {
    float seen = 0.0;
    vec2 way = vec2(1.0, 0.0);
    for (int i = 0; i < taps; ++i) {
        vec2 aside = radius * sqrt((float(i) + 0.5) / float(kShadowTaps)) * way;
        seen += texture(shadow_map, vec3(at.xy + aside, plane_depth(at, slope, aside)));
        way = kGoldenTurn * way;
    }
    return seen / float(kShadowTaps);
}

void main() {
    vec4 place = texelFetch(places, ivec2(gl_FragCoord.xy), 0);
    bool is_beside = any(greaterThan(abs(place.xy - 0.5), vec2(0.5)));  // outside the map, where nothing casts shadows
    bool is_searched = place.w >= 0.0 && !is_beside && textureLod(shadow_nearest, place.xy, 0.0).r < place.z;
    float most = shadow_reach / shadow_width;
    vec2 blockers = find_blockers(place.xyz, most, plane_slope(place.w), is_searched ? kBlockerTaps : 0);
    bool is_edge = blockers.x > 0.5 && blockers.x < float(kBlockerTaps) - 0.5;
    float radius = clamp((place.z - blockers.y) * kLightSize, kLeastBlur / shadow_width, most);
    float seen = lit_share(place.xyz, radius, plane_slope(place.w), is_edge ? kShadowTaps : 0);
    if (!is_edge) seen = blockers.x > 0.5 || place.w < 0.0 ? 0.0 : 1.0;
    mask = vec2(seen, place.z);
}
