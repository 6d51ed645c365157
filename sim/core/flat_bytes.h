#pragma once
// Serialisation of plain data between two processes of the same program, or two runs of it on machines of one kind. The
// writer may run in a process that a bad file has corrupted, and a file on disk may be broken, so the reader checks
// every length.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace selvedge::sim {

class FlatWriter {
 public:
    template <class T>
    void value(const T& item) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes_.append(reinterpret_cast<const char*>(&item), sizeof item);
    }
    void text(std::string_view text) {
        value(std::uint64_t(text.size()));
        bytes_ += text;
    }
    // Copies items bitwise: arrays of numbers, Eigen's fixed-size vectors.
    template <class T>
    void list(const std::vector<T>& items) {
        value(std::uint64_t(items.size()));
        if (!items.empty()) bytes_.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
    }
    // Calls write(item) for each item, after their number.
    template <class T, class Write>
    void each(const std::vector<T>& items, const Write& write) {
        value(std::uint64_t(items.size()));
        for (const T& item : items) write(item);
    }
    void texts(const std::vector<std::string>& texts) {
        each(texts, [this](const std::string& item) { text(item); });
    }
    const std::string& bytes() const { return bytes_; }

 private:
    std::string bytes_;
};

// After a read beyond the end, all further reads return zeros or empty values and is_sound() is false.
class FlatReader {
 public:
    explicit FlatReader(std::string_view bytes) : bytes_(bytes) {}

    template <class T>
    T value() {
        T item{};
        take(&item, sizeof item);
        return item;
    }
    std::string text() {
        std::string text(count(1), '\0');
        take(text.data(), text.size());
        return text;
    }
    template <class T>
    std::vector<T> list() {
        std::vector<T> items(count(sizeof(T)));
        if (!items.empty()) take(static_cast<void*>(items.data()), items.size() * sizeof(T));
        return items;
    }
    // Calls read(item) for a new item until all have been read, or the reader is no longer sound.
    template <class T, class Read>
    std::vector<T> each(const Read& read) {
        std::vector<T> items;
        for (std::size_t left = count(1); left > 0 && is_sound_; --left) read(items.emplace_back());
        return items;
    }
    std::vector<std::string> texts() {
        return each<std::string>([this](std::string& item) { item = text(); });
    }
    // Says that what was read is not sound.
    void refuse() { is_sound_ = false; }
    bool is_sound() const { return is_sound_; }
    bool is_at_end() const { return bytes_.empty(); }

 private:
    // Rejects a count that exceeds the number of items that the remaining bytes can hold.
    std::size_t count(std::size_t item_bytes) {
        const std::uint64_t count = value<std::uint64_t>();
        if (count > bytes_.size() / item_bytes) is_sound_ = false;
        return is_sound_ ? std::size_t(count) : 0;
    }
    void take(void* target, std::size_t size) {
        if (size > bytes_.size()) is_sound_ = false;
        if (!is_sound_ || size == 0) return;
        std::memcpy(target, bytes_.data(), size);
        bytes_.remove_prefix(size);
    }

    std::string_view bytes_;
    bool is_sound_ = true;
};

}  // namespace selvedge::sim
