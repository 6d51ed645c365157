#include "sim/repair/bvh_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <set>
#include <system_error>

#include "sim/core/error.h"
#include "sim/repair/guarded_import.h"

namespace selvedge::sim {
namespace {

constexpr double kLargestValue = 1e6;  // of an offset or a channel; admits a hall in millimetres

// Words between white space; braces are words of their own.
class Words {
 public:
    explicit Words(std::string_view text) : rest_(text) { advance(); }

    bool is_at_end() const { return word_.empty(); }
    std::string_view word() const { return word_; }
    std::size_t line() const { return line_; }  // of word(), from 1; at the end, the last that has any

    void advance() {
        std::size_t lines = 0, at = 0;
        for (; at < rest_.size() && kSpace.find(rest_[at]) != kSpace.npos; ++at) lines += rest_[at] == '\n' ? 1 : 0;
        rest_.remove_prefix(at);
        std::size_t length = std::min(rest_.find_first_of(kEnds), rest_.size());
        if (length == 0 && !rest_.empty()) length = 1;  // a brace
        word_ = rest_.substr(0, length);
        rest_.remove_prefix(length);
        if (!word_.empty()) line_ += lines;
    }

 private:
    static constexpr std::string_view kSpace = " \t\r\n\f\v", kEnds = " \t\r\n\f\v{}";

    std::string_view rest_;
    std::string_view word_;
    std::size_t line_ = 1;
};

// The word in a message: at most 40 characters, none of which ends the line.
std::string quoted(std::string_view word) {
    constexpr std::size_t kLongest = 40;
    std::string text(word.substr(0, kLongest));
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return "'" + text + "'";
}

class BvhReader {
 public:
    BvhReader(std::string_view text, const std::string& file, const MotionLimits& limits)
        : words_(text), file_(file), limits_(limits) {}

    void check() {
        expect("HIERARCHY");
        if (words_.word() != "ROOT") fail_at_word("'ROOT' is missing");
        while (words_.word() == "ROOT") read_tree();
        expect("MOTION");
        const std::size_t frames = read_frames();
        read_frame_time(frames);
        read_rows(frames);
    }

 private:
    [[noreturn]] void fail(std::size_t line, const std::string& problem) const {
        throw InputError(file_, "line " + std::to_string(line), problem);
    }
    [[noreturn]] void fail_at_word(const std::string& problem) const {
        fail(words_.line(),
             problem + (words_.is_at_end() ? ": the file ends here" : ", before " + quoted(words_.word())));
    }

    void expect(std::string_view word) {
        if (words_.word() != word) fail_at_word("'" + std::string(word) + "' is missing");
        words_.advance();
    }

    double read_number(const char* what) {
        if (words_.is_at_end()) fail_at_word(std::string(what) + " is missing");
        std::string_view word = words_.word();
        if (word.starts_with('+')) word.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            fail(words_.line(), std::string(what) + " is no number: " + quoted(words_.word()));
        words_.advance();
        return value;
    }

    double read_value(const char* what) {
        const std::size_t line = words_.line();
        const double value = read_number(what);
        if (!(std::abs(value) <= kLargestValue)) fail(line, std::string(what) + " is not a reasonable number");
        return value;
    }

    // Without recursion: a hostile file may nest as deep as it likes.
    void read_tree() {
        std::size_t depth = 0;
        do {
            const std::string_view kind = words_.word();
            if (kind == "}") {
                words_.advance();
                --depth;
            } else if (kind == "ROOT" || kind == "JOINT") {
                words_.advance();
                read_joint();
                ++depth;
            } else if (kind == "End") {
                words_.advance();
                read_end();
            } else {
                fail_at_word("'JOINT', 'End Site' or '}' is missing");
            }
        } while (depth > 0);
    }

    void read_joint() {
        const std::size_t line = words_.line();
        const std::string_view name = words_.word();
        if (words_.is_at_end() || name == "{") fail_at_word("the name of a joint is missing");
        if (!names_.insert(name).second) fail(line, "a second joint is called " + quoted(name));
        if (names_.size() > limits_.joints) fail(line, "more than " + std::to_string(limits_.joints) + " joints");
        words_.advance();
        expect("{");
        read_offset();
        read_channels();
    }

