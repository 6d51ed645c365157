#pragma once
// What cannot be done to a draft, in words a tailor understands, and where: views light the places up.
#include <stdexcept>
#include <string>
#include <vector>

namespace selvedge {

struct DraftPlace {
    std::string panel;
    int edge = -1;    // none: -1
    int vertex = -1;  // none: -1

    bool operator==(const DraftPlace&) const = default;
};

class DraftError : public std::runtime_error {
 public:
    explicit DraftError(const std::string& words, std::vector<DraftPlace> places = {})
        : std::runtime_error(words), places_(std::move(places)) {}

    const std::vector<DraftPlace>& places() const { return places_; }

 private:
    std::vector<DraftPlace> places_;
};

}  // namespace selvedge
