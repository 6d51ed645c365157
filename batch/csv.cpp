#include "batch/csv.h"

#include <algorithm>
#include <utility>

#include "sim/core/error.h"

namespace selvedge::batch {
namespace {

// The one that the names of the columns stand between. Spreadsheets write ';' where numbers have a decimal comma.
char separator_of(std::string_view names) {
    constexpr std::string_view kSeparators = ",;\t";
    return *std::ranges::max_element(kSeparators, {}, [&](char c) { return std::ranges::count(names, c); });
}

class CsvReader {
 public:
    CsvReader(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
        if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
        if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF"))
            throw sim::InputError(file_, "", "is UTF-16: save it as UTF-8");
        separator_ = separator_of(text_.substr(0, text_.find_first_of("\r\n")));
    }

    std::vector<CsvRow> rows() {
        std::vector<CsvRow> rows;
        while (at_ < text_.size()) {
            CsvRow row{.line = line_, .fields = {}};
            do {
                row.fields.push_back(field());
            } while (skip(separator_));
            end_of_line();
            if (!std::ranges::all_of(row.fields, &std::string::empty)) rows.push_back(std::move(row));
        }
        return rows;
    }

 private:
    bool skip(char c) {
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    bool is_at_end_of_field() const {
        return at_ >= text_.size() || text_[at_] == separator_ || text_[at_] == '\n' || text_[at_] == '\r';
    }
    void end_of_line() {
        skip('\r');
        if (skip('\n')) ++line_;
    }
    std::string field() {
        std::string value;
        if (!skip('"')) {
            while (!is_at_end_of_field()) value += text_[at_++];
            return value;
        }
        const std::size_t first_line = line_;
        for (;;) {
            if (at_ >= text_.size())
                throw sim::InputError(file_, "line " + std::to_string(first_line), "a quote is not closed");
            const char c = text_[at_++];
            if (c == '"' && !skip('"')) break;
            if (c == '\n') ++line_;
            value += c;
        }
        if (!is_at_end_of_field())
            throw sim::InputError(file_, "line " + std::to_string(line_), "there is text behind a closing quote");
        return value;
    }

    std::string_view text_;
    std::string file_;
    char separator_ = ',';
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

}  // namespace

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& file) {
    return CsvReader(text, file).rows();
}

std::string csv_line(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) {
        if (&field != &fields.front()) line += ',';
        if (field.find_first_of(",\"\n\r") == std::string::npos) {
            line += field;
            continue;
        }
        line += '"';
        for (const char c : field) line += c == '"' ? std::string("\"\"") : std::string(1, c);
        line += '"';
    }
    return line + '\n';
}

}  // namespace selvedge::batch
