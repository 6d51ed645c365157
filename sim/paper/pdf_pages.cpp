#include "sim/paper/pdf_pages.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/flat_bytes.h"
#include "sim/paper/pdf_recorder.h"

namespace selvedge::sim {
namespace {

bool are_sound_points(const std::vector<Vec2d>& points) {
    constexpr double kLargest = 1e6;  // mm
    return std::ranges::all_of(points,
                               [](const Vec2d& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() <= kLargest; });
}

bool are_sound_layers(const std::vector<std::int32_t>& layers, std::size_t count) {
    return std::ranges::all_of(layers, [&](std::int32_t i) { return i >= 0 && static_cast<std::size_t>(i) < count; });
}

bool is_sound_shape(const PdfShape& shape, std::size_t layers) {
    std::size_t points = 1;
    for (const std::uint8_t curve : shape.is_curve) points += curve != 0 ? 3 : 1;
    return !shape.is_curve.empty() && shape.points.size() == points && shape.seen.size() == 2 &&
           are_sound_points(shape.points) && are_sound_points(shape.seen) && are_sound_layers(shape.layers, layers);
}

bool is_sound_text(const PdfText& text, std::size_t layers) {
    return text.ends.size() == 2 && are_sound_points(text.ends) && are_sound_points({Vec2d(text.height, 0)}) &&
           are_sound_layers(text.layers, layers);
}

bool is_sound_page(const PdfPage& page, std::size_t layers) {
    return are_sound_points({page.size}) && page.size.minCoeff() > 0 && are_sound_points(page.pictures) &&
           page.pictures.size() % 2 == 0 &&
           std::ranges::all_of(page.shapes, [&](const PdfShape& shape) { return is_sound_shape(shape, layers); }) &&
           std::ranges::all_of(page.texts, [&](const PdfText& text) { return is_sound_text(text, layers); });
}

void write_page(FlatWriter& writer, const PdfPage& page) {
    writer.value(page.size.x());
    writer.value(page.size.y());
    writer.each(page.shapes, [&](const PdfShape& shape) {
        writer.list(shape.points);
        writer.list(shape.is_curve);
        writer.value(shape.is_closed);
        writer.value(shape.is_filled_only);
        writer.text(shape.style);
        writer.list(shape.layers);
        writer.list(shape.seen);
    });
    writer.each(page.texts, [&](const PdfText& text) {
        writer.list(text.ends);
        writer.value(text.height);
        writer.text(text.text);
        writer.list(text.layers);
    });
    writer.list(page.pictures);
}

void read_page(FlatReader& reader, PdfPage& page) {
    page.size.x() = reader.value<double>();
    page.size.y() = reader.value<double>();
    page.shapes = reader.each<PdfShape>([&](PdfShape& shape) {
        shape.points = reader.list<Vec2d>();
        shape.is_curve = reader.list<std::uint8_t>();
        shape.is_closed = reader.value<std::uint8_t>();
        shape.is_filled_only = reader.value<std::uint8_t>();
        shape.style = reader.text();
        shape.layers = reader.list<std::int32_t>();
        shape.seen = reader.list<Vec2d>();
    });
    page.texts = reader.each<PdfText>([&](PdfText& text) {
        text.ends = reader.list<Vec2d>();
        text.height = reader.value<double>();
        text.text = reader.text();
        text.layers = reader.list<std::int32_t>();
    });
    page.pictures = reader.list<Vec2d>();
}

}  // namespace

Vec2d PdfText::middle() const {
    const Vec2d along = ends[1] - ends[0];
    const double length = along.norm();
    constexpr double kHalfOfSmallLetters = 0.25;  // of the face's height: the x-height of sans-serif faces is 0.5
    const Vec2d up = length > 0 ? Vec2d(Vec2d(-along.y(), along.x()) / length) : Vec2d(Vec2d::UnitY());
    return (ends[0] + ends[1]) / 2 + kHalfOfSmallLetters * height * up;
}

bool looks_like_pdf(std::string_view bytes) {
    constexpr std::size_t kHead = 1024;  // viewers look for the mark there  (ISO 32000-1, implementation note 13)
    return bytes.substr(0, kHead).find("%PDF-") != std::string_view::npos;
}

std::string bytes_of_pdf_answer(const PdfAnswer& answer) {
    FlatWriter writer;
    writer.text(answer.failure);
    writer.text(answer.file.title);
    writer.each(answer.file.layers, [&](const PdfLayer& layer) {
        writer.text(layer.name);
        writer.value(layer.is_hidden);
    });
    writer.each(answer.file.pages, [&](const PdfPage& page) { write_page(writer, page); });
    return writer.bytes();
}

std::optional<PdfAnswer> pdf_answer_of(std::string_view bytes) {
    FlatReader reader(bytes);
    PdfAnswer answer;
    answer.failure = reader.text();
    answer.file.title = reader.text();
    answer.file.layers = reader.each<PdfLayer>([&](PdfLayer& layer) {
        layer.name = reader.text();
        layer.is_hidden = reader.value<std::uint8_t>();
    });
    answer.file.pages = reader.each<PdfPage>([&](PdfPage& page) { read_page(reader, page); });
    if (!reader.is_sound() || !reader.is_at_end()) return std::nullopt;
    const std::size_t count = answer.file.layers.size();
    if (!std::ranges::all_of(answer.file.pages, [&](const PdfPage& page) { return is_sound_page(page, count); }))
        return std::nullopt;
    return answer;
}

PdfFile read_pdf_file(std::string_view bytes, const std::string& file, const PdfLimits& limits) {
    const std::string read = answer_of_child(
        [&] {
            PdfAnswer answer;
            try {
                answer = record_pdf(bytes, limits);
            } catch (const std::exception& error) {
                answer = {error.what(), {}};
            }
            return bytes_of_pdf_answer(answer);
        },
        file, limits.child);
    std::optional<PdfAnswer> answer = pdf_answer_of(read);
    if (!answer) throw InputError(file, "", "its pages have numbers that no drawing has");
    check_memory_of_child(answer->failure, file);
    if (!answer->failure.empty()) throw InputError(file, "", answer->failure);
    return std::move(answer->file);
}

}  // namespace selvedge::sim
