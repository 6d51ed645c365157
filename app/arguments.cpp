#include "app/arguments.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string_view>

#include "sim/pattern/spelling.h"

namespace selvedge::app {

struct Command::Parts {
    std::unique_ptr<CLI::App> program;  // null of a subcommand
    CLI::App& app;
    std::vector<std::unique_ptr<Command>> subcommands{};
};

namespace {

std::unique_ptr<Command::Parts> program_parts(const std::string& help) {
    auto program = std::make_unique<CLI::App>(help);
    CLI::App& app = *program;
    return std::unique_ptr<Command::Parts>(new Command::Parts{.program = std::move(program), .app = app});
}

CLI::App& app_of(const Command& command) {
    return command.parts().app;
}

void add_range(CLI::Option&, std::monostate) {}

template <class T>
void add_range(CLI::Option& option, const Limits<T>& limits) {
    option.check(CLI::Range(limits.least, limits.most));
}

void apply_details(CLI::App& app, CLI::Option& option, const OptionDetails& details) {
    if (!details.type.empty()) option.type_name(details.type);
    if (!details.group.empty()) option.group(details.group);
    if (details.is_required) option.required();
    if (details.takes_one_value) option.allow_extra_args(false);
    if (details.delimiter != 0) option.delimiter(details.delimiter);
    std::visit([&](const auto& range) { add_range(option, range); }, details.range);
    if (!details.one_of.empty()) option.check(CLI::IsMember(details.one_of));
    for (const std::string& name : details.needs) option.needs(app.get_option(name));
    for (const std::string& name : details.excludes) option.excludes(app.get_option(name));
    if (details.shows_default) option.capture_default_str();
}

}  // namespace

Command::Command(const std::string& help) : parts_(program_parts(help)) {}

Command::Command(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Command::~Command() = default;

Command& add_command(Command& parent, const std::string& name, const std::string& help) {
    CLI::App& app = *app_of(parent).add_subcommand(name, help);
    std::unique_ptr<Command::Parts> parts(new Command::Parts{.program = nullptr, .app = app});
    return *parent.parts().subcommands.emplace_back(std::make_unique<Command>(std::move(parts)));
}

void add_passing_command(Command& parent, const std::string& name, const std::string& help,
                         const std::function<void(const std::vector<std::string>& words)>& run) {
    CLI::App& app = app_of(add_command(parent, name, help));
    app.prefix_command();
    app.set_help_flag();
    app.callback([&app, run] { run(app.remaining()); });
}

void set_name(Command& program, const std::string& name) {
    app_of(program).name(name);
}

void set_version(Command& program, const std::function<std::string()>& text) {
    app_of(program).set_version_flag("--version", text);
}

void require_command(Command& program) {
    app_of(program).require_subcommand(1);
}

void set_footer(Command& command, const std::string& text) {
    app_of(command).footer(text);
}

void set_action(Command& command, const std::function<void()>& run) {
    app_of(command).callback(run);
}

template <OptionValue T>
void add_option(Command& command, const std::string& names, T& value, const std::string& help,
                const OptionDetails& details) {
    CLI::App& app = app_of(command);
    apply_details(app, *app.add_option(names, value, help), details);
}

template void add_option(Command&, const std::string&, std::string&, const std::string&, const OptionDetails&);
template void add_option(Command&, const std::string&, std::filesystem::path&, const std::string&,
                         const OptionDetails&);
template void add_option(Command&, const std::string&, int&, const std::string&, const OptionDetails&);
template void add_option(Command&, const std::string&, double&, const std::string&, const OptionDetails&);
template void add_option(Command&, const std::string&, std::optional<int>&, const std::string&, const OptionDetails&);
template void add_option(Command&, const std::string&, std::optional<float>&, const std::string&, const OptionDetails&);
template void add_option(Command&, const std::string&, std::optional<double>&, const std::string&,
                         const OptionDetails&);
template void add_option(Command&, const std::string&, std::vector<std::string>&, const std::string&,
                         const OptionDetails&);
template void add_option(Command&, const std::string&, std::vector<std::filesystem::path>&, const std::string&,
                         const OptionDetails&);
template void add_option(Command&, const std::string&, std::vector<std::size_t>&, const std::string&,
                         const OptionDetails&);

void add_text_option(Command& command, const std::string& names, const std::string& help, const OptionDetails& details,
                     const std::function<void(const std::string&)>& take) {
    CLI::App& app = app_of(command);
    apply_details(app, *app.add_option_function<std::string>(names, take, help), details);
}

template <class T>
requires kIsOneOf<T, int, double>
void add_number(Command& command, const std::string& names, Limits<T> limits, const std::string& help,
                const OptionDetails& details, const std::function<void(T)>& take) {
    const auto check_and_take = [=](const T& value) {
        const bool is_within = value >= limits.least && value <= limits.most;  // false for NaN
        if (!is_within) {
            throw sim::InputError(
                "", names,
                "must be from " + CLI::detail::to_string(limits.least) + " to " + CLI::detail::to_string(limits.most));
        }
        take(value);
    };
    CLI::App& app = app_of(command);
    apply_details(app, *app.add_option_function<T>(names, check_and_take, help), details);
}

template void add_number(Command&, const std::string&, Limits<int>, const std::string&, const OptionDetails&,
                         const std::function<void(int)>&);
template void add_number(Command&, const std::string&, Limits<double>, const std::string&, const OptionDetails&,
                         const std::function<void(double)>&);

void add_flag(Command& command, const std::string& names, bool& value, const std::string& help,
              const OptionDetails& details) {
    CLI::App& app = app_of(command);
    apply_details(app, *app.add_flag(names, value, help), details);
}

void add_flag(Command& command, const std::string& names, const std::string& help, const std::function<void()>& take) {
    app_of(command).add_flag_function(
        names, [take](std::int64_t) { take(); }, help);
}

namespace {

// Of a subcommand that does not exist, CLI11 says only that one is required.
std::string problem_of(const CLI::ParseError& error, const CLI::App& app, const char* first_word) {
    const auto code = static_cast<CLI::ExitCodes>(error.get_exit_code());
    if (code != CLI::ExitCodes::RequiredError || first_word == nullptr || !app.get_subcommands().empty())
        return error.what();
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    if (names.empty() || *first_word == '-') return error.what();
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string near(sim::nearly_spelt(first_word, known));
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return "no command '" + std::string(first_word) +
           "': " + (near.empty() ? "there are " + all : "is '" + near + "' meant?");
}

}  // namespace

bool parse_arguments(Command& program, int argc, const char* const* argv) {
    CLI::App& app = app_of(program);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) throw UsageError(problem_of(error, app, argc > 1 ? argv[1] : nullptr));
        app.exit(error);
        return false;
    }
    return true;
}

void parse_arguments(Command& command, const std::vector<std::string>& words) {
    try {
        app_of(command).parse(
            std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes the last one first
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
}

std::optional<std::string> given_value(const Command& program, const std::string& name) {
    const std::vector<CLI::App*> named = app_of(program).get_subcommands();
    const CLI::Option* option = named.empty() ? nullptr : named.front()->get_option_no_throw(name);
    if (option == nullptr || option->results().empty()) return std::nullopt;
    return option->results().front();
}

}  // namespace selvedge::app
