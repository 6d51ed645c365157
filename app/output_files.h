#pragma once
// Files that a subcommand will write, looked at before its work begins: nobody should wait for what cannot be kept.
#include <array>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace selvedge {

// For check_output.
inline constexpr std::array<std::string_view, 1> kPictureExtensions{".png"};
inline constexpr std::array<std::string_view, 2> kMeshExtensions{".obj", ".glb"};

// Throws InputError when the folder is not there or may not be written to, when something stands there that is no file,
// or when the name ends in none of the extensions, in small or capital letters (none given: any will do).
void check_output(const std::filesystem::path& path, std::span<const std::string_view> extensions = {});

// Throws InputError when two outputs are one file, or an output is a file that is read.
void check_apart(const std::vector<std::filesystem::path>& outputs, const std::vector<std::filesystem::path>& inputs);

}  // namespace selvedge
