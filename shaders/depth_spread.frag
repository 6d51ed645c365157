// The smallest depth within `cells` tiles along rows or columns. Two passes give the smallest depth within a square.
uniform sampler2D depths;
uniform int cells;
uniform int along_columns;

out vec4 nearest;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(depths, 0) - 1;
    float least = 1.0;
    ivec2 step_to = along_columns != 0 ? ivec2(0, 1) : ivec2(1, 0);
    for (int i = -cells; i <= cells; ++i) {
        least = min(least, texelFetch(depths, clamp(at + i * step_to, ivec2(0), last), 0).r);
    }
    nearest = vec4(least);
}
