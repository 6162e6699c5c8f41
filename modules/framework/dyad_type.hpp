// A dyad type: a family of constraints on poses, with the laws that bind it to its space and to its lifted family.
//
// Laws (checked by modules/framework/conformance.hpp; x pose, d design, g and h changes of frame):
//   1. Covariance: |residual(moved(d, g, h), g x h^-1)| = |residual(d, x)|.
//   2. Inverse: |residual(inverse(d), x^-1)| = |residual(d, x)|, fixed and moving exchanged; inverse twice is the
//      design again (RR <-> RR, PR <-> RP, PP <-> PP).
//   3. Effectiveness: a random design is not satisfied by a random pose; some poses satisfy it; the `parameters`
//      local coordinates are independent.
// and for a type with a lifted form k in the family's R^dimension:
//   4. row(x) . encode(d) = 0 exactly where residual(d, x) = 0: it is norm(x) times a function of the residual.
//   5. relations(encode(d)) = 0, and decode(encode(d)) is d up to the freedom of its coordinates.
//   6. Rows of random poses span R^dimension.
// So n poses are n linear equations on k, and the dyads are where their solution space meets the relations.
#pragma once

#include <concepts>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>

#include "burmester/modules/framework/pose_space.hpp"
#include "burmester/modules/framework/record.hpp"

namespace burmester {

template <class D>
concept DyadType = PoseSpace<typename D::Space> &&
    requires(const typename D::Design d, const typename D::Space::Pose x, const PointOf<typename D::Space> g,
             const Vector<double, D::parameters> u, Random random) {
      { D::name } -> std::convertible_to<std::string_view>;  // joints from the fixed to the moving body: RR, PR, ..
      requires D::parameters >= 1;                           // so many poses leave finitely many designs
      { D::residual(d, x) } -> std::same_as<double>;         // signed distance from being met; length units or radians
      { D::moved(d, g, g) } -> std::same_as<typename D::Design>;
      { D::inverse(d) } -> std::same_as<typename D::Inverse::Design>;
      { D::nudged(d, u) } -> std::same_as<typename D::Design>;  // local coordinates: lengths and radians
      { D::random_design(random) } -> std::same_as<typename D::Design>;
      { D::record(d) } -> std::same_as<DyadRecord>;          // what people and files see
    };

template <class F>
concept LiftedFamily = PoseSpace<typename F::Space> &&
    requires(const typename F::Space::Pose x, const Vector<double, F::dimension> k) {
      requires F::dimension > F::Space::ambient;
      { F::template row<double>(x) } -> std::same_as<Vector<double, F::dimension>>;
      { F::template relations<double>(k) } -> std::same_as<Vector<double, F::relation_count>>;
      { F::decode(k) };  // std::optional of a std::variant of designs: empty where k is no dyad
    };

/// A dyad type with a lifted form in the family D::Family.
template <class D>
concept LiftedDyadType = DyadType<D> && LiftedFamily<typename D::Family> && requires(const typename D::Design d) {
  { D::encode(d) } -> std::same_as<Vector<double, D::Family::dimension>>;
};

/// The list of a module's dyad types; tests, the module's face and the general search read it.
template <class... D>
struct DyadList {
  using Design = std::variant<typename D::Design...>;
  template <class F>
  static void for_each(F f) {
    (f.template operator()<D>(), ...);
  }
  /// Calls f.operator()<D>(d) with the type and design that `any` holds.
  template <class F>
  static auto visit(const Design& any, F f) {
    return std::visit([&]<class X>(const X& d) { return f.template operator()<TypeOf<X>>(d); }, any);
  }

 private:
  template <class X>
  struct Find {
    template <class Candidate>
    using If = std::conditional_t<std::is_same_v<typename Candidate::Design, X>, std::tuple<Candidate>, std::tuple<>>;
    using type = std::tuple_element_t<0, decltype(std::tuple_cat(std::declval<If<D>>()...))>;
  };
  template <class X>
  using TypeOf = typename Find<X>::type;
};

}  // namespace burmester
