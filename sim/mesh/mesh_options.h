#pragma once
// How finely panels are cut into triangles.

namespace selvedge {

struct MeshOptions {
    double target_edge = 0.05;   // m, the edge length aimed at; a T-shirt then has some 700 triangles
    double chord_error = 0.003;  // m, how far an outline curve may stand off its chords
    int relaxations = 12;        // rounds of moving interior points
    int max_triangles = 200000;  // of one panel; more is taken for an error in units

    bool operator==(const MeshOptions&) const = default;
};

}  // namespace selvedge
