#pragma once
// How SVG elements are drawn: style sheets, style attributes and presentation attributes together.  (W3C, "Cascading
// Style Sheets Level 2" 6.4 and "Selectors Level 3")
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace selvedge::sim {

// What an element looks like, as far as it tells parts from what is not drawn. Inherited from its parent, but for
// `transform` and `is_drawn`.
struct SvgLook {
    bool is_drawn = true;    // false: display is none or opacity is 0, so that nothing within is drawn either
    bool is_visible = true;  // visibility
    std::string fill = "black";
    std::string stroke = "none";
    std::string dashes = "none";
    bool is_fill_clear = false, is_stroke_clear = false;  // their opacity is 0
    bool is_stroke_thin = false;                          // its width is 0

    bool is_painted() const { return has_fill() || has_stroke(); }
    bool has_fill() const { return fill != "none" && !is_fill_clear; }
    bool has_stroke() const { return stroke != "none" && !is_stroke_clear && !is_stroke_thin; }

    std::string transform = {};  // of the style, which goes before the attribute
};

// A name without its namespace prefix.
std::string_view local_name(std::string_view name);

class SvgStyles {
 public:
    // The file is named in errors, and outlives the styles.
    explicit SvgStyles(const std::string& file) : file_(file) {}

    // Adds the rules of a style sheet. Rules whose selectors have other parts than names, classes, ids and ancestors,
    // and those within @-rules other than @media for screens, are left out.
    void add_sheet(std::string_view css);

    // Throws InputError where comparing selectors with elements takes without end.
    SvgLook look_of(const pugi::xml_node& node, const SvgLook& parent);

    // Selectors of rules that could hide something, and have parts that are not understood or come after the 2,000th.
    int left_out() const { return left_out_; }

 private:
    using Properties = std::map<std::string, std::string, std::less<>>;

    // "g.cut#front": empty parts ask nothing.
    struct Compound {
        std::string tag = {};
        std::string id = {};
        std::vector<std::string> classes = {};
        bool is_child = false;  // of the compound before it, not only within it
    };
    struct Rule {
        std::vector<Compound> selector;
        int specificity = 0;
        Properties properties;
        Properties important;
    };

    using Numbers = std::vector<std::size_t>;  // of rules
    using NumbersByName = std::map<std::string, Numbers, std::less<>>;

    static bool read_selector(std::string_view text, Rule& rule);
    bool matches(const Compound& compound, const pugi::xml_node& node);
    bool matches(const std::vector<Compound>& selector, const pugi::xml_node& node);
    void add_rules(std::string_view css, int depth);
    void sort_rules();
    Numbers rules_for(const pugi::xml_node& node);
    void count_steps(std::size_t steps);

    const std::string& file_;
    int left_out_ = 0;
    std::size_t steps_ = 0;
    std::vector<Rule> rules_;  // in the order in which they count, once they are sorted: the last wins
    bool is_sorted_ = true;
    // By what the last part of the selector asks: an id, else a class, else a name, else nothing.
    NumbersByName by_id_, by_class_, by_tag_;
    Numbers for_all_;
};

}  // namespace selvedge::sim
