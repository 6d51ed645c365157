// The backdrop alone, with the top row first.
out vec4 colour;

void main() {
    vec2 at = vec2(gl_FragCoord.x, picture_size_px.y - gl_FragCoord.y);
    colour = vec4(encode(shoulder(backdrop(at))) + noise(uvec2(at)) * 0.8 / 255.0, 1.0);
}
