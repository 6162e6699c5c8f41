#include "program/output_folder.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "burmester/modules/framework/input.hpp"
#include "program/console.hpp"

namespace burmester {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& expected,
                         const std::string& reason) {
  throw InputError(
      fmt::format("{}: expected {}, got none ({})", shown_name(path.string()), expected, reason));
}

}  // namespace

OutputFolder::OutputFolder(const std::string& path) : folder_(path) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (!std::filesystem::is_directory(folder_))
    refuse(folder_, "a folder to write to", error ? error.message() : "a file is there");
  if (access(folder_.c_str(), W_OK | X_OK) != 0)
    refuse(folder_, "a folder to write to", std::strerror(errno));
}

void OutputFolder::write(const std::string& name, std::string_view text) const {
  const std::filesystem::path target = folder_ / name,
                              draft = folder_ / fmt::format(".{}.{}", name, getpid());
  errno = 0;
  std::ofstream file(draft, std::ios::binary);
  if (!file) refuse(target, "a file to write to", std::strerror(errno));
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  std::error_code error;
  if (!file) {
    const std::string reason = std::strerror(errno);
    std::filesystem::remove(draft, error);
    throw OutputError(fmt::format("{} cannot be written ({})", target.string(), reason));
  }
  std::filesystem::rename(draft, target, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(draft, ignored);
  refuse(target, "a file to write to", error.message());
}

void OutputFolder::remove_others(const std::set<std::string>& kept, std::string_view mark) const {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored)) {
    if (!entry.is_regular_file(ignored) || kept.contains(entry.path().filename().string())) continue;
    std::string start(mark.size(), ' ');
    std::ifstream(entry.path(), std::ios::binary)
        .read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start == mark) std::filesystem::remove(entry.path(), ignored);
  }
}

std::string OutputFolder::path(const std::string& name) const { return (folder_ / name).string(); }

}  // namespace burmester
