#include "sim/print/dxf_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>

#include "sim/paper/field_record.h"
#include "sim/paper/placement_record.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/outline.h"
#include "sim/print/paper_piece.h"

namespace selvedge::sim {
namespace {

constexpr double kChordError = 2e-5;  // m

std::string number(double value) {
    std::array<char, 64> text{};
    const auto [stop, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 6);
    return error == std::errc() ? std::string(text.data(), stop) : "0.0";
}

std::string in_mm(const Vec2d& p) {
    return number(1000 * p.x()) + " " + number(1000 * p.y());
}

// The code point that begins at `at`, which moves behind it. Broken UTF-8 counts as Latin-1.
std::uint32_t next_character(std::string_view text, std::size_t& at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::uint32_t first = byte(at++);
    const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
    if (more == 0 || at + static_cast<std::size_t>(more) > text.size()) return first;
    std::uint32_t code = first & (0x3FU >> static_cast<unsigned>(more));
    for (int k = 0; k < more; ++k) code = (code << 6U) | (byte(at + static_cast<std::size_t>(k)) & 0x3FU);
    at += static_cast<std::size_t>(more);
    return code;
}

// As UTF-16 units outside ASCII, as DXF writes them. Control characters become blanks.
std::string ascii(std::string_view text) {
    std::string out;
    const auto append = [&](std::uint32_t unit) {
        std::array<char, 16> escape{};
        std::snprintf(escape.data(), escape.size(), "\\U+%04X", unit);
        out += escape.data();
    };
    for (std::size_t at = 0; at < text.size();) {
        const std::uint32_t code = next_character(text, at);
        if (code < 0x20) {
            out += ' ';
        } else if (code < 0x7F) {
            out += static_cast<char>(code);
        } else if (code < 0x10000) {
            append(code);
        } else {
            append(0xD800 + ((code - 0x10000) >> 10U));
            append(0xDC00 + ((code - 0x10000) & 0x3FFU));
        }
    }
    return out;
}

class DxfWriter {
 public:
    DxfWriter(const Pattern& pattern, DxfStandard standard, const DxfStamp& stamp)
        : pattern_(pattern), standard_(standard), stamp_(stamp) {}

    std::string write() {
        section("HEADER");
        group(9, "$ACADVER");
        group(1, "AC1009");
        end_section();
        write_layers();
        const std::vector<PaperPiece> pieces = paper_pieces(pattern_, {.chord_error = kChordError});
        section("BLOCKS");
        for (const PaperPiece& piece : pieces) write_block(piece);
        end_section();
        section("ENTITIES");
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            group(0, "INSERT");
            group(8, "1");
            group(2, blocks_[i]);
            point(10, Vec2d::Zero());
        }
        text(1, "Style Name: " + pattern_.name);
        write_stamp();
        text(1, "Units: METRIC");
        if (!pattern_.size.empty()) text(1, "Sample Size: " + pattern_.size);
        write_seams();
        if (has_portable_placement(pattern_)) write_body();
        end_section();
        group(0, "EOF");
        return std::move(out_);
    }

 private:
    void group(int code, std::string_view value) {
        out_ += std::to_string(code) + "\n";
        out_ += value;
        out_ += '\n';
    }

    void section(const char* name) {
        group(0, "SECTION");
        group(2, name);
    }

    void end_section() { group(0, "ENDSEC"); }

    void point(int code, const Vec2d& p) {
        group(code, number(1000 * p.x()));
        group(code + 10, number(1000 * p.y()));
    }

    void write_layers() {
        constexpr std::array layers{"1", "2", "3", "4", "7", "8", "13", "14", "15", "80", "81", "82", "83"};
        section("TABLES");
        group(0, "TABLE");
        group(2, "LAYER");
        group(70, std::to_string(layers.size()));
        for (const char* layer : layers) {
            group(0, "LAYER");
            group(2, layer);
            group(70, "0");
            group(62, "7");
            group(6, "CONTINUOUS");
        }
        group(0, "ENDTAB");
        end_section();
    }

    // ---- Entities.

    void text(int layer, const std::string& value, const Vec2d& at = Vec2d::Zero()) {
        constexpr std::size_t kLongest = 250;  // of R10
        group(0, "TEXT");
        group(8, std::to_string(layer));
        point(10, at);
        group(40, "5.0");
        group(1, ascii(value).substr(0, kLongest));
    }