    void read_end() {
        expect("Site");
        expect("{");
        read_offset();
        expect("}");
    }

    void read_offset() {
        expect("OFFSET");
        for (int axis = 0; axis < 3; ++axis) read_value("an offset");
    }

    void read_channels() {
        constexpr std::array<std::string_view, 6> kNames{"Xposition", "Yposition", "Zposition",
                                                         "Xrotation", "Yrotation", "Zrotation"};
        expect("CHANNELS");
        const std::size_t line = words_.line();
        const double count = read_number("the number of channels");
        if (!(count >= 0 && count <= kNames.size() && count == std::floor(count)))
            fail(line, "a joint has 0 to 6 channels");
        std::set<std::string_view> seen;
        for (std::size_t k = 0; k < std::size_t(count); ++k) {
            const std::string_view name = words_.word();
            if (std::ranges::find(kNames, name) == kNames.end())
                fail_at_word("the name of a channel, as Xrotation, is missing");
            if (!seen.insert(name).second) fail(words_.line(), "a second channel " + quoted(name) + " of one joint");
            words_.advance();
        }
        channels_ += std::size_t(count);
    }

    std::size_t read_frames() {
        expect("Frames:");
        const std::size_t line = words_.line();
        const double frames = read_number("the number of frames");
        if (frames == 0) fail(line, "its motion has no frames");
        if (!(frames > 0 && frames == std::floor(frames))) fail(line, "the number of frames is not a whole number");
        if (frames * double(std::max<std::size_t>(channels_, 1)) > double(limits_.clip.keys) * kChannelsPerKey)
            fail(line, "its motion is too long: more than " + std::to_string(limits_.clip.keys) + " keys");
        return std::size_t(frames);
    }

    void read_frame_time(std::size_t frames) {
        constexpr double kShortest = 1e-3, kLongest = 1;  // s
        expect("Frame");
        expect("Time:");
        const std::size_t line = words_.line();
        const double time = read_number("the time of a frame");
        if (!(time >= kShortest && time <= kLongest)) fail(line, "the time of a frame is not between 0.001 and 1 s");
        if (time * double(frames) > limits_.clip.seconds)
            fail(line, "its motion is longer than " + std::to_string(int(limits_.clip.seconds)) + " s");
    }

    void read_rows(std::size_t frames) {
        for (std::size_t row = 0; row < frames; ++row) {
            for (std::size_t k = 0; k < channels_; ++k) {
                if (words_.is_at_end())
                    fail(words_.line(), "the file ends in row " + std::to_string(row + 1) + " of " +
                                            std::to_string(frames) + ", after " + std::to_string(k) + " of " +
                                            std::to_string(channels_) + " numbers");
                read_value("a channel");
            }
        }
        read_surplus(frames);
    }

    // Recorders write rows after the last that they count: whole ones are left out.
    void read_surplus(std::size_t frames) {
        while (!words_.is_at_end()) {
            const std::size_t line = words_.line();
            for (std::size_t k = 0; k < channels_; ++k) {
                if (words_.is_at_end() || words_.line() != line)
                    fail(line, "neither a row of " + std::to_string(channels_) + " numbers nor the end, after the " +
                                   std::to_string(frames) + " rows of 'Frames:'");
                read_value("a channel");
            }
            if (channels_ == 0) fail(line, "numbers of no channel");
        }
    }

    static constexpr double kChannelsPerKey = 3;  // a rotation's or a place's

    Words words_;
    const std::string& file_;
    const MotionLimits& limits_;
    std::set<std::string_view> names_;
    std::size_t channels_ = 0;  // of all joints
};

}  // namespace

void check_bvh(std::string_view text, const std::string& file, const MotionLimits& limits) {
    BvhReader(text, file, limits).check();
}

}  // namespace selvedge::sim
