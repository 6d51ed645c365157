#pragma once
// Garment patterns, as the files of patterns/FORMAT.md have them.
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "selvedge/errors.h"
#include "selvedge/export.h"

namespace selvedge {

// A garment's pattern. It does not change; copies share it, and several threads may use it.
class SELVEDGE_API Pattern {
 public:
    struct Content;  // of the library

    explicit Pattern(std::shared_ptr<const Content> content);
    Pattern(const Pattern&);
    Pattern& operator=(const Pattern&);
    ~Pattern();

    const std::string& name() const;
    std::vector<std::string> panel_names() const;
    std::vector<std::string> seam_names() const;  // in the order of Result::seams_of_vertices()
    std::string text() const;                     // of a garment file
    // Warnings and errors, as `selvedge check` lists them. Empty: it can be dressed.
    std::vector<Fault> faults() const;

    const Content& content() const { return *content_; }

 private:
    std::shared_ptr<const Content> content_;
};

// Reads a garment file, or its text; `name`: its file's name in messages. Throws InputError for the first fault that is
// an error.
SELVEDGE_API Pattern load_pattern(const std::filesystem::path& file);
SELVEDGE_API Pattern parse_pattern(std::string_view text, const std::string& name = {});

// All faults of a garment file, also of one that load_pattern() refuses. Does not throw InputError.
SELVEDGE_API std::vector<Fault> check_pattern(const std::filesystem::path& file);

// Names for DressOptions::fabric and Looks::tartan, in alphabetical order.
SELVEDGE_API std::vector<std::string> fabric_names();
SELVEDGE_API std::vector<std::string> tartan_names();

}  // namespace selvedge
