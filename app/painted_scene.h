#pragma once
// Scenes whose mode paints figures on the cloth (render/show.h), as the editor asks for them: painted once, with the
// legend beside them.
#include <memory>
#include <optional>

#include "render/legend.h"
#include "render/scene/scene.h"

namespace selvedge {

struct PaintedScene {
    std::shared_ptr<const Scene> scene;
    std::optional<Legend> legend;
};

class ScenePaint {
 public:
    // The same scene gives the same pointer. Where the mode asks for what is not there, cloth is plain.
    const PaintedScene& painted(const std::shared_ptr<const Scene>& scene);

 private:
    std::shared_ptr<const Scene> last_;
    PaintedScene painted_;
};

}  // namespace selvedge
