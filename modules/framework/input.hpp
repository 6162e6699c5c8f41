// Reading files. A document is parsed once; its nodes know where they stand, so that every complaint is one
// line that says file, place and what was expected:   task.json: poses[2].angle: expected a number, got "12
// deg" Nothing is lost silently: a key given twice is bad input, an unknown key a warning.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "burmester/modules/framework/problem.hpp"

namespace burmester {

class InputDocument;

/// A value of a document, or the place where one could be. Lives no longer than its document.
class InputNode {
 public:
  bool present() const { return value_ != nullptr; }
  bool is_object() const;
  bool is_array() const;
  bool is_number() const;
  bool is_string() const;

  // Everything below throws InputError with the place where the value is not what is asked for.
  double number() const;
  std::string string() const;
  /// A string that is one of `known`.
  std::string choice(const std::vector<std::string>& known) const;
  /// An array of exactly `count` numbers.
  std::vector<double> numbers(std::size_t count) const;
  /// Length of an array.
  std::size_t size() const;
  InputNode at(std::size_t index) const;
  /// The member of an object; present() is false, and reading it an error, where there is none.
  InputNode at(std::string_view key) const;
  /// True if this is an object with that key.
  bool has(std::string_view key) const;

  /// Warns of members with other names.
  void expect_keys(std::initializer_list<std::string_view> known) const;
  /// "file: place: expected <expected>, got <this value>"
  [[noreturn]] void fail(std::string_view expected) const;
  /// "file: place: <text>"
  [[noreturn]] void reject(std::string_view text) const;
  void warn(std::string_view text) const;

 private:
  friend class InputDocument;
  InputNode(const InputDocument& document, const nlohmann::json* value, std::string place)
      : document_(&document), value_(value), place_(std::move(place)) {}

  const InputDocument* document_;
  const nlohmann::json* value_;
  std::string place_;  ///< "poses[2].angle"; empty at the top
};

class InputDocument {
 public:
  /// Parses JSON. Throws InputError with line and column; `file` is what messages call the source.
  InputDocument(std::string_view text, std::string file);
  ~InputDocument();
  InputDocument(const InputDocument&) = delete;
  InputDocument& operator=(const InputDocument&) = delete;

  InputNode root() const { return {*this, value_.get(), ""}; }
  /// "place: text", each kind once: of poses[0].colour, poses[1].colour, .. only the first is told.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  friend class InputNode;
  std::string file_;
  std::unique_ptr<nlohmann::json> value_;
  mutable std::vector<std::string> warnings_;
  mutable std::set<std::string> warned_;
};

/// Text for messages and terminals: no control characters, valid UTF-8, cut at about `limit` characters.
std::string printable(std::string_view text, std::size_t limit = 60);

/// "a", "a or b", "a, b or c"
std::string one_of(const std::vector<std::string>& words);

}  // namespace burmester
