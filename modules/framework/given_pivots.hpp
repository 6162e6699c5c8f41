// Two and three poses, and given pivots: dyads that follow from linear equations, in any geometry whose displacements
// are correlations.
//
// n poses give n - 1 equations p^T N_j c = 0 on the moving pivot p and the fixed pivot c, both seen from pose 1
// (geometry/correlations.hpp). For a given p, or a given c with N_j transposed, each is a line of partners: the
// perpendicular bisector of two places of the pivot, on the sphere a great circle. So the partners of a given pivot are
//     two poses     a line,
//     three poses   the point where two lines meet: equations 7 and 8 of the spherical Burmester problem (J. Angeles,
//                   S. Bai), in the plane the circumcentre of three places (MECH 576, section 5.1),
//     more          in general none: the best fit over all circles and lines is listed.
// The pivot that two poses bring to one place is their pole, and its line is not determined: infinitely many partners.
// Everything is solved in rationals, for the data as they stand, and so is the question whether they determine the
// partner. It is asked again of data known to within a rounding: where the box of the partner then holds no direction,
// a warning names the reason.
//
// G, the geometry's part (planar/pivots.hpp, spherical/pivots.hpp): see PivotGeometry below.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "burmester/geometry/correlations.hpp"
#include "burmester/geometry/range.hpp"
#include "burmester/geometry/rational_interval.hpp"
#include "burmester/modules/framework/condition.hpp"
#include "burmester/modules/framework/counted.hpp"
#include "burmester/modules/framework/equal_poses.hpp"
#include "burmester/modules/framework/expect_pivots.hpp"
#include "burmester/modules/framework/local.hpp"
#include "burmester/modules/framework/problem.hpp"
#include "burmester/modules/framework/repeated.hpp"
#include "burmester/modules/framework/report.hpp"

