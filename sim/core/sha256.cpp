#include "sim/core/sha256.h"

#include <nettle/sha2.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/file_path.h"

namespace selvedge::sim {
namespace {

class Hash {
 public:
    Hash() { sha256_init(&context_); }

    void add(std::string_view content) {
        sha256_update(&context_, content.size(), reinterpret_cast<const std::uint8_t*>(content.data()));
    }
    std::string digits() {
        std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest;
        sha256_digest(&context_, digest.size(), digest.data());
        std::string text;
        for (const unsigned byte : digest) {
            text += "0123456789abcdef"[byte >> 4];
            text += "0123456789abcdef"[byte & 15];
        }
        return text;
    }

 private:
    sha256_ctx context_;
};

}  // namespace

std::string sha256(std::string_view content) {
    Hash hash;
    hash.add(content);
    return hash.digits();
}

std::string sha256_of_file(const std::filesystem::path& path) {
    if (file_exists(path) && !is_file(path)) throw InputError(path.string(), "", "not a regular file");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(path.string(), "", std::string("cannot read: ") + std::strerror(errno));
    constexpr std::size_t kPart = 1 << 16;
    std::vector<char> part(kPart);
    Hash hash;
    while (file.read(part.data(), std::streamsize(part.size())) || file.gcount() > 0)
        hash.add({part.data(), std::size_t(file.gcount())});
    if (file.bad()) throw InputError(path.string(), "", "cannot read it to its end");
    return hash.digits();
}

}  // namespace selvedge::sim
