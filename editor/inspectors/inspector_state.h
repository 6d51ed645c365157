#pragma once
// What the boxes and lists remember between two frames of the screen: what is typed and not yet applied, what is
// unfolded, pictures that are made once.
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/frame/frame_output.h"
#include "editor/inspectors/drape_trace.h"
#include "sim/body/body.h"
#include "sim/tartan/match.h"
#include "sim/tartan/sett.h"

namespace selvedge {

// Text that is being typed into a box.
struct TypedText {
    unsigned box = 0;  // ImGui's id; 0: none
    std::string text{};
    std::string text_before{};
    std::optional<double> before{};  // value of a number box, when it was entered
    std::string wrong{};             // why it cannot be applied, in words; empty: it can
    bool is_trying = false;          // a change is shown that is not kept yet
    int last_frame = 0;              // when the box was last drawn
};

// A number that is dragged by its label.
struct Scrub {
    unsigned box = 0;  // ImGui's id; 0: none
    double before = 0;
    double value = 0;
    bool is_trying = false;
    bool is_given_up = false;  // by Esc, until the button is let go
    int last_frame = 0;
};

struct BoxState {
    TypedText typed;
    TypedText left;  // another box was entered before this one could apply its text
    Scrub scrub;
};

// What is costly to know of a panel, as of a revision of the document.
struct PanelFacts {
    std::uint64_t revision = 0;
    double area = 0;       // m^2
    double perimeter = 0;  // m
};

// Angles as they were typed: a rotation has several.
struct TypedAngles {
    Vec3d angles = Vec3d::Zero();  // rad, about x, y, z
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

struct TartanPicture {
    std::string shown_as{};  // "Black Watch"
    Sett sett{};
    UiTexture texture = 0;
};

struct MaterialState {
    std::string fabric{};  // whose values are shown; empty: the garment's
    std::string search{};
    std::vector<std::pair<std::string, TartanPicture>> tartans{};  // those that ship, by name
    UiTexture repeats = 0;                                         // the preview from afar,
    UiTexture threads = 0;                                         // and from near
    std::string previewed{};                                       // what they show
    std::vector<SeamMatch> matched{};                              // what the last match came to
    std::uint64_t matched_revision = 0;
};

struct BodyState {
    std::string pending{};  // the body that is wanted and not yet the document's; empty: none
    bool is_kept = false;   // to become the document's once it is made
    int idle_frames = 0;    // that nothing was being made while it was pending
    std::string wrong{};    // why what was typed is no body
    std::string drafted{};  // text of the body that the document names, and that body
    std::shared_ptr<const Body> drafted_body{};
};

struct DrapeState {
    DrapeTrace trace{};
    std::vector<std::string> kept{};  // names of drapes that the session keeps
    std::string name{};               // for the next
};

struct InspectorState {
    BoxState boxes{};
    std::map<std::string, PanelFacts> panels{};
    std::map<std::string, TypedAngles> angles{};
    MaterialState material{};
    BodyState body{};
    DrapeState drape{};
    std::optional<int> hovered_seam{};  // that the list lights up
};

}  // namespace selvedge
