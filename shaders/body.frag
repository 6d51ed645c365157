centroid in vec3 v_position;  // centroid: sampled inside the triangle, also where it covers only a part of the pixel
centroid in vec3 v_normal;
in float v_ambient_visibility;

uniform vec3 body_colour;
uniform float gloss;
uniform float roughness;
uniform float sheen;

out vec4 colour;

void main() {
    Surface surface;
    surface.albedo = body_colour;
    surface.normal = normalize(v_normal);
    surface.ambient_visibility = v_ambient_visibility;
    surface.gloss = gloss;
    surface.roughness = roughness;
    surface.sheen = sheen;
    colour = vec4(lit(surface, v_position), 1.0);
}
