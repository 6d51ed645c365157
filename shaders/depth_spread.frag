// The least depth within `cells` tiles each way.
uniform sampler2D depths;
uniform int cells;

out vec4 nearest;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(depths, 0) - 1;
    float least = 1.0;
    for (int y = -cells; y <= cells; ++y) {
        for (int x = -cells; x <= cells; ++x) {
            least = min(least, texelFetch(depths, clamp(at + ivec2(x, y), ivec2(0), last), 0).r);
        }
    }
    nearest = vec4(least);
}
