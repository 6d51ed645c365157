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

void carry_stress(std::span<const LimitRecord> records, float* above) {
    for (const LimitRecord& record : records) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const Xyz all = sum_of(load_places(above, &record.parent[at]), stress_of(record, at));
            put_places(above, &record.place[at], all);
        }
    }
}

// What a limit's bias makes of it.
[[gnu::always_inline]] inline void apply_bias(LimitBlock& block, const LimitRecord& record, std::size_t at) {
    lanes::store(&block.longest_warp[at], load_at(record.free_length[0], at) - load_at(record.bias[0], at));
    lanes::store(&block.longest_weft[at], load_at(record.free_length[1], at) - load_at(record.bias[1], at));
    lanes::store(&block.shear[at], load_at(record.bias[2], at) * -load_at(record.per_shear, at));
}

// What was summed up for a place, which is left empty, and is handed on to that of the parent.
[[gnu::always_inline]] inline Xyz take_sum(float* sums, const LimitRecord& record, std::size_t at, const Xyz& more) {
    const Xyz inside = load_places(sums, &record.place[at]);
    put_places(sums, &record.place[at], Xyz{});
    const Xyz here = sum_of(inside, more);
    const Floats of_area = load_at(record.of_area, at);
    add_to_places(sums, &record.parent[at], {here.x * of_area, here.y * of_area, here.z * of_area});
    return inside;
}

// Of a refined triangle: stress of warp, weft and shear, by the stiffness, that it carries by itself, with all that it
// is inside of, and in all.
struct Stress {
    Xyz own, coarse, all;

    // N/m but for a factor that is the same for each: of warp and weft together.
    static Floats tension(const LimitRecord& record, std::size_t at, const Xyz& stress) {
        const Floats sum = stress.x / load_at(record.compliance[0], at) + stress.y / load_at(record.compliance[1], at);
        return lanes::greater(sum, lanes::all(kTiny));
    }
};

// off: what the leaves in it are off by on an average. The strain of the refined triangle itself does not do: the flat
// triangle through the corners of bent cloth is shorter than the cloth in some directions and longer in others.
//
// Tension along the threads alone may come from refined triangles as from leaves. Where it comes with shear it must
// not: forces of coarse triangles reach all that hangs on their corners, so at the cloth's edges they balance only if
// they are in the same proportion as the stress itself. So a refined triangle learns no more tension once it and all
// that it is inside of carry what the leaves cannot do well; and shear in the same share as tension.
[[gnu::always_inline]] inline void move_biases(LimitRecord& record, std::size_t at, const Stress& stress,
                                               const Xyz& off, const BiasGains& gains) {
    const Floats one = lanes::all(1.0F);
    const Floats tension = Stress::tension(record, at, stress.all);
    const Floats coarse = Stress::tension(record, at, stress.coarse) / tension;
    const Floats per_tension = lanes::all(2.0F) / (load_at(record.compliance[2], at) * tension);
    const Floats sheared = lanes::greater(stress.all.z, -stress.all.z);
    const Floats easy = lanes::lesser(lanes::lesser(sheared, load_at(record.easy_shear, at)) * per_tension, one);
    const auto move = [&](std::size_t k, Floats by) {
        const Floats allowed =
            lanes::where(coarse < one - easy, by) + lanes::where(coarse >= one - easy, lanes::lesser(by, Floats{}));
        move_bias(record.bias[k], at, allowed, gains.stretch, Floats{}, gains.most);
    };
    move(0, off.x);
    move(1, off.y);
    const Floats share = lanes::lesser(Stress::tension(record, at, stress.own) / tension, one);
    const Floats missing = share * stress.all.z - stress.own.z;
    move_bias(record.bias[2], at, missing * load_at(record.per_stress[2], at), gains.stretch,
              lanes::all(-kMoreShear * gains.most), kMoreShear * gains.most);
}

void update_parents(std::span<LimitBlock> blocks, std::span<LimitRecord> records, const BiasGains& gains,
                    const StressSums& sums) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        LimitRecord& record = records[i];
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const Xyz own = stress_of(record, at);
            const Xyz coarse = load_places(sums.above, &record.place[at]);
            const Xyz all = sum_of(take_sum(sums.below, record, at, own), coarse);
            const Xyz off = take_sum(sums.off, record, at, Xyz{});
            move_biases(record, at, {.own = own, .coarse = coarse, .all = all}, off, gains);
            apply_bias(blocks[i], record, at);
        }
    }
}

}  // namespace
}  // namespace selvedge
