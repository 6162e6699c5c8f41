// The laws of modules/framework/dyad_type.hpp, by number. Designs are compared by what they say about poses,
// so that no law needs to know a design's coordinates or what freedom they have.
#pragma once

#include <Eigen/SVD>
#include <algorithm>

#include "burmester/modules/framework/laws.hpp"
#include "burmester/modules/framework/local.hpp"

namespace burmester::laws {

/// The numbers of a record, in one list.
inline std::vector<double> numbers_of(const DyadRecord& record) {
  std::vector<double> out = record.fixed;
  out.insert(out.end(), record.moving.begin(), record.moving.end());
  if (record.line) {
    out.insert(out.end(), record.line->point.begin(), record.line->point.end());
    out.push_back(record.line->angle);
  }
  for (const auto& value : {record.length, record.arc, record.angle})
    if (value) out.push_back(*value);
  return out;
}

template <DyadType D>
std::string text_of(const typename D::Design& d) {
  const std::vector<double> numbers = numbers_of(D::record(d));
  const Eigen::Map<const Eigen::VectorXd> values(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  return std::string("d = ") + std::string(D::name) + " " + Findings::show(values);
}

/// 1 + the largest number that a reader would see: the design's size, length units.
template <DyadType D>
double size_of(const typename D::Design& d) {
  double size = 0;
  for (const double value : numbers_of(D::record(d))) size = std::max(size, std::abs(value));
  return 1 + size;
}

template <PoseSpace S>
std::vector<typename S::Pose> random_poses(Random& random, int count) {
  std::vector<typename S::Pose> out;
  for (int i = 0; i < count; ++i) out.push_back(S::random_pose(random));
  return out;
}

/// Some pose near which the design's residual is `target`; empty after ten tries.
template <DyadType D>
std::optional<typename D::Space::Pose> find_pose(const typename D::Design& d, Random& random,
                                                 double target = 0) {
  for (int i = 0; i < 10; ++i)
    if (const auto pose = pose_with_residual<D>(d, D::Space::random_pose(random), target)) return pose;
  return std::nullopt;
}

template <DyadType D>
void residual_is_covariant(Findings& f) {  // 1
  using S = typename D::Space;
  Pool<S> pool(f.random);
  for (int i = 0; i < trials; ++i) {
    const typename D::Design d = D::random_design(f.random);
    const Element<S> x = pool.draw(), g = pool.draw(), h = pool.draw();
    const auto inputs = [&] {
      return text_of<D>(d) + "\n  " + x.text("x") + "\n  " + g.text("g") + "\n  " + h.text("h");
    };
    const typename D::Design moved = D::moved(d, g.x, h.x);
    const double spread = x.size() * g.size() * h.size();
    f.expect_near(std::abs(D::residual(moved, S::pose(reframed<S>(g.x, x.x, h.x)))),
                  std::abs(D::residual(d, x.pose())), rounding<S> * size_of<D>(d) * spread * spread,
                  "|residual(moved(d, g, h), g x h^-1)| = |residual(d, x)|", inputs);
  }
}

template <DyadType D>
void inverse_exchanges_the_bodies(Findings& f) {  // 2
  using S = typename D::Space;
  using I = typename D::Inverse;
  static_assert(std::is_same_v<typename I::Inverse, D>, "the inverse's inverse is the type itself");
  Pool<S> pool(f.random);
  for (int i = 0; i < trials; ++i) {
    const typename D::Design d = D::random_design(f.random);
    const typename I::Design inverse = D::inverse(d);
    const Element<S> x = pool.draw();
    const auto inputs = [&] {
      return text_of<D>(d) + "\n  inverse " + text_of<I>(inverse) + "\n  " + x.text();
    };
    const double tolerance = rounding<S> * size_of<D>(d) * x.size() * x.size();
    const double residual = std::abs(D::residual(d, x.pose()));
    f.expect_near(std::abs(I::residual(inverse, S::pose(S::template conjugate<double>(x.x)))), residual,
                  tolerance, "|residual(inverse(d), x^-1)| = |residual(d, x)|", inputs);
    f.expect_near(std::abs(D::residual(I::inverse(inverse), x.pose())), residual, tolerance,
                  "inverse(inverse(d)) is d", inputs);
  }
}

template <DyadType D>
void design_constrains_poses(Findings& f) {  // 3
  using S = typename D::Space;
  int effective = 0;
  for (int i = 0; i < trials; ++i) {
    const typename D::Design d = D::random_design(f.random);
    effective += std::abs(D::residual(d, S::random_pose(f.random))) > 1e-4;
    f.expect(find_pose<D>(d, f.random).has_value(), "some pose satisfies the design",
             [&] { return text_of<D>(d); });
  }
  f.expect(effective > trials * 9 / 10, "a random design is not satisfied by a random pose",
           [&] { return std::to_string(trials - effective) + " of " + std::to_string(trials) + " are"; });
}

/// The derivative by the local coordinates has full rank: `parameters` is their number, and none is idle.
template <DyadType D>
void parameters_are_independent(Findings& f) {  // 3, counting
  int independent = 0;
  for (int i = 0; i < trials; ++i) {
    const typename D::Design d = D::random_design(f.random);
    const auto probes = random_poses<typename D::Space>(f.random, 4 * D::parameters);
    const auto stretch = Eigen::JacobiSVD<Eigen::MatrixXd>(design_jacobian<D>(d, probes)).singularValues();
    independent += stretch[D::parameters - 1] > 1e-4 * stretch[0];
    f.expect_near(disagreement<D>(D::nudged(d, Vector<double, D::parameters>::Zero()), d, probes), 0.0,
                  rounding<typename D::Space> * size_of<D>(d) * 100, "nudged(d, 0) is d",
                  [&] { return text_of<D>(d); });
  }
  f.expect(independent > trials * 9 / 10, "local coordinates are independent", [&] {
    return "only so for " + std::to_string(independent) + " of " + std::to_string(trials) + " designs";
  });
}

template <DyadType D>
void record_shows_the_design(Findings& f) {
  for (int i = 0; i < trials; ++i) {
    const typename D::Design d = D::random_design(f.random);
    const DyadRecord record = D::record(d);
    const std::vector<double> numbers = numbers_of(record);
    f.expect(record.type == D::name, "record(d).type is the type's name", [&] { return record.type; });
    f.expect(!numbers.empty() &&
                 std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }),
             "record(d) shows finite numbers", [&] { return text_of<D>(d); });
  }
}

