#include "sim/paper/pdf_pictures.h"

#include <poppler/Error.h>
#include <poppler/GfxFont.h>
#include <poppler/GfxState.h>
#include <poppler/GlobalParams.h>
#include <poppler/PDFDoc.h>
#include <poppler/SplashOutputDev.h>
#include <poppler/Stream.h>
#include <poppler/splash/SplashBitmap.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <stdexcept>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/flat_bytes.h"

namespace selvedge::sim {
namespace {

constexpr double kInch = 0.0254;  // m

// Poppler's renderer looks for fonts that are not in the file among those of the machine.
class PageDrawer final : public SplashOutputDev {
 public:
    using SplashOutputDev::SplashOutputDev;

    void drawChar(GfxState* state, double x, double y, double dx, double dy, double originX, double originY,
                  CharCode code, int bytes, const Unicode* letters, int count) override {
        Ref embedded{};
        if (!state->getFont() || !state->getFont()->getEmbeddedFontID(&embedded)) return;
        SplashOutputDev::drawChar(state, x, y, dx, dy, originX, originY, code, bytes, letters, count);
    }
};

bool draws_no_note(Annot*, void*) {
    return false;
}

void draw_page(PDFDoc& doc, DrawnPicture& page) {
    SplashColor white = {0xFF, 0xFF, 0xFF, 0xFF};
    PageDrawer drawer(splashModeRGB8, 1, false, white);
    drawer.setFontAntialias(true);
    drawer.setVectorAntialias(true);
    drawer.startDoc(&doc);
    const int number = static_cast<int>(page.number);
    const double points = std::max(doc.getPageCropWidth(number), doc.getPageCropHeight(number));
    const double resolution = 72 * page.size.maxCoeff() / page.pixel_size / points;  // counts the page's own unit
    doc.displayPage(&drawer, number, resolution, resolution, 0, false, true, false, nullptr, nullptr, draws_no_note,
                    nullptr);
    const SplashBitmap* bitmap = drawer.getBitmap();
    if (bitmap == nullptr || bitmap->getDataPtr() == nullptr)
        throw std::runtime_error("page " + std::to_string(number) + ": its picture cannot be drawn");
    page.width_px = bitmap->getWidth();
    page.height_px = bitmap->getHeight();
    const auto width = static_cast<std::size_t>(page.width_px), row = static_cast<std::size_t>(bitmap->getRowSize());
    page.rgb.clear();
    page.rgb.reserve(3 * width * static_cast<std::size_t>(page.height_px));
    for (int y = 0; y < page.height_px; ++y) {
        const SplashColorConstPtr pixels = bitmap->getDataPtr() + static_cast<std::size_t>(y) * row;
        page.rgb.insert(page.rgb.end(), pixels, pixels + 3 * width);
    }
}

std::string drawn_in_child(std::string_view bytes, std::vector<DrawnPicture> pages) {
    FlatWriter writer;
    try {
        globalParams = std::make_unique<GlobalParams>();
        setErrorCallback([](ErrorCategory, Goffset, const char*) {});
        PDFDoc doc(new MemStream(bytes.data(), 0, static_cast<Goffset>(bytes.size()), Object(objNull)));
        if (!doc.isOk()) throw std::runtime_error("a broken PDF: its structure cannot be read");
        for (DrawnPicture& page : pages) draw_page(doc, page);
        writer.text("");
        writer.each(pages, [&](const DrawnPicture& page) {
            writer.value(page.width_px);
            writer.value(page.height_px);
            writer.list(page.rgb);
        });
    } catch (const std::exception& error) {
        writer = {};
        writer.text(error.what());
    }
    return writer.bytes();
}

void choose_pixel_sizes(std::vector<DrawnPicture>& pages, const PdfPictureLimits& limits) {
    double pixels = 0;
    for (DrawnPicture& page : pages) {
        page.pixel_size = std::max(kInch / limits.resolution, page.size.maxCoeff() / (limits.side_px - 1));
        pixels += page.size.prod() / (page.pixel_size * page.pixel_size);
    }
    if (pixels <= limits.pixels) return;
    for (DrawnPicture& page : pages) page.pixel_size *= std::sqrt(pixels / limits.pixels);
}

bool covers_its_page(const DrawnPicture& page) {
    const Vec2d px(page.width_px, page.height_px), wanted = page.size / page.pixel_size;
    return page.width_px > 0 && page.height_px > 0 && (px - wanted).cwiseAbs().maxCoeff() <= 1 + 1e-6 &&
           page.rgb.size() == 3 * static_cast<std::size_t>(page.width_px) * static_cast<std::size_t>(page.height_px);
}

}  // namespace

void draw_pages(std::string_view bytes, const std::string& file, std::vector<DrawnPicture>& pages,
                const PdfPictureLimits& limits) {
    if (pages.empty()) return;
    choose_pixel_sizes(pages, limits);
    const std::string answer = answer_of_child([&] { return drawn_in_child(bytes, pages); }, file, limits.child);
    FlatReader reader(answer);
    if (const std::string failure = reader.text(); !failure.empty()) {
        check_memory_of_child(failure, file);
        throw InputError(file, "", failure);
    }
    std::size_t next = 0;
    reader.each<int>([&](int&) {
        if (next == pages.size()) return reader.refuse();
        DrawnPicture& page = pages[next++];
        page.width_px = reader.value<int>();
        page.height_px = reader.value<int>();
        page.rgb = reader.list<std::uint8_t>();
        if (!covers_its_page(page)) reader.refuse();
    });
    if (!reader.is_sound() || !reader.is_at_end() || next != pages.size())
        throw InputError(file, "", "the pictures of its pages cannot be drawn");
}

void scale_pictures(std::vector<DrawnPicture>& pictures, double factor) {
    for (DrawnPicture& picture : pictures) {
        picture.size *= factor;
        picture.pixel_size *= factor;
    }
}

}  // namespace selvedge::sim
