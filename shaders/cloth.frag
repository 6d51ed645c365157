centroid in vec3 v_position;  // centroid: sampled inside the triangle, also where it covers only a part of the pixel
centroid in vec3 v_normal;
in vec2 v_place;
in vec3 v_heights;
in vec2 v_ambient_visibility;
in vec2 v_touch;
in float v_paint;
flat in uint v_marks;

uniform int show;          // 0 tartan or picture, 1 level, 2 edges, 3 plain, 4 painted
uniform vec3 cloth_colour;
uniform vec3 level_colours[8];
uniform float line_px;     // px, half the width of an edge's line
uniform int has_picture;   // 1: a picture is printed on the cloth
uniform sampler2D cloth_picture;
uniform vec3 picture_u;    // from (weft, warp, 1) to its texture coordinates
uniform vec3 picture_v;
uniform vec3 picture_ground;
uniform sampler2D paint_map;
uniform int paint_colours;
uniform float edge_ink;    // 0..1, darkness of edges on plain and painted cloth
uniform float gloss;
uniform float roughness;
uniform float sheen;

out vec4 colour;

// 1 on the nearest edge, 0 away from it. Fades out where triangles are hardly larger than the line.
float edge_line() {
    vec3 distance_px = v_heights / max(fwidth(v_heights), vec3(1e-9));
    float nearest = min(distance_px.x, min(distance_px.y, distance_px.z));
    float size_px = max(distance_px.x, max(distance_px.y, distance_px.z));
    return (1.0 - smoothstep(line_px - 0.5, line_px + 0.5, nearest)) * smoothstep(line_px, 8.0 * line_px, size_px);
}

// How dark a seam or hem is, 0..1: cloth sinks in at a seam and is doubled at a hem. mask: the triangle's marked edges;
// touch: m, distance from a marked edge that only a corner touches; half_width: m.
float sewn_shade(uint mask, float touch, float half_width) {
    float nearest = mask == 0u ? touch : 1e9;
    for (int i = 0; i < 3; ++i) {
        if ((mask >> i & 1u) != 0u) nearest = min(nearest, v_heights[i]);
    }
    vec3 slope = fwidth(v_heights);
    float pixel = max(max(slope.x, slope.y), slope.z);
    float share = half_width / (half_width + pixel);
    return share * (1.0 - smoothstep(0.3 * half_width, half_width + pixel, nearest));
}

// Interpolates linearly between neighbouring colours of the map.
vec3 painted() {
    float at = clamp(v_paint, 0.0, 1.0) * float(paint_colours - 1);
    int below = int(min(at, float(paint_colours - 2)));
    return mix(texelFetch(paint_map, ivec2(below, 0), 0).rgb, texelFetch(paint_map, ivec2(below + 1, 0), 0).rgb,
               at - float(below));
}

// Ink goes only partly through to the wrong side.
vec3 printed(float side) {
    vec3 place = vec3(v_place, 1.0);
    vec3 ink = texture(cloth_picture, vec2(dot(picture_u, place), dot(picture_v, place))).rgb;
    return side > 0.0 ? ink : mix(ink, picture_ground, 0.6);
}

vec3 cloth_albedo(float side) {
    if (show == 0 && has_picture != 0) return 0.94 * printed(side) + 0.008;
    if (show == 0) return 0.94 * tartan(v_place, side) + 0.008;  // even black yarn reflects a little light
    if (show == 1) return level_colours[min(v_marks & 255u, 7u)];
    if (show == 4) return painted();
    return cloth_colour;
}

// Components of the key light's direction along weft and warp. They make one flank of a yarn lighter than the other.
vec2 light_along_threads() {
    vec3 right = dFdx(v_position), up = dFdy(v_position);
    vec2 place_right = dFdx(v_place), place_up = dFdy(v_place);
    float turn = place_right.x * place_up.y - place_right.y * place_up.x;
    vec3 weft = right * place_up.y - up * place_right.y, warp = up * place_right.x - right * place_up.x;
    if (abs(turn) < 1e-20) return vec2(0.0);
    return sign(turn) * vec2(dot(normalize(weft), to_key), dot(normalize(warp), to_key));
}

void main() {
    float side = gl_FrontFacing ? 1.0 : -1.0;
    weave_light = light_along_threads();
    vec3 albedo = cloth_albedo(side);
    float lines = edge_line();  // always computed, because derivatives need every pixel
    albedo *= 1.0 - 0.55 * sewn_shade(v_marks >> 8 & 7u, v_touch.x, 0.0016);
    albedo *= 1.0 - 0.30 * sewn_shade(v_marks >> 11 & 7u, v_touch.y, 0.0020);
    if (show == 1) albedo = mix(albedo, albedo * 0.35, 0.7 * lines);
    if (show == 2) albedo = mix(albedo, vec3(0.035, 0.05, 0.09), 0.9 * lines);
    if (show > 2) albedo = mix(albedo, albedo * 0.25, edge_ink * lines);
    if (side < 0.0) albedo *= 0.86;  // the wrong side is darker, also where both sides are alike
    Surface surface;
    surface.albedo = albedo;
    surface.normal = normalize(v_normal) * side;
    surface.ambient_visibility = side > 0.0 ? v_ambient_visibility.x : v_ambient_visibility.y;
    surface.gloss = gloss;
    surface.roughness = roughness;
    surface.sheen = sheen;
    colour = vec4(lit(surface, v_position), 1.0);
}
