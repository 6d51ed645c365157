#include "sim/proposals/panel_role.h"

#include <algorithm>
#include <array>

#include "sim/pattern/edge_shape.h"
#include "sim/proposals/shape_role.h"

namespace selvedge::sim {
namespace {

// The beginnings of words that name the part, without accents; of "=" the whole word. The first row that fits wins.
struct PartWords {
    GarmentPart part;
    std::string_view words;
};
constexpr std::array kPartWords = std::to_array<PartWords>({
    {GarmentPart::Accessory,
     "facing interfac lining stay pocket flap placket welt fly loop belt strap zip tab elastic tasche besatz beleg "
     "futter "
     "einlage poche doublure parementure forro bolsillo bolso vista tasca fodera voering zak podsivk podszewk kapsa "
     "kieszen vuori tasku foder ficka podkladk karman планк подклад карман кишен клапан обтачк обшивк подборт застеж "
     "дублер мешков 口袋 里布 裏 ポケット 见返 見返"},
    {GarmentPart::Binding, "binding ribbing rib neckband armband einfass biais bies окантов бейк резинк"},
    {GarmentPart::Waistband,
     "waistband wb bund ceinture pretina cintura cinturilla tailleband pasek vyotar linning =cos poyas пояс 腰头 腰頭 "
     "ウエスト"},
    {GarmentPart::Cuff,
     "cuff manschett manchette manchet polsino poignet puno punho mankiet manzet mansett manzhet манжет 袖口 袖头 "
     "袖克夫 "
     "カフス"},
    {GarmentPart::Sleeve,
     "sleeve slv topsleeve undersleeve shortsleeve longsleeve armel aermel rmel manche manga manica mouw rekaw rukav "
     "hiha =arm рукав ръкав μανικι 袖"},
    {GarmentPart::CollarStand,
     "collarstand collarbase collarband kragensteg kragenstand stojk stoyka стойк стійк 领座 領座 台衿"},
    {GarmentPart::Collar,
     "undercollar collar kragen krage kraag cuello colletto =col =collo gola kolnierz limec kaulu vorotnik воротн "
     "комір "
     "γιακα 领 領 衿"},
    {GarmentPart::Hood,
     "hood kapuze kaptur kapuce capuche capucha capuchon cappuccio capuz huppu huva капюш каптур 帽 "
     "フード"},
    {GarmentPart::Yoke, "yoke passe canesu empiecement sprone karcz kaarroke koketk кокетк"},
    {GarmentPart::Skirt, "skirt rock jupe falda gonna godet saia =rok spodnic sukne hame kjol юбк спідниц 裙 スカート"},
    {GarmentPart::Leg,
     "pant trouser leg jeans chino shorts slacks hose pantalon broek spodnie kalhot housu lahje byx calca брюк штан "
     "裤 褲 パンツ"},
    {GarmentPart::Torso, "torso ftorso btorso bodice bust corps 身頃"},
});

constexpr std::string_view kFrontWords =
    "front frnt fr f ftorso vorder devant delanter davanti frente voor przod predni fram forstykke etu eleje pered "
    "poloch перед полоч пілоч предн 前";
constexpr std::string_view kBackWords =
    "back bk b btorso rear rueck ruck hinter dos trasero espalda dietro costas achter rugpand tyl zadni bak rygg ryg "
    "taka hatulj spink spate спин зад гръб 后 後";
constexpr std::string_view kLeftWords =
    "left l lt links linker gauche izquierd esquerd sinistr lewy lewa levy leva лев лів 左";
constexpr std::string_view kRightWords =
    "right r rt rechts rechter droit derech direit destr prawy prawa pravy prava прав 右";
constexpr std::string_view kWithWords = "=with =mit =avec =con =com =met";
constexpr std::string_view kUpperWords = "top upper ober dessus верх";
constexpr std::string_view kUnderWords = "under unter dessous нижн";

GarmentPart part_of_words(const std::vector<std::string>& words) {
    const auto row =
        std::ranges::find_if(kPartWords, [&](const PartWords& one) { return names_any(words, one.words); });
    return row == kPartWords.end() ? GarmentPart::Unknown : row->part;
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

// Leg or Skirt, if words about the whole garment say so; else Unknown.
GarmentPart lower_garment(const Pattern& pattern, std::string_view hints) {
    for (const std::string_view text : {std::string_view(pattern.name), hints}) {
        const GarmentPart part = part_of_words(words_of_name(text));
        if (part == GarmentPart::Leg || part == GarmentPart::Skirt) return part;
    }
    return GarmentPart::Unknown;
}

// The part of fronts and backs that name none.
GarmentPart part_of_faces(const Pattern& pattern, const std::vector<PanelRole>& roles, std::string_view hints) {
    const auto has = [&](GarmentPart part) {
        return std::ranges::any_of(roles, [&](const PanelRole& role) { return role.part == part; });
    };
    if (const GarmentPart part = lower_garment(pattern, hints); part != GarmentPart::Unknown) return part;
    for (const GarmentPart upper :
         {GarmentPart::Sleeve, GarmentPart::Collar, GarmentPart::CollarStand, GarmentPart::Hood, GarmentPart::Yoke}) {
        if (has(upper)) return GarmentPart::Torso;
    }
    // A front or back that spans the middle of the body, as those cut on the fold, is of no trousers, nor is a back
    // with a shoulder above its outermost corner; a front may have a slanted pocket there.
    bool is_leg = false, has_other = false;
    for (std::size_t p = 0; p < roles.size(); ++p) {
        if (!is_plain_face(roles[p]) || !pattern.panels[p].is_worn) continue;
        (looks_like_leg(pattern.panels[p]) ? is_leg : has_other) = true;
        has_other = has_other || is_symmetric(pattern.panels[p]) ||
                    (roles[p].face == Face::Back && looks_like_bodice(pattern.panels[p]));
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

PanelRole role_of_name(std::string_view name) {
    std::vector<std::string> words = words_of_name(name);
    const auto with =
        std::ranges::find_if(words, [](const std::string& word) { return names_any({word}, kWithWords); });
    if (with != words.begin()) words.erase(with, words.end());  // "sleeve with cuff" is a sleeve
    PanelRole role;
    role.part = part_of_words(words);
    if (names_any(words, kFrontWords)) role.face = Face::Front;
    const bool ends_in_back =
        std::ranges::any_of(words, [](const std::string& word) { return word.ends_with("back"); });  // "skirtback"
    if (ends_in_back || names_any(words, kBackWords)) role.face = role.face == Face::None ? Face::Back : Face::None;
    // The two halves of a sleeve.
    if (role.part == GarmentPart::Sleeve && names_any(words, kUpperWords)) role.face = Face::Front;
    if (role.part == GarmentPart::Sleeve && names_any(words, kUnderWords)) role.face = Face::Back;
    if (names_any(words, kLeftWords)) role.flank = Flank::Left;
    if (names_any(words, kRightWords)) role.flank = role.flank == Flank::None ? Flank::Right : Flank::None;
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
    if (tells_nothing) return roles_by_shape(pattern, lower_garment(pattern, hints));
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
