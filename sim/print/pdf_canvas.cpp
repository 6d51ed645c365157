#include "sim/print/pdf_canvas.h"

#include <cairo-pdf.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <stdexcept>

#include "sim/print/pdf_layers.h"

namespace selvedge::sim {
namespace {

constexpr double kPoint = 0.0254 / 72;  // m

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

double points(double metres) {
    return metres / kPoint;
}

// Broken UTF-8 with replacement characters. Of a text that fills pages, without its middle: Pango takes ages for it.
std::string valid(const std::string& text) {
    constexpr std::size_t kMostBytes = 2000;
    if (text.size() > kMostBytes)
        return valid(text.substr(0, kMostBytes / 2 - 3) + "..." + text.substr(text.size() - kMostBytes / 2));
    gchar* made = g_utf8_make_valid(text.data(), static_cast<gssize>(text.size()));
    std::string out(made);
    g_free(made);
    return out;
}

}  // namespace

struct PdfCanvas::State {
    std::string bytes;
    cairo_surface_t* surface = nullptr;
    cairo_t* cairo = nullptr;
    bool has_page = false;
    std::vector<std::string> layers;     // in the order of their first use
    std::vector<std::vector<int>> used;  // see with_layers()
    std::string layer;

    void set_style(const LineStyle& style) const {
        cairo_set_source_rgb(cairo, style.grey, style.grey, style.grey);
        cairo_set_line_width(cairo, points(style.width));
        std::vector<double> dashes;
        for (const double dash : style.dashes) dashes.push_back(points(dash));
        cairo_set_dash(cairo, dashes.data(), static_cast<int>(dashes.size()), 0);
    }

    void add_path(const std::vector<Vec2d>& line, bool is_closed) const {
        cairo_new_path(cairo);
        for (const Vec2d& p : line) cairo_line_to(cairo, points(p.x()), points(p.y()));
        if (is_closed) cairo_close_path(cairo);
    }