namespace burmester {

/// Of the task size: where rounding is more, residuals do not tell whether poses are met.
inline constexpr double told_at_most = 1e-7;

/// The body that carries a pivot.
enum class Body { fixed, moving };

inline const char* name_of(Body body) { return body == Body::fixed ? "fixed" : "moving"; }
inline Body other(Body body) { return body == Body::fixed ? Body::moving : Body::fixed; }

/// The exact data of a pose over a number type.
template <class T>
using DataOf = std::array<T, 4>;

/// D with all its local coordinates but the `Free` ones held: what is left to choose for a given pivot.
template <DyadType D, std::array Free>
struct Holding : D {
  static constexpr int parameters = static_cast<int>(Free.size());
  static typename D::Design nudged(const typename D::Design& d, const Vector<double, parameters>& u) {
    Vector<double, D::parameters> all = Vector<double, D::parameters>::Zero();
    for (std::size_t i = 0; i < Free.size(); ++i) all[Free[i]] = u[static_cast<int>(i)];
    return D::nudged(d, all);
  }
};

/// Condition of a dyad of which one pivot is given; nothing where fewer poses leave it free. D: a Holding.
template <DyadType D, class Design>
std::optional<double> condition_of(const Design& design, std::span<const typename D::Space::Pose> poses) {
  if (poses.size() < D::parameters) return std::nullopt;
  return condition<D>(std::get<typename D::Design>(design), poses);
}

template <class G>
concept PivotGeometry = requires(const typename G::Pose pose, std::span<const typename G::Pose> poses, Body body,
                                 const std::vector<double> pivot, const DataOf<Rational> data,
                                 const std::vector<Rational> exact_pivot, const Point2<Rational> exact,
                                 const Point2<double> point) {
  typename G::Dyads;
  typename G::Space;
  // What people call a pivot, pivots, a pole, what partners of a pivot fill, and which one of these in two poses.
  { G::pivot } -> std::convertible_to<std::string_view>;
  { G::pivots } -> std::convertible_to<std::string_view>;
  { G::pole } -> std::convertible_to<std::string_view>;
  { G::locus } -> std::convertible_to<std::string_view>;
  { G::bisector } -> std::convertible_to<std::string_view>;
  { G::data(pose) } -> std::same_as<DataOf<double>>;
  /// Between the two poses: points as seen from the first.
  { G::template correlation<Rational>(data, data) } -> std::same_as<Correlation<Rational>>;
  { G::template seen<Rational>(body, data, exact_pivot) } -> std::same_as<Point2<Rational>>;
  /// The dyad of a given pivot (of `body`) and its partner as seen from pose 1; certified on request.
  { G::dyad(body, pivot, exact, poses, true) } -> std::same_as<Found<typename G::Dyads::Design>>;
  /// What was expected instead of this pivot; null if it can be used.
  { G::complaint(pivot) } -> std::same_as<const char*>;
  /// Best dyads for a given pivot, of each type; none where it has fewer than three different places.
  { G::fits(body, pivot, poses) } -> std::same_as<std::vector<Found<typename G::Dyads::Design>>>;
  { G::rounding(pivot, poses) } -> std::same_as<double>;  // residuals up to this are rounding
  { G::partners(body, pivot, point, pose) } -> std::same_as<PartnersRecord>;
  { G::along(point, point, 3) } -> std::same_as<std::vector<Point2<double>>>;  // of a line: points near the given one
  { G::grid(poses) } -> std::same_as<std::vector<std::vector<double>>>;        // fixed pivots to look at
  { G::pole_of(pose, pose) } -> std::same_as<std::optional<PoleRecord>>;       // nothing for equal poses
  { G::described(PoleRecord(), Units()) } -> std::same_as<std::string>;        // the displacement of two poses
};

namespace detail {

inline Rational middle(double x) { return Rational(x); }
inline Rational middle(const Rational& x) { return x; }
inline Rational middle(const RationalInterval& x) { return (x.low() + x.high()) / 2; }

/// A multiple of p that doubles can hold, however long or short p is. Precondition: not zero.
template <class T>
Point2<double> to_double(const Point2<T>& p) {
  const Point2<Rational> q(middle(p[0]), middle(p[1]), middle(p[2]));
  Rational largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::max(largest, Rational(abs(q[i])));
  return {approximate(Rational(q[0] / largest)), approximate(Rational(q[1] / largest)),
          approximate(Rational(q[2] / largest))};
}

inline Rational number(const Rational*, double x) { return Rational(x); }
/// A double that stands for any number that rounds to it, or nearly so.
inline RationalInterval number(const RationalInterval*, double x) {
  const Rational at(x), off = at * Rational(2 * unit_roundoff);
  return x < 0 ? RationalInterval(at + off, at - off) : RationalInterval(at - off, at + off);
}

inline bool may_be_zero(const Rational& x) { return x == 0; }
inline bool may_be_zero(const RationalInterval& x) { return contains_zero(x); }

template <class M>
bool may_vanish(const M& m) {
  for (Eigen::Index i = 0; i < m.size(); ++i)
    if (!may_be_zero(m.reshaped()[i])) return false;
  return true;
}

/// Whether at least three places of a pivot differ by more than the tolerance.
template <class Place>
bool three_differ(const std::vector<Place>& places, double tolerance) {
  std::vector<Place> seen;
  for (auto p = places.begin(); p != places.end() && seen.size() < 3; ++p)
    if (std::none_of(seen.begin(), seen.end(), [&](const Place& q) { return (*p - q).norm() <= tolerance; }))
      seen.push_back(*p);
  return seen.size() == 3;
}

}  // namespace detail

/// Lines of partners of one given pivot. T: Rational (exact data) or RationalInterval (data known to a rounding).
template <class G, class T>
class Partners {
 public:
  Partners(Body body, const std::vector<double>& pivot, std::span<const typename G::Pose> poses) : body_(body) {
    for (const auto& pose : poses) {
      const DataOf<double> data = G::data(pose);
      DataOf<T>& to = poses_.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) to[i] = number(data[i]);
    }
    for (const double x : pivot) pivot_.push_back(number(x));
  }
  /// Given and partner exchanged where the given one is fixed.
  Correlation<T> correlation(std::size_t from, std::size_t to) const {
    const Correlation<T> n = G::template correlation<T>(poses_[from], poses_[to]);
    return body_ == Body::moving ? n : Correlation<T>(n.transpose());
  }
  Point2<T> seen(std::size_t from) const { return G::template seen<T>(body_, poses_[from], pivot_); }
  LinearForm<T> line(std::size_t from, std::size_t to) const {
    return line_of_partners<T>(correlation(from, to), seen(from));
  }
  Point2<T> partner() const {
    return burmester::partner<T>(std::array<Correlation<T>, 2>{correlation(0, 1), correlation(0, 2)}, seen(0));
  }

