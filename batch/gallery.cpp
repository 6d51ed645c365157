#include "batch/gallery.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

#include "batch/job_folder.h"
#include "batch/results.h"
#include "sim/core/file.h"
#include "sim/inspection/report.h"

namespace selvedge::batch {

std::span<const sim::EmbeddedFile> embedded_gallery();  // gallery.html

namespace {

using sim::Json;
namespace key = sim::report_key;

constexpr std::string_view kPlaceOfRows = "/*ROWS*/";

bool has_file(const Json& row, std::string_view name) {
    return std::ranges::any_of(row.find("files")->elements(), [&](const Json& file) { return file.string() == name; });
}

Json faults_of(const Json& row) {
    Json list = Json::array();
    for (const Json& fault : row.find(key::kFaults)->elements()) {
        Json item = Json::object();
        for (const std::string_view name : {key::kKind, key::kClass, key::kValue, key::kUnit, key::kCause})
            item[name] = member_of(fault, name);
        list.push_back(std::move(item));
    }
    return list;
}

Json row_of(const Json& row, const JobChange* change) {
    Json shown = Json::object();
    for (const std::string_view name :
         {"job", "garment", "over", "body", "fabric", "job_options", "exit_code", "files", "replay"})
        shown[name] = member_of(row, name);
    for (const std::string_view name :
         {key::kOutcome, key::kProblem, key::kFit, key::kInputs, key::kNotes, key::kSimulatedSeconds})
        shown[name] = member_of(row, name);
    shown["faults"] = faults_of(row);
    shown["first_cause"] = first_cause(row);
    shown["picture"] = has_file(row, job_file::kPicture);
    const Json* mesh = row.find(key::kMesh);
    shown["triangles"] = mesh == nullptr ? Json() : member_of(*mesh, key::kLeafTriangles);
    if (change == nullptr) return shown;
    Json& changed = shown["change"] = Json::object();
    changed["is_changed"] = change->is_changed();
    changed["is_new"] = change->is_new;
    changed["outcome_before"] = change->outcome_before;
    changed["has_new_picture"] = change->has_new_picture;
    changed["differing_share"] = change->differing_share;
    return shown;
}

// JSON that can stand in a script of a page: no text ends the script.
std::string for_script(const Json& json) {
    constexpr int kOneLine = -1;
    std::string text;
    for (const char c : write_json(json, kOneLine)) {
        if (c == '<') {
            text += "\\u003c";
        } else {
            text += c;
        }
    }
    return text;
}

}  // namespace

std::string gallery_html(const std::vector<Json>& rows, const std::vector<JobChange>& changes) {
    std::string text = "[";
    for (std::size_t i = 0; i < rows.size(); ++i)
        text += (i == 0 ? "\n" : ",\n") + for_script(row_of(rows[i], changes.empty() ? nullptr : &changes[i]));
    text += "\n]";
    std::string page(embedded_gallery().front().text);
    page.replace(page.find(kPlaceOfRows), kPlaceOfRows.size(), text);
    return page;
}

void write_gallery(const std::vector<Json>& rows, const std::vector<JobChange>& changes,
                   const std::filesystem::path& output) {
    sim::write_file_atomically(output / result_file::kGallery, gallery_html(rows, changes));
}

}  // namespace selvedge::batch
