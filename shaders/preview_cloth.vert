// Cloth in previews, three vertices per triangle. Light is computed at the vertices and encoded as sRGB; a pixel is
// this light times the picture's colour.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 place;  // (weft, warp) in m, or the position along the map of a painted mode
layout(location = 3) in uint marks;  // as in cloth.vert

uniform mat4 camera;
uniform vec3 place_u;  // from (place, 1) to texture coordinates
uniform vec3 place_v;
uniform vec3 cloth_colour;  // sRGB; white if the picture gives the colour
uniform vec3 level_colours[8];
uniform float level_share;  // 1: coloured by level
uniform int all_lines;      // 1: draws every edge; 0: only seams and hems

out vec2 v_place;
out vec3 v_front;  // colour of the right side
out vec3 v_back;
out vec3 v_edges;  // drawn edges: height over the edge, 1 at its opposite corner; other edges: 1

// ambient_visibility and key_seen are constants here, lower on the wrong side: previews have no shadows.
vec3 light_on(vec3 side_normal, float ambient_visibility, float key_seen) {
    Surface surface;
    surface.albedo = vec3(1.0);
    surface.normal = side_normal;
    surface.ambient_visibility = ambient_visibility;
    surface.gloss = 0.0;
    surface.roughness = 0.5;
    surface.sheen = 0.0;
    return encode(lit_by(surface, position, key_seen));
}

void main() {
    vec3 colour = mix(cloth_colour, level_colours[min(marks & 255u, 7u)], level_share);
    v_front = colour * light_on(normal, 0.8, 1.0);
    v_back = colour * light_on(-normal, 0.5, 0.35);
    v_place = vec2(dot(place_u, vec3(place, 1.0)), dot(place_v, vec3(place, 1.0)));
    int corner = gl_VertexID % 3;
    uint lines = all_lines != 0 ? 7u : (marks >> 8 | marks >> 11) & 7u;
    vec3 heights = vec3(corner == 0, corner == 1, corner == 2);
    v_edges = vec3((lines & 1u) != 0u ? heights.x : 1.0, (lines & 2u) != 0u ? heights.y : 1.0,
                   (lines & 4u) != 0u ? heights.z : 1.0);
    gl_Position = camera * vec4(position, 1.0);
}
