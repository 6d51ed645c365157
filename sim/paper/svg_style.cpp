#include "sim/paper/svg_style.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

#include "sim/core/error.h"
#include "sim/core/lower_case.h"
#include "sim/core/trimmed.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kMostStyleRules = 2000;
constexpr int kDeepestMedia = 16;
constexpr std::size_t kMostSteps = 500'000'000;  // compared characters: seconds
constexpr std::size_t kStepsPerProperty = 16;

// The properties that are also attributes; of a style, `transform` counts too.
constexpr std::array<const char*, 9> kLooks{"display",        "visibility",       "opacity",
                                            "fill",           "stroke",           "fill-opacity",
                                            "stroke-opacity", "stroke-dasharray", "stroke-width"};

bool is_read(std::string_view property) {
    return property == "transform" || std::ranges::find(kLooks, property) != kLooks.end();
}

// Without comments, and with spaces for line breaks.
std::string plain_css(std::string_view css) {
    std::string text;
    while (!css.empty()) {
        const std::size_t from = css.find("/*");
        text += css.substr(0, from);
        if (from == std::string_view::npos) break;
        const std::size_t to = css.find("*/", from + 2);
        css = to == std::string_view::npos ? std::string_view() : css.substr(to + 2);
        text += ' ';
    }
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\f'; }, ' ');
    return text;
}

// The position of the brace that closes the one before `from`; the end if none does.
std::size_t closing_brace(std::string_view css, std::size_t from) {
    int depth = 1;
    for (std::size_t i = from; i < css.size(); ++i) {
        depth += css[i] == '{' ? 1 : css[i] == '}' ? -1 : 0;
        if (depth == 0) return i;
    }
    return css.size();
}

// Takes the text up to a separator from the front, without it.
std::string_view take_until(std::string_view& text, char separator) {
    const std::size_t at = text.find(separator);
    const std::string_view part = text.substr(0, at);
    text = at == std::string_view::npos ? std::string_view() : text.substr(at + 1);
    return part;
}

template <class Take>
void for_each_declaration(std::string_view text, Take take) {
    while (!text.empty()) {
        std::string_view declaration = take_until(text, ';');
        const std::string name = lower_case(trimmed(take_until(declaration, ':')));
        std::string_view value = trimmed(declaration);
        const std::size_t mark = value.rfind('!');
        const bool is_important =
            mark != std::string_view::npos && lower_case(trimmed(value.substr(mark + 1))) == "important";
        if (is_important) value = trimmed(value.substr(0, mark));
        if (is_read(name) && !value.empty()) take(name, std::string(value), is_important);
    }
}

bool is_name_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

std::string_view take_name(std::string_view& text) {
    std::size_t end = 0;
    while (end < text.size() && is_name_letter(text[end])) ++end;
    const std::string_view name = text.substr(0, end);
    text.remove_prefix(end);
    return name;
}

bool has_class(std::string_view classes, std::string_view wanted) {
    while (!classes.empty()) {
        const std::size_t end = std::min(classes.find_first_of(" \t\r\n"), classes.size());
        if (classes.substr(0, end) == wanted) return true;
        classes.remove_prefix(std::min(end + 1, classes.size()));
    }
    return false;
}

// Zero, of "0", "0.0" and "0%".
bool is_zero(const std::string& value) {
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    return end != value.c_str() && number <= 0;
}

// "transparent", "rgba(0, 0, 0, 0)", "#10203000".
bool is_clear_color(const std::string& color) {
    constexpr std::size_t kWithAlpha = 9;
    if (color == "transparent") return true;
    if (color.starts_with('#')) return color.size() == kWithAlpha && color.ends_with("00");
    const std::size_t last = color.find_last_of(",/");
    const bool has_alpha = std::ranges::count(color, ',') == 3 || color.find('/') != std::string::npos;
    return color.find('(') != std::string::npos && has_alpha && is_zero(color.substr(last + 1));
}

template <class Properties>
bool can_hide(const Properties& properties) {
    return properties.contains("display") || properties.contains("visibility") || properties.contains("opacity");
}

}  // namespace

