#include "sim/paper/pdf_recorder.h"

#include <poppler/Annot.h>
#include <poppler/Catalog.h>
#include <poppler/Error.h>
#include <poppler/ErrorCodes.h>
#include <poppler/GfxState.h>
#include <poppler/GlobalParams.h>
#include <poppler/OptionalContent.h>
#include <poppler/OutputDev.h>
#include <poppler/PDFDoc.h>
#include <poppler/Page.h>
#include <poppler/Stream.h>
#include <poppler/UTF.h>
#include <poppler/XRef.h>
#include <poppler/goo/GooString.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

#include "sim/paper/size_names.h"

namespace selvedge::sim {
namespace {

constexpr double kPointsPerInch = 72, kMmPerInch = 25.4;

using PdfBox = Eigen::AlignedBox2d;

void append_utf8(std::uint32_t letter, std::string& text) {
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (letter == 0xAD || letter < 0x20) return;  // a soft hyphen, control characters
    if (letter < 0x80) return put(letter);
    if (letter < 0x800) return put(0xC0 | letter >> 6U), put(0x80 | (letter & 0x3FU));
    if (letter < 0x10000) {
        if (letter >= 0xD800 && letter < 0xE000) return;
        return put(0xE0 | letter >> 12U), put(0x80 | (letter >> 6U & 0x3FU)), put(0x80 | (letter & 0x3FU));
    }
    if (letter > 0x10FFFF) return;
    put(0xF0 | letter >> 18U), put(0x80 | (letter >> 12U & 0x3FU)), put(0x80 | (letter >> 6U & 0x3FU));
    put(0x80 | (letter & 0x3FU));
}

// poppler 22 allocates an array; since 23 it returns a vector.
template <class String>
std::vector<Unicode> letters_of(const String& text) {
    if constexpr (requires(Unicode * *letters) { TextStringToUCS4(text, letters); }) {
        Unicode* letters = nullptr;
        const int count = TextStringToUCS4(text, &letters);
        const std::unique_ptr<Unicode, decltype(&std::free)> owner(letters, &std::free);
        return {letters, letters + count};
    } else {
        return TextStringToUCS4(text);
    }
}

std::string utf8_of(const GooString* text) {
    if (text == nullptr) return {};
    std::string out;
    constexpr std::size_t kLongest = 200;  // bytes, about
    for (const Unicode letter : letters_of(text->toStr())) {
        if (out.size() >= kLongest) break;
        append_utf8(letter, out);
    }
    return out;
}

// What a page draws, in the order in which it does. The hash of a thing tells it apart in two recordings.
struct Recording {
    PdfPage page;
    struct Thing {
        std::size_t hash = 0;
        int kind = 0;  // 0: a shape, 1: a text, 2: a picture
        std::size_t index = 0;
    };
    std::vector<Thing> things;
};

class Recorder final : public OutputDev {
 public:
    Recorder(Recording& recording, double mm_per_point, std::size_t& points_left, std::size_t& texts_left)
        : out_(recording), mm_(mm_per_point), points_left_(points_left), texts_left_(texts_left) {}

    bool upsideDown() override { return false; }
    bool useDrawChar() override { return true; }
    bool interpretType3Chars() override { return false; }
    bool useTilingPatternFill() override { return true; }
    bool useShadedFills(int /*type*/) override { return true; }
    bool tilingPatternFill(GfxState*, Gfx*, Catalog*, GfxTilingPattern*, const double*, int, int, int, int, double,
                           double) override {
        return true;
    }
    bool functionShadedFill(GfxState*, GfxFunctionShading*) override { return true; }
    bool axialShadedFill(GfxState*, GfxAxialShading*, double, double) override { return true; }
    bool radialShadedFill(GfxState*, GfxRadialShading*, double, double) override { return true; }
    bool gouraudTriangleShadedFill(GfxState*, GfxGouraudTriangleShading*) override { return true; }
    bool patchMeshShadedFill(GfxState*, GfxPatchMeshShading*) override { return true; }

    void stroke(GfxState* state) override { add_path(state, false); }
    void fill(GfxState* state) override { add_path(state, true); }
    void eoFill(GfxState* state) override { add_path(state, true); }

