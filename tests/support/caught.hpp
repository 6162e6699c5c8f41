// For tests of the laws themselves: planted mistakes, and which law must see them.
#pragma once

#include <gtest/gtest.h>

#include "burmester/modules/framework/dyad_laws.hpp"
#include "burmester/modules/framework/space_laws.hpp"

namespace burmester {

inline testing::AssertionResult caught(const laws::Violations& violations, std::string_view law) {
  for (const std::string& text : violations)
    if (text.starts_with(law)) return testing::AssertionSuccess();
  auto result = testing::AssertionFailure() << law << " saw nothing; found were " << violations.size();
  for (const std::string& text : violations) result << "\n" << text;
  return result;
}

/// The dyad type D with one entry of its rows negated.
template <class D, int entry>
struct FlippedRow : D {
  struct Family : D::Family {
    template <class T>
    static auto row(const typename D::Space::Pose& pose) {
      auto out = D::Family::template row<T>(pose);
      out[entry] = -out[entry];
      return out;
    }
  };
  using Inverse = FlippedRow;
};

/// The dyad type D with one entry of its lifted form negated.
template <class D, int entry>
struct FlippedForm : D {
  using Inverse = FlippedForm;
  static auto encode(const typename D::Design& d) {
    auto out = D::encode(d);
    out[entry] = -out[entry];
    return out;
  }
};

template <class D, int entry>
void expect_flip_caught() {
  EXPECT_TRUE(caught(laws::dyad_violations<FlippedRow<D, entry>>(), "form_is_a_function")) << "row " << entry;
  EXPECT_TRUE(caught(laws::dyad_violations<FlippedForm<D, entry>>(), "form_is_a_function"))
      << "form " << entry;
}

/// Every flipped entry is seen. Precondition: D is its own inverse, and no entry of its form is zero for all
/// designs.
template <class D>
void expect_flips_caught() {
  []<int... entry>(std::integer_sequence<int, entry...>) { (expect_flip_caught<D, entry>(), ...); }
  (std::make_integer_sequence<int, D::Family::dimension>{});
}

}  // namespace burmester
