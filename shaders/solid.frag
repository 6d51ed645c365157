in vec3 v_position;
in vec3 v_normal;
in vec3 v_colour;

out vec4 colour;

void main() {
    Surface surface;
    surface.albedo = v_colour;
    surface.normal = normalize(v_normal);
    surface.ambient_visibility = 1.0;
    surface.gloss = 0.04;
    surface.roughness = 0.3;
    surface.sheen = 0.0;
    colour = vec4(lit(surface, v_position), 1.0);
}
