#include "app/turntable.h"

#include <algorithm>
#include <vector>

#include "app/composition.h"
#include "app/film.h"
#include "render/renderer.h"
#include "sim/core/error.h"

namespace selvedge {
namespace {

FilmFormat film_format(const PictureOptions& picture, const TurntableOptions& options) {
    return {.width_px = picture.width_px,
            .height_px = picture.height_px,
            .frames_per_second = options.frames_per_second,
            .frames = options.frames};
}

// So many angles of one turn, rad.
std::vector<float> turn_in(int count) {
    std::vector<float> turns;
    for (int i = 0; i < count; ++i) turns.push_back(6.2831853F * float(i) / float(count));
    return turns;
}

void add_count(CLI::App& command, const char* name, int& value, int most, const char* help) {
    const auto check_and_take = [name, &value, most](const int& count) {
        if (count < 1 || count > most) throw InputError("", name, "must be from 1 to " + std::to_string(most));
        value = count;
    };
    command.add_option_function<int>(name, check_and_take, help)
        ->type_name("N")
        ->group("Film")
        ->needs(command.get_option("--turntable"));
}

}  // namespace

void add_turntable_options(CLI::App& command, TurntableOptions& options) {
    command
        .add_option("--turntable", options.file,
                    "Film of one turn: .mp4 or .gif (by ffmpeg), or a folder for frames, ending in / or .frames")
        ->type_name("FILE|FOLDER/")
        ->group("Film");
    add_count(command, "--frames", options.frames, 3600, "Frames of the turn (default 100)");
    add_count(command, "--fps", options.frames_per_second, 120, "Frames per second (default 25)");
}

void check_turntable(const TurntableOptions& options, const PictureOptions& picture) {
    if (options.file.empty()) return;
    check_film(options.file, film_format(picture, options));
    if (picture.is_transparent && film_kind(options.file) != FilmKind::Frames)
        throw InputError("", "--transparent", "films have no transparency: name a folder for frames");
}

void write_turntable(const Sitter& sitter, const PictureOptions& picture, const TurntableOptions& options,
                     const Progress& progress) {
    constexpr int most_framed = 48;  // angles are enough to find the frame for all of them
    const std::vector<float> turns = turn_in(options.frames);
    const Composition composition = compose(sitter, picture, turn_in(std::min(options.frames, most_framed)));
    Renderer renderer;
    FilmWriter film(options.file, film_format(picture, options));
    for (std::size_t i = 0; i < turns.size(); ++i) {
        report(progress, "filming", double(i) / double(turns.size()));
        Image image = renderer.draw(turned(composition, picture, turns[i]), render_options(picture));
        if (composition.legend) draw_legend(image, *composition.legend, composition.corner);
        film.add(image);
    }
    film.finish();
    report(progress, "filming", 1);
}

}  // namespace selvedge
