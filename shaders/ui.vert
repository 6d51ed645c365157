layout(location = 0) in vec2 position;  // in ImGui's coordinates
layout(location = 1) in vec2 place;
layout(location = 2) in vec4 colour;  // sRGB, straight alpha

uniform vec2 display_low;  // upper left corner of the display
uniform vec2 display_size;
uniform float upwards;  // 1: upright; -1: row 0 of the target is the top row

out vec2 v_place;
out vec4 v_colour;

void main() {
    v_place = place;
    v_colour = colour;
    vec2 at = (position - display_low) / display_size;
    gl_Position = vec4(2.0 * at.x - 1.0, upwards * (1.0 - 2.0 * at.y), 0.0, 1.0);
}
