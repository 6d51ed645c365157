#pragma once
// What the thesis' captions ask of each of its tables, figures and listings, in chapters 3 to 6. A caption specifies an
// experiment: the item that bears its number shows what it names. Chapter 2 reviews literature and is left out.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/support/table.h"

namespace selvedge::bench {

enum class CaptionKind { Table, Figure, Listing };

// Some column of the table names this quantity, with this unit. Empty unit: a number or a name.
struct WantedColumn {
    std::string_view quantity;
    std::string_view unit{};
    bool is_whole_name = false;  // the column is called just this
};

struct Caption {
    CaptionKind kind = CaptionKind::Table;
    std::string_view number;                  // such as "3.2"
    std::string_view subject;                 // what it shows, in our words
    std::span<const WantedColumn> columns{};  // of a table
    std::string_view reported{};              // facts and numbers of the thesis' own, where known
    std::string_view explained{};             // for drawings and listings: where the project has what they explain
};

// In the thesis' order: by chapter; within it tables, figures, listings.
std::span<const Caption> thesis_captions();

// "T3.2", "F3.9", "L3.1".
std::string short_name(const Caption& caption);

// The wanted columns that a table lacks, each as "quantity, unit". A column has a unit if its name ends in ", unit".
std::vector<std::string> missing_columns(const Caption& caption, const Table& table);

// Whether a table or series of this name belongs to the caption: it bears its number, alone or with more after a dash
// ("6.2-distance"), and for a listing "listing-" before it.
bool is_of(const Caption& caption, std::string_view name);

}  // namespace selvedge::bench
