// Woven cloth from the setts of warp and weft: plain weave, 2/2 twill or 3/1 twill. Filtered over the pixel's
// footprint, along warp and weft separately, without mipmaps. Three parts, all with the same mean colour:
// - stripes: mean colours from prefix sums along the setts, so that stripes finer than a pixel do not alias;
// - threads: single crossings when near, fading to the mean mixture of warp and weft when finer than a pixel;
// - yarns: when nearer still, the roundness and twist of each yarn.
uniform sampler2D sett_sums;  // row 0 warp, row 1 weft; texel k: sum over threads before k of (colour - mean)
uniform int warp_threads;     // in one repeat
uniform int weft_threads;
uniform vec3 warp_mean;
uniform vec3 weft_mean;
uniform int weave;             // 0 plain, 1 2/2 twill, 2 3/1 twill
uniform float thread_spacing;  // m
uniform vec2 sett_position;    // m

vec2 weave_light = vec2(0.0);  // components of the direction to the key light along weft and warp

const float kTwoPi = 6.2831853;

struct ThreadSystem {
    int row;
    int threads;
    vec3 mean;
};

ThreadSystem warp_system() { return ThreadSystem(0, warp_threads, warp_mean); }
ThreadSystem weft_system() { return ThreadSystem(1, weft_threads, weft_mean); }

int sett_index(float thread, int threads) {
    float count = float(threads);
    return clamp(int(thread - floor((thread + 0.5) / count) * count + 0.5), 0, threads - 1);
}

vec3 sett_sum(ThreadSystem system, float t) {
    float thread = floor(t);
    int k = sett_index(thread, system.threads);
    return mix(texelFetch(sett_sums, ivec2(k, system.row), 0).rgb,
               texelFetch(sett_sums, ivec2(k + 1, system.row), 0).rgb, t - thread);
}

vec3 mean_colour(ThreadSystem system, float t, float width) {
    return system.mean + (sett_sum(system, t + 0.5 * width) - sett_sum(system, t - 0.5 * width)) / width;
}

vec3 thread_colour(ThreadSystem system, float thread) {
    int k = sett_index(thread, system.threads);
    return system.mean + texelFetch(sett_sums, ivec2(k + 1, system.row), 0).rgb -
           texelFetch(sett_sums, ivec2(k, system.row), 0).rgb;
}

// Fraction of the pixel [t - width/2, t + width/2] that the thread [thread, thread + 1] covers.
float coverage(float thread, float t, float width) {
    float low = max(thread, t - 0.5 * width), high = min(thread + 1.0, t + 0.5 * width);
    return max(high - low, 0.0) / width;
}

// Whether the warp is on top at this crossing, seen from `side`.
bool is_warp_seen(float end, float pick, float side) {
    float period = weave == 0 ? 2.0 : 4.0;
    float over = weave == 0 ? 1.0 : (weave == 1 ? 2.0 : 3.0);
    float place = end - pick;
    place -= period * floor((place + 0.5) / period);
    return (place < over - 0.5) == (side > 0.0);
}

// Fraction of the visible surface that is warp, seen from `side`.
float warp_share(float side) { return weave == 2 ? 0.5 + 0.25 * side : 0.5; }

// Difference between the single threads that the pixel covers (at most 4 x 4) and the mean mixture of warp and weft.
vec3 weave_detail(vec2 t, vec2 width, float side, bool is_near) {
    vec2 first = floor(t - 0.5 * width);
    float share = warp_share(side);
    int count = is_near ? 4 : 0;  // a loop count: software GL executes both sides of a branch
    vec3 detail = vec3(0.0);
    for (int j = 0; j < count; ++j) {
        float pick = first.y + float(j);
        float pick_share = coverage(pick, t.y, width.y);
        vec3 weft = thread_colour(weft_system(), pick);
        for (int i = 0; i < count; ++i) {
            float end = first.x + float(i);
            float seen = is_warp_seen(end, pick, side) ? 1.0 - share : -share;
            detail += coverage(end, t.x, width.x) * pick_share * seen * (thread_colour(warp_system(), end) - weft);
        }
    }
    return detail;
}

// Brightness of a round yarn at a position on its float, relative to its mean. across: -0.5..0.5; along: 0..1 within
// the crossing; dives: whether the yarn goes under at the beginning and end of the crossing. Every term, and every
// product of terms, has mean zero over a float.
float yarn_relief(float across, float along, vec2 dives, vec2 light) {
    vec2 depth = dives * vec2(pow(1.0 - along, 3.0), along * along * along);
    float round_of = 1.0 + 2.6 * (1.0 / 12.0 - across * across);
    float dive_of = 1.0 - 0.72 * (depth.x + depth.y - 0.25 * (dives.x + dives.y));
    float bend = 0.9 * across * light.x + 0.35 * (depth.y - depth.x) * light.y;
    return round_of * dive_of * (1.0 + bend) - 1.0;
}

// Brightness of the twisted fibres; every thread has a phase of its own. The mean is zero: whole waves per crossing.
float yarn_twist(float across, float along, float thread, float width) {
    float own = fract(sin(thread * 12.9898) * 43758.547);
    float strand = cos(kTwoPi * (3.0 * along + 1.4 * across + own)) * (1.0 - smoothstep(0.07, 0.16, width));
    float fibre = cos(kTwoPi * (8.0 * along + 3.1 * across + 5.0 * own)) * (1.0 - smoothstep(0.025, 0.06, width));
    return (0.085 * strand + 0.05 * fibre) * (1.0 - 3.0 * across * across);
}

float thread_relief(vec2 t, float side, float width) {
    vec2 cell = floor(t), at = fract(t);
    bool is_warp = is_warp_seen(cell.x, cell.y, side);
    vec2 next = is_warp ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
    vec2 dives = vec2(is_warp_seen(cell.x - next.x, cell.y - next.y, side) != is_warp,
                      is_warp_seen(cell.x + next.x, cell.y + next.y, side) != is_warp);
    vec2 place = is_warp ? at : at.yx;  // across, along
    float relief = yarn_relief(place.x - 0.5, place.y, dives, is_warp ? weave_light : weave_light.yx);
    return relief + yarn_twist(place.x - 0.5, place.y, is_warp ? cell.x : cell.y + 0.37, width);
}

// place: (weft, warp) on the fabric, m; side: 1 for the right side, -1 for the wrong side.
vec3 tartan(vec2 place, float side) {
    vec2 t = (place - sett_position) / thread_spacing;
    vec2 width = max(fwidth(t), vec2(0.01));
    vec3 colour = mix(mean_colour(weft_system(), t.y, width.y), mean_colour(warp_system(), t.x, width.x),
                      warp_share(side));
    float widest = max(width.x, width.y);
    float detail = 1.0 - smoothstep(0.9, 2.6, widest);
    colour += detail * weave_detail(t, width, side, detail > 0.0);
    float relief = 1.0 - smoothstep(0.22, 0.6, widest);
    return max(colour, vec3(0.0)) * (1.0 + relief * thread_relief(t, side, widest));
}
