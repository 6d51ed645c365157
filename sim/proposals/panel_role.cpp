#include "sim/proposals/panel_role.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "sim/pattern/edge_shape.h"
#include "sim/proposals/shape_role.h"

namespace selvedge::sim {
namespace {

// Words that begin with one of these name the part; the first row that fits any word of the name wins.
struct PartWords {
    GarmentPart part;
    std::string_view words;
};
constexpr std::array kPartWords = std::to_array<PartWords>({
    {GarmentPart::Accessory,
     "facing interfac lining pocket flap placket welt fly loop belt strap zip tab elastic tasche besatz beleg poche "
     "bolsillo tasca"},
    {GarmentPart::Binding, "binding ribbing rib neckband armband"},
    {GarmentPart::Waistband, "waistband wb bund ceinture pretina cintura tailleband"},
    {GarmentPart::Cuff, "cuff manschette manchette polsino"},
    {GarmentPart::Sleeve,
     "sleeve slv topsleeve undersleeve shortsleeve longsleeve armel aermel rmel manche manga manica mouw"},
    {GarmentPart::CollarStand, "collarstand collarbase collarband"},
    {GarmentPart::Collar, "undercollar collar kragen cuello colletto kraag"},
    {GarmentPart::Hood, "hood kapuze capuche capucha cappuccio"},
    {GarmentPart::Yoke, "yoke passe canesu"},
    {GarmentPart::Skirt, "skirt rock jupe falda gonna godet"},
    {GarmentPart::Leg, "pant trouser leg jeans chino shorts slacks hose pantalon broek"},
    {GarmentPart::Torso, "torso ftorso btorso bodice bust corps"},
});

constexpr std::array<std::string_view, 9> kFrontWords{"front",  "frnt",   "fr",       "f",      "ftorso",
                                                      "vorder", "devant", "delanter", "davanti"};
constexpr std::array<std::string_view, 9> kBackWords{"back",  "bk",  "b",       "btorso", "rear",
                                                     "rueck", "dos", "trasero", "dietro"};
constexpr std::array<std::string_view, 5> kLeftWords{"left", "l", "lt", "links", "gauche"};
constexpr std::array<std::string_view, 5> kRightWords{"right", "r", "rt", "rechts", "droit"};

// Words of up to two letters must be equal, longer ones may go on.
bool begins(const std::string& word, std::string_view with) {
    return with.size() <= 2 ? word == with : word.starts_with(with);
}

template <std::size_t N>
bool has_word(const std::vector<std::string>& words, const std::array<std::string_view, N>& known) {
    return std::ranges::any_of(words, [&](const std::string& word) {
        return std::ranges::any_of(known, [&](std::string_view one) { return begins(word, one); });
    });
}

GarmentPart part_of_words(const std::vector<std::string>& words) {
    constexpr std::size_t kCompound = 5;  // letters: words as long as this may be in a longer one, as FULLSLEEVE
    std::string together;
    for (const std::string& word : words) together += word;
    for (const PartWords& row : kPartWords) {
        for (const std::string& known : words_of_name(row.words)) {
            if (known.size() >= kCompound && together.find(known) != std::string::npos) return row.part;
            if (std::ranges::any_of(words, [&](const std::string& word) { return begins(word, known); }))
                return row.part;
        }
    }
    return GarmentPart::Unknown;
}

// Whether each vertex has its mirror image in the vertical through the middle.
bool is_symmetric(const Panel& panel) {
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    const double axis = box.center().x(), tolerance = 0.002 + 0.002 * box.sizes().x();  // m
    return std::ranges::all_of(panel.vertices, [&](const Vec2d& v) {
        return std::ranges::any_of(
            panel.vertices, [&](const Vec2d& w) { return (Vec2d(2 * axis - v.x(), v.y()) - w).norm() < tolerance; });
    });
}

bool is_plain_face(const PanelRole& role) {
    return role.part == GarmentPart::Unknown && role.face != Face::None;
}

// The part of fronts and backs that name none.
GarmentPart part_of_faces(const Pattern& pattern, const std::vector<PanelRole>& roles, std::string_view hints) {
    const auto has = [&](GarmentPart part) {
        return std::ranges::any_of(roles, [&](const PanelRole& role) { return role.part == part; });
    };
    for (const std::string_view text : {std::string_view(pattern.name), hints}) {
        const GarmentPart part = part_of_words(words_of_name(text));
        if (part == GarmentPart::Leg || part == GarmentPart::Skirt) return part;
    }
    for (const GarmentPart upper :
         {GarmentPart::Sleeve, GarmentPart::Collar, GarmentPart::CollarStand, GarmentPart::Hood, GarmentPart::Yoke}) {
        if (has(upper)) return GarmentPart::Torso;
    }
    // A front or back that spans the middle of the body, as those cut on the fold, is of no trousers.
    bool is_leg = false, has_other = false;
    for (std::size_t p = 0; p < roles.size(); ++p) {
        if (!is_plain_face(roles[p]) || !pattern.panels[p].is_worn) continue;
        (looks_like_leg(pattern.panels[p]) ? is_leg : has_other) = true;
        has_other = has_other || is_symmetric(pattern.panels[p]);
    }
    if (is_leg && !has_other) return GarmentPart::Leg;
    return has(GarmentPart::Waistband) ? GarmentPart::Skirt : GarmentPart::Torso;
}

}  // namespace

std::string_view name_of(GarmentPart part) {
    constexpr std::array<std::string_view, 13> names{"unknown",   "torso",        "yoke",     "sleeve", "cuff",
                                                     "collar",    "collar stand", "hood",     "skirt",  "leg",
                                                     "waistband", "binding",      "accessory"};
    return names[static_cast<std::size_t>(part)];
}

std::vector<std::string> words_of_name(std::string_view name) {
    std::vector<std::string> words;
    char last = ' ';
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const auto before = static_cast<unsigned char>(last);
        const bool is_letter = std::isalpha(byte) || byte >= 0x80;
        if (is_letter || std::isdigit(byte)) {
            const bool goes_on = is_letter ? std::isalpha(before) || before >= 0x80 : std::isdigit(before) != 0;
            const bool is_capital = std::isupper(byte) && std::islower(before);
            if (!goes_on || is_capital) words.emplace_back();
            words.back() += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
        }
        last = c;
    }
    return words;
}

