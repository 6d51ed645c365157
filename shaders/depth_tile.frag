// The smallest depth in one tile of cells x cells texels.
uniform sampler2D depths;
uniform int cells;

out vec4 nearest;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * cells;
    float least = 1.0;
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) least = min(least, texelFetch(depths, first + ivec2(x, y), 0).r);
    }
    nearest = vec4(least);
}
