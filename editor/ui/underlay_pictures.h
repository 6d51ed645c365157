#pragma once
// The pictures of the photos and scans that lie under the sheet, read when a document first names them.
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "editor/workspace/workspace.h"
#include "render/image/photo.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

using PhotoReader = std::function<render::Photo(const std::string& file)>;  // throws InputError

inline constexpr int kLargestUnderlaySide = 8192;  // px; larger photos are held at half their size, or less

class UnderlayPictures {
 public:
    // Holds the pictures of these underlays, and no other. A file that cannot be read gives one warning.
    void update(const std::vector<sim::Underlay>& underlays, const PhotoReader& read, Messages& messages);

    // Holds the picture of a file that was just read, so that `update` does not read it again.
    void hold(const std::string& file, render::Photo photo);

    // null: it could not be read, or belongs to no underlay.
    std::shared_ptr<const render::Photo> find(const std::string& file) const;

    // Its size in px, before it was reduced; zero without one.
    Eigen::Vector2i size_px(const std::string& file) const;

 private:
    struct Held {
        std::shared_ptr<const render::Photo> photo;
        Eigen::Vector2i size_px = Eigen::Vector2i::Zero();
    };
    std::map<std::string, Held> held_;
};

}  // namespace selvedge::editor