    // In a comment, which nothing draws.
    void record(const std::string& value) {
        constexpr std::size_t kLongest = 250;
        group(999, ascii(value).substr(0, kLongest));
    }

    void write_stamp() {
        if (!stamp_.date.empty()) text(1, "Creation Date: " + stamp_.date);
        if (!stamp_.time.empty()) text(1, "Creation Time: " + stamp_.time);
        text(1, "Author: Selvedge");
        text(1, "Product: Selvedge");
        if (!stamp_.version.empty()) text(1, "Version: " + stamp_.version);
    }

    void line(int layer, const Vec2d& from, const Vec2d& to) {
        group(0, "LINE");
        group(8, std::to_string(layer));
        point(10, from);
        point(11, to);
    }

    void mark(int layer, const Vec2d& at) {
        group(0, "POINT");
        group(8, std::to_string(layer));
        point(10, at);
    }

    void polyline(int layer, const std::vector<Vec2d>& points, bool is_closed) {
        group(0, "POLYLINE");
        group(8, std::to_string(layer));
        group(66, "1");
        group(70, is_closed ? "1" : "0");
        for (const Vec2d& p : points) {
            group(0, "VERTEX");
            group(8, std::to_string(layer));
            point(10, p);
        }
        group(0, "SEQEND");
        group(8, std::to_string(layer));
    }

    // ---- A panel.

    // Letters and digits of R10 only; each name once.
    std::string block_name(const Panel& panel) {
        constexpr std::size_t kLongest = 24;
        std::string name;
        for (const char c : panel.name) {
            const bool is_small = c >= 'a' && c <= 'z', is_kept = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
            if (name.size() < kLongest) name += is_small ? static_cast<char>(c - 'a' + 'A') : is_kept ? c : '_';
        }
        if (name.empty()) name = "PIECE";
        std::string free = name;
        for (int k = 2; used_.contains(free); ++k) free = name + "_" + std::to_string(k);
        used_.insert(free);
        blocks_.push_back(free);
        return free;
    }

    void write_block(const PaperPiece& piece) {
        const Panel& panel = pattern_.panels[static_cast<std::size_t>(piece.panel)];
        const std::string name = block_name(panel);
        group(0, "BLOCK");
        group(8, "1");
        group(2, name);
        group(70, "0");
        point(10, Vec2d::Zero());
        polyline(1, piece.cut, true);
        write_points(piece.cut);
        if (piece.sew != piece.cut) polyline(14, piece.sew, true);  // without an allowance the boundary is both
        for (const OutlineEdge& edge : panel.edges) mark(2, panel.vertices[static_cast<std::size_t>(edge.start)]);
        for (const NotchLine& notch : piece.notches) mark(notch_layer(notch.kind), notch.on_cut);
        for (const PaperLine& line_of_paper : piece.lines) {
            if (line_of_paper.layer == PaperLayer::Grain)
                line(7, line_of_paper.points.front(), line_of_paper.points.back());
        }
        for (const InternalLine& line : panel.internal_lines) {
            if (line.points.size() >= 2) polyline(8, line.points, false);
        }
        for (const Vec2d& at : panel.drill_points) mark(13, at);
        write_texts(panel, piece);
        write_records(panel);
        group(0, "ENDBLK");
        group(8, "1");
    }

    int notch_layer(NotchKind kind) const {
        if (standard_ == DxfStandard::Aama) return 4;
        switch (kind) {
            case NotchKind::Slit:
                return 4;
            case NotchKind::T:
                return 80;
            case NotchKind::Castle:
                return 81;
            case NotchKind::V:
                return 82;
            case NotchKind::U:
                return 83;
        }
        return 4;
    }

    // Of the cut line: points at which it turns more than a polyline along a smooth curve does, and the rest.
    void write_points(const std::vector<Vec2d>& line) {
        constexpr double kLeast = 0.02, kSharp = 0.2;  // rad
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Vec2d a = line[i] - line[(i + line.size() - 1) % line.size()],
                        b = line[(i + 1) % line.size()] - line[i];
            // A chord of length l that is off its arc by e turns by 8 e / l from the next one.
            const double smooth = 8 * kChordError / std::max(1e-9, std::min(a.norm(), b.norm()));
            const double turn = std::abs(std::atan2(cross2(a, b), a.dot(b)));
            mark(turn > std::clamp(3 * smooth, kLeast, kSharp) ? 2 : 3, line[i]);
        }
    }

