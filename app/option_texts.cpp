#include "app/option_texts.h"

#include "app/arguments.h"

namespace selvedge::app {

DressArguments read_dress_options(const std::vector<std::string>& texts) {
    Command command;
    DressArguments arguments;
    add_dress_options(command, arguments);
    parse_arguments(command, texts);
    return arguments;
}

PictureOptions read_picture_options(const std::vector<std::string>& texts) {
    Command command;
    PictureOptions options;
    add_picture_options(command, options);
    parse_arguments(command, texts);
    return options;
}

BodyOptions read_body_options(const std::vector<std::string>& texts) {
    Command command;
    BodyOptions options;
    add_body_options(command, options, "");
    parse_arguments(command, texts);
    return options;
}

ExportOptions read_export_options(const std::vector<std::string>& texts) {
    Command command;
    ExportOptions options;
    add_picture_options(command, options.picture);
    add_garment_file_options(command, options.files);
    parse_arguments(command, texts);
    return options;
}

AnimateArguments read_animation_options(const std::vector<std::string>& texts) {
    Command command;
    AnimateArguments arguments;
    add_animation_options(command, arguments);
    parse_arguments(command, texts);
    return arguments;
}

}  // namespace selvedge::app
