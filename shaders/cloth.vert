layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 place;     // (weft, warp), m
layout(location = 3) in vec3 heights;   // m, height over each of the triangle's edges
layout(location = 4) in vec2 ambient_visibility;  // right side, wrong side
layout(location = 5) in vec2 touch;     // m, distance to a seam and a hem that only a corner touches
layout(location = 6) in uint marks;     // bits 0-7: level; 8-10: edges on seams; 11-13: edges on hems
layout(location = 7) in float paint;    // position along the colour map of painted modes, 0..1

uniform mat4 camera;

centroid out vec3 v_position;
centroid out vec3 v_normal;
out vec2 v_place;
out vec3 v_heights;
out vec2 v_ambient_visibility;
out vec2 v_touch;
out float v_paint;
flat out uint v_marks;

void main() {
    v_position = position;
    v_normal = normal;
    v_place = place;
    v_heights = heights;
    v_ambient_visibility = ambient_visibility;
    v_touch = touch;
    v_paint = paint;
    v_marks = marks;
    gl_Position = camera * vec4(position, 1.0);
}
