#include "burmester/geometry/vector.hpp"

#include <gtest/gtest.h>

namespace burmester {

// A library built for plain x86-64 and a consumer built with -march=native must agree on the layout.
template <int n>
constexpr bool plain_layout = alignof(Vector<double, n>) == alignof(double) &&
                              sizeof(Vector<double, n>) == n * sizeof(double);

TEST(Vector, HasTheLayoutOfAPlainArray) {
  static_assert(plain_layout<2> && plain_layout<3> && plain_layout<4> && plain_layout<7> && plain_layout<8>);
  static_assert(alignof(Matrix<double, 4, 4>) == alignof(double) && sizeof(Matrix<double, 4, 4>) == 128);
  struct Holder {
    char tag;
    Vector<double, 4> v;
  };
  static_assert(sizeof(Holder) == 40);
}

TEST(Vector, WorksAtAnyAddressOfADouble) {
  double room[10] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  for (int shift = 0; shift < 6; ++shift) {
    const auto& v = *reinterpret_cast<const Vector<double, 4>*>(room + shift);
    EXPECT_EQ(v.sum(), 4 * shift + 6);
    EXPECT_EQ((v + v)[3], 2 * (shift + 3));
  }
}

}  // namespace burmester
