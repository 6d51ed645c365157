#pragma once
// Whether a film that another program wrote is whole. A program that ran out of disk can leave the first part of one
// and still exit successfully.
#include <filesystem>

#include "app/film.h"

namespace selvedge::app {

// Whether the file holds a film of this kind to its end: an MP4 whose boxes fill the file and have the index that
// players look for (ISO/IEC 14496-12, 4.2: ftyp, moov, mdat), a GIF that ends in its trailer (GIF89a, 27). False if it
// cannot be read. Of Frames: true.
bool is_whole_film(const std::filesystem::path& file, FilmKind kind);

}  // namespace selvedge::app
