#include "sim/paper/svg_path.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

namespace selvedge::sim {
namespace {

// Reads numbers and flags from text, with blanks and commas between them.
class Scanner {
 public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::size_t place() const { return at_; }
    bool is_done() {
        skip_blanks();
        return at_ >= text_.size();
    }
    char peek() {
        skip_blanks();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    void advance() { ++at_; }

    bool number(double& value) {
        skip_blanks();
        const char* begin = text_.data() + at_;
        const char* end = text_.data() + text_.size();
        if (begin != end && *begin == '+') ++begin;
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error != std::errc() || !std::isfinite(value)) return false;
        at_ = static_cast<std::size_t>(stop - text_.data());
        return true;
    }

    // One digit, which needs nothing between it and the next number.
    bool flag(bool& value) {
        const char c = peek();
        if (c != '0' && c != '1') return false;
        value = c == '1';
        ++at_;
        return true;
    }

    bool point(Vec2d& p) { return number(p.x()) && number(p.y()); }

 private:
    void skip_blanks() {
        while (at_ < text_.size() && (std::isspace(static_cast<unsigned char>(text_[at_])) || text_[at_] == ',')) ++at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

struct EllipticalArc {
    Vec2d radii = Vec2d::Ones();
    double tilt = 0;  // rad
    bool is_large = false;
    bool is_sweep = false;
};

// From the end points to the centre and the angles, then to cubics of at most 45 degrees.
void draw_elliptical_arc(const Vec2d& from, const Vec2d& to, EllipticalArc arc, bool keeps_circles, PathBuilder& pen) {
    arc.radii = arc.radii.cwiseAbs();
    if (from == to) return;
    if (arc.radii.minCoeff() < 1e-12) return pen.line(to);
    const Eigen::Rotation2Dd tilt(arc.tilt);
    const Vec2d half = tilt.inverse() * ((from - to) / 2);
    const double excess = half.cwiseQuotient(arc.radii).squaredNorm();
    if (excess > 1) arc.radii *= std::sqrt(excess);
    if (keeps_circles && std::abs(arc.radii.x() - arc.radii.y()) < 1e-9 * arc.radii.x() && excess <= 1)
        return pen.arc(arc.radii.x(), arc.is_large, !arc.is_sweep, to);
    const double a = arc.radii.x(), b = arc.radii.y();
    const double factor = (arc.is_large == arc.is_sweep ? -1 : 1) * std::sqrt(std::max(0.0, 1 - excess) / excess);
    const Vec2d centre_turned(factor * a * half.y() / b, -factor * b * half.x() / a);
    const Vec2d centre = tilt * centre_turned + (from + to) / 2;
    const Vec2d first = (half - centre_turned).cwiseQuotient(arc.radii);
    const Vec2d last = (-half - centre_turned).cwiseQuotient(arc.radii);
    const double start = std::atan2(first.y(), first.x());
    double sweep = std::atan2(cross2(first, last), first.dot(last));
    if (!std::isfinite(start) || !std::isfinite(sweep)) return pen.line(to);  // radii beyond what a double holds
    if (arc.is_sweep && sweep < 0) sweep += 2 * std::numbers::pi;
    if (!arc.is_sweep && sweep > 0) sweep -= 2 * std::numbers::pi;
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (std::numbers::pi / 4) - 1e-9)));
    const double step = sweep / count, reach = 4.0 / 3 * std::tan(step / 4);
    const auto at = [&](double angle, double along) {
        const Vec2d on(std::cos(angle), std::sin(angle)), tangent(-std::sin(angle), std::cos(angle));
        return Vec2d(centre + tilt * Vec2d(arc.radii.cwiseProduct(on + along * tangent)));
    };
    for (int i = 0; i < count; ++i) {
        const double angle = start + i * step;
        pen.cubic(at(angle, reach), at(angle + step, -reach), i + 1 == count ? to : at(angle + step, 0));
    }
}

class PathReader {
 public:
    PathReader(std::string_view data, bool keeps_circles, PathBuilder& pen)
        : scan_(data), keeps_circles_(keeps_circles), pen_(pen) {}

    std::string read() {
        while (!scan_.is_done()) {
            const std::size_t place = scan_.place();
            const char c = scan_.peek();
            if (std::isalpha(static_cast<unsigned char>(c))) {
                command_ = c;
                scan_.advance();
            } else if (command_ == '\0' || command_ == 'Z' || command_ == 'z') {
                return fault("a command should be", place);
            }
            if (!has_moved_ && command_ != 'M' && command_ != 'm') return fault("a move should begin the path", place);
            if (!draw()) return fault("the path data are wrong", place);
        }
        return {};
    }

