centroid in vec3 v_position;  // centroid: sampled inside the triangle, also where it covers only a part of the pixel
centroid in vec3 v_normal;
in float v_ambient_visibility;

uniform vec3 ground_centre;
uniform float ground_radius;
uniform int is_transparent;
uniform int supersample;

out vec4 colour;

// The ground only darkens the backdrop and adds no light, so that its border is invisible.
void main() {
    float key_seen = key_visibility(v_position, vec3(0.0, 1.0, 0.0));
    float away = length(v_position - ground_centre) / ground_radius;
    float dark = (0.30 * (1.0 - key_seen) + 0.72 * (1.0 - v_ambient_visibility)) * (1.0 - smoothstep(0.35, 1.0, away));
    float passed = 1.0 - 0.94 * dark;
    // Transparent pictures are blended in sRGB, where the same shadow needs a smaller alpha than in linear light.
    float alpha = is_transparent != 0 ? 1.0 - pow(passed, 1.0 / 2.2) : 1.0 - passed;
    float blue = is_transparent != 0 ? 0.0 : 0.02 * dark * backdrop(gl_FragCoord.xy / float(supersample)).b;
    colour = vec4(0.0, 0.0, blue, alpha);
}
