#include "app/option_texts.h"

#include "app/arguments.h"

namespace selvedge::app {
namespace {

// add_options(command, options): adds the options of a command, which are read into `options`.
template <class Options, class AddOptions>
Options read(const std::vector<std::string>& texts, const AddOptions& add_options) {
    Command command;
    Options options;
    add_options(command, options);
    parse_arguments(command, texts);
    return options;
}

}  // namespace

DressArguments read_dress_options(const std::vector<std::string>& texts) {
    return read<DressArguments>(texts, add_dress_options);
}

PictureOptions read_picture_options(const std::vector<std::string>& texts) {
    return read<PictureOptions>(texts, add_picture_options);
}

BodyOptions read_body_options(const std::vector<std::string>& texts) {
    return read<BodyOptions>(texts,
                             [](Command& command, BodyOptions& options) { add_body_options(command, options, ""); });
}

ExportOptions read_export_options(const std::vector<std::string>& texts) {
    return read<ExportOptions>(texts, [](Command& command, ExportOptions& options) {
        add_picture_options(command, options.picture);
        add_garment_file_options(command, options.files);
    });
}

AnimateArguments read_animation_options(const std::vector<std::string>& texts) {
    return read<AnimateArguments>(texts, add_animation_options);
}

}  // namespace selvedge::app