    void drawChar(GfxState* state, double x, double y, double dx, double dy, double /*originX*/, double /*originY*/,
                  CharCode /*code*/, int /*bytes*/, const Unicode* letters, int count) override {
        constexpr int kInvisible = 3;
        if (state->getRender() == kInvisible) return;
        const Vec2d from = at(state, x, y);
        Vec2d step = Vec2d::Zero();
        state->transformDelta(dx, dy, &step.x(), &step.y());
        add_letters(state, from, from + mm_ * step, letters, count);
    }
    void endTextObject(GfxState*) override { end_text(); }
    void endPage() override { end_text(); }

    void drawImage(GfxState* state, Object* ref, Stream* str, int width, int height, GfxImageColorMap* map,
                   bool interpolate, const int* mask, bool is_inline) override {
        add_picture(state);
        OutputDev::drawImage(state, ref, str, width, height, map, interpolate, mask, is_inline);
    }
    void drawImageMask(GfxState* state, Object* ref, Stream* str, int width, int height, bool invert, bool interpolate,
                       bool is_inline) override {
        add_picture(state);
        OutputDev::drawImageMask(state, ref, str, width, height, invert, interpolate, is_inline);
    }
    void drawMaskedImage(GfxState* state, Object*, Stream*, int, int, GfxImageColorMap*, bool, Stream*, int, int, bool,
                         bool) override {
        add_picture(state);
    }
    void drawSoftMaskedImage(GfxState* state, Object*, Stream*, int, int, GfxImageColorMap*, bool, Stream*, int, int,
                             GfxImageColorMap*, bool) override {
        add_picture(state);
    }

 private:
    Vec2d at(const GfxState* state, double x, double y) const {
        Vec2d p = Vec2d::Zero();
        state->transform(x, y, &p.x(), &p.y());
        return mm_ * p;
    }

    PdfBox seen(const GfxState* state) const {
        PdfBox box;
        state->getClipBBox(&box.min().x(), &box.min().y(), &box.max().x(), &box.max().y());
        const PdfBox page(Vec2d::Zero(), out_.page.size);
        return page.intersection(PdfBox(Vec2d(mm_ * box.min()), Vec2d(mm_ * box.max())));
    }

    static std::size_t combined(std::size_t hash, double value) {
        return hash * 1099511628211U ^ std::hash<double>()(value);
    }

    void note(std::size_t hash, int kind, std::size_t index) {
        out_.things.push_back({hash, kind, index});
        if (kind != 0) fill_begins_ = fill_things_ = kNoFill;
    }

    // ---- Paths.

    std::string style_of(GfxState* state, bool is_fill) const {
        GfxRGB rgb;
        if (is_fill) {
            state->getFillRGB(&rgb);
        } else {
            state->getStrokeRGB(&rgb);
        }
        std::array<char, 64> text{};
        std::snprintf(text.data(), text.size(), "#%02x%02x%02x", unsigned(colToByte(rgb.r)), unsigned(colToByte(rgb.g)),
                      unsigned(colToByte(rgb.b)));
        std::string style = text.data();
        if (is_fill) return style + " filled";
        const double scale = mm_ * std::sqrt(std::abs(determinant(state)));
        std::snprintf(text.data(), text.size(), " %.2f", scale * state->getLineWidth());
        style += text.data();
        double start = 0;
        for (const double dash : state->getLineDash(&start)) {
            std::snprintf(text.data(), text.size(), ",%.1f", scale * dash);
            style += text.data();
            if (style.size() > 100) break;
        }
        return style;
    }

    static double determinant(const GfxState* state) {
        const double* m = state->getCTM();
        return m[0] * m[3] - m[1] * m[2];
    }

    void add_path(GfxState* state, bool is_fill) {
        end_text();
        const PdfBox box = seen(state);
        if (box.isEmpty() || box.sizes().minCoeff() <= 0) return;
        if ((is_fill ? state->getFillOpacity() : state->getStrokeOpacity()) <= 0 || is_white(state, is_fill)) return;
        const std::string style = style_of(state, is_fill);
        const GfxPath* path = state->getPath();
        const std::size_t first = out_.page.shapes.size(), filled = std::exchange(fill_begins_, first);
        const std::size_t things = out_.things.size(), filled_things = std::exchange(fill_things_, things);
        for (int i = 0; i < path->getNumSubpaths(); ++i) add_subpath(state, path->getSubpath(i), box, style, is_fill);
        if (!is_fill && repeats(filled, first)) {
            const auto shape = [&](std::size_t i) { return out_.page.shapes.begin() + static_cast<std::ptrdiff_t>(i); };
            out_.page.shapes.erase(shape(filled), shape(first));
            const auto thing = [&](std::size_t i) { return out_.things.begin() + static_cast<std::ptrdiff_t>(i); };
            out_.things.erase(thing(filled_things), thing(things));
            for (std::size_t i = filled_things; i < out_.things.size(); ++i)
                out_.things[i].index = filled + i - filled_things;
        }
        if (!is_fill) fill_begins_ = fill_things_ = kNoFill;
    }

