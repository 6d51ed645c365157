#pragma once
// The files that a garment file or a fabric file names: fabrics, pictures, photos under the sheet, bodies. What a
// stored file names is held by its canonical path, what a user types as it is typed. A file that is stored names it
// relative to its own folder if it lies there or below, so that both can be moved or sent together; otherwise by its
// canonical path.
#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/json.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The canonical path of what `file` names. The file that is named need not exist. As it is named if `file`
// or the name is empty.
std::string resolve_named_file(const std::string& name, const std::filesystem::path& file);

// The same for all files that the pattern names.
void resolve_named_files(Pattern& pattern, const std::filesystem::path& file);

enum class FileUse { Body, Fabric, Picture, Underlay };  // Underlay: a photo under the sheet of the editor

struct NamedFileUse {
    std::string file;
    FileUse use = FileUse::Fabric;
};

// The files that are read when the pattern is dressed, drawn or edited, as the pattern holds them; the picture of a
// fabric's file too. A file may come twice.
std::vector<NamedFileUse> named_file_uses(const Pattern& pattern);

std::vector<std::string> named_files(const Pattern& pattern);  // the same without their uses

// Names the file at `path` in JSON that will be stored as `file`. A path that is not absolute is relative to the
// working directory. A name that leads there already is kept. If `file` is empty, the name is the path.
void set_named_file(Json& name, const std::string& path, const std::filesystem::path& file);

}  // namespace selvedge::sim
