// A pose space: one geometry, seen as an algebra whose points, up to scale, are the displacements.
//
// Laws (modules/framework/conformance.hpp checks every one of them for every space):
//   1. norm(product(x, y)) = norm(x) norm(y); norm is 0 exactly where x is no displacement.
//   2. product is associative; point(Pose{}), the identity, is its unit up to scale.
//   3. product(x, conjugate(x)) = norm(x) times the unit.
//   4. act(x, a) is norm(x) times the moved feature x(a), a polynomial without division, and (x y)(a) = x(y(a)):
//      displacements act from the left. Different displacements move some feature differently.
//   5. Displacements are isometries: distances between features do not change.
//   6. gap(x, y) = 0 exactly for multiples of each other, of either sign; it is symmetric and at most 1.
//   7. pose(point(p)) is p again (same displacement), point(pose(x)) is x up to scale.
//   8. nudged(p, u) moves p by its local coordinates u, lengths and radians: p itself at u = 0, and nearby the dof
//      directions are independent.
// Notation: x = point of P^ambient, a = feature (what a pivot is a point of: the plane, the unit sphere).
#pragma once

#include <concepts>
#include <string_view>

#include "burmester/geometry/random.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

template <class S>
using PointOf = Vector<double, S::ambient + 1>;
template <class S>
using FeatureOf = Vector<double, S::feature_size>;

template <class S>
concept PoseSpace = requires(const typename S::Pose p, const PointOf<S> x, const FeatureOf<S> a,
                             const Vector<double, S::dof> u, Random random) {
  requires std::default_initializable<typename S::Pose>;  // the identity
  { S::name } -> std::convertible_to<std::string_view>;
  requires S::dof >= 1 && S::ambient >= S::dof && S::feature_size >= 1;
  // Exact data: plain doubles, read as exact numbers by solvers, certificates and oracles.
  { S::template point<double>(p) } -> std::same_as<PointOf<S>>;
  { S::pose(x) } -> std::same_as<typename S::Pose>;
  { S::template product<double>(x, x) } -> std::same_as<PointOf<S>>;
  { S::template conjugate<double>(x) } -> std::same_as<PointOf<S>>;
  { S::template norm<double>(x) } -> std::same_as<double>;
  { S::template act<double>(x, a) } -> std::same_as<FeatureOf<S>>;
  { S::nudged(p, u) } -> std::same_as<typename S::Pose>;
  { S::gap(x, x) } -> std::same_as<double>;
  { S::distance(a, a) } -> std::same_as<double>;  // length units; radians on the sphere
  { S::random_pose(random) } -> std::same_as<typename S::Pose>;
  { S::random_feature(random) } -> std::same_as<FeatureOf<S>>;
};

/// The displacement g x h^-1: pose x seen after a change g of the fixed frame and h of the moving frame.
template <PoseSpace S>
PointOf<S> reframed(const PointOf<S>& g, const PointOf<S>& x, const PointOf<S>& h) {
  return S::template product<double>(S::template product<double>(g, x), S::template conjugate<double>(h));
}

}  // namespace burmester