 private:
  static T number(double x) { return detail::number(static_cast<const T*>(nullptr), x); }
  Body body_;
  std::vector<DataOf<T>> poses_;
  std::vector<T> pivot_;
};

/// Why two or three poses do not determine the line (the point) of partners; nothing where they do. T: Rational for the
/// data as they stand, RationalInterval for data known to a rounding.
template <class G, class T>
std::optional<std::string> undetermined(Body body, const std::vector<double>& pivot,
                                        std::span<const typename G::Pose> poses) {
  const Partners<G, T> partners(body, pivot, poses);
  const bool three = poses.size() == 3;
  if (!detail::may_vanish(three ? partners.partner() : partners.line(0, 1))) return std::nullopt;
  if (three && detail::may_vanish(partners.line(0, 1)) && detail::may_vanish(partners.line(0, 2)))
    return "it is at one place in all poses";
  for (const auto& [from, to] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
    if (to >= static_cast<int>(poses.size())) continue;
    const auto i = static_cast<std::size_t>(from), k = static_cast<std::size_t>(to);
    if (detail::may_vanish(partners.correlation(i, k))) return fmt::format("poses {} and {} are equal", i + 1, k + 1);
    if (detail::may_vanish(partners.line(i, k)))
      return fmt::format("it is the {} of poses {} and {}", G::pole, i + 1, k + 1);
  }
  return "its places in the poses are too close to each other for the accuracy of the data";
}

/// Members of the family of all dyads that meet two or three poses, over a grid of fixed pivots.
template <class G>
std::vector<DyadRecord> samples_of_family(std::span<const typename G::Pose> poses) {
  std::vector<DyadRecord> out;
  const auto add = [&](const std::vector<double>& fixed, const Point2<Rational>& partner) {
    Report<typename G::Dyads> one;
    one.dyads.push_back(G::dyad(Body::fixed, fixed, partner, poses, false));
    out.push_back(records_of(one).front());
    out.back().id = 0;
  };
  for (const std::vector<double>& fixed : G::grid(poses)) {
    if (undetermined<G, RationalInterval>(Body::fixed, fixed, poses)) continue;
    const Partners<G, Rational> partners(Body::fixed, fixed, poses);
    if (poses.size() == 3)
      add(fixed, partners.partner());
    else
      for (const Point2<double>& p :
           G::along(detail::to_double(partners.line(0, 1)), detail::to_double(partners.seen(0)), 3))
        add(fixed, p.template cast<Rational>());
  }
  return out;
}

/// The poles of all pairs of poses; none for equal poses.
template <class G>
std::vector<PoleRecord> poles_of(std::span<const typename G::Pose> poses) {
  std::vector<PoleRecord> out;
  for (std::size_t i = 0; i < poses.size(); ++i)
    for (std::size_t k = i + 1; k < poses.size(); ++k)
      if (auto pole = G::pole_of(poses[i], poses[k])) {
        pole->poses[0] = static_cast<int>(i) + 1, pole->poses[1] = static_cast<int>(k) + 1;
        out.push_back(std::move(*pole));
      }
  return out;
}

/// In words, with what rounding may have made of a zero as 0.
template <class G>
std::string described(PoleRecord pole, std::span<const typename G::Pose> poses, const Units& units) {
  const std::vector<double> at = pole.fixed;
  for (double& x : pole.fixed)
    if (std::abs(x) <= G::rounding(at, poses)) x = 0;
  return G::described(pole, units);
}

