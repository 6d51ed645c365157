#include "bench/thesis/page.h"

#include <algorithm>
#include <array>

namespace selvedge::bench {
namespace {

constexpr const char* kStyle = R"(
:root { --ink: #22211f; --soft: #6d6a64; --rule: #d9d5cc; --paper: #fcfbf8; --card: #fff;
        --yes: #2f6b3f; --no: #9c3a21; --link: #234f7d; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e3dc; --soft: #a19d94; --rule: #3a3833; --paper: #191816; --card: #fbfaf7;
          --yes: #8cc79a; --no: #e69a80; --link: #93b9e0; } }
* { box-sizing: border-box; }
html { scroll-behavior: smooth; }
body { margin: 0 auto; padding: 3rem 1.5rem 6rem; max-width: 66rem; background: var(--paper); color: var(--ink);
       font: 17px/1.55 "Iowan Old Style", Palatino, "Palatino Linotype", "Book Antiqua", Georgia, serif; }
h1 { font-size: 2rem; line-height: 1.2; font-weight: 500; margin: 0 0 .6rem; }
h2 { font-size: 1.45rem; font-weight: 500; margin: 4rem 0 1rem; padding-top: 1rem; border-top: 2px solid var(--ink); }
p, ul { max-width: 42rem; margin: .5rem 0; }
ul { padding-left: 1.2rem; }
a { color: var(--link); text-decoration: none; }
a:hover { text-decoration: underline; }
.warning { color: var(--no); font-weight: 600; }
nav p { max-width: none; line-height: 1.9; font-variant-numeric: tabular-nums; }
nav a { display: inline-block; min-width: 2.9rem; margin-right: .5rem; }
nav a::before { content: "\25CB\00A0"; color: var(--soft); }
nav a.shown::before { content: "\25CF\00A0"; color: var(--soft); }
nav a.agrees::before { content: "\25CF\00A0"; color: var(--yes); }
nav a.differs::before { content: "\25CF\00A0"; color: var(--no); }
nav a.missing { color: var(--no); }
nav a.missing::before { content: "\00D7\00A0"; color: var(--no); }
section { display: grid; grid-template-columns: 7rem minmax(0, 1fr); column-gap: 1.5rem; padding: 1.6rem 0;
          border-top: 1px solid var(--rule); }
section > h3 { font-size: 1rem; font-weight: 600; margin: 0; }
section > h3 a { color: inherit; }
.subject { margin-top: 0; font-size: 1.06rem; }
.reported, .note, .state, .files { color: var(--soft); font-size: .88rem; line-height: 1.5; }
.trend { font-size: .95rem; padding-left: .8rem; border-left: 3px solid var(--yes); margin: .9rem 0; }
.trend b { color: var(--yes); font-weight: 600; }
.trend.differs { border-color: var(--no); }
.trend.differs b { color: var(--no); }
.missing-state { color: var(--no); }
.table { overflow-x: auto; margin: 1rem 0; }
h4 { font-size: 1rem; font-weight: 600; margin: 1.2rem 0 .2rem; }
table { border-collapse: collapse; font: 14px/1.45 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif;
        font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .7rem; text-align: left; vertical-align: bottom; white-space: nowrap; }
th { font-weight: 600; white-space: normal; border-bottom: 1px solid var(--ink); max-width: 9rem; }
td { border-bottom: 1px solid var(--rule); }
th:first-child, td:first-child { padding-left: 0; }
.right { text-align: right; }
figure { margin: 1rem 0; }
figure img, figure svg { display: block; max-width: 100%; height: auto; background: #fff; border-radius: 3px; }
figcaption { color: var(--soft); font-size: .88rem; margin-top: .3rem; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
.pictures figure { flex: 1 1 15rem; margin: 0; max-width: 100%; }
@media (max-width: 46rem) { section { display: block; } section > h3 { margin-bottom: .4rem; } }
@media print { nav { display: none; } section { break-inside: avoid; } }
)";

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

// "us" as it is written in units, with the Greek letter.
std::string unit_text(std::string text) {
    if (text.ends_with(", us")) text.replace(text.size() - 2, 2, "\u00B5s");
    return text;
}

std::string element(std::string_view tag, std::string_view attributes, std::string_view content) {
    std::string out = "<" + std::string(tag);
    if (!attributes.empty()) out += " " + std::string(attributes);
    return out + ">" + std::string(content) + "</" + std::string(tag) + ">\n";
}

std::string paragraph(std::string_view kind, std::string_view text) {
    return text.empty() ? "" : element("p", "class=\"" + std::string(kind) + "\"", escaped(text));
}

std::string table_html(const Table& table) {
    std::vector<bool> is_right(table.columns.size());
    for (std::size_t i = 0; i < is_right.size(); ++i) {
        is_right[i] = std::all_of(table.rows.begin(), table.rows.end(), [&](const std::vector<Cell>& row) {
            return row[i].is_number() || row[i].is_empty();
        });
    }
    const auto attributes = [&](std::size_t i) { return is_right[i] ? "class=\"right\"" : ""; };
    std::string head;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        head += element("th", attributes(i), escaped(unit_text(table.columns[i])));
    std::string rows = element("tr", "", head);
    for (const std::vector<Cell>& row : table.rows) {
        std::string cells;
        for (std::size_t i = 0; i < row.size(); ++i)
            cells += element("td", attributes(i), row[i].is_empty() ? "" : escaped(row[i].to_text()));
        rows += element("tr", "", cells);
    }
    return element("h4", "", escaped(table.title)) + element("div", "class=\"table\"", element("table", "", rows)) +
           paragraph("note", table.note);
}

std::string drawing_html(const PageDrawing& drawing) {
    std::string caption = escaped(drawing.title);
    if (!drawing.note.empty()) caption += (caption.empty() ? "" : ". ") + escaped(drawing.note);
    if (!drawing.data_file.empty())
        caption += " <a href=\"" + escaped(drawing.data_file) + "\">" + escaped(drawing.data_file) + "</a>";
    return element("figure", "", drawing.svg + element("figcaption", "", caption));
}

std::string picture_html(const PagePicture& picture) {
    const std::string file = escaped(picture.file);
    return element("figure", "",
                   "<a href=\"" + file + "\"><img loading=\"lazy\" src=\"" + file + "\" alt=\"" +
                       escaped(picture.name) + " " + escaped(picture.moment) + "\"></a>" +
                       element("figcaption", "", escaped(picture.moment)));
}

std::string trend_html(const Trend& trend) {
    return element("p", trend.agrees ? "class=\"trend\"" : "class=\"trend differs\"",
                   std::string(trend.agrees ? "<b>Agrees.</b> " : "<b>Differs.</b> ") +
                       "The thesis: " + escaped(trend.reported) + " Here: " + escaped(trend.measured));
}

template <class Element>
std::vector<const Element*> of(const Caption& caption, const std::vector<Element>& all) {
    std::vector<const Element*> own;
    for (const Element& element : all) {
        if (is_of(caption, element.name)) own.push_back(&element);
    }
    return own;
}

struct Content {
    std::vector<const Table*> tables;
    std::vector<const PageDrawing*> drawings;
    std::vector<const PagePicture*> pictures;
    std::vector<const Trend*> trends;

    bool empty() const { return tables.empty() && drawings.empty() && pictures.empty(); }
};

// A table's or listing's number may also be that of a figure. So a table shows tables only; a figure shows drawings,
// pictures, and the tables that are named "figure-" and its number.
Content content_of(const Caption& caption, const ThesisPage& page) {
    Content content;
    if (caption.kind == CaptionKind::Figure) {
        content.drawings = of(caption, page.drawings);
        content.pictures = of(caption, page.pictures);
        for (const Table& table : page.tables) {
            constexpr std::string_view kPrefix = "figure-";
            const std::string_view name = table.name;
            if (name.starts_with(kPrefix) && is_of(caption, name.substr(kPrefix.size())))
                content.tables.push_back(&table);
        }
    } else {
        content.tables = of(caption, page.tables);
    }
    for (const Trend& trend : page.trends) {
        if (trend.item == short_name(caption)) content.trends.push_back(&trend);
    }
    return content;
}

bool is_made(const Caption& caption, const std::vector<Experiment>& experiments) {
    const auto names = [&](const std::vector<std::string>& all) {
        return std::any_of(all.begin(), all.end(), [&](const std::string& name) { return is_of(caption, name); });
    };
    return std::any_of(experiments.begin(), experiments.end(), [&](const Experiment& experiment) {
        return names(caption.kind == CaptionKind::Figure ? experiment.figures : experiment.tables);
    });
}

std::string option_of(const Caption& caption) {
    const std::string number(caption.number);
    if (caption.kind == CaptionKind::Figure) return "--figure " + number;
    return caption.kind == CaptionKind::Table ? "--table " + number : "--table listing-" + number;
}

std::string long_name(const Caption& caption) {
    static constexpr std::array<const char*, 3> kNames{"Table ", "Figure ", "Listing "};
    return kNames[static_cast<std::size_t>(caption.kind)] + std::string(caption.number);
}

std::string state_html(const Caption& caption, ItemState state) {
    switch (state) {
        case ItemState::Shown:
            if (caption.explained.empty()) return "";
            [[fallthrough]];
        case ItemState::Explained:
            return element("p", "class=\"state\"", "In the project: " + escaped(caption.explained) + ".");
        case ItemState::NotRun:
            return element("p", "class=\"state\"",
                           "Not part of this run: selvedge bench thesis " + option_of(caption) + " --out DIR");
        case ItemState::Missing:
            return element("p", "class=\"state missing-state\"", "Missing: nothing here shows this yet.");
    }
    return "";
}

std::string item_html(const Caption& caption, const ThesisPage& page) {
    const Content content = content_of(caption, page);
    std::string body = paragraph("subject", caption.subject) + state_html(caption, state_of(caption, page));
    for (const PageDrawing* drawing : content.drawings) body += drawing_html(*drawing);
    std::string pictures;
    for (const PagePicture* picture : content.pictures) pictures += picture_html(*picture);
    if (!pictures.empty()) body += element("div", "class=\"pictures\"", pictures);
    for (const Table* table : content.tables) body += table_html(*table);
    if (!caption.reported.empty() && content.trends.empty())
        body += element("p", "class=\"reported\"", "The thesis: " + escaped(caption.reported));
    for (const Trend* trend : content.trends) body += trend_html(*trend);
    const std::string name = short_name(caption);
    return element(
        "section", "id=\"" + name + "\"",
        element("h3", "", "<a href=\"#" + name + "\">" + long_name(caption) + "</a>") + element("div", "", body));
}

std::string link_html(const Caption& caption, const ThesisPage& page) {
    const Content content = content_of(caption, page);
    std::string kind;
    switch (state_of(caption, page)) {
        case ItemState::Shown:
            kind = "shown";
            break;
        case ItemState::Missing:
            kind = "missing";
            break;
        default:
            kind = "elsewhere";
    }
    if (!content.trends.empty()) {
        const bool agree =
            std::all_of(content.trends.begin(), content.trends.end(), [](const Trend* trend) { return trend->agrees; });
        kind = agree ? "agrees" : "differs";
    }
    const std::string name = short_name(caption);
    return element("a", "class=\"" + kind + "\" href=\"#" + name + "\"", name);
}

struct Chapter {
    char number;
    const char* title;
};
constexpr std::array<Chapter, 4> kChapters{{{'3', "The edge-based adaptive mesh"},
                                            {'4', "Clothing on static bodies"},
                                            {'5', "Clothing on animated characters"},
                                            {'6', "The adaptive curved surface"}}};

template <class Html>
std::string chapter_html(char number, Html&& html) {
    std::string text;
    for (const Caption& caption : thesis_captions()) {
        if (caption.number[0] == number) text += html(caption);
    }
    return text;
}

std::string counts_html(const ThesisPage& page) {
    std::array<int, 4> counts{};
    for (const Caption& caption : thesis_captions()) ++counts[static_cast<std::size_t>(state_of(caption, page))];
    const auto agree = std::count_if(page.trends.begin(), page.trends.end(), [](const Trend& t) { return t.agrees; });
    return element("p", "",
                   "Of " + std::to_string(thesis_captions().size()) + " tables, figures and listings, " +
                       std::to_string(counts[0]) + " are shown, " + std::to_string(counts[1]) +
                       " explain what the project holds elsewhere, " + std::to_string(counts[2]) +
                       " were not part of this run and " + std::to_string(counts[3]) + " are missing. " +
                       std::to_string(agree) + " of " + std::to_string(page.trends.size()) +
                       " trends agree with the thesis.");
}

}  // namespace

ItemState state_of(const Caption& caption, const ThesisPage& page) {
    if (!content_of(caption, page).empty()) return ItemState::Shown;
    if (is_made(caption, page.experiments)) return ItemState::NotRun;
    return caption.explained.empty() ? ItemState::Missing : ItemState::Explained;
}

std::string to_html(const ThesisPage& page) {
    std::string body = element("h1", "", "The thesis\u2019 tables and figures, measured with Selvedge");
    body += element("p", "",
                    "T. J. R. Simnett: <i>Real-time Simulation and Visualisation of Cloth using Edge-based Adaptive "
                    "Meshes</i>, University of East Anglia, 2012. Each item bears the thesis\u2019 number and shows "
                    "what its caption names; the words and numbers are ours unless they are called the thesis\u2019. "
                    "Whether a trend agrees is decided by the program from the numbers of this run.");
    body += counts_html(page);
    if (page.is_quick)
        body += paragraph("warning",
                          "A quick run at small sizes: it shows that everything works. Its numbers mean nothing.");
    std::string conditions;
    for (const std::string& condition : page.conditions) conditions += element("li", "", escaped(condition));
    if (!conditions.empty()) body += element("ul", "class=\"note\"", conditions);
    std::string links;
    for (const Chapter& chapter : kChapters) {
        links += element("p", "",
                         std::string(1, chapter.number) + "&nbsp; " +
                             chapter_html(chapter.number, [&](const Caption& c) { return link_html(c, page); }));
    }
    body += element("nav", "", links);
    body += paragraph("note",
                      "Green: the trend agrees. Red: it differs. Grey: shown, nothing to judge. Open: elsewhere or not "
                      "run. Cross: missing.");
    for (const Chapter& chapter : kChapters) {
        body += element("h2", "", std::string(1, chapter.number) + "&ensp;" + chapter.title);
        body += chapter_html(chapter.number, [&](const Caption& c) { return item_html(c, page); });
    }
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<title>The thesis\u2019 tables and figures, measured with Selvedge</title>\n" +
           element("style", "", kStyle) + "</head>\n<body>\n" + body + "</body>\n</html>\n";
}

}  // namespace selvedge::bench