// ---- Lifted types ----

template <LiftedDyadType D>
double form(const Vector<double, D::Family::dimension>& k, const typename D::Space::Pose& x) {
  using S = typename D::Space;
  return D::Family::template row<double>(x).dot(k) / S::template norm<double>(S::template point<double>(x));
}

/// How much row(x) . k / norm(x) may change when the residual changes by `change`: both are bounded by the
/// sizes of row and k, and the form is at most quadratic in lengths.
template <LiftedDyadType D>
double form_tolerance(const Vector<double, D::Family::dimension>& k, const typename D::Space::Pose& x,
                      double change) {
  using S = typename D::Space;
  const PointOf<S> p = S::template point<double>(x);
  const double row = D::Family::template row<double>(x).norm() / S::template norm<double>(p);
  const double slack = change + rounding<S>;
  return 16 * slack * row * k.norm();
}

template <LiftedDyadType D>
void form_is_a_function_of_the_residual(Findings& f) {  // 4
  using S = typename D::Space;
  Pool<S> pool(f.random);
  for (int i = 0; i < trials; ++i) {
    const typename D::Design d = D::random_design(f.random);
    const Vector<double, D::Family::dimension> k = D::encode(d);
    const Element<S> x = pool.draw();
    const double residual = D::residual(d, x.pose()), value = form<D>(k, x.pose());
    const auto inputs = [&] { return text_of<D>(d) + "\n  " + x.text(); };
    if (std::abs(residual) > 0.1)
      f.expect(std::abs(value) > form_tolerance<D>(k, x.pose(), 1e-9),
               "row . k != 0 where the residual is not 0", inputs);
    if (const auto met = find_pose<D>(d, f.random))
      f.expect_near(form<D>(k, *met), 0.0, form_tolerance<D>(k, *met, std::abs(D::residual(d, *met))),
                    "row . k = 0 where the residual is 0", [&] {
                      return text_of<D>(d) + "\n  x = " + Findings::show(S::template point<double>(*met));
                    });
    if (const auto equal = find_pose<D>(d, f.random, residual)) {
      const double change = std::abs(D::residual(d, *equal) - residual);
      f.expect_near(
          form<D>(k, *equal), value, form_tolerance<D>(k, *equal, change) + form_tolerance<D>(k, x.pose(), 0),
          "equal residuals, equal row . k / norm",
          [&] { return inputs() + "\n  y = " + Findings::show(S::template point<double>(*equal)); });
    }
  }
}

