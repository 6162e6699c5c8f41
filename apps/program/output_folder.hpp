// A folder that results are written into. Each file appears complete or not at all.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace burmester {

class OutputFolder {
 public:
  /// Makes the folder and those above it. Throws InputError where that is not possible.
  explicit OutputFolder(const std::string& path);

  /// Throws InputError where the file cannot be made, OutputError where writing fails.
  void write(const std::string& name, std::string_view text) const;
  /// Removes files that begin with `mark` but those named in `kept`: figures of an earlier run.
  void remove_others(const std::set<std::string>& kept, std::string_view mark) const;
  std::string path(const std::string& name) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace burmester
