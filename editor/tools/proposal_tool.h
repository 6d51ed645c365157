#pragma once
// Shows the seams that a pattern without seams probably has (sim/proposals/seam_proposals.h), as dashed links with
// their confidence. One key each: Enter sews the marked one, Delete refuses it, R turns it round, Tab goes on to the
// next. What is sewn leads to new proposals.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "editor/tools/tool.h"
#include "editor/tools/tool_table.h"
#include "sim/proposals/seam_proposals.h"

namespace selvedge::editor {

class ProposalTool : public Tool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;  // marks the link under the cursor
    bool key(ToolContext& context, Key key, const Modifiers& modifiers) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    void refresh(const ToolContext& context);
    bool is_of_now(const Document& document) const;
    bool is_current(const ToolContext& context) const;
    void accept(ToolContext& context);
    void refuse();

    std::vector<sim::SeamProposal> proposals_;  // without those refused; the marked one is shown with its reason
    std::vector<std::pair<sim::EdgeSpan, sim::EdgeSpan>> refused_;  // the first parts of those
    std::optional<std::uint64_t> revision_;                         // of the document that they are of
    PanelStates states_;  // likewise: no seams are proposed to hidden and locked panels
    std::size_t marked_ = 0;
    bool is_turned_ = false;
};

// Not in the toolbar: the action seam.propose chooses it.
const ToolInfo& proposal_tool();

}  // namespace selvedge::editor
