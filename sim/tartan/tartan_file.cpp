#include "sim/tartan/tartan_file.h"

#include <algorithm>
#include <filesystem>
#include <span>

#include "sim/core/embedded.h"
#include "sim/core/error.h"
#include "sim/core/json.h"

namespace selvedge {

std::span<const EmbeddedFile> tartan_files();

namespace {

// "Black Watch", "black-watch" and "BLACK_WATCH" are one name.
std::string plain_name(std::string_view name) {
    std::string plain;
    for (char c : name) {
        if (c == ' ' || c == '-') c = '_';
        plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return plain;
}

std::string file_stem(const EmbeddedFile& file) {
    return std::filesystem::path(file.name).stem().string();
}

bool has_digit(std::string_view text) {
    return std::any_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

Palette read_palette(const JsonView& view) {
    Palette palette;
    for (const std::string& code : view.keys()) {
        const JsonView colour = view.at(code);
        palette[code] = parse_colour(colour.string(), colour.file(), colour.path());
    }
    return palette;
}

}  // namespace

Sett parse_tartan(std::string_view json, const std::string& file) {
    const Json document = parse_json(json, file);
    const JsonView view(document, file);
    const Palette palette = view.has("palette") ? read_palette(view.at("palette")) : Palette{};
    Sett sett;
    try {
        sett = parse_threadcount(view.at("threadcount").string(), palette);
    } catch (const InputError& error) {
        if (error.file() == file) throw;
        throw InputError(file, "threadcount",
                         error.place().empty() ? error.problem() : error.place() + ": " + error.problem());
    }
    sett.name = view.at("name").string();
    if (view.has("repeat_cm")) sett = with_repeat_size(sett, view.at("repeat_cm").number_between(0.1, 500) / 100);
    return sett;
}

std::vector<std::string> shipped_tartans() {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : tartan_files()) names.push_back(file_stem(file));
    std::sort(names.begin(), names.end());
    return names;
}

Sett find_tartan(const std::string& name_or_threadcount) {
    const std::string name = plain_name(name_or_threadcount);
    for (const EmbeddedFile& file : tartan_files()) {
        if (file_stem(file) == name) return parse_tartan(file.text, std::string(file.name));
    }
    if (has_digit(name_or_threadcount)) return parse_threadcount(name_or_threadcount);
    std::string known;
    for (const std::string& shipped : shipped_tartans()) known += (known.empty() ? "" : ", ") + shipped;
    throw InputError("", "tartan",
                     "none is called '" + name_or_threadcount.substr(0, 64) +
                         "'; give a threadcount such as 'B/24 W4 B24 R/2', or one of " + known);
}

}  // namespace selvedge
