#pragma once
// Pictures one after the other as a film: an .mp4 or .gif by ffmpeg, which reads raw frames from a pipe, or a folder of
// PNG files.
#include <filesystem>
#include <memory>
#include <string>

#include "render/image/image.h"

namespace selvedge {

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
    void add(const Image& image);
    void finish();

 private:
    class Encoder;

    std::filesystem::path path_;
    FilmKind kind_;
    int frames_ = 0;
    std::unique_ptr<Encoder> encoder_;  // none for frames
};

}  // namespace selvedge
