#include "app/film_check.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace selvedge::app {
namespace {

// A number of `count` bytes, the most significant first. Zero after the file's end; the stream tells.
std::uint64_t read_number(std::istream& stream, int count) {
    std::uint64_t number = 0;
    for (int i = 0; i < count; ++i) number = number << 8U | (static_cast<std::uint64_t>(stream.get()) & 0xFFU);
    return stream ? number : 0;
}

bool is_whole_mp4(std::istream& stream, std::uint64_t size) {
    bool has_type = false, has_index = false, has_frames = false;
    std::uint64_t at = 0;
    while (at < size) {
        stream.seekg(static_cast<std::streamoff>(at));
        std::uint64_t length = read_number(stream, 4);
        std::array<char, 4> name{};
        stream.read(name.data(), name.size());
        const std::string_view kind(name.data(), name.size());
        std::uint64_t header = 8;
        if (length == 1) {  // a long one
            length = read_number(stream, 8);
            header = 16;
        }
        if (!stream || length < header || length > size - at) return false;
        has_type |= kind == "ftyp";
        has_index |= kind == "moov" && length > header;
        has_frames |= kind == "mdat" && length > header;
        at += length;
    }
    return has_type && has_index && has_frames;
}

bool is_whole_gif(std::istream& stream, std::uint64_t size) {
    std::array<char, 4> head{};
    stream.read(head.data(), head.size());
    if (size < 14 || std::string_view(head.data(), head.size()) != "GIF8") return false;
    stream.seekg(static_cast<std::streamoff>(size - 2));
    return stream.get() == 0 && stream.get() == ';';  // the end of the last picture, and the trailer
}

}  // namespace

bool is_whole_film(const std::filesystem::path& file, FilmKind kind) {
    if (kind == FilmKind::Frames) return true;
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    if (error || !stream) return false;
    return kind == FilmKind::Mp4 ? is_whole_mp4(stream, size) : is_whole_gif(stream, size);
}

}  // namespace selvedge::app
