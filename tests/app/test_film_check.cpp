// Films that were cut off are found, and the writer refuses one although its encoder says that all is well.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/film.h"
#include "app/film_check.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "tests/app/run_program.h"

namespace selvedge::app {
namespace {

std::string box(const std::string& kind, const std::string& content) {
    const std::size_t size = content.size() + 8;
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(size >> shift & 0xFFU);
    return text + kind + content;
}

std::string whole_mp4() {
    return box("ftyp", "isom0000") + box("moov", std::string(300, 'i')) + box("mdat", std::string(5000, 'd'));
}

std::string whole_gif() {
    return "GIF89a" + std::string(300, 'g') + std::string("\0;", 2);
}

bool is_whole(const std::string& bytes, FilmKind kind) {
    const ScratchFolder folder;
    sim::write_file_atomically(folder / "film", bytes);
    return is_whole_film(folder / "film", kind);
}

TEST(FilmCheck, knows_a_whole_film_from_its_first_part) {
    for (const auto& [film, kind] : {std::pair(whole_mp4(), FilmKind::Mp4), std::pair(whole_gif(), FilmKind::Gif)}) {
        EXPECT_TRUE(is_whole(film, kind));
        const ScratchFolder folder;
        sim::write_file_atomically(folder / "film", film);
        for (std::size_t size = film.size(); size-- > 0;) {
            std::filesystem::resize_file(folder / "film", size);
            ASSERT_FALSE(is_whole_film(folder / "film", kind)) << size << " of " << film.size();
        }
    }
}

TEST(FilmCheck, wants_the_index_that_players_look_for) {
    EXPECT_FALSE(is_whole(box("ftyp", "isom0000") + box("mdat", "frames"), FilmKind::Mp4));
    EXPECT_FALSE(is_whole(box("moov", "index") + box("mdat", "frames"), FilmKind::Mp4));
    EXPECT_FALSE(is_whole("no film", FilmKind::Mp4));
    EXPECT_FALSE(is_whole("no film, but it ends so" + std::string("\0;", 2), FilmKind::Gif));
    EXPECT_FALSE(is_whole_film("/no/such/film.mp4", FilmKind::Mp4));
}

// Instead of ffmpeg, a program that writes these bytes to the file that it is told, and always exits with 0.
class StandInEncoder {
 public:
    explicit StandInEncoder(const std::string& bytes) {
        sim::write_file_atomically(folder_ / "bytes", bytes);
        sim::write_file_atomically(
            folder_ / "ffmpeg",
            "#!/bin/sh\ncat > /dev/null\nfor last; do :; done\ncat '" + folder_ / "bytes" +
                "' > \"$last\"\necho 'av_interleaved_write_frame(): No space left on device' >&2\n");
        std::filesystem::permissions(folder_ / "ffmpeg", std::filesystem::perms::owner_all);
        ::setenv("PATH", (folder_.path().string() + ":" + before_).c_str(), 1);
    }
    ~StandInEncoder() { ::setenv("PATH", before_.c_str(), 1); }
    StandInEncoder(const StandInEncoder&) = delete;
    StandInEncoder& operator=(const StandInEncoder&) = delete;

    std::string operator/(const std::string& name) const { return folder_ / name; }

 private:
    ScratchFolder folder_;
    std::string before_ = std::getenv("PATH");
};

TEST(FilmWriter, refuses_a_film_that_a_full_disk_cut_off) {
    const StandInEncoder encoder(whole_mp4().substr(0, 2000));
    const std::string file = encoder / "film.mp4";
    FilmWriter film(file, {.width_px = 4, .height_px = 4});
    film.add(render::Image(4, 4));
    try {
        film.finish();
        ADD_FAILURE() << "accepted";
    } catch (const sim::InputError& error) {
        EXPECT_EQ(error.file(), file);
        EXPECT_EQ(error.problem(), "cannot write: No space left on device");
    }
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(FilmWriter, keeps_a_whole_film) {
    const StandInEncoder encoder(whole_mp4());
    const std::string file = encoder / "film.mp4";
    FilmWriter film(file, {.width_px = 4, .height_px = 4});
    film.add(render::Image(4, 4));
    film.finish();
    EXPECT_EQ(content_of(file), whole_mp4());
}

}  // namespace
}  // namespace selvedge::app
