// A woven tartan from its sett: 2/2 twill, weft repeating warp. Filtered over the pixel without mipmaps: stripe
// colours by sums along the sett, so that neither edges nor stripes finer than a pixel alias; the twill itself thread
// by thread when near, and fading to the even mixture that the eye sees when threads are finer than a pixel.
uniform sampler2D sett_sums;  // texel k: sum over the threads before k of (colour - mean); periodic, as its total is 0
uniform int sett_threads;
uniform vec3 sett_mean;
uniform float thread_spacing;  // m
uniform vec2 sett_position;    // m

int sett_index(float thread) { return int(thread - floor(thread / float(sett_threads)) * float(sett_threads)); }

vec3 sett_sum(float t) {
    float thread = floor(t);
    int k = clamp(sett_index(thread), 0, sett_threads - 1);
    return mix(texelFetch(sett_sums, ivec2(k, 0), 0).rgb, texelFetch(sett_sums, ivec2(k + 1, 0), 0).rgb, t - thread);
}

vec3 mean_colour(float t, float width) {
    return sett_mean + (sett_sum(t + 0.5 * width) - sett_sum(t - 0.5 * width)) / width;
}

vec3 thread_colour(float thread) {
    int k = clamp(sett_index(thread), 0, sett_threads - 1);
    return sett_mean + texelFetch(sett_sums, ivec2(k + 1, 0), 0).rgb - texelFetch(sett_sums, ivec2(k, 0), 0).rgb;
}

// How much of the pixel [t - width/2, t + width/2] lies on the thread [thread, thread + 1].
float coverage(float thread, float t, float width) {
    float low = max(thread, t - 0.5 * width), high = min(thread + 1.0, t + 0.5 * width);
    return max(high - low, 0.0) / width;
}

bool is_warp_on_top(float end, float pick) {
    float diagonal = end - pick;
    return diagonal - 4.0 * floor(diagonal / 4.0) < 1.5;
}

// What the weave adds to the even mixture of warp and weft, over the threads that the pixel covers (4 x 4 at most).
vec3 weave_detail(vec2 t, vec2 width, float side) {
    vec2 first = floor(t - 0.5 * width);
    vec3 detail = vec3(0.0);
    for (int j = 0; j < 4; ++j) {
        float pick = first.y + float(j);
        float pick_share = coverage(pick, t.y, width.y);
        vec3 weft = thread_colour(pick);
        for (int i = 0; i < 4; ++i) {
            float end = first.x + float(i);
            float sign_of_top = is_warp_on_top(end, pick) ? side : -side;
            detail += coverage(end, t.x, width.x) * pick_share * 0.5 * sign_of_top * (thread_colour(end) - weft);
        }
    }
    return detail;
}

// Threads are round: darker where they dive under the next. Seen only from near.
float thread_relief(vec2 t, float side) {
    vec2 across = fract(t) - 0.5;
    float off = is_warp_on_top(floor(t.x), floor(t.y)) == (side > 0.0) ? across.x : across.y;
    return 1.12 - 1.6 * off * off;
}

// place: (weft, warp) in m on the fabric; side: 1 seen from the right side, -1 from the wrong one.
vec3 tartan(vec2 place, float side) {
    vec2 t = (place - sett_position) / thread_spacing;
    vec2 width = max(fwidth(t), vec2(0.02));
    vec3 colour = 0.5 * (mean_colour(t.x, width.x) + mean_colour(t.y, width.y));
    float widest = max(width.x, width.y);
    float detail = 1.0 - smoothstep(0.9, 2.6, widest);
    if (detail <= 0.0) return colour;
    colour += detail * weave_detail(t, width, side);
    float relief = 1.0 - smoothstep(0.25, 0.7, widest);
    return max(colour, vec3(0.0)) * mix(1.0, thread_relief(t, side), relief);
}
