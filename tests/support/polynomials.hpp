// The list of the polynomials of geometry/signs.hpp, for tests that run over all of them.
#pragma once

#include <gtest/gtest.h>

#include "burmester/geometry/signs.hpp"

namespace burmester {

/// These, and more of a test's own.
template <class... More>
using Polynomials = testing::Types<Determinant<2>, Determinant<3>, Determinant<4>, Orientation2, Orientation3, InCircle,
                                   DyadClosure, More...>;

}  // namespace burmester
