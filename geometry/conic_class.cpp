#include "burmester/geometry/conic_class.hpp"

#include <Eigen/Eigenvalues>

#include "burmester/geometry/affine_inertia.hpp"
#include "burmester/geometry/quad.hpp"

namespace burmester {
namespace {

using Vector2 = Vector<double, 2>;
using C = Conic<double>;

ConicType type_of(const AffineInertia& form) {
  const bool real = std::abs(form.whole.signature) < form.whole.rank;
  switch (4 * form.whole.rank + form.at_infinity.rank) {
    case 4 * 3 + 2:
      if (!real) return ConicType::imaginary_ellipse;
      return form.at_infinity.signature == 0 ? ConicType::hyperbola : ConicType::ellipse;
    case 4 * 3 + 1:
      return ConicType::parabola;
    case 4 * 2 + 2:
      return real ? ConicType::crossing_lines : ConicType::point;
    case 4 * 2 + 1:
      return real ? ConicType::parallel_lines : ConicType::complex_parallel_lines;
    case 4 * 2 + 0:
      return ConicType::line_and_infinity;
    case 4 * 1 + 1:
      return ConicType::coincident_lines;
    case 4 * 1 + 0:
      return ConicType::infinity_twice;
    default:
      return ConicType::everything;
  }
}

template <class T>
ConicClass classify_exactly(const Conic<T>& c) {
  const AffineInertia form = affine_inertia<T, 3>(doubled_matrix<T, 3>(c), {T(0), T(0), T(1)});
  return {type_of(form), c.q[0] == c.q[1] && c.q[5] == 0 && c.q[0] != 0,
          c.q[0] == -c.q[1] && (c.q[0] != 0 || c.q[5] != 0), form.rung};
}

double discriminant(const C& c) { return difference_of_products(4 * c.q[0], c.q[1], c.q[5], c.q[5]); }

/// Eigenvectors and eigenvalues of the part of degree two, the larger eigenvalue first.
struct Principal {
  std::array<Vector2, 2> axis;
  std::array<double, 2> value;

  explicit Principal(const C& c) {
    const double angle = std::atan2(c.q[5], c.q[0] - c.q[1]) / 2;
    axis = {Vector2(std::cos(angle), std::sin(angle)), Vector2(-std::sin(angle), std::cos(angle))};
    const double sum = c.q[0] + c.q[1], gap = std::hypot(c.q[0] - c.q[1], c.q[5]);
    const bool positive = sum >= 0;
    const double outer = (sum + (positive ? gap : -gap)) / 2, inner = discriminant(c) / (4 * outer);
    value = {positive ? outer : inner, positive ? inner : outer};
  }
};

/// The same conic with coefficients of order 1: no product of them over- or underflows.
C near_one(C c) {
  const double size = size_of(c);
  if (size > 0 && std::isfinite(size))
    for (double& q : c.q) q /= size;
  return c;
}

}  // namespace

ConicClass classify(const Conic<double>& conic) { return classify_exactly(conic); }
ConicClass classify(const Conic<Rational>& conic) { return classify_exactly(conic); }

std::string_view name_of(const ConicClass& c) {
  switch (c.type) {
    case ConicType::ellipse:
      return c.circular ? "circle" : "ellipse";
    case ConicType::imaginary_ellipse:
      return c.circular ? "imaginary circle" : "imaginary ellipse";
    case ConicType::hyperbola:
      return c.rectangular ? "rectangular hyperbola" : "hyperbola";
    case ConicType::parabola:
      return "parabola";
    case ConicType::crossing_lines:
      return c.rectangular ? "perpendicular lines" : "crossing lines";
    case ConicType::point:
      return "point";
    case ConicType::parallel_lines:
      return "parallel lines";
    case ConicType::complex_parallel_lines:
      return "complex parallel lines";
    case ConicType::coincident_lines:
      return "coincident lines";
    case ConicType::line_and_infinity:
      return "line and the line at infinity";
    case ConicType::infinity_twice:
      return "line at infinity, twice";
    case ConicType::everything:
      return "every point";
  }
  return {};
}

Vector2 centre_of(const C& given) {
  const C c = near_one(given);
  const auto& q = c.q;
  return Vector2(difference_of_products(q[3], q[5], 2 * q[1], q[4]),
                 difference_of_products(q[4], q[5], 2 * q[0], q[3])) /
         discriminant(c);
}

ConicAxes axes_of(const C& given) {
  const C c = near_one(given);
  const Principal p(c);
  const Vector2 centre = centre_of(c);
  const double there = c.q[2] + (c.q[4] * centre[0] + c.q[3] * centre[1]) / 2;
  ConicAxes out{centre, p.axis, {-there / p.value[0], -there / p.value[1]}};
  if (out.square[0] < out.square[1]) {
    std::swap(out.square[0], out.square[1]);
    out.axis = {out.axis[1], Vector2(-out.axis[0])};
  }
  return out;
}

std::array<Vector2, 2> asymptote_directions(const C& c) {
  const Principal p(c);
  const double u = std::sqrt(std::abs(p.value[1])), v = std::sqrt(std::abs(p.value[0]));
  return {Vector2(u * p.axis[0] + v * p.axis[1]).normalized(),
          Vector2(u * p.axis[0] - v * p.axis[1]).normalized()};
}

ParabolaFrame parabola_frame(const C& given) {
  const C c = near_one(given);
  const bool steep = std::abs(c.q[0]) > std::abs(c.q[1]);
  Vector2 axis = Vector2(steep ? c.q[5] : 2 * c.q[1], steep ? -2 * c.q[0] : -c.q[5]).normalized();
  const double trace = c.q[0] + c.q[1];
  double parameter = -(c.q[4] * axis[0] + c.q[3] * axis[1]) / (2 * trace);
  if (parameter < 0) parameter = -parameter, axis = -axis;
  const Vector2 normal(-axis[1], axis[0]);
  const double v = -(c.q[4] * normal[0] + c.q[3] * normal[1]) / (2 * trace);
  const double u = (c.q[2] / trace - v * v) / (2 * parameter);
  return {u * axis + v * normal, axis, parameter};
}

std::vector<LinearForm<double>> lines_of(const C& c, ConicType type) {
  const auto lines = [&c](int count) {
    Conic<Quad> quad;  // minors of doubles have their exact sign in 113 bits
    for (int i = 0; i < 6; ++i) quad.q[i] = c.q[i];
    const LinePair<Quad> pair = detail::split(quad);
    std::vector<LinearForm<double>> out{pair.first.cast<double>(), pair.second.cast<double>()};
    out.resize(static_cast<std::size_t>(count));
    return out;
  };
  switch (type) {
    case ConicType::crossing_lines:
    case ConicType::parallel_lines:
    case ConicType::line_and_infinity:
      return lines(2);
    case ConicType::coincident_lines:
    case ConicType::infinity_twice: {
      const Matrix<double, 3, 3> m = doubled_matrix<double, 3>(c);
      int k = 0;
      m.diagonal().cwiseAbs().maxCoeff(&k);
      return {m.col(k)};
    }
    default:
      return {};
  }
}

Point2<double> real_point(const C& c) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(doubled_matrix<double, 3>(c));
  const Point2<double> x = std::sqrt(-eigen.eigenvalues()[0]) * eigen.eigenvectors().col(2) +
                           std::sqrt(eigen.eigenvalues()[2]) * eigen.eigenvectors().col(0);
  return x.normalized();
}

}  // namespace burmester
