#pragma once
// JSON, read and written with its order and its numbers as they stood: a number keeps the text it came with, so that
// what a program does not change it does not reformat. The one owner of nlohmann-json, and of the limits on what is
// read: 64 MB, 64 levels, 4 million values, finite numbers, no key twice in an object.
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
    Json(double value);  // a number that is not finite becomes null: JSON has no other word for it
    Json(std::string value);
    Json(std::string_view value);
    Json(const char* value);
    template <std::integral T>
    requires(!std::same_as<T, bool>) Json(T value)
        : Json(number_as_written(static_cast<double>(value), std::to_string(value))) {}

    static Json array(std::vector<Json> elements = {});
    static Json object();
    // A number that came as `text`, whose value is `value`.
    static Json number_as_written(double value, std::string text);

    Kind kind() const { return static_cast<Kind>(value_.index()); }
    bool is_number() const { return kind() == Kind::Number; }
    bool is_string() const { return kind() == Kind::String; }
    bool is_array() const { return kind() == Kind::Array; }
    bool is_object() const { return kind() == Kind::Object; }
    bool is_bool() const { return kind() == Kind::Bool; }
    bool is_null() const { return kind() == Kind::Null; }

    // Pre: of that kind.
    bool boolean() const;
    double number() const;
    const std::string& number_text() const;
    const std::string& string() const;
    const std::vector<Json>& elements() const;
    std::vector<Json>& elements();
    const std::vector<Member>& members() const;
    std::vector<Member>& members();

    // The member of an object; null pointer when there is none, or when this is no object.
    const Json* find(std::string_view key) const;
    Json* find(std::string_view key);

    // The member of an object, added at its end when there is none. A null becomes an object first.
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

// The name of a kind with its article, for messages: "a number", "an object".
const char* describe(Json::Kind kind);

// Throws InputError with `file`, and the line where the text stops being JSON.
Json parse_json(std::string_view text, const std::string& file);
Json read_json(const std::filesystem::path& path);

// Indented by `indent` spaces; arrays and objects that hold only plain values stay on one line where they fit in 100
// columns. Ends in a newline. A negative indent gives one line without spaces.
std::string write_json(const Json& value, int indent = 2);

// A place in a document, to read what must be there: each step throws an InputError that names the file and the path,
// such as "fabric.json: warp.stretch: a string where a number should be".
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
    std::size_t size() const;               // elements of an array
    std::vector<std::string> keys() const;  // of an object, in the file's order

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

// "a.b" and "a[3]": how paths are written, here and in every report of a fault.
std::string json_path(const std::string& parent, std::string_view key);
std::string json_path(const std::string& parent, std::size_t index);

}  // namespace selvedge::sim
