#pragma once
// Pictures one after the other as a film: an .mp4 or .gif by ffmpeg, which reads raw frames from a pipe, or a folder of
// PNG files.
#include <sys/types.h>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture.h"
#include "render/image/image.h"
#include "sim/core/parallel.h"

namespace CLI {
class App;
}

namespace selvedge::app {

enum class FilmKind { Mp4, Gif, Frames };

struct FilmFormat {
    int width_px = 0;
    int height_px = 0;
    int frames_per_second = 25;
    int frames = 1;
};

// By its ending; frames where it names a folder: one that is there, or a name that ends in '/' or .frames.
// Throws InputError for any other name.
FilmKind film_kind(const std::filesystem::path& path);

// Throws InputError when such a film cannot be written there, where frames of a longer one are, or ffmpeg is asked for
// and missing: to be asked before long work.
void check_film(const std::filesystem::path& path, const FilmFormat& format);

// What stands at the path is replaced when the film is whole; until then the film has another name, and goes with the
// object. Frames are written as frame_0001.png and so on, one by one.
class FilmWriter {
 public:
    FilmWriter(const std::filesystem::path& path, const FilmFormat& format);
    ~FilmWriter();
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;

    // Pre: of the format's size. Both throw InputError when the film cannot be written, with ffmpeg's own first words.
    void add(const render::Image& image);
    void finish();

 private:
    class Encoder;

    std::filesystem::path path_;
    FilmKind kind_;
    int frames_ = 0;
    std::unique_ptr<Encoder> encoder_;  // none for frames
};

// A program that reads what we write to it. It is started without a shell.

// Whether PATH has a program of that name.
bool has_program(const std::string& name);

class PipedProcess {
 public:
    // arguments: the program's name first; it is looked for in PATH. Its output goes nowhere.
    // Throws std::runtime_error when it cannot be started.
    explicit PipedProcess(const std::vector<std::string>& arguments);
    ~PipedProcess();  // one that was not waited for is killed
    PipedProcess(const PipedProcess&) = delete;
    PipedProcess& operator=(const PipedProcess&) = delete;

    // False when it does not read any more.
    bool write(std::string_view bytes);

    // Closes the pipe and waits. Whether it ended well.
    bool finish();

    // The first line that it complained with, so far.
    std::string complaint() const;

 private:
    void close_pipe();

    std::FILE* complaints_ = nullptr;  // a file without a name
    int pipe_ = -1;
    pid_t process_ = -1;
};

// --turntable: a film of the figure turning once about its upright, before a camera and lights that stand.

struct TurntableOptions {
    std::filesystem::path file;  // empty: no film is wanted
    int frames = 100;            // of one turn; the one after the last would be the first
    int frames_per_second = 25;
};

// Adds --turntable, --frames and --fps. `options` must outlive the command line.
void add_turntable_options(CLI::App& command, TurntableOptions& options);

// Throws InputError when the film cannot be written or is at odds with the picture's options: to be asked before long
// work. Without a file all is well.
void check_turntable(const TurntableOptions& options, const PictureOptions& picture);

// The frame is one for all angles, and holds the figure at each. Throws InputError as draw_picture does, and when the
// film cannot be written.
void write_turntable(const RenderSubject& sitter, const PictureOptions& picture, const TurntableOptions& options,
                     const sim::Progress& progress = {});

}  // namespace selvedge::app
