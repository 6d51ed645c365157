// Finishes a picture: averages the samples in linear light, blends them over the backdrop, encodes as sRGB.
uniform sampler2DMS light;  // premultiplied
uniform int samples;        // per drawn pixel
uniform int supersample;
uniform int is_transparent;

out vec4 colour;

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
