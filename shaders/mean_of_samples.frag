// The mean of the pictures that add_sample.frag has added up.
uniform sampler2D sum;

out vec4 colour;

void main() {
    vec4 all = texelFetch(sum, ivec2(gl_FragCoord.xy), 0);
    colour = vec4(encode(all.rgb / all.a), 1.0);
}