    // Paper is white: such lines cover others, and such fills lie under their lines.
    static bool is_white(GfxState* state, bool is_fill) {
        constexpr int kLeast = 250;  // of 255
        GfxRGB rgb;
        if (is_fill) {
            state->getFillRGB(&rgb);
        } else {
            state->getStrokeRGB(&rgb);
        }
        return colToByte(rgb.r) >= kLeast && colToByte(rgb.g) >= kLeast && colToByte(rgb.b) >= kLeast;
    }

    // Whether the shapes from `second` on are the lines round the fills from `first` on: one path, filled and stroked.
    bool repeats(std::size_t first, std::size_t second) const {
        const std::vector<PdfShape>& shapes = out_.page.shapes;
        if (first == kNoFill || first >= second || second - first != shapes.size() - second) return false;
        for (std::size_t i = first; i < second; ++i) {
            if (shapes[i].is_filled_only == 0 || shapes[i].points != shapes[i + second - first].points) return false;
        }
        return out_.things.size() - fill_things_ == shapes.size() - second;
    }

    void add_subpath(GfxState* state, const GfxSubpath* subpath, const PdfBox& box, const std::string& style,
                     bool is_fill) {
        const int count = subpath->getNumPoints();
        if (count < 2) return;
        if (points_left_ < static_cast<std::size_t>(count)) throw std::runtime_error("more than 2 million points");
        points_left_ -= static_cast<std::size_t>(count);
        PdfShape shape;
        PdfBox extent;
        std::size_t hash = std::hash<std::string>()(style);
        for (int i = 0; i < count; ++i) {
            const Vec2d p = at(state, subpath->getX(i), subpath->getY(i));
            shape.points.push_back(p);
            extent.extend(p);
            hash = combined(combined(hash, p.x()), p.y());
        }
        if (!extent.intersects(box)) return;
        for (int i = 1; i < count;) {
            const bool is_curve = subpath->getCurve(i) && i + 2 < count;
            shape.is_curve.push_back(is_curve ? 1 : 0);
            i += is_curve ? 3 : 1;
        }
        shape.is_closed = subpath->isClosed() || is_fill ? 1 : 0;
        shape.is_filled_only = is_fill ? 1 : 0;
        shape.style = style;
        shape.seen = {box.min(), box.max()};
        out_.page.shapes.push_back(std::move(shape));
        note(hash, 0, out_.page.shapes.size() - 1);
    }

    // ---- Texts.

    void add_letters(GfxState* state, const Vec2d& from, const Vec2d& to, const Unicode* letters, int count) {
        std::string text;
        for (int i = 0; i < count; ++i) append_utf8(letters[i], text);
        const double height = mm_ * state->getTransformedFontSize();
        if (text.empty() || !(height > 0)) return;
        const bool is_space = text.find_first_not_of(' ') == std::string::npos;
        if (!continues(from, to, height)) end_text();
        if (!is_started_) {
            if (is_space) return;
            is_started_ = true;
            text_.ends = {from, to};
            text_.height = height;
            text_.text.clear();
            box_ = seen(state);
        } else if ((from - text_.ends[1]).norm() > kGapOfWords * height && !text_.text.ends_with(' ')) {
            text_.text += ' ';
        }
        text_.text += text;
        text_.ends[1] = to;
    }

    // Whether a letter goes on in the line of the text that is being gathered.
    bool continues(const Vec2d& from, const Vec2d& to, double height) const {
        constexpr double kMostGap = 1.2, kMostBack = 0.4, kOffLine = 0.15, kSameSize = 0.1;  // of the height
        if (!is_started_ || std::abs(height - text_.height) > kSameSize * height) return false;
        Vec2d along = text_.ends[1] - text_.ends[0];
        if (along.norm() < 1e-9) along = to - from;
        if (along.norm() < 1e-9) return true;
        along.normalize();
        const Vec2d gap = from - text_.ends[1];
        const double ahead = gap.dot(along), aside = std::abs(along.x() * gap.y() - along.y() * gap.x());
        return ahead < kMostGap * height && ahead > -kMostBack * height && aside < kOffLine * height;
    }

