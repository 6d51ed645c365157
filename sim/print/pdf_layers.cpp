#include "sim/print/pdf_layers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <optional>

namespace selvedge::sim {
namespace {

std::optional<std::size_t> number_at(std::string_view text, std::size_t at) {
    while (at < text.size() && text[at] == ' ') ++at;
    std::size_t number = 0;
    const auto [stop, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
    return error == std::errc() ? std::optional(number) : std::nullopt;
}

// The number behind a key, as 8 in "/Contents 8 0 R".
std::optional<std::size_t> number_after(std::string_view text, std::string_view key) {
    const std::size_t at = text.find(key);
    return at == std::string_view::npos ? std::nullopt : number_at(text, at + key.size());
}

std::string reference(std::size_t number) {
    return std::to_string(number) + " 0 R";
}

// Text between parentheses in PDF: UTF-16 with its mark where it is not ASCII would be needed; names of layers are.
std::string string_of(const std::string& text) {
    std::string out = "(";
    for (const char c : text) {
        if (c == '(' || c == ')' || c == '\\') out += '\\';
        out += c;
    }
    return out + ")";
}

class LayerWriter {
 public:
    LayerWriter(const std::string& pdf, const std::vector<std::string>& names,
                const std::vector<std::vector<int>>& used)
        : pdf_(pdf), names_(names), used_(used) {}

    std::optional<std::string> write() {
        if (!find_objects() || !find_pages()) return std::nullopt;
        first_group_ = objects_.size();
        for (std::size_t page = 0; page < pages_.size(); ++page) {
            if (page < used_.size() && !used_[page].empty() && !change_forms(pages_[page], used_[page]))
                return std::nullopt;
        }
        if (!change_catalog()) return std::nullopt;
        for (const std::string& name : names_)
            objects_.push_back(std::to_string(objects_.size()) + " 0 obj\n<< /Type /OCG /Name " + string_of(name) +
                               " >>\nendobj\n");
        return joined();
    }

 private:
    // By the table at the end: objects lie one after the other.
    bool find_objects() {
        const std::size_t last = pdf_.rfind("startxref");
        if (last == std::string::npos) return false;
        const std::optional<std::size_t> table = number_at(pdf_, last + 10);
        if (!table || *table >= pdf_.size() || pdf_.compare(*table, 7, "xref\n0 ") != 0) return false;
        const std::optional<std::size_t> count = number_at(pdf_, *table + 7);
        const std::size_t entries = pdf_.find('\n', *table + 5) + 1;
        constexpr std::size_t kEntry = 20;  // bytes
        if (!count || *count < 2 || entries + *count * kEntry > pdf_.size()) return false;
        std::vector<std::size_t> starts;
        for (std::size_t i = 1; i < *count; ++i) {
            // Zeros in front are no sign of another base.
            const std::optional<std::size_t> start = number_at(pdf_, entries + i * kEntry);
            if (!start || *start >= *table) return false;
            starts.push_back(*start);
        }
        std::vector<std::size_t> order = starts;
        order.push_back(*table);
        std::ranges::sort(order);
        head_ = pdf_.substr(0, order.front());
        constexpr std::string_view kWithoutLayers = "%PDF-1.4";
        if (head_.starts_with(kWithoutLayers)) head_[kWithoutLayers.size() - 1] = '5';
        objects_.emplace_back();
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const std::size_t end = *std::ranges::upper_bound(order, starts[i]);
            objects_.push_back(pdf_.substr(starts[i], end - starts[i]));
            if (number_at(objects_.back(), 0) != i + 1) return false;
        }
        trailer_ = pdf_.substr(entries + *count * kEntry, last - entries - *count * kEntry);
        return true;
    }

    bool find_pages() {
        const auto tree = std::ranges::find_if(
            objects_, [](const std::string& object) { return object.find("/Type /Pages") != std::string::npos; });
        if (tree == objects_.end()) return false;
        const std::size_t kids = tree->find("/Kids [");
        if (kids == std::string::npos) return false;
        const std::string list = tree->substr(kids + 7, tree->find(']', kids) - kids - 7);
        for (std::size_t at = 0; at < list.size();) {
            const std::optional<std::size_t> number = number_at(list, at);
            if (!number || *number >= objects_.size()) break;
            pages_.push_back(*number);
            const std::size_t end = list.find('R', at);
            if (end == std::string::npos) return false;
            at = end + 1;
        }
        return !pages_.empty();
    }

    // The page's form objects stand among its resources in the order in which the page draws them, as
    // "/XObject << /x7 7 0 R /x9 9 0 R >>".
    bool change_forms(std::size_t page, const std::vector<int>& used) {
        const std::optional<std::size_t> resources = number_after(objects_[page], "/Resources ");
        if (!resources || *resources >= objects_.size()) return false;
        const std::string& list = objects_[*resources];
        const std::size_t start = list.find("/XObject <<");
        if (start == std::string::npos) return false;
        const std::size_t end = list.find(">>", start);
        std::size_t count = 0;
        for (std::size_t at = list.find(" /x", start); at < end; at = list.find(" /x", at + 1), ++count) {
            const std::optional<std::size_t> form = number_after(std::string_view(list).substr(at + 1), " ");
            if (!form || *form >= objects_.size() || count >= used.size()) return false;
            constexpr std::string_view kForm = "   /Subtype /Form\n";
            const std::size_t kind = objects_[*form].find(kForm);
            if (kind == std::string::npos || kind > objects_[*form].find("stream\n")) return false;
            objects_[*form].insert(kind + kForm.size(),
                                   "   /OC " + reference(first_group_ + static_cast<std::size_t>(used[count])) + "\n");
        }
        return count == used.size();
    }

    bool change_catalog() {
        const auto catalog = std::ranges::find_if(
            objects_, [](const std::string& object) { return object.find("/Type /Catalog") != std::string::npos; });
        if (catalog == objects_.end()) return false;
        std::string groups;
        for (std::size_t i = 0; i < names_.size(); ++i) groups += " " + reference(first_group_ + i);
        const std::size_t end = catalog->rfind(">>");
        if (end == std::string::npos) return false;
        catalog->insert(end, "   /OCProperties << /OCGs [" + groups + " ] /D << /Order [" + groups + " ] /ON [" +
                                 groups + " ] >> >>\n");
        return true;
    }

    std::string joined() const {
        std::string out = head_, table = "0000000000 65535 f \n";
        for (std::size_t i = 1; i < objects_.size(); ++i) {
            std::array<char, 24> entry{};
            std::snprintf(entry.data(), entry.size(), "%010zu 00000 n \n", out.size());
            table += entry.data();
            out += objects_[i];
        }
        std::string trailer = trailer_;
        const std::size_t size = trailer.find("/Size ");
        if (size != std::string::npos)
            trailer.replace(size, trailer.find('\n', size) - size, "/Size " + std::to_string(objects_.size()));
        const std::string start = std::to_string(out.size());
        return out + "xref\n0 " + std::to_string(objects_.size()) + "\n" + table + trailer + "startxref\n" + start +
               "\n%%EOF\n";
    }

    const std::string& pdf_;
    const std::vector<std::string>& names_;
    const std::vector<std::vector<int>>& used_;
    std::string head_, trailer_;
    std::vector<std::string> objects_;  // by their numbers; 0 is none
    std::vector<std::size_t> pages_;    // numbers of objects
    std::size_t first_group_ = 0;
};

}  // namespace

std::string with_layers(std::string pdf, const std::vector<std::string>& names,
                        const std::vector<std::vector<int>>& used) {
    if (names.empty()) return pdf;
    std::optional<std::string> layered = LayerWriter(pdf, names, used).write();
    return layered ? std::move(*layered) : pdf;
}

}  // namespace selvedge::sim
