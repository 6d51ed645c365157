// How much of the key light each pixel's place sees: 0..1, and the place's depth from the light, by which it is known
// again. The further the blocker, the softer its edge.
// Apart from the drawing of surfaces, since these are drawn in triangles hardly larger than a pixel, each of which has
// whole blocks of pixels shaded.
uniform sampler2D places;            // of shadow.glsl; w below 0 where no key light falls or nothing is
uniform sampler2DShadow shadow_map;  // shadow_depth, compared and softened
uniform sampler2D shadow_depth;
uniform sampler2D shadow_nearest;    // the least depth within shadow_reach, coarsely
uniform float shadow_reach;          // m: the softest shadow's edge, and how far a blocker is looked for
uniform float shadow_width;          // m that the map spans

out vec2 mask;

const int kBlockerTaps = 24;
const int kShadowTaps = 40;
const float kLightSize = 0.10;   // across, as seen from the scene, rad
const float kLeastBlur = 0.003;  // m

// The points of a disc are spread evenly (Vogel): each lies a golden angle further round than the one before.
const mat2 kGoldenTurn = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);

// What stands before a point of the scene: x how many of the taps, y their mean depth.
// Software GL works through both sides of a branch: a loop of no rounds is what saves work.
vec2 find_blockers(vec3 at, float radius, float slope, int taps) {
    float sum = 0.0, count = 0.0;
    vec2 way = vec2(1.0, 0.0);
    for (int i = 0; i < taps; ++i) {
        float away = radius * sqrt((float(i) + 0.5) / float(kBlockerTaps));
        float depth = textureLod(shadow_depth, at.xy + away * way, 0.0).r;
        float is_before = step(depth, at.z - away * slope);
        sum += depth * is_before;
        count += is_before;
        way = kGoldenTurn * way;
    }
    return vec2(count, sum / max(count, 1.0));
}

float lit_share(vec3 at, float radius, float slope, int taps) {
    float seen = 0.0;
    vec2 way = vec2(1.0, 0.0);
    for (int i = 0; i < taps; ++i) {
        float away = radius * sqrt((float(i) + 0.5) / float(kShadowTaps));
        seen += texture(shadow_map, vec3(at.xy + away * way, at.z - away * slope));
        way = kGoldenTurn * way;
    }
    return seen / float(kShadowTaps);
}

void main() {
    vec4 place = texelFetch(places, ivec2(gl_FragCoord.xy), 0);
    bool is_beside = any(greaterThan(abs(place.xy - 0.5), vec2(0.5)));  // all that casts shadows
    bool is_searched = place.w >= 0.0 && !is_beside && textureLod(shadow_nearest, place.xy, 0.0).r < place.z;
    float most = shadow_reach / shadow_width;
    vec2 blockers = find_blockers(place.xyz, most, place.w, is_searched ? kBlockerTaps : 0);
    bool is_edge = blockers.x > 0.5 && blockers.x < float(kBlockerTaps) - 0.5;
    float radius = clamp((place.z - blockers.y) * kLightSize, kLeastBlur / shadow_width, most);
    float seen = lit_share(place.xyz, radius, place.w, is_edge ? kShadowTaps : 0);
    if (!is_edge) seen = blockers.x > 0.5 || place.w < 0.0 ? 0.0 : 1.0;
    mask = vec2(seen, place.z);
}
