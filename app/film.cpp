#include "app/film.h"

#include <fcntl.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): <csignal> need not have POSIX sigaction
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "app/arguments.h"
#include "app/film_check.h"
#include "app/options.h"
#include "app/picture.h"
#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "sim/core/assert.h"
#include "sim/core/atomic_file.h"
#include "sim/core/error.h"
#include "sim/core/file_extension.h"
#include "sim/core/file_path.h"

namespace selvedge::app {
namespace {

// Ignores SIGPIPE, so that writing to a process that has ended returns an error instead of ending this program.
class WithoutPipeSignal {
 public:
    WithoutPipeSignal() {
        struct sigaction ignored {};
        ignored.sa_handler = SIG_IGN;
        ::sigaction(SIGPIPE, &ignored, &before_);
    }
    ~WithoutPipeSignal() { ::sigaction(SIGPIPE, &before_, nullptr); }
    WithoutPipeSignal(const WithoutPipeSignal&) = delete;
    WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

 private:
    struct sigaction before_ {};
};

int spawn(pid_t& process, std::vector<std::string> arguments, int input, int complaints) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, complaints, STDERR_FILENO);
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error = ::posix_spawnp(&process, pointers.front(), &files, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

}  // namespace

bool has_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::filesystem::path program = std::filesystem::path(folder.empty() ? "." : folder) / name;
        std::error_code ignored;
        if (std::filesystem::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0) return true;
    }
    return false;
}

PipedProcess::PipedProcess(const std::vector<std::string>& arguments) : complaints_(std::tmpfile()) {
    std::array<int, 2> ends{};
    if (complaints_ == nullptr || ::pipe2(ends.data(), O_CLOEXEC) != 0) {
        if (complaints_ != nullptr) std::fclose(complaints_);
        throw std::runtime_error("cannot start " + arguments.front() + ": " + std::strerror(errno));
    }
    const int error = spawn(process_, arguments, ends[0], ::fileno(complaints_));
    ::close(ends[0]);
    pipe_ = ends[1];
    if (error == 0) return;
    process_ = -1;
    close_pipe();
    std::fclose(complaints_);
    throw std::runtime_error("cannot start " + arguments.front() + ": " + std::strerror(error));
}

PipedProcess::~PipedProcess() {
    close_pipe();
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    std::fclose(complaints_);
}

