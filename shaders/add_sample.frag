// Adds a picture to the sum of several, in linear light. Alpha counts them.
uniform sampler2D picture;  // sRGB bytes

out vec4 sum;

vec3 decode(vec3 x) { return mix(x / 12.92, pow((max(x, 0.04045) + 0.055) / 1.055, vec3(2.4)), step(0.04045, x)); }

void main() { sum = vec4(decode(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb), 1.0); }