std::string_view local_name(std::string_view name) {
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

void SvgStyles::add_sheet(std::string_view css) {
    add_rules(plain_css(css), 0);
    is_sorted_ = false;
}

void SvgStyles::add_rules(std::string_view css, int depth) {
    while (true) {
        const std::size_t open = css.find('{');
        if (open == std::string_view::npos) return;
        std::string_view head = css.substr(0, open);
        if (const std::size_t statement = head.rfind(';'); statement != std::string_view::npos)
            head.remove_prefix(statement + 1);  // @import "..."; and its like
        head = trimmed(head);
        const std::size_t close = closing_brace(css, open + 1);
        const std::string_view body = css.substr(open + 1, close - open - 1);
        css = css.substr(std::min(close + 1, css.size()));
        if (head.starts_with('@')) {
            const std::string media = lower_case(head);
            const bool is_for_print = media.find("print") != std::string::npos &&
                                      media.find("screen") == std::string::npos &&
                                      media.find("all") == std::string::npos;
            if (!media.starts_with("@media") || is_for_print) continue;
            if (depth < kDeepestMedia) {
                add_rules(body, depth + 1);
            } else {
                ++left_out_;
            }
            continue;
        }
        Rule rule;
        for_each_declaration(body, [&](const std::string& name, std::string value, bool is_important) {
            (is_important ? rule.important : rule.properties)[name] = std::move(value);
        });
        if (rule.properties.empty() && rule.important.empty()) continue;
        const bool hides = can_hide(rule.properties) || can_hide(rule.important);
        while (!head.empty()) {
            const std::string_view selector = trimmed(take_until(head, ','));
            Rule one;
            if (rules_.size() < kMostStyleRules && read_selector(selector, one)) {
                one.properties = rule.properties;
                one.important = rule.important;
                rules_.push_back(std::move(one));
            } else if (hides) {
                ++left_out_;
            }
        }
    }
}

void SvgStyles::sort_rules() {
    if (is_sorted_) return;
    is_sorted_ = true;
    std::ranges::stable_sort(rules_, {}, &Rule::specificity);
    by_id_.clear();
    by_class_.clear();
    by_tag_.clear();
    for_all_.clear();
    for (std::size_t i = 0; i < rules_.size(); ++i) {
        const Compound& last = rules_[i].selector.back();
        Numbers& list = !last.id.empty()        ? by_id_[last.id]
                        : !last.classes.empty() ? by_class_[last.classes.front()]
                        : !last.tag.empty()     ? by_tag_[last.tag]
                                                : for_all_;
        list.push_back(i);
    }
}

void SvgStyles::count_steps(std::size_t steps) {
    steps_ += steps;
    if (steps_ > kMostSteps) throw InputError(file_, "", "its style sheets have too many rules for so many elements");
}

// Those that may match a node, in order.
SvgStyles::Numbers SvgStyles::rules_for(const pugi::xml_node& node) {
    Numbers numbers = for_all_;
    const auto add = [&](const NumbersByName& lists, std::string_view name) {
        if (const auto found = lists.find(name); found != lists.end())
            numbers.insert(numbers.end(), found->second.begin(), found->second.end());
    };
    add(by_tag_, local_name(node.name()));
    add(by_id_, node.attribute("id").value());
    if (!by_class_.empty()) {
        std::string_view classes = node.attribute("class").value();
        count_steps(classes.size());
        std::set<std::string_view> different;
        while (!classes.empty()) {
            const std::size_t end = std::min(classes.find_first_of(" \t\r\n"), classes.size());
            if (different.insert(classes.substr(0, end)).second) add(by_class_, classes.substr(0, end));
            classes.remove_prefix(std::min(end + 1, classes.size()));
        }
    }
    std::ranges::sort(numbers);
    return numbers;
}

bool SvgStyles::read_selector(std::string_view text, Rule& rule) {
    constexpr int kId = 10000, kClass = 100, kTag = 1;
    constexpr std::size_t kMostParts = 64, kMostClasses = 16;
    bool is_child = false;
    while (!text.empty()) {
        if (rule.selector.size() >= kMostParts) return false;
        Compound compound{.is_child = is_child};
        if (text.front() == '*') {
            text.remove_prefix(1);
        } else if (is_name_letter(text.front())) {
            const std::string_view first = take_name(text);
            compound.tag = first;
            rule.specificity += kTag;
        }
        while (!text.empty() && (text.front() == '.' || text.front() == '#')) {
            const bool is_id = text.front() == '#';
            text.remove_prefix(1);
            const std::string name(take_name(text));
            if (name.empty() || compound.classes.size() >= kMostClasses) return false;
            if (is_id) compound.id = name;
            if (!is_id) compound.classes.push_back(name);
            rule.specificity += is_id ? kId : kClass;
        }
        rule.selector.push_back(std::move(compound));
        if (!text.empty() && std::string_view(" \t\r>").find(text.front()) == std::string_view::npos) return false;
        text = trimmed(text);
        is_child = text.starts_with('>');
        if (is_child) text = trimmed(text.substr(1));
        if (is_child && text.empty()) return false;
        if (!text.empty() && text.front() != '*' && text.front() != '.' && text.front() != '#' &&
            !is_name_letter(text.front()))
            return false;
    }
    return !rule.selector.empty();
}

bool SvgStyles::matches(const Compound& compound, const pugi::xml_node& node) {
    count_steps(1);
    if (!compound.tag.empty() && local_name(node.name()) != compound.tag) return false;
    if (!compound.id.empty() && compound.id != node.attribute("id").value()) return false;
    if (compound.classes.empty()) return true;
    const std::string_view classes = node.attribute("class").value();
    count_steps(compound.classes.size() * classes.size());
    return std::ranges::all_of(compound.classes, [&](const std::string& one) { return has_class(classes, one); });
}

// Whether a node matches a selector: itself the last compound, its nearest ancestors that do the others.
bool SvgStyles::matches(const std::vector<Compound>& selector, const pugi::xml_node& node) {
    if (!matches(selector.back(), node)) return false;
    pugi::xml_node above = node.parent();
    for (std::size_t k = selector.size() - 1; k > 0; --k) {
        if (!selector[k].is_child) {
            while (above.type() == pugi::node_element && !matches(selector[k - 1], above)) above = above.parent();
        }
        if (above.type() != pugi::node_element || !matches(selector[k - 1], above)) return false;
        above = above.parent();
    }
    return true;
}

SvgLook SvgStyles::look_of(const pugi::xml_node& node, const SvgLook& parent) {
    sort_rules();
    Properties style;
    for (const char* name : kLooks) {
        if (const pugi::xml_attribute value = node.attribute(name)) style[name] = trimmed(value.value());
    }
    std::vector<const Rule*> matching;
    for (const std::size_t i : rules_for(node)) {
        const Rule& rule = rules_[i];
        if (!matches(rule.selector, node)) continue;
        count_steps(kStepsPerProperty * (rule.properties.size() + rule.important.size()));
        matching.push_back(&rule);
    }
    for (const Rule* rule : matching) {
        for (const auto& [name, value] : rule->properties) style[name] = value;
    }
    Properties important;
    for (const Rule* rule : matching) {
        for (const auto& [name, value] : rule->important) important[name] = value;
    }
    for_each_declaration(node.attribute("style").value(),
                         [&](const std::string& name, std::string value, bool is_important) {
                             (is_important ? important : style)[name] = std::move(value);
                         });
    for (const auto& [name, value] : important) style[name] = value;

    SvgLook look = parent;
    look.transform.clear();
    const auto given = [&](std::string_view name) -> const std::string* {
        const auto found = style.find(name);
        return found == style.end() || found->second == "inherit" ? nullptr : &found->second;
    };
    if (const std::string* value = given("display")) look.is_drawn = *value != "none";
    if (const std::string* value = given("opacity")) look.is_drawn = look.is_drawn && !is_zero(*value);
    if (const std::string* value = given("visibility")) look.is_visible = *value != "hidden" && *value != "collapse";
    if (const std::string* value = given("fill")) look.fill = *value;
    if (const std::string* value = given("stroke")) look.stroke = *value;
    if (const std::string* value = given("stroke-dasharray")) look.dashes = *value;
    if (const std::string* value = given("fill-opacity")) look.is_fill_clear = is_zero(*value);
    if (const std::string* value = given("stroke-opacity")) look.is_stroke_clear = is_zero(*value);
    if (const std::string* value = given("stroke-width")) look.is_stroke_thin = is_zero(*value);
    if (const std::string* value = given("transform"); value && *value != "none") look.transform = *value;
    for (std::string* color : {&look.fill, &look.stroke}) {
        if (is_clear_color(*color)) *color = "none";
    }
    return look;
}

}  // namespace selvedge::sim