    void end_text() {
        if (!std::exchange(is_started_, false)) return;
        while (text_.text.ends_with(' ')) text_.text.pop_back();
        constexpr std::size_t kLongest = 500;  // bytes
        if (text_.text.size() > kLongest || box_.isEmpty()) return;
        const Vec2d middle = text_.middle();
        if (!box_.contains(middle) && !box_.contains(text_.ends[0]) && !box_.contains(text_.ends[1])) return;
        if (texts_left_ == 0) throw std::runtime_error("more than 100,000 texts");
        --texts_left_;
        const std::size_t hash =
            combined(combined(std::hash<std::string>()(text_.text), text_.ends[0].x()), text_.ends[0].y());
        out_.page.texts.push_back(text_);
        note(hash, 1, out_.page.texts.size() - 1);
    }

    // ---- Pictures.

    void add_picture(GfxState* state) {
        end_text();
        PdfBox box;
        for (const double x : {0.0, 1.0}) {
            for (const double y : {0.0, 1.0}) box.extend(at(state, x, y));
        }
        box = box.intersection(seen(state));
        if (box.isEmpty()) return;
        out_.page.pictures.push_back(box.min());
        out_.page.pictures.push_back(box.max());
        note(combined(combined(2, box.min().x()), box.max().y()), 2, out_.page.pictures.size() / 2 - 1);
    }

    static constexpr double kGapOfWords = 0.2;  // of the height: a space is about 0.25

    static constexpr std::size_t kNoFill = static_cast<std::size_t>(-1);

    Recording& out_;
    double mm_;
    std::size_t fill_begins_ = kNoFill, fill_things_ = kNoFill;  // of the last path, if it was filled
    std::size_t& points_left_;
    std::size_t& texts_left_;
    PdfText text_;
    PdfBox box_;  // seen where the text begins
    bool is_started_ = false;
};

bool draws_no_annotation(Annot*, void*) {
    return false;
}

class FileRecorder {
 public:
    FileRecorder(PDFDoc& doc, const PdfLimits& limits)
        : doc_(doc), limits_(limits), points_left_(limits.points), texts_left_(limits.texts) {}

    PdfFile record() {
        find_layers();
        for (int number = 1; number <= doc_.getNumPages(); ++number) {
            place_ = "page " + std::to_string(number) + ": ";
            add_page(number);
        }
        return std::move(file_);
    }

    const std::string& place() const { return place_; }

 private:
    // By their numbers in the file: poppler has them in the order of a hash.
    void find_layers() {
        const OCGs* all = doc_.getCatalog()->getOptContentConfig();
        if (all == nullptr || !all->isOk()) return;
        for (const auto& [ref, group] : all->getOCGs()) groups_.push_back(group.get());
        std::ranges::sort(groups_, {}, [](const OptionalContentGroup* group) { return group->getRef().num; });
        if (groups_.size() > limits_.layers) throw std::runtime_error("more than 200 layers");
        for (OptionalContentGroup* group : groups_) {
            PdfLayer layer{.name = utf8_of(group->getName())};
            layer.is_hidden = group->getState() == OptionalContentGroup::Off ? 1 : 0;
            if (layer.is_hidden != 0 && size_of_name(layer.name)) group->setState(OptionalContentGroup::On);
            file_.layers.push_back(std::move(layer));
        }
    }