PanelRole role_of_name(std::string_view name) {
    const std::vector<std::string> words = words_of_name(name);
    PanelRole role;
    role.part = part_of_words(words);
    if (has_word(words, kFrontWords)) role.face = Face::Front;
    if (has_word(words, kBackWords)) role.face = role.face == Face::None ? Face::Back : Face::None;
    // The two halves of a sleeve.
    if (role.part == GarmentPart::Sleeve && has_word(words, std::array<std::string_view, 2>{"top", "upper"}))
        role.face = Face::Front;
    if (role.part == GarmentPart::Sleeve && has_word(words, std::array<std::string_view, 1>{"under"}))
        role.face = Face::Back;
    if (has_word(words, kLeftWords)) role.flank = Flank::Left;
    if (has_word(words, kRightWords)) role.flank = role.flank == Flank::None ? Flank::Right : Flank::None;
    return role;
}

std::vector<PanelRole> roles_of(const Pattern& pattern, std::string_view hints) {
    std::vector<PanelRole> roles;
    for (const Panel& panel : pattern.panels) {
        roles.push_back(role_of_name(panel.name));
        PanelRole& role = roles.back();
        if (role.part != GarmentPart::Unknown) continue;
        if (panel.label == "leg") role.part = GarmentPart::Leg;  // of GarmentCode, which means skirts, too
        if (panel.label == "arm") role.part = GarmentPart::Sleeve;
    }
    const bool tells_nothing = std::ranges::all_of(
        roles, [](const PanelRole& role) { return role.part == GarmentPart::Unknown && role.face == Face::None; });
    if (tells_nothing) return roles_by_shape(pattern);
    const GarmentPart part = part_of_faces(pattern, roles, hints);
    for (PanelRole& role : roles) {
        if (is_plain_face(role)) role.part = part;
    }
    return roles;
}

bool are_mirror_images(const Panel& a, const Panel& b) {
    return (!a.mirror_of.empty() && a.mirror_of == b.name) || (!b.mirror_of.empty() && b.mirror_of == a.name);
}

bool comes_in_pairs(const PanelRole& role, std::string_view name) {
    if (role.part == GarmentPart::Sleeve || role.part == GarmentPart::Cuff || role.part == GarmentPart::Leg)
        return true;
    const std::vector<std::string> words = words_of_name(name);
    return role.part == GarmentPart::Binding && std::ranges::any_of(words, [](const std::string& word) {
               return word.starts_with("arm") || word.starts_with("leg") || word.starts_with("sleeve");
           });
}

}  // namespace selvedge::sim
