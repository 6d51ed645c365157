#pragma once
// Commands that change seams. Seams are named by their index in Pattern::seams. See command.h.
#include <optional>
#include <string>
#include <vector>

#include "editor/document/command_parts.h"
#include "editor/document/selection.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// See Seam::is_reversed.
struct SewEdges {
    static constexpr const char* name = "sew_edges";
    PartRef first{};
    PartRef second{};
    bool is_reversed = true;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("first", first);
        visit("second", second);
        visit("is_reversed", is_reversed);
    }
};

// Parts of edges, one to many.
struct SewRuns {
    static constexpr const char* name = "sew_runs";
    std::vector<SpanRef> first{};
    std::vector<SpanRef> second{};
    bool is_reversed = true;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("first", first);
        visit("second", second);
        visit("is_reversed", is_reversed);
    }
};

struct ReverseSeam {
    static constexpr const char* name = "reverse_seam";
    int seam = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
    }
};

struct NameSeam {
    static constexpr const char* name = "name_seam";
    int seam = 0;
    std::string to{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
        visit("to", to);
    }
};

struct AcceptEase {
    static constexpr const char* name = "accept_ease";
    int seam = 0;
    bool is_eased = true;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
        visit("is_eased", is_eased);
    }
};

// Makes its second side as long as the first.
struct EvenSeam {
    static constexpr const char* name = "even_seam";
    int seam = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
    }
};

}  // namespace selvedge