    double mm_per_point(int number) {
        double unit = 1;
        if (const Ref* ref = doc_.getCatalog()->getPageRef(number)) {
            const Object page = doc_.getXRef()->fetch(*ref);
            const Object user = page.isDict() ? page.dictLookup("UserUnit") : Object(objNull);
            if (user.isNum() && user.getNum() > 0 && user.getNum() <= 75'000) unit = user.getNum();
        }
        return unit * kMmPerInch / kPointsPerInch;
    }

    Recording recording_of(int number) {
        Recording recording;
        const double mm = mm_per_point(number);
        Vec2d size(doc_.getPageCropWidth(number), doc_.getPageCropHeight(number));
        if (doc_.getPageRotate(number) % 180 != 0) std::swap(size.x(), size.y());
        recording.page.size = mm * size;
        if (!(recording.page.size.minCoeff() > 0)) throw std::runtime_error("it has no size");
        Recorder recorder(recording, mm, points_left_, texts_left_);
        doc_.displayPage(&recorder, number, kPointsPerInch, kPointsPerInch, 0, false, true, false, nullptr, nullptr,
                         draws_no_annotation, nullptr);
        return recording;
    }

    void add_page(int number) {
        Recording all = recording_of(number);
        if (!all.things.empty() && has_layers(number, all)) {
            for (std::size_t i = 0; i < groups_.size(); ++i) add_layer(number, i, all);
        }
        file_.pages.push_back(std::move(all.page));
    }

    // Whether a page draws less when all layers are off.
    bool has_layers(int number, const Recording& all) {
        if (groups_.empty()) return false;
        std::vector<OptionalContentGroup::State> states;
        for (OptionalContentGroup* group : groups_) {
            states.push_back(group->getState());
            group->setState(OptionalContentGroup::Off);
        }
        const std::size_t things = again(number).things.size();
        for (std::size_t i = 0; i < groups_.size(); ++i) groups_[i]->setState(states[i]);
        return things != all.things.size();
    }

    // A recording of a page whose things count already.
    Recording again(int number) {
        const std::size_t points = points_left_, texts = texts_left_;
        points_left_ = limits_.points;
        texts_left_ = limits_.texts;
        Recording recording = recording_of(number);
        points_left_ = points;
        texts_left_ = texts;
        return recording;
    }

    // What is missing when a layer is off belongs to it, or to a group of layers that it switches.
    void add_layer(int number, std::size_t layer, Recording& all) {
        if (groups_[layer]->getState() == OptionalContentGroup::Off) return;
        groups_[layer]->setState(OptionalContentGroup::Off);
        const Recording rest = again(number);
        groups_[layer]->setState(OptionalContentGroup::On);
        std::size_t next = 0;
        std::vector<const Recording::Thing*> missing;
        for (const Recording::Thing& thing : all.things) {
            if (next < rest.things.size() && rest.things[next].hash == thing.hash) {
                ++next;
            } else {
                missing.push_back(&thing);
            }
        }
        if (next < rest.things.size()) return;  // the file draws other things without it
        for (const Recording::Thing* thing : missing) {
            if (thing->kind == 0) all.page.shapes[thing->index].layers.push_back(static_cast<std::int32_t>(layer));
            if (thing->kind == 1) all.page.texts[thing->index].layers.push_back(static_cast<std::int32_t>(layer));
        }
    }

    PDFDoc& doc_;
    const PdfLimits& limits_;
    std::size_t points_left_, texts_left_;
    std::vector<OptionalContentGroup*> groups_;
    PdfFile file_;
    std::string place_;
};

std::string problem_of_document(PDFDoc& doc, const PdfLimits& limits) {
    if (doc.getErrorCode() == errEncrypted) return "it is encrypted, and opens with a password only: save it without";
    if (!doc.isOk()) return "a broken PDF: its structure cannot be read";
    if (doc.getNumPages() < 1) return "it has no pages";
    if (static_cast<std::size_t>(doc.getNumPages()) > limits.pages)
        return std::to_string(doc.getNumPages()) + " pages: at most " + std::to_string(limits.pages) + " are read";
    return {};
}

}  // namespace

PdfAnswer record_pdf(std::string_view bytes, const PdfLimits& limits) {
    globalParams = std::make_unique<GlobalParams>();
    setErrorCallback([](ErrorCategory, Goffset, const char*) {});
    // Bytes before the mark are skipped by poppler itself.
    PDFDoc doc(new MemStream(bytes.data(), 0, static_cast<Goffset>(bytes.size()), Object(objNull)));
    PdfAnswer answer;
    answer.failure = problem_of_document(doc, limits);
    if (!answer.failure.empty()) return answer;
    FileRecorder recorder(doc, limits);
    try {
        answer.file = recorder.record();
    } catch (const std::runtime_error& error) {
        answer.failure = recorder.place() + error.what();
        return answer;
    }
    const std::unique_ptr<GooString> title = doc.getDocInfoTitle();
    answer.file.title = utf8_of(title.get());
    return answer;
}

}  // namespace selvedge::sim