 private:
    static std::string fault(const std::string& what, std::size_t place) {
        return what + " at character " + std::to_string(place + 1);
    }

    bool is_relative() const { return std::islower(static_cast<unsigned char>(command_)) != 0; }
    Vec2d origin() const { return is_relative() ? pen_.position() : Vec2d(0, 0); }

    bool point(Vec2d& p) {
        if (!scan_.point(p)) return false;
        p += origin();
        return true;
    }

    bool draw() {
        const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(command_)));
        if (!draw(upper)) return false;
        // A smooth curve after another kind of command begins in no direction.
        if (upper != 'C' && upper != 'S') last_cubic_ = pen_.position();
        if (upper != 'Q' && upper != 'T') last_quadratic_ = pen_.position();
        return true;
    }

    bool draw(char upper) {
        const Vec2d from = pen_.position();
        switch (upper) {
            case 'M':
                return move();
            case 'Z':
                pen_.close();
                return true;
            case 'L':
                return line();
            case 'H':
                return along(0);
            case 'V':
                return along(1);
            case 'C':
            case 'S':
                return cubic(upper == 'S', from);
            case 'Q':
            case 'T':
                return quadratic(upper == 'T', from);
            case 'A':
                return arc(from);
            default:
                return false;
        }
    }

    bool move() {
        Vec2d to;
        if (!point(to)) return false;
        pen_.move(to);
        has_moved_ = true;
        command_ = is_relative() ? 'l' : 'L';  // further points are lines
        return true;
    }

    bool line() {
        Vec2d to;
        if (!point(to)) return false;
        pen_.line(to);
        return true;
    }

    bool along(Eigen::Index axis) {
        double value = 0;
        if (!scan_.number(value)) return false;
        Vec2d to = pen_.position();
        to[axis] = value + (is_relative() ? to[axis] : 0);
        pen_.line(to);
        return true;
    }

    bool cubic(bool is_smooth, const Vec2d& from) {
        Vec2d first = 2 * from - last_cubic_, second, to;
        if (!is_smooth && !point(first)) return false;
        if (!point(second) || !point(to)) return false;
        pen_.cubic(first, second, to);
        last_cubic_ = second;
        return true;
    }

    bool quadratic(bool is_smooth, const Vec2d& from) {
        Vec2d control = 2 * from - last_quadratic_, to;
        if (!is_smooth && !point(control)) return false;
        if (!point(to)) return false;
        pen_.quadratic(control, to);
        last_quadratic_ = control;
        return true;
    }

    bool arc(const Vec2d& from) {
        EllipticalArc arc;
        Vec2d to;
        double tilt_deg = 0;
        if (!scan_.point(arc.radii) || !scan_.number(tilt_deg) || !scan_.flag(arc.is_large) ||
            !scan_.flag(arc.is_sweep) || !point(to)) {
            return false;
        }
        arc.tilt = tilt_deg * std::numbers::pi / 180;
        draw_elliptical_arc(from, to, arc, keeps_circles_, pen_);
        return true;
    }

    Scanner scan_;
    bool keeps_circles_;
    PathBuilder& pen_;
    char command_ = '\0';
    bool has_moved_ = false;
    Vec2d last_cubic_ = Vec2d::Zero();
    Vec2d last_quadratic_ = Vec2d::Zero();
};

std::optional<Eigen::Affine2d> one_transform(std::string_view name, const std::vector<double>& v) {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    const std::size_t count = v.size();
    if (name == "matrix" && count == 6) {
        map.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0, 0, 1;
    } else if (name == "translate" && (count == 1 || count == 2)) {
        map.translate(Vec2d(v[0], count == 2 ? v[1] : 0));
    } else if (name == "scale" && (count == 1 || count == 2)) {
        map.scale(Vec2d(v[0], count == 2 ? v[1] : v[0]));
    } else if (name == "rotate" && (count == 1 || count == 3)) {
        const Vec2d about = count == 3 ? Vec2d(v[1], v[2]) : Vec2d(0, 0);
        map.translate(about);
        map.rotate(v[0] * std::numbers::pi / 180);
        map.translate(-about);
    } else if (name == "skewX" && count == 1) {
        map.matrix()(0, 1) = std::tan(v[0] * std::numbers::pi / 180);
    } else if (name == "skewY" && count == 1) {
        map.matrix()(1, 0) = std::tan(v[0] * std::numbers::pi / 180);
    } else {
        return std::nullopt;
    }
    return map;
}

}  // namespace

std::string draw_path_data(std::string_view data, bool keeps_circles, PathBuilder& pen) {
    return PathReader(data, keeps_circles, pen).read();
}

