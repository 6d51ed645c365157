layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;  // sRGB

uniform mat4 camera;

out vec3 v_position;
out vec3 v_normal;
out vec3 v_colour;

void main() {
    v_position = position;
    v_normal = normal;
    v_colour = mix(colour.rgb / 12.92, pow((colour.rgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, colour.rgb));
    gl_Position = camera * vec4(position, 1.0);
}
