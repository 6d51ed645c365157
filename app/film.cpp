#include "app/film.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <vector>

#include "app/output_files.h"
#include "app/piped_process.h"
#include "render/image/png.h"
#include "sim/core/assert.h"
#include "sim/core/error.h"

namespace selvedge {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> kFilmExtensions{".mp4", ".gif"};

std::string lower_extension(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

std::string frame_name(int number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame_%04d.png", number);
    return name.data();
}

// "out/" is "out" when the folder is to be made.
fs::path folder_of_frames(const fs::path& path) {
    return path.has_filename() ? path : path.parent_path();
}

// Of an earlier, longer film: they would be taken for this one's.
void check_no_more_frames(const fs::path& folder, int frames) {
    std::error_code ignored;
    const fs::path next = folder / frame_name(frames + 1);
    if (!fs::exists(next, ignored)) return;
    throw InputError(folder.string(), "",
                     "cannot write: '" + next.filename().string() +
                         "' of an earlier, longer film is there: remove it and those after it, or name another folder");
}

void check_folder(const fs::path& path) {
    const fs::path folder = folder_of_frames(path);
    std::error_code ignored;
    const bool is_there = fs::exists(folder, ignored);
    if (is_there && !fs::is_directory(folder, ignored))
        throw InputError(path.string(), "", "cannot write: what stands there is not a folder");
    const fs::path written = is_there ? folder : fs::absolute(folder, ignored).parent_path();
    if (::access(written.c_str(), W_OK | X_OK) != 0)
        throw InputError(path.string(), "", std::string("cannot write: ") + std::strerror(errno));
}

// The steps of a gif's few colours are hidden by an ordered pattern, which stands still from frame to frame.
std::vector<std::string> gif_words() {
    return {"-filter_complex",
            "[0:v]split[a][b];[a]palettegen=stats_mode=full[palette];"
            "[b][palette]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle",
            "-loop",
            "0",
            "-f",
            "gif"};
}

// Colours by the standard that players take for granted.
std::vector<std::string> mp4_words() {
    return {"-vf",
            "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int",
            "-c:v",
            "libx264",
            "-preset",
            "medium",
            "-crf",
            "16",
            "-pix_fmt",
            "yuv420p",
            "-colorspace",
            "bt709",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "bt709",
            "-color_range",
            "tv",
            "-movflags",
            "+faststart",
            "-f",
            "mp4"};
}

std::vector<std::string> encoder_words(FilmKind kind, const FilmFormat& format, const fs::path& output) {
    std::vector<std::string> words{"ffmpeg",
                                   "-hide_banner",
                                   "-nostdin",
                                   "-v",
                                   "error",
                                   "-y",
                                   "-f",
                                   "rawvideo",
                                   "-pixel_format",
                                   "rgb24",
                                   "-video_size",
                                   std::to_string(format.width_px) + "x" + std::to_string(format.height_px),
                                   "-framerate",
                                   std::to_string(format.frames_per_second),
                                   "-i",
                                   "pipe:0"};
    const std::vector<std::string> more = kind == FilmKind::Gif ? gif_words() : mp4_words();
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), {"-fflags", "+bitexact", "-flags:v", "+bitexact", fs::absolute(output).string()});
    return words;
}

std::string as_rgb(const Image& image) {
    std::string bytes;
    bytes.reserve(3 * image.pixels.size());
    for (const Rgba8& pixel : image.pixels) {
        for (std::size_t i = 0; i < 3; ++i) bytes.push_back(static_cast<char>(pixel[i]));
    }
    return bytes;
}

}  // namespace

FilmKind film_kind(const fs::path& path) {
    const std::string extension = lower_extension(path);
    std::error_code ignored;
    if (fs::is_directory(path, ignored) || !path.has_filename()) return FilmKind::Frames;
    if (extension == ".frames") return FilmKind::Frames;
    if (extension == ".mp4") return FilmKind::Mp4;
    if (extension == ".gif") return FilmKind::Gif;
    throw InputError(
        path.string(), "",
        "cannot write: a film's name should end in .mp4, .gif or, for a folder of frames, in / or .frames");
}

void check_film(const fs::path& path, const FilmFormat& format) {
    const FilmKind kind = film_kind(path);
    if (kind == FilmKind::Frames) {
        check_folder(path);
        return check_no_more_frames(folder_of_frames(path), format.frames);
    }
    if (kind == FilmKind::Gif && format.frames_per_second > 50)
        throw InputError("", "--fps", "a .gif film has at most 50 frames per second");
    check_output(path, kFilmExtensions);
    if (kind == FilmKind::Mp4 && (format.width_px % 2 != 0 || format.height_px % 2 != 0))
        throw InputError("", "--size", "an .mp4 film has sides of even numbers of pixels");
    if (!has_program("ffmpeg")) {
        throw InputError("", "--turntable",
                         "films are written by ffmpeg, which is missing: install the package ffmpeg, or name a folder "
                         "for frames");
    }
}

// ffmpeg at work on a file of another name.
class FilmWriter::Encoder {
 public:
    Encoder(const fs::path& path, FilmKind kind, const FilmFormat& format)
        : path_(path),
          temporary_(path.parent_path() / ("." + path.filename().string() + "." + std::to_string(::getpid()) + ".tmp")),
          process_(std::in_place, encoder_words(kind, format, temporary_)) {}
    ~Encoder() {
        process_.reset();  // so that it does not write on
        std::error_code ignored;
        fs::remove(temporary_, ignored);
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    void add(const Image& image) {
        if (process_->write(as_rgb(image))) return;
        process_->finish();
        fail();
    }
    void finish() {
        if (!process_->finish()) fail();
        if (::rename(temporary_.c_str(), path_.c_str()) != 0)
            throw InputError(path_.string(), "", std::string("cannot write: ") + std::strerror(errno));
    }

 private:
    [[noreturn]] void fail() const {
        const std::string words = process_->complaint();
        throw InputError(path_.string(), "", "ffmpeg could not write it" + (words.empty() ? "" : ": " + words));
    }

    fs::path path_;
    fs::path temporary_;
    std::optional<PipedProcess> process_;
};

FilmWriter::FilmWriter(const fs::path& path, const FilmFormat& format) : path_(path), kind_(film_kind(path)) {
    if (kind_ != FilmKind::Frames) {
        try {
            encoder_ = std::make_unique<Encoder>(path, kind_, format);
        } catch (const InputError&) {
            throw;
        } catch (const std::runtime_error& error) {
            throw InputError(path.string(), "", error.what());
        }
        return;
    }
    std::error_code error;
    fs::create_directories(folder_of_frames(path), error);
    if (error) throw InputError(path.string(), "", "cannot write: " + error.message());
}

FilmWriter::~FilmWriter() = default;

void FilmWriter::add(const Image& image) {
    ++frames_;
    if (encoder_) return encoder_->add(image);
    write_png(folder_of_frames(path_) / frame_name(frames_), image);
}

void FilmWriter::finish() {
    if (encoder_) encoder_->finish();
}

}  // namespace selvedge
