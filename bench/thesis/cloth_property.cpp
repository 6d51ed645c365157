#include "bench/thesis/cloth_property.h"

#include "bench/thesis/thesis.h"

namespace selvedge::bench {
namespace {

struct Rows {
    Table& table;

    void add(const char* what, double value, int decimals, const char* unit) {
        table.add_row({what, Cell(value, decimals), unit[0] == '\0' ? Cell() : Cell(unit)});
    }
    void add(const char* what, float value, int decimals, const char* unit) {
        add(what, static_cast<double>(value), decimals, unit);
    }
    void add(const char* what, int count) { table.add_row({what, count, Cell()}); }
    void add(const char* what, bool is_on) { table.add_row({what, is_on ? "on" : "off", Cell()}); }
};

void add_fabric(Rows& rows, const sim::Fabric& fabric) {
    rows.table.add_row({"fabric", fabric.name, Cell()});
    rows.add("area density", fabric.area_density, 3, "kg/m^2");
    rows.add("stretch stiffness, warp", fabric.stretch_warp, 0, "N/m");
    rows.add("stretch stiffness, weft", fabric.stretch_weft, 0, "N/m");
    rows.add("shear stiffness", fabric.shear, 0, "N/m per rad");
    rows.add("bending rigidity, warp", 1e6 * fabric.bending_warp, 2, "uN m");
    rows.add("bending rigidity, weft", 1e6 * fabric.bending_weft, 2, "uN m");
    rows.add("strain limit", 100 * fabric.strain_limit, 1, "%");
    rows.add("friction on the body", fabric.friction, 2, "");
    rows.add("damping", fabric.damping, 2, "1/s");
    rows.add("air drag", fabric.air_drag, 3, "kg/(m^2 s)");
}

void add_stepping(Rows& rows, const ClothProperty& property) {
    const sim::StepOptions& stepping = property.stepping;
    rows.add("time step", 1e3 * property.step_seconds, 3, "ms");
    rows.add("sub-steps per step", stepping.substeps);
    rows.add("gravity", -stepping.gravity.y(), 2, "m/s^2");
    rows.add("extra damping", stepping.extra_damping, 2, "1/s");
    rows.add("internal damping", stepping.internal_damping, 1, "1/s");
    rows.add("stretch bias rate", stepping.stretch_bias_rate, 2, "1/s");
    rows.add("shear bias rate", stepping.shear_bias_rate, 2, "1/s");
    rows.add("strain limit iterations", stepping.limit_iterations);
    rows.add("contact offset", 1e3F * stepping.contact.offset, 2, "mm");
    rows.add("friction scale", stepping.contact.friction_scale, 2, "");
}

void add_adapting(Rows& rows, const ClothProperty& property) {
    constexpr float kDegrees = 57.29578F;
    const sim::AdaptClothOptions& adapting = property.adapting;
    rows.add("steps per adaptation", property.steps_per_adaptation);
    rows.add("deepest level", property.max_level);
    rows.add("shortest edge that is split", 1e3F * adapting.shortest_edge, 1, "mm");
    rows.add("criterion A, collision", adapting.criteria.collision);
    rows.add("criterion B, curvature", adapting.criteria.curvature);
    rows.add("curvature: split above", kDegrees * adapting.curvature.split_angle, 1, "degrees");
    rows.add("curvature: rejoin below", kDegrees * adapting.curvature.rejoin_angle, 1, "degrees");
    rows.add("criterion C, edge length", adapting.criteria.length);
    rows.add("compression: split above", 100 * adapting.length.split_compression, 1, "%");
    rows.add("compression: rejoin below", 100 * adapting.length.rejoin_compression, 1, "%");
    rows.add("criterion buckling", adapting.criteria.buckling);
}

}  // namespace

Table table_of(const ClothProperty& property, const std::string& name, const std::string& title) {
    Table table{.name = name, .title = title, .columns = {"parameter", "value", "unit"}};
    Rows rows{table};
    add_fabric(rows, property.fabric);
    add_stepping(rows, property);
    add_adapting(rows, property);
    return table;
}

ThesisResult list_cloth_properties(const ThesisOptions&) {
    Table table = table_of({}, "listing-3.5", "The global settings of the cloth");
    table.note =
        "The product's defaults, read from the options that the simulation takes. An experiment that differs says so "
        "beside its table.";
    return {.tables = {table}};
}

}  // namespace selvedge::bench
