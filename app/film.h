#pragma once
// Writes a sequence of images as a film: .mp4 or .gif with ffmpeg, which reads raw frames from a pipe, or a folder of
// PNG files. Also the child process that runs ffmpeg, and --turntable.
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

namespace selvedge::app {

class Command;

enum class FilmKind { Mp4, Gif, Frames };

struct FilmFormat {
    int width_px = 0;
    int height_px = 0;
    int frames_per_second = 25;
    int frames = 1;
};

// The kind of film for a path, by its extension. Frames: an existing folder, or a name that ends in '/' or .frames.
// Throws InputError for any other name.
FilmKind film_kind(const std::filesystem::path& path);

// Throws InputError if the film cannot be written to the path, if the folder contains frames of a longer film, or if
// ffmpeg is required and missing; this names the option. Call it before long work.
void check_film(const std::filesystem::path& path, const FilmFormat& format, const std::string& option);

// Writes to a temporary file and replaces `path` when the film is complete; the destructor removes an incomplete film.
// Frames are written directly, as frame_0001.png and so on.
class FilmWriter {
 public:
    FilmWriter(const std::filesystem::path& path, const FilmFormat& format);
    ~FilmWriter();
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;

    // Pre: the image has the format's size. Both throw InputError if the film cannot be written, with ffmpeg's first
    // error line.
    void add(const render::Image& image);
    void finish();

 private:
    class Encoder;

    std::filesystem::path path_;
    FilmKind kind_;
    int frames_ = 0;
    std::unique_ptr<Encoder> encoder_;  // none for frames
};

// A child process that reads from a pipe; started without a shell.

// Whether PATH contains a program of this name.
bool has_program(const std::string& name);

class PipedProcess {
 public:
    // It runs in a process group of its own, so that an interrupt from the terminal leaves it to its owner.
    // arguments: the program's name first; it is searched in PATH. Its stdout is discarded.
    // Throws std::runtime_error if it cannot be started.
    explicit PipedProcess(const std::vector<std::string>& arguments);
    ~PipedProcess();  // kills the process unless finish() was called
    PipedProcess(const PipedProcess&) = delete;
    PipedProcess& operator=(const PipedProcess&) = delete;

    // Returns false if the process no longer reads.
    bool write(std::string_view bytes);

    // Closes the pipe and waits for the process. Returns whether it exited successfully.
    bool finish();

    // The first line that the process has written to stderr so far.
    std::string message_text() const;

 private:
    void close_pipe();

    std::FILE* complaints_ = nullptr;  // an unnamed temporary file
    int pipe_ = -1;
    pid_t process_ = -1;
};

// --turntable: a film of the subject rotating once about its vertical axis; camera and lights are fixed.

struct TurntableOptions {
    std::filesystem::path file;  // empty: no film
    int frames = 100;            // frames of one full turn; the last is one step before the first
    int frames_per_second = 25;
};

// Adds --turntable, --frames and --fps. `options` must outlive the parsing.
void add_turntable_options(Command& command, TurntableOptions& options);

// Throws InputError if the film cannot be written or conflicts with the picture's options. Call it before long work.
// Does nothing without a file.
void check_turntable(const TurntableOptions& options, const PictureOptions& picture);

// Uses one camera frame for all angles, which contains the subject at each. Throws InputError as draw_picture() does,
// and if the film cannot be written.
void write_turntable(const RenderSubject& subject, const PictureOptions& picture, const TurntableOptions& options,
                     const sim::Progress& progress = {});

}  // namespace selvedge::app
