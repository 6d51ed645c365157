#pragma once
// The command line of a program: subcommands, their options and flags, and their help. An option is added with the
// variable that it sets or the function that takes its value; parse_arguments() does so and runs the subcommand. Only
// arguments.cpp uses CLI11.
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/numbers.h"

namespace selvedge::app {

// Wrong words of a command line, such as an option that does not exist.
class UsageError : public sim::InputError {
 public:
    explicit UsageError(const std::string& problem) : sim::InputError("", "", problem) {}
};

// A program's command line or a subcommand; owns its options and subcommands.
class Command {
 public:
    struct Parts;  // CLI11's objects

    explicit Command(const std::string& help = "");
    explicit Command(std::unique_ptr<Parts> parts);
    ~Command();
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;

    Parts& parts() const { return *parts_; }

 private:
    std::unique_ptr<Parts> parts_;
};

Command& add_command(Command& parent, const std::string& name, const std::string& help);

// A subcommand that gives all words that follow it, also --help, to this function.
void add_passing_command(Command& parent, const std::string& name, const std::string& help,
                         const std::function<void(const std::vector<std::string>& words)>& run);

void set_name(Command& program, const std::string& name);  // in its help; otherwise the program's file
void set_version(Command& program, const std::function<std::string()>& text);  // what --version prints
void require_command(Command& program);                                        // one subcommand must be named
void set_footer(Command& command, const std::string& text);                    // the end of its help
void set_action(Command& command, const std::function<void()>& run);

using sim::Limits;

// What an option takes, and how the help shows it.
struct OptionDetails {
    std::string type{};            // of the value, such as FILE; empty: by the variable, such as TEXT
    std::string group{};           // heading in the help; empty: "Options"
    bool is_required = false;      // the command is refused without it
    bool shows_default = false;    // the help tells the variable's value
    bool takes_one_value = false;  // of a list: one value each time that it is named, not all that follow
    char delimiter = 0;            // between values of a list in one word; 0: none
    std::variant<std::monostate, Limits<int>, Limits<float>, Limits<double>> range{};  // of each value
    std::vector<std::string> one_of{};                                                 // the only values; empty: any
    std::vector<std::string> needs{};     // options that must be given too; added before
    std::vector<std::string> excludes{};  // options that must not be given too; added before
};

template <class T, class... Types>
inline constexpr bool kIsOneOf = (std::same_as<T, Types> || ...);

template <class T>
concept OptionValue = kIsOneOf<T, std::string, std::filesystem::path, int, double, std::optional<int>,
                               std::optional<float>, std::optional<double>, std::vector<std::string>,
                               std::vector<std::filesystem::path>, std::vector<std::size_t>>;

// Adds an option that sets `value`, which must outlive the parsing. names: "-o,--output"; of an argument without a
// name, what the help calls it: "FILE".
template <OptionValue T>
void add_option(Command& command, const std::string& names, T& value, const std::string& help,
                const OptionDetails& details = {});

// Adds an option whose text `take` reads: it throws InputError for a wrong one.
void add_text_option(Command& command, const std::string& names, const std::string& help, const OptionDetails& details,
                     const std::function<void(const std::string&)>& take);

// Adds an option that takes a number within limits; the InputError for another one names the limits.
template <class T>
requires kIsOneOf<T, int, double>
void add_number(Command& command, const std::string& names, Limits<T> limits, const std::string& help,
                const OptionDetails& details, const std::function<void(T)>& take);

// Adds a flag that sets `value`: to true, or to false if its name ends in "{false}" or begins with '!'.
void add_flag(Command& command, const std::string& names, bool& value, const std::string& help,
              const OptionDetails& details = {});

// Adds a flag that calls `take`.
void add_flag(Command& command, const std::string& names, const std::string& help, const std::function<void()>& take);

// Sets what the options name, then runs the subcommand. Returns false if help or the version was asked for: prints it
// to standard output instead. argv: the program's name first. Throws UsageError, and what actions and functions throw.
bool parse_arguments(Command& program, int argc, const char* const* argv);

// The same for words without a program's name. It prints nothing: to ask for help is an error.
void parse_arguments(Command& command, const std::vector<std::string>& words);

// The first value of an option of the subcommand that was named, also of a command line that was refused; none if it
// was not given or there is no such option.
std::optional<std::string> given_value(const Command& program, const std::string& name);

}  // namespace selvedge::app
