#include "sim/core/json.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxValues = 4'000'000;
constexpr std::size_t kMaxLine = 100;

// SAX handler: builds a Json value from the parser's events, and throws InputError if a limit is exceeded or a key is
// duplicated.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
    explicit Builder(std::string file) : file_(std::move(file)) {}

    Json take() { return std::move(root_); }

    bool null() override { return add({}); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(std::int64_t value) override { return add(value); }
    bool number_unsigned(std::uint64_t value) override { return add(value); }
    bool number_float(double value, const std::string& text) override {
        if (!std::isfinite(value)) fail("the number " + text + " is out of range");
        return add(Json::number_as_written(value, text));
    }
    bool string(std::string& value) override { return add(std::move(value)); }
    bool binary(nlohmann::json::binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(std::string& name) override {
        open_.back().key = name;
        if (!open_.back().keys.insert(name).second) fail("the key '" + name + "' is a duplicate key");
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override {
        std::string what = error.what();
        // The parser quotes the whole token that it read last: of a file that ends early, all that is left of it.
        constexpr std::size_t kMostQuoted = 48;
        const std::size_t quote = what.find("; last read: '");
        if (quote != std::string::npos && what.size() - quote > kMostQuoted) what.resize(quote);
        if (error.id == 406) fail(what.substr(what.find("number"), kMostQuoted));
        // what() reads "[json.exception.parse_error.101] parse error at line 3, column 1: ..."
        const std::size_t from = what.find(" at ");
        throw InputError(file_, "", "not JSON" + (from == std::string::npos ? ": " + what : what.substr(from)));
    }

 private:
    struct Open {
        Json* value;
        std::string key;
        std::set<std::string> keys;
    };

    Json& insert(Json value) {
        if (++count_ > kMaxValues) fail("more than " + std::to_string(kMaxValues) + " values");
        if (open_.empty()) return root_ = std::move(value);
        Json& parent = *open_.back().value;
        if (parent.is_array()) {
            parent.elements().push_back(std::move(value));
            return parent.elements().back();
        }
        parent.members().push_back({open_.back().key, std::move(value)});
        return parent.members().back().value;
    }
    bool add(Json value) {
        insert(std::move(value));
        return true;
    }
    // Pointers to a parent's elements stay valid, because nothing is added to a parent while its child is open.
    bool open(Json value) {
        if (open_.size() >= kMaxDepth) fail("nested deeper than " + std::to_string(kMaxDepth) + " levels");
        Json& inserted = insert(std::move(value));
        open_.push_back({&inserted, "", {}});
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }
    [[noreturn]] void fail(const std::string& problem) const {
        std::string path;
        for (const Open& level : open_) {
            const bool is_innermost = &level == &open_.back();
            path = level.value->is_object() ? json_path(path, level.key)
                                            : json_path(path, level.value->elements().size() - (is_innermost ? 0 : 1));
        }
        throw InputError(file_, path, problem);
    }

    std::string file_;
    Json root_;
    std::vector<Open> open_;
    std::size_t count_ = 0;
};

std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string scalar_text(const Json& value) {
    switch (value.kind()) {
        case Json::Kind::Bool:
            return value.boolean() ? "true" : "false";
        case Json::Kind::Number:
            return value.number_text();
        case Json::Kind::String:
            return quoted(value.string());
        default:
            return "null";
    }
}

bool is_plain(const Json& value) {
    return !value.is_array() && !value.is_object();
}

// The value on one line, with spaces after commas and colons if `spaced`.
std::string flat_text(const Json& value, bool spaced) {
    if (is_plain(value)) return scalar_text(value);
    const std::string comma = spaced ? ", " : ",";
    std::string text;
    if (value.is_array()) {
        for (const Json& element : value.elements()) {
            text += (text.empty() ? "" : comma) + flat_text(element, spaced);
        }
        return "[" + text + "]";
    }
    for (const auto& [key, member] : value.members()) {
        text += (text.empty() ? "" : comma) + quoted(key) + (spaced ? ": " : ":") + flat_text(member, spaced);
    }
    return "{" + text + "}";
}

// Whether the value may be written on one line: arrays and objects are nested at most 4 levels deep.
bool is_flat(const Json& value, int depth = 0) {
    if (is_plain(value)) return true;
    if (depth == 4) return false;
    if (value.is_array()) {
        return std::all_of(value.elements().begin(), value.elements().end(),
                           [&](const Json& element) { return is_flat(element, depth + 1); });
    }
    return std::all_of(value.members().begin(), value.members().end(),
                       [&](const Json::Member& member) { return is_flat(member.value, depth + 1); });
}

void write_indented(const Json& value, std::size_t step, std::size_t column, std::string& out) {
    if (is_flat(value)) {
        const std::string line = flat_text(value, true);
        if (is_plain(value) || column + line.size() <= kMaxLine) {
            out += line;
            return;
        }
    }
    const std::string margin(column + step, ' ');
    out += value.is_array() ? "[" : "{";
    bool is_first = true;
    const auto begin_item = [&] {
        out += (is_first ? "\n" : ",\n") + margin;
        is_first = false;
    };
    if (value.is_array()) {
        for (const Json& element : value.elements()) {
            begin_item();
            write_indented(element, step, column + step, out);
        }
    } else {
        for (const auto& [key, member] : value.members()) {
            begin_item();
            out += quoted(key) + ": ";
            write_indented(member, step, column + step, out);
        }
    }
    out += "\n" + std::string(column, ' ') + (value.is_array() ? "]" : "}");
}

}  // namespace

// Defined here and not inline, because instantiating the variant's copy and move functions in each source is slow to
// compile.
Json::Json() = default;
Json::Json(const Json& other) = default;
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(const Json& other) = default;
Json& Json::operator=(Json&& other) noexcept = default;
Json::~Json() = default;

Json::Json(bool value) : value_(value) {}
Json::Json(std::string value) : value_(std::move(value)) {}
Json::Json(std::string_view value) : value_(std::string(value)) {}
Json::Json(const char* value) : value_(std::string(value)) {}

Json::Json(double value) {
    if (!std::isfinite(value)) return;
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    value_ = Number{value, std::string(text.data(), end)};
}

Json Json::array(std::vector<Json> elements) {
    Json json;
    json.value_ = std::move(elements);
    return json;
}

Json Json::object() {
    Json json;
    json.value_ = std::vector<Member>();
    return json;
}

Json Json::number_as_written(double value, std::string text) {
    Json json;
    json.value_ = Number{value, std::move(text)};
    return json;
}

bool Json::boolean() const {
    SELVEDGE_ASSERT(is_bool());
    return std::get<bool>(value_);
}
double Json::number() const {
    SELVEDGE_ASSERT(is_number());
    return std::get<Number>(value_).value;
}
const std::string& Json::number_text() const {
    SELVEDGE_ASSERT(is_number());
    return std::get<Number>(value_).text;
}
const std::string& Json::string() const {
    SELVEDGE_ASSERT(is_string());
    return std::get<std::string>(value_);
}
const std::vector<Json>& Json::elements() const {
    SELVEDGE_ASSERT(is_array());
    return std::get<std::vector<Json>>(value_);
}
std::vector<Json>& Json::elements() {
    SELVEDGE_ASSERT(is_array());
    return std::get<std::vector<Json>>(value_);
}
const std::vector<Json::Member>& Json::members() const {
    SELVEDGE_ASSERT(is_object());
    return std::get<std::vector<Member>>(value_);
}
std::vector<Json::Member>& Json::members() {
    SELVEDGE_ASSERT(is_object());
    return std::get<std::vector<Member>>(value_);
}

const Json* Json::find(std::string_view key) const {
    if (!is_object()) return nullptr;
    for (const Member& member : members()) {
        if (member.key == key) return &member.value;
    }
    return nullptr;
}
Json* Json::find(std::string_view key) {
    return const_cast<Json*>(std::as_const(*this).find(key));
}

Json& Json::operator[](std::string_view key) {
    if (is_null()) value_ = std::vector<Member>();
    if (Json* found = find(key)) return *found;
    members().push_back({std::string(key), {}});
    return members().back().value;
}

void Json::push_back(Json element) {
    if (is_null()) value_ = std::vector<Json>();
    elements().push_back(std::move(element));
}

void Json::erase(std::string_view key) {
    std::erase_if(members(), [&](const Member& member) { return member.key == key; });
}

const char* describe(Json::Kind kind) {
    constexpr std::array<const char*, 6> names{"null",     "true or false", "a number",
                                               "a string", "an array",      "an object"};
    return names[static_cast<std::size_t>(kind)];
}

Json parse_json(std::string_view text, const std::string& file) {
    if (text.size() > kMaxBytes) throw InputError(file, "", "over 64 MB");
    Builder builder(file);
    nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
    return builder.take();
}

Json read_json(const std::filesystem::path& path) {
    return parse_json(read_file(path, kMaxBytes), path.string());
}

std::string write_json(const Json& value, int indent) {
    if (indent < 0) return flat_text(value, false);
    std::string text;
    write_indented(value, static_cast<std::size_t>(indent), 0, text);
    return text + "\n";
}

void JsonView::fail(const std::string& problem) const {
    throw InputError(file_, path_, problem);
}

void JsonView::expect(Json::Kind kind) const {
    if (value_->kind() == kind) return;
    fail(std::string(describe(value_->kind())) + " where " + describe(kind) + " should be");
}

JsonView JsonView::at(std::string_view key) const {
    expect(Json::Kind::Object);
    const Json* found = value_->find(key);
    if (!found) fail("no key '" + std::string(key) + "'");
    return {*found, file_, json_path(path_, key)};
}

JsonView JsonView::at(std::size_t index) const {
    if (index >= size()) fail("only " + std::to_string(size()) + " elements");
    return {value_->elements()[index], file_, json_path(path_, index)};
}

std::size_t JsonView::size() const {
    expect(Json::Kind::Array);
    return value_->elements().size();
}

std::vector<std::string> JsonView::keys() const {
    expect(Json::Kind::Object);
    std::vector<std::string> names;
    for (const Json::Member& member : value_->members()) names.push_back(member.key);
    return names;
}

bool JsonView::boolean() const {
    expect(Json::Kind::Bool);
    return value_->boolean();
}

double JsonView::number() const {
    expect(Json::Kind::Number);
    return value_->number();
}

double JsonView::number_between(double least, double most) const {
    const double value = number();
    if (value >= least && value <= most) return value;
    fail(value_->number_text() + " is not between " + Json(least).number_text() + " and " + Json(most).number_text());
}

int JsonView::integer() const {
    const double value = number_between(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    if (value != std::floor(value)) fail(value_->number_text() + " is not a whole number");
    return static_cast<int>(value);
}

const std::string& JsonView::string() const {
    expect(Json::Kind::String);
    return value_->string();
}

std::vector<double> JsonView::numbers() const {
    std::vector<double> values;
    for (std::size_t i = 0; i < size(); ++i) values.push_back(at(i).number());
    return values;
}

std::string json_path(const std::string& parent, std::string_view key) {
    const bool is_word = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-';
    });
    if (!is_word) return parent + "[" + quoted(std::string(key)) + "]";
    return parent.empty() ? std::string(key) : parent + "." + std::string(key);
}

std::string json_path(const std::string& parent, std::size_t index) {
    return parent + "[" + std::to_string(index) + "]";
}

}  // namespace selvedge::sim
