// Exact arithmetic: integers and rational numbers of any size. The one place that chooses the implementation.
//
// GMP (fast), or with BURMESTER_WITHOUT_GMP Boost's own cpp_int (up to 30 times slower on long numbers, needs
// no library). Without expression templates: `auto x = a + b` is a number. Conversion from double is exact.
#pragma once

#ifdef BURMESTER_WITHOUT_GMP
#include <boost/multiprecision/cpp_int.hpp>
#else
#include <boost/multiprecision/gmp.hpp>
#endif
#include <boost/multiprecision/eigen.hpp>

#ifdef BURMESTER_WITHOUT_GMP
#include <type_traits>

// cpp_int reads containers of bytes; Boost 1.74 fails to compile when it asks whether an expression of Eigen (its
// iterator is void) is one.
template <class Expression>
requires requires { typename Expression::StorageKind; }
struct boost::multiprecision::detail::is_byte_container<Expression> : std::false_type {
};
#endif

namespace burmester {

#ifdef BURMESTER_WITHOUT_GMP
using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
#else
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
#endif

}  // namespace burmester
