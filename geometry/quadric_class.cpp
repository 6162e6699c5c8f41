#include "burmester/geometry/quadric_class.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "burmester/geometry/affine_inertia.hpp"

namespace burmester {
namespace {

QuadricType type_of(const AffineInertia& form) {
  using enum QuadricType;
  const int signature = std::abs(form.whole.signature), there = std::abs(form.at_infinity.signature);
  const bool real = signature < form.whole.rank;
  switch (4 * form.whole.rank + form.at_infinity.rank) {
    case 4 * 4 + 3:
      if (!real) return imaginary_ellipsoid;
      if (signature == 0) return hyperboloid_of_one_sheet;
      return there == 3 ? ellipsoid : hyperboloid_of_two_sheets;
    case 4 * 4 + 2:
      return signature == 0 ? hyperbolic_paraboloid : elliptic_paraboloid;
    case 4 * 3 + 3:
      return real ? cone : point;
    case 4 * 3 + 2:
      if (!real) return imaginary_cylinder;
      return there == 0 ? hyperbolic_cylinder : elliptic_cylinder;
    case 4 * 3 + 1:
      return parabolic_cylinder;
    case 4 * 2 + 2:
      return real ? crossing_planes : line;
    case 4 * 2 + 1:
      return real ? parallel_planes : complex_parallel_planes;
    case 4 * 2 + 0:
      return plane_and_infinity;
    case 4 * 1 + 1:
      return coincident_planes;
    case 4 * 1 + 0:
      return infinity_twice;
    default:
      return everything;
  }
}

template <class T>
QuadricClass classify_exactly(const Quadric<T>& quadric, const Point3<T>& infinity) {
  const AffineInertia form = affine_inertia<T, 4>(doubled_matrix<T, 4>(quadric), infinity);
  return {type_of(form), form.rung};
}

}  // namespace

QuadricClass classify(const Quadric<double>& quadric, const Point3<double>& infinity) {
  return classify_exactly(quadric, infinity);
}
QuadricClass classify(const Quadric<Rational>& quadric, const Point3<Rational>& infinity) {
  return classify_exactly(quadric, infinity);
}

std::string_view name_of(QuadricType type) {
  using enum QuadricType;
  switch (type) {
    case ellipsoid:
      return "ellipsoid";
    case imaginary_ellipsoid:
      return "imaginary ellipsoid";
    case hyperboloid_of_one_sheet:
      return "hyperboloid of one sheet";
    case hyperboloid_of_two_sheets:
      return "hyperboloid of two sheets";
    case elliptic_paraboloid:
      return "elliptic paraboloid";
    case hyperbolic_paraboloid:
      return "hyperbolic paraboloid";
    case cone:
      return "cone";
    case point:
      return "point";
    case elliptic_cylinder:
      return "elliptic cylinder";
    case imaginary_cylinder:
      return "imaginary cylinder";
    case hyperbolic_cylinder:
      return "hyperbolic cylinder";
    case parabolic_cylinder:
      return "parabolic cylinder";
    case crossing_planes:
      return "crossing planes";
    case line:
      return "line";
    case parallel_planes:
      return "parallel planes";
    case complex_parallel_planes:
      return "complex parallel planes";
    case coincident_planes:
      return "coincident planes";
    case plane_and_infinity:
      return "plane and the plane at infinity";
    case infinity_twice:
      return "plane at infinity, twice";
    case everything:
      return "every point";
  }
  return {};
}

Point3<double> centre_of(const Quadric<double>& quadric, const Point3<double>& infinity) {
  const Matrix<double, 4, 4> m = doubled_matrix<double, 4>(quadric);
  return Point3<double>(m.fullPivLu().solve(infinity)).normalized();
}

/// Scaled eigenvectors make Q = a^2 + b^2 - c^2 - d^2, so that (a - c)(a + c) = (d - b)(d + b); these four
/// factors are u0 v0, u1 v1, u0 v1, u1 v0.
Rulings rulings_of(const Quadric<double>& quadric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(doubled_matrix<double, 4>(quadric));
  const auto unit = [&eigen](int i) -> Point3<double> {
    return eigen.eigenvectors().col(i) / std::sqrt(std::abs(eigen.eigenvalues()[i]));
  };
  const Point3<double> c = unit(0), d = unit(1), b = unit(2), a = unit(3);
  return {{{{{a - c, d - b}}, {{d + b, a + c}}}}};
}

}  // namespace burmester
