// Quad precision (113 bits, g++ only): for oracles, tests, benchmarks, data formed once a task and the rare fallback,
// not for fast paths.
#pragma once

#include <boost/multiprecision/float128.hpp>

#include <Eigen/Core>

namespace burmester {

using Quad = boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;

}  // namespace burmester

template <>
struct Eigen::NumTraits<burmester::Quad> : Eigen::GenericNumTraits<burmester::Quad> {
  using Real = burmester::Quad;
  using NonInteger = burmester::Quad;
  using Nested = burmester::Quad;
  enum {
    IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 0, ReadCost = 4, AddCost = 40, MulCost = 40
  };
};
