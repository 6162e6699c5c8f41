#include "burmester/modules/framework/json_parser.hpp"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "burmester/modules/framework/input.hpp"

namespace burmester {
namespace {

using nlohmann::json;

constexpr std::size_t deepest = 100;

std::string between(std::string_view text, std::string_view before, std::string_view after) {
  const std::size_t from = text.find(before);
  if (from == text.npos) return "";
  text.remove_prefix(from + before.size());
  return std::string(text.substr(0, text.find(after)));
}

/// The parser's own words, made shorter: "expected ',' or ']', got 'x'".
std::string complaint(std::string_view what, std::string_view token) {
  const std::string expected = between(what, "; expected ", "\n"), detail = between(what, " - ", "; ");
  std::string words = "a value";
  if (expected == "string literal") words = "a key in quotes";
  if (expected == "':'") words = "':'";
  if (expected == "']'" || expected == "'}'") words = "',' or " + expected;
  if (expected == "end of input") words = "the end of the input";
  std::string text = fmt::format("expected {}, got {}", words, token);
  const std::size_t reason = detail.find("invalid ");
  if (reason != detail.npos && detail != "invalid literal")
    text += fmt::format(" ({})", detail.substr(reason));
  return text;
}

/// Builds the value from the parser's events.
class Builder {
 public:
  Builder(std::string_view text, const std::string& file) : text_(text), file_(file) {}
  json take() { return std::move(root_); }

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value) { return add(value); }
  bool number_float(double value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(json::object()); }
  bool start_array(std::size_t) { return open(json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    Level& level = levels_.back();
    level.key = name;
    if (level.value->contains(name))
      throw InputError(
          fmt::format("{}: {}: expected each key once, got it twice", file_, printable(place(), 120)));
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& error) {
    const auto [at, got] = offender(position, token, error.what());
    fail(at, error.id == 406 ? fmt::format("expected a finite number, got {}", got)
                             : complaint(error.what(), got));
  }

  [[noreturn]] void fail(std::size_t at, const std::string& words) const {
    const std::string_view before = text_.substr(0, at);
    const std::size_t newline = before.rfind('\n');
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = newline == before.npos ? at + 1 : at - newline;
    std::string where = printable(place(), 120);
    if (!where.empty()) where = fmt::format(" ({})", where);
    throw InputError(fmt::format("{}: line {}, column {}{}: {}", file_, line, column, where, words));
  }

 private:
  struct Level {
    json* value;
    std::string key;
  };

  json* put(json value) {
    if (levels_.empty()) return &(root_ = std::move(value));
    json& parent = *levels_.back().value;
    if (parent.is_object()) return &(parent[levels_.back().key] = std::move(value));
    parent.push_back(std::move(value));
    return &parent.back();
  }
  bool add(json value) { return put(std::move(value)); }
  bool open(json value) {
    json* const at = put(std::move(value));
    if (levels_.size() == deepest)
      throw InputError(fmt::format("{}: {}: expected at most {} levels of brackets", file_,
                                   printable(place(), 120), deepest));
    levels_.push_back({at, ""});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }

  std::string place() const {
    std::string out;
    for (const Level& level : levels_) {
      if (level.value->is_array())
        out += fmt::format("[{}]", level.value->size() - (&level != &levels_.back()));
      else if (!level.key.empty())
        out += (out.empty() ? "" : ".") + level.key;
    }
    return out;
  }

  /// Where the text breaks, and on what. The parser's token may begin before what it stumbled over.
  std::pair<std::size_t, std::string> offender(std::size_t position, const std::string& token,
                                               std::string_view what) const {
    std::size_t at = std::clamp<std::size_t>(position, 1, text_.size() + 1) - 1;
    if (at == text_.size()) return {at, "the end of the input"};
    if (text_[at] == '"' || what.find("invalid string") != what.npos) {
      const bool found = token.size() <= at + 1 && text_.substr(at + 1 - token.size(), token.size()) == token;
      return {found ? at + 1 - token.size() : at, printable(token)};
    }
    const auto in_word = [&](std::size_t i) {
      return i < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[i])) || text_[i] == '.' ||
                                  text_[i] == '-' || text_[i] == '+' || text_[i] == '_');
    };
    if (!in_word(at) && at > 0 && in_word(at - 1) && what.find("invalid") != what.npos) --at;
    if (!in_word(at)) return {at, fmt::format("'{}'", printable(text_.substr(at, 1)))};
    std::size_t end = at;
    while (at > 0 && in_word(at - 1)) --at;
    while (in_word(end)) ++end;
    return {at, printable(text_.substr(at, end - at))};
  }

  std::string_view text_;
  const std::string& file_;
  json root_;
  std::vector<Level> levels_;
};

}  // namespace

json parse_json(std::string_view text, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  if (text.find_first_not_of(" \t\r\n") == text.npos)
    throw InputError(fmt::format("{}: line 1: expected a JSON value, got nothing", file));
  Builder builder(text, file);
  const std::size_t zero = text.find('\0');  // the parser would take it for the end
  if (zero != text.npos) builder.fail(zero, "expected text, got a zero byte");
  json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace burmester
