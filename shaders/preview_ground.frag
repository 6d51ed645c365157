in vec2 v_place;

out vec4 colour;

void main() {
    float inside = max(1.0 - dot(v_place, v_place), 0.0);
    colour = vec4(0.0, 0.0, 0.02, 0.22 * inside * inside);
}
