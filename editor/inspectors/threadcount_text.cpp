#include "editor/inspectors/threadcount_text.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>
#include <sstream>

#include "sim/core/error.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge {
namespace {

std::string stripe_text(const SettStripe& stripe, bool is_pivot) {
    return stripe.code + (is_pivot ? "/" : "") + std::to_string(stripe.threads);
}

// Of a mirrored repeat only what lies between the pivots is written.
std::string stripes_text(const std::vector<SettStripe>& stripes, bool is_mirrored) {
    const std::size_t count = is_mirrored ? stripes.size() / 2 + 1 : stripes.size();
    std::string text;
    for (std::size_t i = 0; i < count && i < stripes.size(); ++i) {
        const bool is_pivot = is_mirrored && (i == 0 || i + 1 == count);
        text += (i > 0 ? " " : "") + stripe_text(stripes[i], is_pivot);
    }
    return text;
}

std::string own_colours(const Sett& sett) {
    std::map<std::string, Rgb8> own;
    for (const auto* stripes : {&sett.stripes, &sett.weft_stripes}) {
        for (const SettStripe& stripe : *stripes) {
            const auto usual = standard_palette().find(stripe.code);
            if (usual == standard_palette().end() || usual->second != stripe.colour) own[stripe.code] = stripe.colour;
        }
    }
    std::string text;
    for (const auto& [code, colour] : own) {
        char buffer[32];
        std::snprintf(buffer, sizeof buffer, "=#%02X%02X%02X; ", colour[0], colour[1], colour[2]);
        text += code + buffer;
    }
    return text;
}

std::string small_letters(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

}  // namespace

std::string threadcount_of(const Sett& sett) {
    std::string text = own_colours(sett) + stripes_text(sett.stripes, sett.is_mirrored);
    if (!sett.weft_stripes.empty()) text += " weft: " + stripes_text(sett.weft_stripes, sett.is_weft_mirrored);
    if (sett.weave == Weave::Plain) text += " weave: plain";
    if (sett.weave == Weave::Twill31) text += " weave: denim";
    return text;
}

std::string wrong_with_tartan(const std::string& name_or_threadcount) {
    if (name_or_threadcount.empty()) return "";
    try {
        find_tartan(name_or_threadcount);
        return "";
    } catch (const InputError& error) {
        return error.place().empty() ? error.problem() : error.place() + ": " + error.problem();
    }
}

std::optional<Sett> sett_of(const Pattern& pattern) {
    try {
        Sett sett = find_tartan(pattern.tartan.empty() ? kDefaultTartan : pattern.tartan);
        return pattern.sett_size ? with_repeat_size(std::move(sett), *pattern.sett_size) : sett;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

bool has_words(const std::string& text, const std::string& words) {
    const std::string small = small_letters(text);
    std::istringstream stream(small_letters(words));
    for (std::string word; stream >> word;) {
        if (small.find(word) == std::string::npos) return false;
    }
    return true;
}

}  // namespace selvedge
