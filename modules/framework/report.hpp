// Solver and report: poses and options in, one report out, whatever the number of poses.
//
// A report carries its status: "no real dyad exists" and "these poses are degenerate" are answers, not errors.
// Every fast solver has a slow, obvious one behind the same interface; tests hold the two against each other.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "burmester/modules/framework/dyad_type.hpp"

namespace burmester {

/// One dyad of a report. Lengths in the units of the poses, angles in radians.
template <class Design>
struct Found {
  Design design;
  double residual = 0;                 ///< largest |residual| over the poses
  std::optional<double> condition;     ///< modules/framework/condition.hpp
  std::optional<double> departure;     ///< of a slider: how far the circle that was solved for leaves the line
  std::optional<SliderRecord> slider;  ///< of an RR: the slider that it nearly is
  Certificate certificate;
};

/// List: the module's DyadList.
template <class List>
struct Report {
  using Dyads = List;
  Status status = Status::none;
  std::string message;
  SolutionCounts counts;
  std::vector<Found<typename List::Design>> dyads;
  std::vector<std::string> warnings;
  std::vector<CurveRecord> curves;  ///< where the dyads make a curve
  FamilyRecord family;              ///< where they make more, or a line of partners
};

template <class A>
concept Solver = requires(const A solver, std::span<const typename A::Pose> poses) {
  typename A::Dyads;
  { A::name } -> std::convertible_to<std::string_view>;
  { A::answers } -> std::convertible_to<std::string_view>;
  { solver.solve(poses) } -> std::same_as<Report<typename A::Dyads>>;
};

/// Largest |residual| of the design over the poses.
template <DyadType D>
double largest_residual(const typename D::Design& design, std::span<const typename D::Space::Pose> poses) {
  double largest = 0;
  for (const auto& pose : poses) largest = std::max(largest, std::abs(D::residual(design, pose)));
  return largest;
}

/// Puts the dyads in the order in which results list them: by type in the order of the list, then by length or arc.
template <class List>
void sort_dyads(Report<List>& report) {
  const auto length = [](const auto& found) {
    return List::visit(found.design, []<class D>(const typename D::Design& d) {
      const DyadRecord record = D::record(d);
      return record.length ? *record.length : record.arc.value_or(0);
    });
  };
  std::stable_sort(report.dyads.begin(), report.dyads.end(), [&](const auto& a, const auto& b) {
    if (a.design.index() != b.design.index()) return a.design.index() < b.design.index();
    return length(a) < length(b);
  });
}

/// The dyad as it is shown. Where a sign is a matter of taste (axes), coordinates that may be zero do not choose it.
template <class List>
DyadRecord shown_record(const Found<typename List::Design>& found) {
  const double zero = found.certificate.certified ? found.certificate.radius : 0;
  return List::visit(found.design, [&]<class D>(const typename D::Design& d) {
    if constexpr (requires { D::record(d, zero); })
      return D::record(d, zero);
    else
      return D::record(d);
  });
}

/// The dyads as plain records, numbered from 1 in the order of the report.
template <class List>
std::vector<DyadRecord> records_of(const Report<List>& report) {
  std::vector<DyadRecord> out;
  for (const auto& found : report.dyads) {
    DyadRecord record = shown_record<List>(found);
    record.id = static_cast<int>(out.size()) + 1;
    record.residual = found.residual;
    record.condition = found.condition;
    record.departure = found.departure;
    record.slider = found.slider;
    record.certificate = found.certificate;
    out.push_back(std::move(record));
  }
  return out;
}

}  // namespace burmester