/// All dyads that meet two or three poses: poles, members of the family, and what kind of family it is.
template <class G>
Report<typename G::Dyads> family_of_dyads(std::span<const typename G::Pose> poses, const Units& units) {
  Report<typename G::Dyads> report;
  report.status = Status::family;
  report.counts.dimension = 5 - static_cast<int>(poses.size());
  report.family.poles = poles_of<G>(poses);
  report.family.samples = samples_of_family<G>(poses);
  if (report.family.poles.size() != poses.size() * (poses.size() - 1) / 2) {
    const auto same = [&](int i, int k) {
      return !G::pole_of(poses[static_cast<std::size_t>(i)], poses[static_cast<std::size_t>(k)]);
    };
    report.message = name_equal_poses(same, static_cast<int>(poses.size()));
    report.counts.dimension.reset();
  } else if (poses.size() == 2) {
    report.message =
        fmt::format("{0}a three-dimensional family of dyads: any moving {1}, with any fixed {1} on {2} (samples)",
                    described<G>(report.family.poles[0], poses, units), G::pivot, G::bisector);
  } else {
    report.message = fmt::format(
        "a two-dimensional family of dyads: one fixed {0} for each moving {0} and one moving {0} for each "
        "fixed {0}, but for poles (samples)",
        G::pivot);
  }
  return report;
}

/// What a problem asks for that its other parts leave no room for. G: as for GivenPivots.
template <class G>
std::vector<std::string> ignored_requests(const Problem& problem) {
  std::vector<std::string> warnings;
  const bool given = !problem.fixed.empty() || !problem.moving.empty();
  if (!problem.near.empty() && (problem.poses.size() != 4 || given))
    warnings.push_back(fmt::format("near: only four poses without given {} leave a choice; ignored", G::pivots));
  if (problem.linkages && (problem.poses.size() != 4 || given))
    warnings.push_back(fmt::format("linkages: only four poses without given {} leave a choice; ignored", G::pivots));
  if (!problem.weights.empty() && given)
    warnings.push_back(fmt::format("weights: fits with given {} count all poses alike; ignored", G::pivots));
  else if (!problem.weights.empty() && problem.poses.size() <= 5)
    warnings.push_back("weights: up to five poses are met exactly; ignored");
  return warnings;
}

/// The dyads with the fixed and moving pivots that a problem gives, any number of poses from two.
template <class G>
class GivenPivots {
 public:
  using Dyads = typename G::Dyads;
  using Pose = typename G::Pose;
  GivenPivots(const Problem& problem, std::span<const Pose> poses) : problem_(problem), poses_(poses) {}

  Report<Dyads> solve() {
    for (const Body body : {Body::fixed, Body::moving}) {
      const auto& pivots = body == Body::fixed ? problem_.fixed : problem_.moving;
      expect_pivots<G>(name_of(body), pivots);
      for (auto p = pivots.begin(); p != pivots.end(); ++p)
        if (const auto same = std::find(pivots.begin(), p, *p); same != p)
          report_.warnings.push_back(fmt::format("{0}[{1}] is {0}[{2}] again: listed once", name_of(body),
                                                 p - pivots.begin(), same - pivots.begin()));
        else
          add(body, *p, fmt::format("{}[{}]", name_of(body), p - pivots.begin()));
    }
    if (poses_.size() <= 3) report_.family.poles = poles_of<G>(poses_);
    drop_repeated<G>(report_, poses_, G::pivots);
    conclude();
    return report_;
  }

 private:
  void add(Body body, const std::vector<double>& pivot, const std::string& name) {
    ++given_;
    if (poses_.size() > 3) return add_fits(body, pivot, name);
    const Partners<G, Rational> partners(body, pivot, poses_);
    if (const auto reason = undetermined<G, Rational>(body, pivot, poses_))
      return add_undetermined(body, pivot, partners, name + ": " + *reason);
    if (const auto reason = undetermined<G, RationalInterval>(body, pivot, poses_))
      report_.warnings.push_back(
          fmt::format("{}: within rounding {}; the answer is that of the numbers as they stand", name, *reason));
    if (poses_.size() == 3)
      report_.dyads.push_back(G::dyad(body, pivot, partners.partner(), poses_, problem_.certify));
    else
      add_line(body, pivot, partners);
  }

  void add_line(Body body, const std::vector<double>& pivot, const Partners<G, Rational>& partners) {
    dimension_ = std::max(dimension_, 1);
    const Point2<double> line = detail::to_double(partners.line(0, 1)), seen = detail::to_double(partners.seen(0));
    report_.family.partners.push_back(G::partners(body, pivot, line, poses_[0]));
    Report<Dyads> samples;
    for (const Point2<double>& p : G::along(line, seen, 11))
      samples.dyads.push_back(G::dyad(body, pivot, p.template cast<Rational>(), poses_, false));
    for (DyadRecord& record : records_of(samples)) {
      record.id = 0;
      report_.family.samples.push_back(std::move(record));
    }
  }

