// Phong's light per pixel: a key light with a soft shadow, a fill, and the room's light from all round, dimmed where
// little of the room is seen. Linear throughout.
uniform vec3 eye;
uniform vec3 to_key;
uniform vec3 to_fill;
uniform float key_irradiance;
uniform float fill_irradiance;
uniform float sky_irradiance;
uniform float bounce_irradiance;
uniform mat4 shadow_matrix;         // room to 0..1 in all three
uniform float shadow_width;         // m that the shadow map spans, in width and depth
uniform sampler2DShadow shadow_map;
uniform sampler2D shadow_depth;     // the same texture, read plainly
uniform sampler2D shadow_nearest;   // the least depth within shadow_reach, coarsely
uniform float shadow_reach;         // m: the softest shadow's edge, and how far a blocker is looked for

const vec3 kKeyColour = vec3(1.0, 0.965, 0.92);
const vec3 kSkyColour = vec3(0.95, 0.98, 1.03);
const vec3 kBounceColour = vec3(1.03, 1.0, 0.96);
const int kBlockerTaps = 24;
const int kShadowTaps = 40;
const float kLightSize = 0.10;      // across, as seen from the scene, rad
const float kLeastBlur = 0.003;     // m

// The points of a disc are spread evenly (Vogel): each lies a golden angle further round than the one before.
const mat2 kGoldenTurn = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);

// What stands before a point of the scene: x how many of the taps, y their mean depth.
// Software GL works through both sides of a branch: a loop of no rounds is what saves work.
vec2 find_blockers(vec3 at, float radius, float slope, int taps) {
    float sum = 0.0, count = 0.0;
    vec2 way = vec2(1.0, 0.0);
    for (int i = 0; i < taps; ++i) {
        float away = radius * sqrt((float(i) + 0.5) / float(kBlockerTaps));
        float depth = texture(shadow_depth, at.xy + away * way).r;
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

// 0..1: how much of the key light is seen. The further the blocker, the softer its edge.
float key_visibility(vec3 x, vec3 normal) {
    float cosine = dot(normal, to_key);
    float facing = clamp(cosine, 0.2, 1.0);
    float slope = sqrt(1.0 - facing * facing) / facing;
    vec3 at = (shadow_matrix * vec4(x + normal * 0.004, 1.0)).xyz;
    bool is_beside = any(greaterThan(abs(at.xy - 0.5), vec2(0.5)));  // all that casts shadows
    at.z = min(at.z - 0.002 / shadow_width, 0.9999);                 // the ground reaches beyond the map's depth
    bool may_be_shaded = cosine > 0.0 && !is_beside && texture(shadow_nearest, at.xy).r < at.z;
    float most = shadow_reach / shadow_width;
    vec2 blockers = find_blockers(at, most, slope, may_be_shaded ? kBlockerTaps : 0);
    bool is_edge = blockers.x > 0.5 && blockers.x < float(kBlockerTaps) - 0.5;
    float radius = clamp((at.z - blockers.y) * kLightSize, kLeastBlur / shadow_width, most);
    float seen = lit_share(at, radius, slope, is_edge ? kShadowTaps : 0);
    if (is_edge) return seen;
    return blockers.x > 0.5 || cosine <= 0.0 ? 0.0 : 1.0;
}

struct Surface {
    vec3 albedo;
    vec3 normal;      // to the side that is seen
    float openness;   // 0..1 of the room's light that arrives
    float gloss;      // share of light that is mirrored
    float roughness;  // 0..1, of the highlight
    float sheen;      // share of light that fibres catch at the rim
};

vec3 lit(Surface surface, vec3 x) {
    vec3 to_eye = normalize(eye - x);
    vec3 normal = surface.normal;
    vec3 key = kKeyColour * key_irradiance * key_visibility(x, normal) * max(dot(normal, to_key), 0.0);
    float open = surface.openness;
    vec3 room = mix(kBounceColour * bounce_irradiance, kSkyColour * sky_irradiance, 0.5 + 0.5 * normal.y) * open;
    room += kSkyColour * fill_irradiance * max(dot(normal, to_fill), 0.0) * open;
    vec3 halfway = normalize(to_key + to_eye);
    float shininess = 2.0 / (surface.roughness * surface.roughness) - 2.0;
    float lobe = (shininess + 2.0) / 8.0 * pow(max(dot(normal, halfway), 1e-4), shininess);
    float rim = surface.sheen * pow(1.0 - max(dot(normal, to_eye), 0.0), 3.0);
    return surface.albedo * (key + room) + surface.gloss * lobe * key + rim * (room + 0.5 * key);
}
