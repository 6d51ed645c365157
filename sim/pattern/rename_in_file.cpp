// Implements rename_panel_in_file of pattern_file.h: every place of a pattern file that names a panel.
#include <string>

#include "sim/core/json.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::sim {
namespace {

void rename_text(Json* text, const std::string& from, const std::string& to) {
    if (text && text->is_string() && text->string() == from) *text = to;
}

}  // namespace

void rename_panel_in_file(Json& specification, const std::string& from, const std::string& to) {
    Json* garment = specification.find("pattern");
    Json* panels = garment ? garment->find("panels") : nullptr;
    if (!panels || !panels->is_object() || !panels->find(from) || panels->find(to)) return;
    for (Json::Member& panel : panels->members()) {
        if (panel.key == from) panel.key = to;
        Json* own = panel.value.find("selvedge");
        for (const char* key : {"mirror_of", "copy_of"}) {
            if (own) rename_text(own->find(key), from, to);
        }
    }
    if (Json* order = garment->find("panel_order"); order && order->is_array()) {
        for (Json& name : order->elements()) rename_text(&name, from, to);
    }
    if (Json* stitches = garment->find("stitches"); stitches && stitches->is_array()) {
        for (Json& stitch : stitches->elements()) {
            if (!stitch.is_array()) continue;
            for (Json& side : stitch.elements()) rename_text(side.find("panel"), from, to);
        }
    }
    Json* own = specification.find("selvedge");
    if (Json* names = own ? own->find("seam_names") : nullptr; names && names->is_object()) {
        for (Json::Member& name : names->members()) rename_text(name.value.find("panel"), from, to);
    }
    for (const char* key : {"eased", "seams"}) {
        Json* list = own ? own->find(key) : nullptr;
        if (!list || !list->is_array()) continue;
        for (Json& side : list->elements()) rename_text(side.find("panel"), from, to);
    }
    if (Json* sewings = own ? own->find("sewings") : nullptr; sewings && sewings->is_object()) {
        for (Json::Member& sewing : sewings->members()) {
            if (!sewing.value.is_array()) continue;
            for (Json& side : sewing.value.elements()) rename_text(side.find("panel"), from, to);
        }
    }
}

}  // namespace selvedge::sim
