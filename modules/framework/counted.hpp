// Numbers with their nouns in messages: "1 slider", "2 sliders".
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace burmester {

/// "1 real dyad", "2 real dyads", "0 real dyads": for nouns whose plural ends in s.
template <class Number>
std::string counted(Number count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace burmester
