#pragma once
// The pictures of an import that are to be traced: laid on the sheet at true size, and their files beside the
// garment's.
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/paper/drawing.h"
#include "sim/pattern/pattern.h"

namespace selvedge::app {

struct UnderlayFile {
    std::size_t page = 0;  // of its drawing, from 1
    std::string size;      // "21.0 x 29.7 cm"
    std::string bytes;     // of a JPEG
    std::filesystem::path path = {};
};

// Lays the pictures side by side, in rows, right of the panels. Their files have no names yet.
std::vector<UnderlayFile> lay_pictures(sim::Pattern& pattern, const std::vector<sim::DrawnPicture>& pictures);

// Names the files after a file beside which they lie: "skirt_page3.jpg" beside "skirt.json".
void name_beside(std::vector<UnderlayFile>& files, sim::Pattern& pattern, const std::filesystem::path& beside);

// Writes the files. If it fails, or is undone, none is left that was not there before. Throws InputError if a file is
// there that holds something else.
class WrittenUnderlays {
 public:
    explicit WrittenUnderlays(const std::vector<UnderlayFile>& files);
    ~WrittenUnderlays();
    WrittenUnderlays(const WrittenUnderlays&) = delete;
    WrittenUnderlays& operator=(const WrittenUnderlays&) = delete;

    void keep() { added_.clear(); }

 private:
    void remove_added();

    std::vector<std::filesystem::path> added_;
};

}  // namespace selvedge::app
