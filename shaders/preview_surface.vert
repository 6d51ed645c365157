// Bodies and marks in previews. Their meshes are fine, so lighting at the vertices suffices and pixels are cheap.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 mark_colour;  // sRGB, of marks

uniform mat4 camera;
uniform vec3 body_colour;  // linear
uniform float body_share;  // 1 for bodies, 0 for marks
uniform float ambient_visibility;
uniform float gloss;
uniform float roughness;
uniform float sheen;

out vec3 v_colour;

void main() {
    Surface surface;
    surface.albedo = mix(pow(mark_colour.rgb, vec3(2.2)), body_colour, body_share);
    surface.normal = normal;
    surface.ambient_visibility = ambient_visibility;
    surface.gloss = gloss;
    surface.roughness = roughness;
    surface.sheen = sheen;
    v_colour = encode(shoulder(lit_by(surface, position, 1.0)));
    gl_Position = camera * vec4(position, 1.0);
}
