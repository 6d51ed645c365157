#pragma once
// The entities of a DXF file as lines of points, points and texts, with the layers on which they lie.
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/core/math.h"
#include "sim/paper/dxf_records.h"
#include "sim/paper/dxf_text.h"

namespace selvedge::sim {

inline constexpr double kLargestDxfNumber = 1e7;  // drawing units
inline constexpr std::size_t kMostDxfVertices = 2000000;

struct DxfLine {
    int layer = -1;
    std::vector<Vec2d> points = {};
    bool is_closed = false;         // the last point repeats the first
    int line = 0;                   // in the file
    bool is_segment = false;        // a LINE: one of many may be a piece of a curve
    std::vector<int> corners = {};  // points that the file makes corners of: where its lines meet
    std::string style = {};         // equal for lines that are drawn alike: layer, colour, line type
    std::string layer_name = {};
};

struct DxfLayerText {
    int layer = -1;
    Vec2d at = Vec2d::Zero();
    std::string text;
};

// A block that is placed in the drawing or in another block.
struct DxfInsert {
    std::string block;
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    int line = 0;
    bool is_hidden = false;
};

struct DxfPiece {
    std::string name;
    int line = 0;
    Vec2d base = Vec2d::Zero();                          // of the block
    Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();  // of what it draws, since it was read
    std::vector<DxfLine> lines = {};
    std::vector<std::pair<int, Vec2d>> points = {};  // with their layers
    std::vector<DxfLayerText> texts = {};
    std::vector<DxfInsert> inserts = {};
    DxfRecords records = {};  // of files of Selvedge
};

// Whether a point is a number, and not too large.
bool is_dxf_place(const Vec2d& p);

// What a piece draws, moved. Its records stay as they are.
void transform(DxfPiece& piece, const Eigen::Affine2d& map);

// Adds what `more` draws to a piece.
void append(DxfPiece& piece, DxfPiece more);

class DxfEntityReader {
 public:
    // What lies on hidden layers is left out. Both lists outlive the reader.
    DxfEntityReader(const std::string& file, const std::set<std::string>& hidden_layers,
                    std::vector<std::string>& notes)
        : file_(file), hidden_layers_(hidden_layers), notes_(notes) {}

    // Adds what an entity draws. POLYLINE takes its vertices from the entities that follow; returns how many it took.
    std::size_t read(const std::vector<DxfEntity>& all, std::size_t index, DxfPiece& piece);

    // Takes the comments of Selvedge that stand behind an entity, as texts.
    static void read_comments(const DxfEntity& entity, DxfPiece& piece);

    // Entities that a layer or a code of their own hides.
    int hidden() const { return hidden_; }

 private:
    [[noreturn]] void fail(const DxfEntity& entity, const std::string& problem) const;
    double coordinate(const DxfEntity& entity, std::string_view text) const;
    Vec2d point(const DxfEntity& entity, int code) const;
    std::vector<Vec2d> points(const DxfEntity& entity, int code) const;
    DxfLine line_of(const DxfEntity& entity) const;
    bool is_hidden(const DxfEntity& entity) const;

    void add(DxfPiece& piece, DxfLine line, const DxfEntity& entity);
    std::size_t read_polyline(const std::vector<DxfEntity>& all, std::size_t index, DxfPiece& piece);
    void read_lwpolyline(const DxfEntity& entity, DxfPiece& piece);
    void read_arc(const DxfEntity& entity, DxfPiece& piece);
    void read_ellipse(const DxfEntity& entity, DxfPiece& piece);
    void read_spline(const DxfEntity& entity, DxfPiece& piece);
    void read_text(const DxfEntity& entity, DxfPiece& piece);
    void read_insert(const DxfEntity& entity, DxfPiece& piece);

    const std::string& file_;
    const std::set<std::string>& hidden_layers_;
    std::vector<std::string>& notes_;
    std::map<std::string, int> unknown_ = {};
    std::size_t vertices_ = 0;
    int hidden_ = 0;
};

}  // namespace selvedge::sim