    // Ends the group that holds what was drawn in the layer. Cairo writes none that is empty, as where all lines lie
    // beside the page.
    void draw_layer() {
        cairo_pattern_t* group = cairo_pop_group(cairo);
        cairo_surface_t* drawn = nullptr;
        double x = 0, y = 0, width = 0, height = 0;
        // Fails where Cairo has failed before, which finish() tells.
        if (cairo_pattern_get_surface(group, &drawn) == CAIRO_STATUS_SUCCESS)
            cairo_recording_surface_ink_extents(drawn, &x, &y, &width, &height);
        if (width > 0 && height > 0) {
            cairo_set_source(cairo, group);
            cairo_paint(cairo);
            auto known = std::ranges::find(layers, layer);
            if (known == layers.end()) known = layers.insert(known, layer);
            used.back().push_back(static_cast<int>(known - layers.begin()));
        }
        cairo_pattern_destroy(group);
    }
};

PdfCanvas::PdfCanvas(const std::string& title) : state_(std::make_unique<State>()) {
    state_->surface = cairo_pdf_surface_create_for_stream(append, &state_->bytes, 100, 100);
    // Since 1.17.6, Cairo packs objects into streams where it may, which with_layers() does not read.
    if (cairo_version() >= CAIRO_VERSION_ENCODE(1, 17, 6))
        cairo_pdf_surface_restrict_to_version(state_->surface, CAIRO_PDF_VERSION_1_4);
    cairo_pdf_surface_set_metadata(state_->surface, CAIRO_PDF_METADATA_TITLE, valid(title).c_str());
    cairo_pdf_surface_set_metadata(state_->surface, CAIRO_PDF_METADATA_CREATOR, "Selvedge");
    cairo_pdf_surface_set_metadata(state_->surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
    state_->cairo = cairo_create(state_->surface);
    cairo_set_line_join(state_->cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(state_->cairo, CAIRO_LINE_CAP_ROUND);
}

PdfCanvas::~PdfCanvas() {
    cairo_destroy(state_->cairo);
    cairo_surface_destroy(state_->surface);
}

void PdfCanvas::begin_page(const Vec2d& size) {
    set_layer("");
    if (state_->has_page) cairo_show_page(state_->cairo);
    state_->has_page = true;
    state_->used.emplace_back();
    cairo_pdf_surface_set_size(state_->surface, points(size.x()), points(size.y()));
}

void PdfCanvas::draw_line(const std::vector<Vec2d>& line, bool is_closed, const LineStyle& style) {
    if (line.empty()) return;
    state_->set_style(style);
    state_->add_path(line, is_closed);
    cairo_stroke(state_->cairo);
}

void PdfCanvas::draw_rectangle(const Eigen::AlignedBox2d& box, const LineStyle& style) {
    state_->set_style(style);
    cairo_new_path(state_->cairo);
    cairo_rectangle(state_->cairo, points(box.min().x()), points(box.min().y()), points(box.sizes().x()),
                    points(box.sizes().y()));
    cairo_stroke(state_->cairo);
}

void PdfCanvas::fill(const std::vector<Vec2d>& outline, double grey) {
    if (outline.empty()) return;
    cairo_set_source_rgb(state_->cairo, grey, grey, grey);
    state_->add_path(outline, true);
    cairo_fill(state_->cairo);
}

double PdfCanvas::draw_text(const std::string& text, const Vec2d& at, const TextStyle& style) {
    constexpr double kFaceHeight = 1.25;  // from line to line, over the size of the face
    cairo_t* cairo = state_->cairo;
    cairo_set_source_rgb(cairo, style.grey, style.grey, style.grey);
    PangoLayout* layout = pango_cairo_create_layout(cairo);
    PangoFontDescription* font = pango_font_description_from_string("Inter, sans-serif");
    pango_font_description_set_absolute_size(font, points(style.height / kFaceHeight) * PANGO_SCALE);
    if (style.is_bold) pango_font_description_set_weight(font, PANGO_WEIGHT_BOLD);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);
    pango_layout_set_auto_dir(layout, FALSE);
    if (style.most_width > 0) {
        pango_layout_set_width(layout, static_cast<int>(points(style.most_width) * PANGO_SCALE));
        pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    }
    const std::string utf8 = valid(text);
    pango_layout_set_text(layout, utf8.data(), static_cast<int>(utf8.size()));
    int width = 0, height = 0;
    pango_layout_get_size(layout, &width, &height);
    const double wide = static_cast<double>(width) / PANGO_SCALE;
    const double shift = style.align == TextAlign::Left ? 0 : style.align == TextAlign::Centre ? wide / 2 : wide;
    cairo_save(cairo);
    cairo_translate(cairo, points(at.x()), points(at.y()));
    if (style.angle != 0) cairo_rotate(cairo, -style.angle);
    cairo_move_to(cairo, -shift, 0);
    pango_cairo_update_layout(cairo, layout);
    pango_cairo_show_layout(cairo, layout);
    cairo_restore(cairo);
    g_object_unref(layout);
    return kPoint * static_cast<double>(height) / PANGO_SCALE;
}

void PdfCanvas::begin_clip(const Eigen::AlignedBox2d& box) {
    cairo_save(state_->cairo);
    cairo_rectangle(state_->cairo, points(box.min().x()), points(box.min().y()), points(box.sizes().x()),
                    points(box.sizes().y()));
    cairo_clip(state_->cairo);
}

void PdfCanvas::end_clip() {
    cairo_restore(state_->cairo);
}

void PdfCanvas::set_layer(const std::string& name) {
    if (name == state_->layer) return;
    if (!state_->layer.empty()) state_->draw_layer();
    state_->layer = name;
    if (!name.empty()) cairo_push_group(state_->cairo);
}

std::string PdfCanvas::finish() {
    set_layer("");
    if (state_->has_page) cairo_show_page(state_->cairo);
    cairo_surface_finish(state_->surface);
    cairo_status_t status = cairo_status(state_->cairo);
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(state_->surface);
    if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
    return with_layers(std::move(state_->bytes), state_->layers, state_->used);
}

}  // namespace selvedge::sim
