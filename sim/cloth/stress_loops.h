#pragma once
// The loops over what refined triangles carry, see kernels.h. For kernels only (sim/core/simd_level.h).
#include "sim/cloth/loop_parts.h"

namespace selvedge {
namespace {

// Places of CarriedStress, read and written as points are. Triangles with the same parent share a vertex, so that no
// place comes twice in a colour, but for that of no triangle, which is read and never written.
[[gnu::always_inline]] inline Xyz load_places(const float* stress, const std::uint32_t* places) {
    return lanes::transposed(lanes::gather_points(stress, places));
}
[[gnu::always_inline]] inline bool are_all_of_triangles(const std::uint32_t* places) {
    return lanes::bits(lanes::load_ints(places) == static_cast<std::int32_t>(kNoPlace)) == 0;
}
[[gnu::always_inline]] inline void put_rows(float* stress, const std::uint32_t* places, const Rows& rows) {
    if (are_all_of_triangles(places)) return lanes::scatter_points(stress, places, rows);
    for (std::size_t i = 0; i < lanes::kCount; ++i) {
        if (places[i] == kNoPlace) continue;
        for (std::size_t k = 0; k < 4; ++k) stress[places[i] + k] = rows.row[i % 4][4 * (i / 4) + k];
    }
}
[[gnu::always_inline]] inline void put_places(float* stress, const std::uint32_t* places, const Xyz& values) {
    put_rows(stress, places, lanes::rows_of(values));
}
[[gnu::always_inline]] inline void add_to_places(float* stress, const std::uint32_t* places, const Xyz& by) {
    Rows sum = lanes::gather_points(stress, places);
    const Rows more = lanes::rows_of(by);
    for (int j = 0; j < 4; ++j) sum.row[j] = sum.row[j] + more.row[j];
    put_rows(stress, places, sum);
}
[[gnu::always_inline]] inline Xyz sum_of(const Xyz& p, const Xyz& q) {
    return {p.x + q.x, p.y + q.y, p.z + q.z};
}

// By the stiffness: what was carried by the triangle itself, of warp, weft and shear.
template <class Record>
[[gnu::always_inline]] inline Xyz stress_of(const Record& record, std::size_t at) {
    const auto one = [&](std::size_t k) {
        return -load_at(record.multiplier[k], at) * load_at(record.compliance[k], at);
    };
    return {one(0), one(1), one(2)};
}

void carry_stress(std::span<const LimitRecord> records, float* own, float* above) {
    for (const LimitRecord& record : records) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const Xyz stress = stress_of(record, at);
            put_places(own, &record.place[at], stress);
            put_places(above, &record.place[at], sum_of(load_places(above, &record.parent[at]), stress));
        }
    }
}

// What a limit's bias makes of it.
[[gnu::always_inline]] inline void apply_bias(LimitBlock& block, const LimitRecord& record, std::size_t at) {
    lanes::store(&block.longest_warp[at], load_at(record.free_length[0], at) - load_at(record.bias[0], at));
    lanes::store(&block.longest_weft[at], load_at(record.free_length[1], at) - load_at(record.bias[1], at));
    lanes::store(&block.shear[at], load_at(record.bias[2], at) * -load_at(record.per_shear, at));
}

// Of a refined triangle: stress of warp, weft and shear, by the stiffness, that it carries by itself and in all, and
// what its neighbours carry by themselves on an average.
struct Stress {
    Xyz own, all, beside;

    // N/m but for a factor that is the same for each: of warp and weft together.
    static Floats tension(const LimitRecord& record, std::size_t at, const Xyz& stress) {
        const Floats sum = stress.x / load_at(record.compliance[0], at) + stress.y / load_at(record.compliance[1], at);
        return lanes::greater(sum, lanes::all(kTiny));
    }
};

// Sums up, and hands on to the triangle that it is inside of.
[[gnu::always_inline]] inline Stress summed_stress(const LimitRecord& record, std::size_t at, const float* carried,
                                                   const float* above, float* below) {
    const Xyz own = stress_of(record, at);
    const Xyz inside = load_places(below, &record.place[at]);
    put_places(below, &record.place[at], Xyz{});
    const Floats of_area = load_at(record.of_area, at);
    const Xyz here = sum_of(inside, own);
    add_to_places(below, &record.parent[at], {here.x * of_area, here.y * of_area, here.z * of_area});
    const Xyz two =
        sum_of(load_places(carried, &record.neighbours[0][at]), load_places(carried, &record.neighbours[1][at]));
    const Xyz three = sum_of(two, load_places(carried, &record.neighbours[2][at]));
    const Floats third = lanes::all(1.0F / 3.0F);
    return {.own = own,
            .all = sum_of(inside, load_places(above, &record.place[at])),
            .beside = {three.x * third, three.y * third, three.z * third}};
}

// Tension along the threads alone may come from refined triangles as from leaves. Where it comes with shear it must
// not: forces of coarse triangles reach all that hangs on their corners, so at the cloth's edges they balance only if
// they are in the same proportion as the stress itself, and grow uneven unless they are evened out. So they share no
// more than the leaves cannot do well, and shear in the same share as tension.
[[gnu::always_inline]] inline void move_biases(LimitRecord& record, std::size_t at, const Stress& stress,
                                               Floats warp_strain, Floats weft_strain, const BiasGains& gains) {
    constexpr float kEvening = 0.1F;  // of the rate of the biases themselves
    const Floats one = lanes::all(1.0F);
    const Floats tension = Stress::tension(record, at, stress.all);
    const Floats share = lanes::lesser(Stress::tension(record, at, stress.own) / tension, one);
    const Floats per_tension = lanes::all(2.0F) / (load_at(record.compliance[2], at) * tension);
    const Floats sheared = lanes::greater(stress.all.z, -stress.all.z);
    const Floats with_shear = lanes::lesser(sheared * per_tension, one);
    const Floats easy = lanes::lesser(lanes::lesser(sheared, load_at(record.easy_shear, at)) * per_tension, one);
    const auto move = [&](std::size_t k, Floats strain, Floats all, Floats own, Floats beside) {
        const Floats uneven = (beside - own) * load_at(record.per_stress[k], at);
        const Floats off = strain - all + uneven * with_shear * lanes::all(kEvening);
        const Floats allowed =
            lanes::where(share < one - easy, off) + lanes::where(share >= one - easy, lanes::lesser(off, Floats{}));
        move_bias(record.bias[k], at, allowed, gains.stretch, 0.0F, gains.most);
    };
    move(0, warp_strain, stress.all.x, stress.own.x, stress.beside.x);
    move(1, weft_strain, stress.all.y, stress.own.y, stress.beside.y);
    const Floats missing = share * stress.all.z - stress.own.z;
    move_bias(record.bias[2], at, missing * load_at(record.per_stress[2], at), gains.stretch, -kMoreShear * gains.most,
              kMoreShear * gains.most);
}

void update_parents(std::span<LimitBlock> blocks, std::span<LimitRecord> records, const float* points,
                    const float* before, const BiasGains& gains, const float* carried, const float* above,
                    float* below) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        LimitBlock& block = blocks[i];
        LimitRecord& record = records[i];
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const Threads t = middle_threads(block, at, points, before);
            const Stress stress = summed_stress(record, at, carried, above, below);
            move_biases(record, at, stress, t.warp_length - 1.0F, t.weft_length - 1.0F, gains);
            apply_bias(block, record, at);
        }
    }
}

}  // namespace
}  // namespace selvedge