void draw_ellipse(const Vec2d& centre, const Vec2d& radii, bool keeps_circles, PathBuilder& pen) {
    if (!(radii.minCoeff() > 0)) return;
    const std::array<Vec2d, 4> axes{Vec2d(1, 0), Vec2d(0, 1), Vec2d(-1, 0), Vec2d(0, -1)};
    const auto at = [&](std::size_t i) { return Vec2d(centre + radii.cwiseProduct(axes[i % 4])); };
    pen.move(at(0));
    for (std::size_t i = 0; i < 4; ++i) {
        draw_elliptical_arc(at(i), at(i + 1), {.radii = radii, .is_sweep = true}, keeps_circles, pen);
    }
    pen.close();
}

std::vector<double> parse_numbers(std::string_view text) {
    Scanner scan(text);
    std::vector<double> numbers;
    double value = 0;
    while (!scan.is_done() && scan.number(value)) numbers.push_back(value);
    return numbers;
}

std::optional<Eigen::Affine2d> parse_transform(std::string_view text) {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    std::size_t at = 0;
    while (true) {
        at = text.find_first_not_of(" \t\r\n,", at);
        if (at == std::string_view::npos) return map;
        const std::size_t open = text.find('(', at), end = text.find(')', at);
        if (open == std::string_view::npos || end == std::string_view::npos || end < open) return std::nullopt;
        std::string_view name = text.substr(at, open - at);
        while (!name.empty() && std::isspace(static_cast<unsigned char>(name.back()))) name.remove_suffix(1);
        const auto one = one_transform(name, parse_numbers(text.substr(open + 1, end - open - 1)));
        if (!one) return std::nullopt;
        map = map * *one;
        at = end + 1;
    }
}

namespace {

// Values of a CSS function as the numbers that SVG has: lengths in px, angles in degrees. None: one has another unit.
std::optional<std::vector<double>> css_values(std::string_view text) {
    struct Unit {
        std::string_view name;
        double factor;
    };
    constexpr std::array kUnits = std::to_array<Unit>({{"", 1},
                                                       {"px", 1},
                                                       {"in", 96},
                                                       {"cm", 96 / 2.54},
                                                       {"mm", 96 / 25.4},
                                                       {"pt", 96.0 / 72},
                                                       {"deg", 1},
                                                       {"rad", 180 / std::numbers::pi},
                                                       {"grad", 0.9},
                                                       {"turn", 360}});
    std::vector<double> values;
    while (true) {
        const std::size_t first = text.find_first_not_of(" \t\r\n,");
        if (first == std::string_view::npos) return values;
        text.remove_prefix(first);
        const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n,"));
        const std::optional<SvgLength> length = parse_length(word);
        const auto unit = length ? std::ranges::find(kUnits, length->unit, &Unit::name) : kUnits.end();
        if (unit == kUnits.end()) return std::nullopt;
        values.push_back(length->value * unit->factor);
        text.remove_prefix(word.size());
    }
}

std::optional<Eigen::Affine2d> one_css_transform(std::string_view name, std::vector<double> v) {
    const bool is_along_y = name.ends_with('Y') && name != "skewY";
    if (v.size() == 1 && (name == "translateX" || name == "translateY"))
        return one_transform("translate", {is_along_y ? 0 : v[0], is_along_y ? v[0] : 0});
    if (v.size() == 1 && (name == "scaleX" || name == "scaleY"))
        return one_transform("scale", {is_along_y ? 1 : v[0], is_along_y ? v[0] : 1});
    return one_transform(name, v);
}

}  // namespace

std::optional<Eigen::Affine2d> parse_css_transform(std::string_view text) {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    while (true) {
        const std::size_t first = text.find_first_not_of(" \t\r\n");
        if (first == std::string_view::npos) return map;
        text.remove_prefix(first);
        const std::size_t open = text.find('('), end = text.find(')');
        if (open == std::string_view::npos || end == std::string_view::npos || end < open) return std::nullopt;
        const auto values = css_values(text.substr(open + 1, end - open - 1));
        const auto one = values ? one_css_transform(text.substr(0, open), *values) : std::nullopt;
        if (!one) return std::nullopt;
        map = map * *one;
        text.remove_prefix(end + 1);
    }
}

std::optional<SvgLength> parse_length(std::string_view text) {
    Scanner scan(text);
    SvgLength length;
    if (!scan.number(length.value)) return std::nullopt;
    std::string_view unit = text.substr(std::min(scan.place(), text.size()));
    while (!unit.empty() && std::isspace(static_cast<unsigned char>(unit.back()))) unit.remove_suffix(1);
    length.unit = unit;
    return length;
}

}  // namespace selvedge::sim
