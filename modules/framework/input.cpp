#include "burmester/modules/framework/input.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "burmester/modules/framework/json_parser.hpp"

namespace burmester {
namespace {

constexpr std::size_t most_warnings = 20;

std::string describe(const nlohmann::json* value) {
  if (!value) return "nothing";
  if (value->is_object()) return "an object";
  if (value->is_array())
    return value->empty() ? "an empty array" : fmt::format("an array of {}", value->size());
  if (value->is_string()) return fmt::format("\"{}\"", printable(value->get_ref<const std::string&>()));
  return value->dump();
}

/// poses[12].angle and poses[3].angle are one kind of place.
std::string without_indices(std::string_view place) {
  std::string out;
  for (const char c : place)
    if (c < '0' || c > '9') out += c;
  return out;
}

/// Bytes of the UTF-8 character that `text` begins with; 0 where it begins with none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  if (first == 0xE0 && byte(1) < 0xA0) return 0;  // longer than needed
  if (first == 0xED && byte(1) > 0x9F) return 0;  // half of a surrogate pair
  if (first == 0xF0 && byte(1) < 0x90) return 0;
  if (first == 0xF4 && byte(1) > 0x8F) return 0;
  return length;
}

}  // namespace

std::string printable(std::string_view text, std::size_t limit) {
  std::string out;
  while (!text.empty() && out.size() < limit) {
    const std::size_t length = utf8_length(text);
    const bool control = length == 1 && (text[0] < 0x20 || text[0] == 0x7F);
    const bool control_beyond_ascii =
        length == 2 && text[0] == '\xC2' && static_cast<unsigned char>(text[1]) < 0xA0;
    if (length == 0 || control || control_beyond_ascii)
      out += text[0] == '\n' || text[0] == '\t' ? ' ' : '?';
    else
      out += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return text.empty() ? out : out + "..";
}

std::string one_of(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return out;
}

InputDocument::InputDocument(std::string_view text, std::string file)
    : file_(std::move(file)), value_(std::make_unique<nlohmann::json>(parse_json(text, file_))) {}

InputDocument::~InputDocument() = default;

bool InputNode::is_object() const { return value_ && value_->is_object(); }
bool InputNode::is_array() const { return value_ && value_->is_array(); }
bool InputNode::is_number() const { return value_ && value_->is_number(); }
bool InputNode::is_string() const { return value_ && value_->is_string(); }

double InputNode::number() const {
  if (!is_number()) fail("a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number)) fail("a finite number");
  return number;
}

std::string InputNode::string() const {
  if (!is_string()) fail("a string");
  return value_->get<std::string>();
}

std::string InputNode::choice(const std::vector<std::string>& known) const {
  if (!is_string() ||
      std::find(known.begin(), known.end(), value_->get_ref<const std::string&>()) == known.end())
    fail(one_of(known));
  return value_->get<std::string>();
}

std::vector<double> InputNode::numbers(std::size_t count) const {
  if (!is_array() || value_->size() != count) fail(fmt::format("an array of {} numbers", count));
  std::vector<double> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(at(i).number());
  return out;
}

std::size_t InputNode::size() const {
  if (!is_array()) fail("an array");
  return value_->size();
}

InputNode InputNode::at(std::size_t index) const {
  return {*document_, index < size() ? &(*value_)[index] : nullptr, fmt::format("{}[{}]", place_, index)};
}

InputNode InputNode::at(std::string_view key) const {
  if (!is_object()) fail("an object");
  const auto found = value_->find(key);
  return {*document_, found == value_->end() ? nullptr : &*found,
          fmt::format("{}{}{}", place_, place_.empty() ? "" : ".", key)};
}

bool InputNode::has(std::string_view key) const { return is_object() && value_->contains(key); }

void InputNode::expect_keys(std::initializer_list<std::string_view> known) const {
  if (!is_object()) fail("an object");
  for (const auto& item : value_->items())
    if (std::find(known.begin(), known.end(), item.key()) == known.end())
      at(item.key()).warn("unknown key, ignored");
}

void InputNode::fail(std::string_view expected) const {
  reject(fmt::format("expected {}, got {}", expected, describe(value_)));
}

void InputNode::reject(std::string_view text) const {
  throw InputError(fmt::format("{}: {}: {}", document_->file_,
                               place_.empty() ? "top level" : printable(place_, 120), text));
}

void InputNode::warn(std::string_view text) const {
  if (document_->warned_.size() > most_warnings || !document_->warned_.insert(without_indices(place_)).second)
    return;
  document_->warnings_.push_back(
      document_->warned_.size() > most_warnings
          ? "further warnings are left out"
          : fmt::format("{}: {}", place_.empty() ? "top level" : printable(place_, 120), text));
}

}  // namespace burmester
