in vec2 v_place;
in vec3 v_front;
in vec3 v_back;
in vec3 v_edges;

uniform sampler2D picture;  // sRGB: woven or painted colours, or white
uniform float ink;          // 0..1, darkness of lines
uniform float line_px;      // px, half the width of lines
uniform float finer;        // levels of the picture, for one of several samples of a pixel

out vec4 colour;

void main() {
    vec3 distance_px = v_edges / max(fwidth(v_edges), vec3(1e-9));
    float nearest = min(distance_px.x, min(distance_px.y, distance_px.z));
    float size_px = max(distance_px.x, max(distance_px.y, distance_px.z));
    float line = clamp(line_px + 0.5 - nearest, 0.0, 1.0) * clamp(size_px / (7.0 * line_px) - 0.15, 0.0, 1.0);
    vec3 seen = (gl_FrontFacing ? v_front : v_back) * texture(picture, v_place, -finer).rgb;
    colour = vec4(seen * (1.0 - ink * line), 1.0);
}