template <LiftedDyadType D>
void encoded_designs_keep_the_relations(Findings& f) {  // 5
  using Family = typename D::Family;
  int kept_by_chance = 0;
  for (int i = 0; i < trials; ++i) {
    const typename D::Design d = D::random_design(f.random);
    const Vector<double, Family::dimension> k = D::encode(d);
    const Vector<double, Family::relation_count> zero = Vector<double, Family::relation_count>::Zero();
    f.expect_near(Family::template relations<double>(k), zero,
                  rounding<typename D::Space> * std::pow(1 + k.norm(), 3), "relations(encode(d)) = 0",
                  [&] { return text_of<D>(d) + "\n  k = " + Findings::show(k); });
    Vector<double, Family::dimension> other;
    for (int j = 0; j < Family::dimension; ++j) other[j] = f.random.normal();
    kept_by_chance += Family::template relations<double>(other).norm() < 1e-6;
  }
  f.expect(kept_by_chance < trials / 10, "a random k does not keep the relations", [] { return ""; });
}

/// Near length 0 or arc 0, where two designs of one k come together, k knows them only to the square root of
/// rounding.
template <LiftedDyadType D>
void decode_undoes_encode(Findings& f) {  // 5
  using Family = typename D::Family;
  for (int i = 0; i < trials; ++i) {
    const typename D::Design d = D::random_design(f.random);
    const Vector<double, Family::dimension> k = D::encode(d);
    const auto probes = random_poses<typename D::Space>(f.random, 2 * D::parameters);
    for (const double factor : {1.0, -1.0, 2.0, 1e-3}) {
      const auto inputs = [&] {
        return text_of<D>(d) + "\n  k = " + Findings::show(k) + " times " + Findings::show(factor);
      };
      const auto decoded = Family::decode(factor * k);
      const auto* again = decoded ? std::get_if<typename D::Design>(&*decoded) : nullptr;
      f.expect(again != nullptr, "decode(encode(d)) is of d's type", inputs);
      if (again)
        f.expect_near(disagreement<D>(*again, d, probes), 0.0,
                      std::sqrt(rounding<typename D::Space>) * size_of<D>(d), "decode(encode(d)) is d",
                      inputs);
    }
  }
  f.expect(!Family::decode(Vector<double, Family::dimension>::Zero()), "decode(0) is empty",
           [] { return ""; });
}

/// `dimension` is the number of independent conditions, so that n poses in general position give rank n.
template <LiftedDyadType D>
void rows_span_the_family(Findings& f) {  // 6
  using Family = typename D::Family;
  constexpr int n = Family::dimension;
  Eigen::Matrix<double, 4 * n, n> rows;
  for (int i = 0; i < 4 * n; ++i)
    rows.row(i) = Family::template row<double>(D::Space::random_pose(f.random)).normalized();
  const auto stretch = Eigen::JacobiSVD<Eigen::MatrixXd>(rows).singularValues();
  f.expect(stretch[n - 1] > 1e-4 * stretch[0], "rows of random poses span R^dimension",
           [&] { return "singular values " + Findings::show(stretch); });
}

template <DyadType D>
std::vector<Law> dyad_laws() {
  std::vector<Law> out{{"residual_is_covariant", &residual_is_covariant<D>},
                       {"inverse_exchanges_the_bodies", &inverse_exchanges_the_bodies<D>},
                       {"design_constrains_poses", &design_constrains_poses<D>},
                       {"parameters_are_independent", &parameters_are_independent<D>},
                       {"record_shows_the_design", &record_shows_the_design<D>}};
  if constexpr (LiftedDyadType<D>) {
    out.push_back({"form_is_a_function_of_the_residual", &form_is_a_function_of_the_residual<D>});
    out.push_back({"encoded_designs_keep_the_relations", &encoded_designs_keep_the_relations<D>});
    out.push_back({"decode_undoes_encode", &decode_undoes_encode<D>});
    out.push_back({"rows_span_the_family", &rows_span_the_family<D>});
  }
  return out;
}

template <DyadType D>
std::string subject_of() {
  return std::string(D::Space::name) + "." + std::string(D::name);
}

/// Empty if D keeps every law.
template <DyadType D>
Violations dyad_violations() {
  return violations(dyad_laws<D>(), subject_of<D>());
}

}  // namespace burmester::laws
