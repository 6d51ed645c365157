#pragma once
// A JSON value that preserves the order of keys and the original text of floating-point numbers, so that unchanged
// parts of a document are not reformatted; a parser, a writer, and JsonView for reading with error messages that name
// the path. Only json.cpp uses nlohmann-json. Limits on input: 64 MiB, 64 nesting levels, 4 million values, finite
// numbers, no duplicate key in an object.
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace selvedge::sim {

class Json {
 public:
    struct Member;
    enum class Kind { Null, Bool, Number, String, Array, Object };

    Json();  // null
    Json(const Json& other);
    Json(Json&& other) noexcept;
    Json& operator=(const Json& other);
    Json& operator=(Json&& other) noexcept;
    ~Json();
    Json(bool value);
    Json(double value);  // NaN and infinity become null, because JSON cannot represent them
    Json(std::string value);
    Json(std::string_view value);
    Json(const char* value);
    template <std::integral T>
    requires(!std::same_as<T, bool>) Json(T value)
        : Json(number_as_written(static_cast<double>(value), std::to_string(value))) {}

    static Json array(std::vector<Json> elements = {});
    static Json object();
    // The number `value`, written as `text`. Pre: `text` is a valid JSON number with that value.
    static Json number_as_written(double value, std::string text);

    Kind kind() const { return static_cast<Kind>(value_.index()); }
    bool is_number() const { return kind() == Kind::Number; }
    bool is_string() const { return kind() == Kind::String; }
    bool is_array() const { return kind() == Kind::Array; }
    bool is_object() const { return kind() == Kind::Object; }
    bool is_bool() const { return kind() == Kind::Bool; }
    bool is_null() const { return kind() == Kind::Null; }

    // Pre: the value is of that kind.
    bool boolean() const;
    double number() const;
    const std::string& number_text() const;
    const std::string& string() const;
    const std::vector<Json>& elements() const;
    std::vector<Json>& elements();
    const std::vector<Member>& members() const;
    std::vector<Member>& members();

    // The member with this key; nullptr if there is none or if this value is not an object.
    const Json* find(std::string_view key) const;
    Json* find(std::string_view key);

    // The member with this key, appended (as null) if there is none. A null value becomes an object first, and in
    // push_back an array. Pre: null or an object (operator[]), null or an array (push_back), an object (erase).
    Json& operator[](std::string_view key);
    void push_back(Json element);
    void erase(std::string_view key);

 private:
    struct Number {
        double value = 0;
        std::string text;
    };

    std::variant<std::monostate, bool, Number, std::string, std::vector<Json>, std::vector<Member>> value_;
};

struct Json::Member {
    std::string key;
    Json value;
};

// The name of a kind for messages, with its article: "a number", "an object".
const char* describe(Json::Kind kind);

// Throws InputError with `file` and the position of a syntax error, or the JSON path where a limit above is exceeded.
Json parse_json(std::string_view text, const std::string& file);
Json read_json(const std::filesystem::path& path);

// The value as text, indented by `indent` spaces per level, with a newline at the end. An array or object nested at
// most 4 levels deep stays on one line if its text and indentation fit in 100 columns. A negative indent gives one line
// without spaces and without a newline.
std::string write_json(const Json& value, int indent = 2);

// A value in a document together with its file and JSON path, for reading required values. Each access throws an
// InputError if the value is missing or of the wrong kind: "fabric.json: warp.stretch: a string where a number should
// be".
class JsonView {
 public:
    // The document must outlive the view.
    JsonView(const Json& value, std::string file, std::string path = "")
        : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

    const Json& value() const { return *value_; }
    const std::string& file() const { return file_; }
    const std::string& path() const { return path_; }

    bool has(std::string_view key) const { return value_->find(key) != nullptr; }
    JsonView at(std::string_view key) const;
    JsonView at(std::size_t index) const;
    std::size_t size() const;               // number of elements; an array
    std::vector<std::string> keys() const;  // of an object, in file order

    bool boolean() const;
    double number() const;
    double number_between(double least, double most) const;
    int integer() const;
    const std::string& string() const;
    std::vector<double> numbers() const;

    [[noreturn]] void fail(const std::string& problem) const;

 private:
    void expect(Json::Kind kind) const;

    const Json* value_;
    std::string file_;
    std::string path_;
};

// Appends a key or an index to a JSON path: "a.b", "a[3]"; a key with other characters than letters, digits, '_' and
// '-' is quoted: a["b c"].
std::string json_path(const std::string& parent, std::string_view key);
std::string json_path(const std::string& parent, std::size_t index);

}  // namespace selvedge::sim
