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

const vec3 kKeyColour = vec3(1.0, 0.965, 0.92);
const vec3 kSkyColour = vec3(0.95, 0.98, 1.03);
const vec3 kBounceColour = vec3(1.03, 1.0, 0.96);
const int kBlockerTaps = 24;
const int kShadowTaps = 40;
const float kLightSize = 0.10;      // across, as seen from the scene, rad
const float kLeastBlur = 0.003;     // m
const float kMostBlur = 0.07;       // m

// Points spread evenly over the unit disc (Vogel).
vec2 disc_point(int i, int count) {
    float angle = float(i) * 2.39996323;
    return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}

// Mean depth of what stands before the point, or a negative number.
float blocker_depth(vec3 at, float radius, float slope) {
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < kBlockerTaps; ++i) {
        vec2 offset = disc_point(i, kBlockerTaps) * radius;
        float depth = texture(shadow_depth, at.xy + offset).r;
        float is_before = step(depth, at.z - length(offset) * slope);
        sum += depth * is_before;
        count += is_before;
    }
    return count > 0.0 ? sum / count : -1.0;
}

// 0..1: how much of the key light is seen. The further the blocker, the softer its edge.
float key_visibility(vec3 x, vec3 normal) {
    float facing = clamp(dot(normal, to_key), 0.2, 1.0);
    float slope = sqrt(1.0 - facing * facing) / facing;
    vec3 at = (shadow_matrix * vec4(x + normal * 0.004, 1.0)).xyz;
    if (any(greaterThan(abs(at.xy - 0.5), vec2(0.5)))) return 1.0;  // beside all that casts shadows
    at.z = min(at.z - 0.002 / shadow_width, 0.9999);                // the ground reaches beyond the map's depth
    float blocker = blocker_depth(at, kMostBlur / shadow_width, slope);
    if (blocker < 0.0) return 1.0;
    float radius = clamp((at.z - blocker) * kLightSize, kLeastBlur / shadow_width, kMostBlur / shadow_width);
    float seen = 0.0;
    for (int i = 0; i < kShadowTaps; ++i) {
        vec2 offset = disc_point(i, kShadowTaps) * radius;
        seen += texture(shadow_map, vec3(at.xy + offset, at.z - length(offset) * slope));
    }
    return seen / float(kShadowTaps);
}

struct Surface {
    vec3 albedo;
    vec3 normal;     // to the side that is seen
    float openness;  // 0..1 of the room's light that arrives
    float gloss;     // strength of the highlight
    float shininess;
    float sheen;     // light that fibres catch at the rim
};

vec3 lit(Surface surface, vec3 x) {
    vec3 to_eye = normalize(eye - x);
    vec3 normal = surface.normal;
    float facing_key = dot(normal, to_key);
    float seen = facing_key > 0.0 ? key_visibility(x, normal) : 0.0;
    vec3 key = kKeyColour * key_irradiance * seen;
    float open = surface.openness;
    vec3 room = mix(kBounceColour * bounce_irradiance, kSkyColour * sky_irradiance, 0.5 + 0.5 * normal.y) * open;
    room += kSkyColour * fill_irradiance * max(dot(normal, to_fill), 0.0) * open;
    vec3 halfway = normalize(to_key + to_eye);
    float highlight = surface.gloss * pow(max(dot(normal, halfway), 0.0), surface.shininess);
    float rim = surface.sheen * pow(1.0 - max(dot(normal, to_eye), 0.0), 3.0);
    vec3 diffuse = key * max(facing_key, 0.0) + room;
    return surface.albedo * diffuse + highlight * key * max(facing_key, 0.0) + rim * (room + 0.5 * key * max(facing_key, 0.0));
}
