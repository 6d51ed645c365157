// Linear light to sRGB. shoulder() compresses light above 0.9 to below 1; noise() is for dithering against banding.
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
