// Linear light to a picture: average the samples, lay them over the backdrop, soften what is brighter than white, encode
// as sRGB, and dither by less than a step, so that the soft backdrop shows no bands.
uniform sampler2DMS light;  // premultiplied
uniform int samples;        // of each pixel drawn
uniform int supersample;
uniform int is_transparent;

out vec4 colour;

vec3 shoulder(vec3 x) {
    vec3 over = max(x - 0.9, 0.0);
    return min(x, 0.9) + 0.1 * over / (0.1 + over);
}

vec3 encode(vec3 x) { return mix(12.92 * x, 1.055 * pow(max(x, 1e-6), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, x)); }

float noise(uvec2 at) {
    uint h = at.x * 1664525u + at.y * 1013904223u;
    h = (h ^ (h >> 15)) * 2246822519u;
    h = (h ^ (h >> 13)) * 3266489917u;
    return float((h ^ (h >> 16)) & 65535u) / 65535.0 - 0.5;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy) * supersample;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < supersample; ++y) {
        for (int x = 0; x < supersample; ++x) {
            for (int i = 0; i < samples; ++i) sum += texelFetch(light, at + ivec2(x, y), i);
        }
    }
    sum /= float(supersample * supersample * samples);
    vec3 straight = sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0);
    vec3 over = sum.rgb + (1.0 - sum.a) * backdrop(gl_FragCoord.xy);
    vec3 encoded = encode(shoulder(max(is_transparent != 0 ? straight : over, 0.0)));
    float dither = noise(uvec2(gl_FragCoord.xy + tile_origin_px)) * 0.8 / 255.0;
    colour = vec4(encoded + dither, is_transparent != 0 ? sum.a : 1.0);
}
