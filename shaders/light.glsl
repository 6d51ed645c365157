// Phong lighting in linear light: a key light, a fill light, and ambient light dimmed by ambient occlusion.
// `to_key` must be declared before it.
uniform vec3 eye;
uniform vec3 to_fill;
uniform float key_irradiance;
uniform float fill_irradiance;
uniform float sky_irradiance;
uniform float bounce_irradiance;

const vec3 kKeyColour = vec3(1.0, 0.965, 0.92);
const vec3 kSkyColour = vec3(0.95, 0.98, 1.03);
const vec3 kBounceColour = vec3(1.03, 1.0, 0.96);

struct Surface {
    vec3 albedo;
    vec3 normal;               // on the visible side
    float ambient_visibility;  // 0..1
    float gloss;               // fraction of light reflected specularly
    float roughness;           // 0..1, width of the highlight
    float sheen;               // fraction of light that fibres scatter at grazing angles
};

// Ambient visibility with interreflection: light reflected inside a fold takes on the surface's own colour. Fit by
// Jimenez et al., "Practical Realtime Strategies for Accurate Indirect Occlusion" (2016), eq. 10. Never below 0.2.
vec3 with_own_light(float ambient_visibility, vec3 albedo) {
    vec3 a = 2.0404 * albedo - 0.3324, b = 0.6417 - 4.7951 * albedo, c = 2.7552 * albedo + 0.6903;
    float least = mix(0.2, 1.0, ambient_visibility);
    return max(vec3(least), ((least * a + b) * least + c) * least);
}

// key_seen: visibility of the key light, 0..1.
vec3 lit_by(Surface surface, vec3 x, float key_seen) {
    vec3 to_eye = normalize(eye - x);
    vec3 normal = surface.normal;
    vec3 key = kKeyColour * key_irradiance * key_seen * max(dot(normal, to_key), 0.0);
    vec3 ambient = mix(kBounceColour * bounce_irradiance, kSkyColour * sky_irradiance, 0.5 + 0.5 * normal.y);
    ambient += kSkyColour * fill_irradiance * max(dot(normal, to_fill), 0.0);
    ambient *= with_own_light(surface.ambient_visibility, surface.albedo);
    vec3 halfway = normalize(to_key + to_eye);
    float shininess = 2.0 / (surface.roughness * surface.roughness) - 2.0;
    float lobe = (shininess + 2.0) / 8.0 * pow(max(dot(normal, halfway), 1e-4), shininess);
    float rim = surface.sheen * pow(1.0 - max(dot(normal, to_eye), 0.0), 3.0);
    return surface.albedo * (key + ambient) + surface.gloss * lobe * key + rim * (ambient + 0.5 * key);
}
