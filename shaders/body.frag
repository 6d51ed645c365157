in vec3 v_position;
in vec3 v_normal;
in float v_openness;

uniform vec3 body_colour;

out vec4 colour;

void main() {
    Surface surface;
    surface.albedo = body_colour;
    surface.normal = normalize(v_normal);
    surface.openness = v_openness;
    surface.gloss = 0.05;
    surface.shininess = 22.0;
    surface.sheen = 0.05;
    colour = vec4(lit(surface, v_position), 1.0);
}