    void write_texts(const Panel& panel, const PaperPiece& piece) {
        Vec2d at = piece.label.at;
        const auto say = [&](const std::string& value) {
            text(1, value, at);
            at.y() -= 0.007;
        };
        say("Piece Name: " + panel.name);
        if (!pattern_.size.empty()) say("Size: " + pattern_.size);
        say("Quantity: " + std::to_string(panel.pieces));
        const std::string& fabric = panel.fabric.empty() ? pattern_.fabric : panel.fabric;
        if (!fabric.empty()) say("Material: " + fabric_title(fabric));
    }

    // ---- What the standards have no entity for.

    void write_records(const Panel& panel) {
        for (std::size_t e = 0; e < panel.edges.size(); ++e) {
            const OutlineEdge& edge = panel.edges[e];
            const Vec2d& start = panel.vertices[static_cast<std::size_t>(edge.start)];
            std::string edge_record = "SELVEDGE EDGE " + in_mm(start);
            switch (edge.kind) {
                case CurveKind::Line:
                    edge_record += " LINE";
                    break;
                case CurveKind::Quadratic:
                    edge_record += " QUADRATIC " + in_mm(edge.control[0]);
                    break;
                case CurveKind::Cubic:
                    edge_record += " CUBIC " + in_mm(edge.control[0]) + " " + in_mm(edge.control[1]);
                    break;
                case CurveKind::Arc:
                    edge_record += " ARC " + number(1000 * edge.arc_radius) + (edge.is_large_arc ? " 1" : " 0") +
                                   (edge.turns_right ? " 1" : " 0");
                    break;
            }
            record(edge_record);
        }
        for (const Notch& notch : panel.notches) {
            record("SELVEDGE NOTCH " + std::to_string(notch.edge) + " " + number(notch.t) + " " +
                   std::string(name_of_value(notch.kind)) + " " + std::to_string(notch.count));
        }
        for (const InternalLine& line : panel.internal_lines) {
            if (line.points.size() < 2) continue;
            record("SELVEDGE LINE " + std::string(name_of_value(line.use)) + " " + line.name);
        }
        write_properties(panel);
        if (!has_portable_placement(pattern_)) return;
        for (const std::string& phrase : placement_phrases(panel)) record("SELVEDGE PLACED " + phrase);
    }

    void write_properties(const Panel& panel) {
        for (std::size_t e = 0; e < panel.edges.size(); ++e)
            write_properties("OF edge " + std::to_string(e), record_phrases(panel.edges[e]));
        std::size_t number = 0;
        for (const InternalLine& line : panel.internal_lines) {
            if (line.points.size() < 2) continue;
            write_properties("OF line " + std::to_string(number++), record_phrases(line));
        }
    }

    void write_properties(const std::string& of, const std::vector<std::string>& phrases) {
        for (const std::string& phrase : phrases) record("SELVEDGE " + of + " " + phrase);
    }

    // A sewing is told by its number: a name can be too long for a text, or have letters that DXF lacks.
    void write_seams() {
        std::map<std::string, std::size_t> numbers;
        for (const Seam& seam : pattern_.seams) {
            const auto side = [](const SeamSide& s) { return std::to_string(s.panel) + ":" + std::to_string(s.edge); };
            record("SELVEDGE SEAM " + side(seam.first) + " " + side(seam.second) +
                   (seam.is_reversed ? " reversed" : " same") + (seam.is_eased ? " eased " : " exact ") + seam.name);
            write_properties("SEAMED " + side(seam.first), record_phrases(seam));
            if (seam.sewing.empty()) continue;
            const std::size_t number = numbers.try_emplace(seam.sewing, numbers.size() + 1).first->second;
            record("SELVEDGE SEWING " + side(seam.first) + " " + std::to_string(number) + " " + seam.sewing);
        }
    }

    // In as many texts as it needs.
    void write_body() {
        constexpr std::size_t kMost = 200;
        const std::string phrase = body_phrase(pattern_);
        for (std::size_t at = 0; at < phrase.size(); at += kMost) record("SELVEDGE BODY " + phrase.substr(at, kMost));
    }

    const Pattern& pattern_;
    DxfStandard standard_;
    const DxfStamp& stamp_;
    std::set<std::string> used_;
    std::vector<std::string> blocks_;
    std::string out_;
};

}  // namespace

std::string dxf_of(const Pattern& pattern, DxfStandard standard, const DxfStamp& stamp) {
    return DxfWriter(pattern, standard, stamp).write();
}

}  // namespace selvedge::sim
