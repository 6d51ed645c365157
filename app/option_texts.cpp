#include "app/option_texts.h"

#include <CLI/CLI.hpp>

#include "sim/core/error.h"

namespace selvedge::app {
namespace {

void parse(CLI::App& command, const std::vector<std::string>& texts) {
    try {
        command.parse(std::vector<std::string>(texts.rbegin(), texts.rend()));  // CLI11 takes the last one first
    } catch (const CLI::ParseError& error) {
        throw sim::InputError("", "", error.what());
    }
}

}  // namespace

DressArguments read_dress_options(const std::vector<std::string>& texts) {
    CLI::App command;
    DressArguments arguments;
    add_dress_options(command, arguments);
    parse(command, texts);
    return arguments;
}

PictureOptions read_picture_options(const std::vector<std::string>& texts) {
    CLI::App command;
    PictureOptions options;
    add_picture_options(command, options);
    parse(command, texts);
    return options;
}

BodyOptions read_body_options(const std::vector<std::string>& texts) {
    CLI::App command;
    BodyOptions options;
    add_body_options(command, options, "");
    parse(command, texts);
    return options;
}

ExportOptions read_export_options(const std::vector<std::string>& texts) {
    CLI::App command;
    ExportOptions options;
    add_picture_options(command, options.picture);
    add_garment_file_options(command, options.files);
    parse(command, texts);
    return options;
}

}  // namespace selvedge::app