bool PipedProcess::write(std::string_view bytes) {
    const WithoutPipeSignal guard;
    while (!bytes.empty()) {
        const ssize_t written = ::write(pipe_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

bool PipedProcess::finish() {
    close_pipe();
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0) {
        if (errno != EINTR) break;
    }
    process_ = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string PipedProcess::message_text() const {
    std::array<char, 300> text{};
    const ssize_t got = ::pread(::fileno(complaints_), text.data(), text.size() - 1, 0);
    const std::string message(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
    return message.substr(0, message.find('\n'));
}

void PipedProcess::close_pipe() {
    if (pipe_ >= 0) ::close(pipe_);
    pipe_ = -1;
}

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> kFilmExtensions{".mp4", ".gif"};

std::string frame_name(int number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame_%04d.png", number);
    return name.data();
}

// "out/" becomes "out", so that the folder can be created.
fs::path folder_of_frames(const fs::path& path) {
    return path.has_filename() ? path : path.parent_path();
}

// Frames of an earlier, longer film would be read as part of this one.
void check_no_more_frames(const fs::path& folder, int frames) {
    std::error_code ignored;
    const fs::path next = folder / frame_name(frames + 1);
    if (!fs::exists(next, ignored)) return;
    throw sim::InputError(
        folder.string(), "",
        "cannot write: '" + next.filename().string() +
            "' of an earlier, longer film is there: remove it and those after it, or name another folder");
}

void check_frame_folder(const fs::path& path) {
    const fs::path folder = folder_of_frames(path);
    std::error_code ignored;
    const bool is_there = fs::exists(folder, ignored);
    if (is_there && !fs::is_directory(folder, ignored))
        throw sim::InputError(path.string(), "", "cannot write: what stands there is not a folder");
    const fs::path written = is_there ? folder : sim::absolute_path(folder).parent_path();
    if (::access(written.c_str(), W_OK | X_OK) != 0)
        throw sim::InputError(path.string(), "", std::string("cannot write: ") + std::strerror(errno));
}

// GIF has few colours: ordered dithering hides the banding and is stable from frame to frame.
std::vector<std::string> gif_arguments() {
    const std::string colours =
        "[0:v]split[a][b];[a]palettegen=stats_mode=full[palette];"
        "[b][palette]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle";
    return {"-filter_complex", colours, "-loop", "0", "-f", "gif"};
}

// BT.709, the colour standard that players assume.
std::vector<std::string> mp4_arguments() {
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

std::vector<std::string> encoder_arguments(FilmKind kind, const FilmFormat& format, const fs::path& output) {
    std::vector<std::string> arguments{"ffmpeg",
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
    const std::vector<std::string> more = kind == FilmKind::Gif ? gif_arguments() : mp4_arguments();
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(),
                     {"-fflags", "+bitexact", "-flags:v", "+bitexact", sim::absolute_path(output).string()});
    return arguments;
}

std::string as_rgb(const render::Image& image) {
    std::string bytes;
    bytes.reserve(3 * image.pixels.size());
    for (const render::Rgba8& pixel : image.pixels) {
        for (std::size_t i = 0; i < 3; ++i) bytes.push_back(static_cast<char>(pixel[i]));
    }
    return bytes;
}

}  // namespace

FilmKind film_kind(const fs::path& path) {
    const std::string extension = sim::lower_extension(path);
    std::error_code ignored;
    if (fs::is_directory(path, ignored) || !path.has_filename()) return FilmKind::Frames;
    if (extension == ".frames") return FilmKind::Frames;
    if (extension == ".mp4") return FilmKind::Mp4;
    if (extension == ".gif") return FilmKind::Gif;
    throw sim::InputError(
        path.string(), "",
        "cannot write: a film's name should end in .mp4, .gif or, for a folder of frames, in / or .frames");
}

void check_film(const fs::path& path, const FilmFormat& format, const std::string& option) {
    const FilmKind kind = film_kind(path);
    if (kind == FilmKind::Frames) {
        check_frame_folder(path);
        return check_no_more_frames(folder_of_frames(path), format.frames);
    }
    if (kind == FilmKind::Gif && format.frames_per_second > 50)
        throw sim::InputError("", "--fps", "a .gif film has at most 50 frames per second");
    check_output(path, kFilmExtensions);
    if (kind == FilmKind::Mp4 && (format.width_px % 2 != 0 || format.height_px % 2 != 0))
        throw sim::InputError("", "--size", "an .mp4 film has sides of even numbers of pixels");
    if (!has_program("ffmpeg")) {
        throw sim::InputError(
            "", option,
            "films are written by ffmpeg, which is missing: install the package ffmpeg, or name a folder "
            "for frames");
    }
}

// An ffmpeg process that writes to a temporary file.
class FilmWriter::Encoder {
 public:
    Encoder(const fs::path& path, FilmKind kind, const FilmFormat& format)
        : path_(path),
          kind_(kind),
          file_(path, sim::TemporaryName::Random),
          process_(std::in_place, encoder_arguments(kind, format, file_.temporary())) {}
    ~Encoder() {
        process_.reset();  // stops ffmpeg before its file is removed
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    void add(const render::Image& image) {
        if (process_->write(as_rgb(image))) return;
        process_->finish();
        fail();
    }
    // ffmpeg may exit successfully although the disk was full: what it wrote is looked at.
    void finish() {
        if (!process_->finish() || !is_whole_film(file_.temporary(), kind_)) fail();
        file_.commit();
    }

 private:
    [[noreturn]] void fail() const {
        const std::string text = process_->message_text();
        const std::string full = std::strerror(ENOSPC);
        if (text.ends_with(full)) throw sim::InputError(path_.string(), "", "cannot write: " + full);
        throw sim::InputError(path_.string(), "", "ffmpeg could not write it" + (text.empty() ? "" : ": " + text));
    }

    fs::path path_;
    FilmKind kind_;
    sim::AtomicFile file_;
    std::optional<PipedProcess> process_;
};

FilmWriter::FilmWriter(const fs::path& path, const FilmFormat& format) : path_(path), kind_(film_kind(path)) {
    if (kind_ != FilmKind::Frames) {
        try {
            encoder_ = std::make_unique<Encoder>(path, kind_, format);
        } catch (const sim::InputError&) {
            throw;
        } catch (const std::runtime_error& error) {
            throw sim::InputError(path.string(), "", error.what());
        }
        return;
    }
    std::error_code error;
    fs::create_directories(folder_of_frames(path), error);
    if (error) throw sim::InputError(path.string(), "", "cannot write: " + error.message());
}

FilmWriter::~FilmWriter() = default;

void FilmWriter::add(const render::Image& image) {
    ++frames_;
    if (encoder_) return encoder_->add(image);
    write_png(folder_of_frames(path_) / frame_name(frames_), image);
}

void FilmWriter::finish() {
    if (encoder_) encoder_->finish();
}

namespace {

FilmFormat film_format(const PictureOptions& picture, const TurntableOptions& options) {
    return {.width_px = picture.width_px,
            .height_px = picture.height_px,
            .frames_per_second = options.frames_per_second,
            .frames = options.frames};
}

// `count` equally spaced angles of one turn, rad.
std::vector<float> turn_in(int count) {
    std::vector<float> turns;
    turns.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i) turns.push_back(6.2831853F * float(i) / float(count));
    return turns;
}

void add_count(Command& command, const char* name, int& value, int most, const char* help) {
    add_number<int>(command, name, {1, most}, help, {.type = "N", .group = "Film", .needs = {"--turntable"}},
                    [&value](int count) { value = count; });
}

}  // namespace

void add_turntable_options(Command& command, TurntableOptions& options) {
    add_option(command, "--turntable", options.file,
               "Film of one turn: .mp4 or .gif (by ffmpeg), or a folder for frames, ending in / or .frames",
               {.type = "FILE|FOLDER/", .group = "Film"});
    add_count(command, "--frames", options.frames, 3600, "Frames of the turn (default 100)");
    add_count(command, "--fps", options.frames_per_second, 120, "Frames per second (default 25)");
}

void check_turntable(const TurntableOptions& options, const PictureOptions& picture) {
    if (options.file.empty()) return;
    check_film(options.file, film_format(picture, options), "--turntable");
    if (picture.is_transparent && film_kind(options.file) != FilmKind::Frames)
        throw sim::InputError("", "--transparent", "films have no transparency: name a folder for frames");
}

void write_turntable(const RenderSubject& subject, const PictureOptions& picture, const TurntableOptions& options,
                     const sim::Progress& progress) {
    constexpr int most_framed = 48;  // enough angles to find a camera frame for all of them
    const std::vector<float> turns = turn_in(options.frames);
    const render::Layout layout = compose(subject, picture, turn_in(std::min(options.frames, most_framed)));
    render::Renderer renderer;
    FilmWriter film(options.file, film_format(picture, options));
    for (std::size_t i = 0; i < turns.size(); ++i) {
        sim::report(progress, "filming", double(i) / double(turns.size()));
        render::Image image = renderer.draw(turned(layout, picture, turns[i]), render_options(picture));
        if (layout.legend) draw_legend(image, *layout.legend, layout.corner);
        film.add(image);
    }
    film.finish();
    sim::report(progress, "filming", 1);
}

}  // namespace selvedge::app
