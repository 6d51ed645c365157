#include "sim/tartan/tartan_file.h"

#include <algorithm>
#include <filesystem>
#include <span>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/json.h"

namespace selvedge::sim {

std::span<const EmbeddedFile> tartan_files();

namespace {

// Normalises a name: "Black Watch", "black-watch" and "BLACK_WATCH" give "black_watch".
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

// An object of codes and colours, or the text of a "pallet" of the Scottish Register of Tartans.
Palette read_palette(const JsonView& view) {
    if (view.value().kind() == Json::Kind::String) {
        try {
            return parse_palette(view.string());
        } catch (const InputError& error) {
            view.fail(error.place() + ": " + error.problem());
        }
    }
    Palette palette;
    for (const std::string& code : view.keys()) {
        const JsonView colour = view.at(code);
        palette[code] = parse_named_colour(colour.string(), colour.file(), colour.path());
    }
    return palette;
}

// Parses the threadcount under `key`; errors in it name the file and the key.
Sett read_threadcount(const JsonView& view, const std::string& key, const Palette& palette) {
    const JsonView text = view.at(key);
    try {
        return parse_threadcount(text.string(), palette);
    } catch (const InputError& error) {
        if (error.file() == view.file()) throw;
        throw InputError(view.file(), key,
                         error.place().empty() ? error.problem() : error.place() + ": " + error.problem());
    }
}

void read_weft(const JsonView& view, const Palette& palette, Sett& sett) {
    Sett weft = read_threadcount(view, "weft", palette);
    if (!sett.weft_stripes.empty() || !weft.weft_stripes.empty()) view.at("weft").fail("the weft is given twice");
    sett.weft_stripes = std::move(weft.stripes);
    sett.is_weft_mirrored = weft.is_mirrored;
}

void read_register(const JsonView& entry, Sett& sett) {
    sett.register_name = entry.at("name").string();
    sett.register_number = entry.at("number").integer();
    if (sett.register_number < 1) entry.at("number").fail("a reference number is 1 or more");
}

}  // namespace

Sett parse_tartan(std::string_view json, const std::string& file) {
    const Json document = parse_json(json, file);
    const JsonView view(document, file);
    const Palette palette = view.has("palette") ? read_palette(view.at("palette")) : Palette{};
    Sett sett = read_threadcount(view, "threadcount", palette);
    if (view.has("weft")) read_weft(view, palette, sett);
    if (view.has("weave")) {
        const std::optional<Weave> weave = parse_weave(view.at("weave").string());
        if (!weave) view.at("weave").fail(std::string("a weave is one of ") + kWeaveNames);
        sett.weave = *weave;
    }
    sett.name = view.at("name").string();
    if (view.has("register")) read_register(view.at("register"), sett);
    if (view.has("repeat_cm")) sett = with_repeat_size(sett, view.at("repeat_cm").number_between(0.1, 500) / 100);
    return sett;
}

Sett find_sett(const std::string& name_or_threadcount, std::optional<double> repeat_size) {
    const Sett sett = find_tartan(name_or_threadcount.empty() ? kDefaultTartan : name_or_threadcount);
    return repeat_size ? with_repeat_size(sett, *repeat_size) : sett;
}

Sett sett_of(const Pattern& pattern) {
    if (pattern.tartan.empty()) throw InputError(pattern.name, "selvedge.tartan", "names no tartan to match");
    return find_sett(pattern.tartan, pattern.sett_size);
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

}  // namespace selvedge::sim