  /// One of the two lines may still be known: then it is the line of partners.
  void add_undetermined(Body body, const std::vector<double>& pivot, const Partners<G, Rational>& partners,
                        const std::string& reason) {
    for (std::size_t k = 1; k < poses_.size(); ++k)
      if (const auto line = partners.line(0, k); !detail::may_vanish(line)) {
        report_.family.partners.push_back(G::partners(body, pivot, detail::to_double(line), poses_[0]));
        dimension_ = std::max(dimension_, 1);
        return undetermined_.push_back(fmt::format("{}, its partners fill a {}", reason, G::locus));
      }
    dimension_ = 2;
    undetermined_.push_back(fmt::format("{}, every {} {} is a partner", reason, name_of(other(body)), G::pivot));
  }

  void add_fits(Body body, const std::vector<double>& pivot, const std::string& name) {
    auto fits = G::fits(body, pivot, poses_);
    if (fits.empty()) undetermined_.push_back(name + ": fewer than three different places, infinitely many partners");
    const double rounding = G::rounding(pivot, poses_);
    const bool tells = rounding <= told_at_most * extent<typename G::Space>(poses_);
    if (!tells)
      report_.warnings.push_back(name + ": rounding of numbers so large hides whether a dyad meets the poses");
    const auto met = [&](const auto& found) { return tells && found.residual <= rounding; };
    if (std::any_of(fits.begin(), fits.end(), met))
      std::erase_if(fits, [&](const auto& found) { return !met(found); }), ++met_;
    if (!fits.empty()) fitted_.push_back(body);
    for (auto& found : fits) report_.dyads.push_back(std::move(found));
  }

  void conclude() {
    const std::size_t n = poses_.size(), count = report_.dyads.size();
    const std::string given = fmt::format("given {}", given_ == 1 ? G::pivot : G::pivots);
    const std::string some_given = fmt::format("{}{}", given_ == 1 ? "a " : "", given);
    if (n <= 3) report_.counts.dimension = dimension_;
    if (n == 2) {
      report_.status = Status::family;
      report_.message = fmt::format("two poses and {}: a {}-dimensional family of dyads", some_given,
                                    dimension_ == 1 ? "one" : "two");
      if (!report_.family.partners.empty())
        report_.message += fmt::format(", the partners of {} {} fill a {} (partners, samples)",
                                       given_ == 1 ? "the" : undetermined_.empty() ? "each" : "each other", G::pivot,
                                       G::locus);
    } else if (n == 3) {
      report_.status = undetermined_.empty() ? Status::exact : Status::degenerate;
      report_.message = fmt::format("{} for the {}, by linear equations", counted(count, "dyad"), given);
      if (undetermined_.empty()) report_.counts.complex = static_cast<int>(count);
      if (undetermined_.empty()) report_.counts.real = static_cast<int>(count);
      report_.counts.certified =
          undetermined_.empty() && std::all_of(report_.dyads.begin(), report_.dyads.end(),
                                               [](const auto& d) { return d.certificate.certified; });
      if (report_.counts.certified) report_.message += ", proved";
    } else {
      const bool exact = met_ == given_;
      report_.status = !undetermined_.empty() ? Status::degenerate : exact ? Status::exact : Status::approximate;
      if (undetermined_.empty()) report_.counts.dimension = 0;
      if (exact) report_.counts.real = static_cast<int>(count);
      report_.message = fmt::format(
          "{} poses and {}: {}", n, some_given,
          exact ? "met but for rounding"
                : "more conditions than unknowns; the best fits over circles and lines, with their residuals");
      if (fitted_.size() == 1 && count > 1)
        report_.message += fmt::format("; all these dyads share the given {} {}: no two of them make a linkage",
                                       name_of(fitted_[0]), G::pivot);
    }
    for (const std::string& reason : undetermined_) report_.message += "; " + reason;
  }

  const Problem& problem_;
  std::span<const Pose> poses_;
  Report<Dyads> report_;
  std::vector<std::string> undetermined_;
  std::vector<Body> fitted_;  // of the given pivots with fits
  std::size_t given_ = 0, met_ = 0;
  int dimension_ = 0;  // of the dyads of two or three poses
};

}  // namespace burmester
