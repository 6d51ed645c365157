#pragma once
// One HTML page with every item of thesis_captions(): our table or picture, the thesis' own numbers where known, how it
// was measured, and whether the trend agrees. Items that this run does not show say where they are, or that they are
// missing.
#include <string>
#include <vector>

#include "bench/thesis/captions.h"
#include "bench/thesis/thesis.h"

namespace selvedge::bench {

// A picture file beside the page.
struct PagePicture {
    std::string name;    // of the figure
    std::string file;    // relative to the page
    std::string moment;  // what tells it from others of the same figure; may be empty
};

// A drawn figure. The page holds it inline.
struct PageDrawing {
    std::string name;
    std::string title;
    std::string note{};
    std::string svg;
    std::string data_file{};  // relative to the page; empty: none
};

struct ThesisPage {
    std::vector<Experiment> experiments = thesis_experiments();  // that exist, whether they ran or not
    std::vector<std::string> conditions{};                       // of all experiments, one sentence each
    std::vector<Table> tables{};
    std::vector<PageDrawing> drawings{};
    std::vector<PagePicture> pictures{};
    std::vector<Trend> trends{};
    bool is_quick = false;  // small sizes: the page warns that its numbers mean nothing
};

// How the page shows an item.
enum class ItemState {
    Shown,      // a table, drawing or picture of this run
    Explained,  // a drawing or listing of the thesis that explains what our code or documents hold elsewhere
    NotRun,     // an experiment makes it; this run left it out
    Missing     // no experiment makes it
};

ItemState state_of(const Caption& caption, const ThesisPage& page);

// A whole document. Text is escaped; links are relative.
std::string to_html(const ThesisPage& page);

}  // namespace selvedge::bench
