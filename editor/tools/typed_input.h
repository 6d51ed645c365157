#pragma once
// Numbers that a person types while a tool is at work: 12, 92/4+1, 30 x 40. Centimetres or degrees, as the tool says.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace selvedge {

class TypedInput {
 public:
    // Takes what can be part of a number; a letter only where it goes on with one that has begun: x between two.
    // Returns whether it was taken.
    bool add(std::string_view text);
    void remove_last();
    void clear() { text_.clear(); }

    bool is_empty() const { return text_.empty(); }
    const std::string& text() const { return text_; }

    // One number, or several with x between them. None: it cannot be read (so far), or is empty.
    std::optional<std::vector<double>> numbers() const;

 private:
    std::string text_;
};

}  // namespace selvedge
