#include "bench/plot.h"

#include <cstdlib>

#include "sim/core/file.h"

namespace selvedge {
namespace {

std::string csv_word(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string csv_cell(const Cell& cell) {
    return cell.is_empty() ? "" : csv_word(cell.to_text());
}

// In gnuplot's single quotes.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? "''" : std::string(1, c);
    return out + "'";
}

std::string shell_word(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}

std::string script_of(const Figure& figure, const std::filesystem::path& png) {
    const Table& series = figure.series;
    std::string script = "set terminal pngcairo size 1000,600 noenhanced\nset output " + quoted(png.string()) +
                         "\nset datafile separator ','\nset key outside bottom center horizontal\nset grid\n" +
                         "set title " + quoted(series.name + ": " + series.title) + "\nset xlabel " +
                         quoted(series.columns[0]) + "\nset ylabel " + quoted(figure.y_label) + "\n";
    if (figure.is_logarithmic) script += "set logscale xy\n";
    if (!figure.right_column.empty())
        script +=
            "set ytics nomirror\nset y2tics\nset y2range [0:*]\nset y2label " + quoted(figure.right_column) + "\n";
    script += "$data << END_OF_DATA\n" + to_csv(series) + "END_OF_DATA\nplot ";
    for (std::size_t i = 1; i < series.columns.size(); ++i) {
        const bool is_right = series.columns[i] == figure.right_column;
        script += (i > 1 ? ", " : "") + std::string("$data using 1:") + std::to_string(i + 1) +
                  (is_right ? " axes x1y2 with lines dashtype 2" : " with lines") + " linewidth 2 title " +
                  quoted(series.columns[i]);
    }
    return script + "\n";
}

}  // namespace

std::string to_csv(const Table& table) {
    std::string text;
    for (std::size_t i = 0; i < table.columns.size(); ++i) text += (i > 0 ? "," : "") + csv_word(table.columns[i]);
    text += "\n";
    for (const std::vector<Cell>& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + csv_cell(row[i]);
        text += "\n";
    }
    return text;
}

bool plot(const Figure& figure, const std::filesystem::path& png) {
    std::filesystem::path script = png;
    script.replace_extension(".gnuplot");
    write_file_atomically(script, script_of(figure, png));
    return std::system(("gnuplot " + shell_word(script.string()) + " >/dev/null 2>&1").c_str()) == 0;
}

}  // namespace selvedge
