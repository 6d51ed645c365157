in vec3 v_position;
in vec3 v_normal;
in float v_openness;

uniform vec3 ground_centre;
uniform float ground_radius;
uniform int is_transparent;

out vec4 colour;

// The ground takes light from the backdrop and adds none, so that it ends nowhere.
void main() {
    float key_seen = key_visibility(v_position, vec3(0.0, 1.0, 0.0));
    float away = length(v_position - ground_centre) / ground_radius;
    float dark = (0.30 * (1.0 - key_seen) + 0.62 * (1.0 - v_openness)) * (1.0 - smoothstep(0.35, 1.0, away));
    colour = is_transparent != 0 ? vec4(vec3(0.0), dark) : vec4(backdrop() * mix(vec3(1.0), vec3(0.05, 0.055, 0.07), dark), 1.0);
}
