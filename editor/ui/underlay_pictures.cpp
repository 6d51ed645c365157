#include "editor/ui/underlay_pictures.h"

#include <algorithm>
#include <utility>

#include "sim/core/error.h"

namespace selvedge::editor {

void UnderlayPictures::update(const std::vector<sim::Underlay>& underlays, const PhotoReader& read,
                              Messages& messages) {
    std::erase_if(held_, [&](const auto& entry) {
        return std::ranges::find(underlays, entry.first, &sim::Underlay::file) == underlays.end();
    });
    for (const sim::Underlay& underlay : underlays) {
        if (!held_.try_emplace(underlay.file).second || !read) continue;
        try {
            hold(underlay.file, read(underlay.file));
        } catch (const sim::InputError& error) {
            messages.warn(error.what());
        }
    }
}

void UnderlayPictures::hold(const std::string& file, render::Photo photo) {
    Held& held = held_[file];
    held.size_px = {photo.image.width_px, photo.image.height_px};
    photo.image = reduced(std::move(photo.image), kLargestUnderlaySide);
    held.photo = std::make_shared<const render::Photo>(std::move(photo));
}

std::shared_ptr<const render::Photo> UnderlayPictures::find(const std::string& file) const {
    const auto found = held_.find(file);
    return found == held_.end() ? nullptr : found->second.photo;
}

Eigen::Vector2i UnderlayPictures::size_px(const std::string& file) const {
    const auto found = held_.find(file);
    return found == held_.end() ? Eigen::Vector2i(0, 0) : found->second.size_px;
}

}  // namespace selvedge::editor
