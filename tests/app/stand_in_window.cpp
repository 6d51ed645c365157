// The stand-in in a real window, for test_window: ends on Escape or a close request, then prints the input it received.
#include <iostream>

#include "sim/core/error.h"
#include "tests/app/edit_stand_in.h"
#include "tests/golden/frozen_scene.h"

int main(int argc, char** argv) {
    using namespace selvedge;
    using namespace selvedge::app;
    const std::string frame_times = argc > 1 ? argv[1] : "";
    try {
        Window window({.title = "Stand-in", .width = 1280, .height = 800});
        FakeEditor surface(test::make_frozen_scene(), frame_times.empty() ? 0 : 0.02F);
        EditLoopOptions options{.frame_times = frame_times};
        if (!frame_times.empty()) options.frames = 240;
        run_edit_loop(surface, window, options);
        window.set_clipboard("woven");
        std::cout << "pressed " << surface.presses() << " typed '" << surface.typed() << "' clipboard '"
                  << window.clipboard() << "' scale " << window.scale() << '\n';
    } catch (const sim::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
    return 0;
}
