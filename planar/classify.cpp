#include "burmester/planar/classify.hpp"

#include <vector>

#include "burmester/geometry/quad.hpp"

namespace burmester::planar {
namespace {

Vector2 to_double(const auto& v) { return {static_cast<double>(v[0]), static_cast<double>(v[1])}; }

/// The best line through the places of a pivot; place(pose, pivot) with poses seen from the reference pose's origin, so
/// that a far origin costs nothing.
template <class Place>
std::optional<Slider> line_through(const char* type, const Vector2& pivot, std::span<const Pose> poses,
                                   const Pose& reference, Place place) {
  if (!pivot.allFinite()) return std::nullopt;
  std::vector<Vector2> places;
  for (const Pose& p : poses) places.push_back(place(Pose{p.x - reference.x, p.y - reference.y, p.X3, p.X4}, pivot));
  const FittedLine fit = fit_line(places);
  return Slider{type, line_of(fit), fit.departure};
}

std::optional<Slider> best_slider(const Vector2& moving, const Vector2& fixed, FivePoses poses, const Pose& reference) {
  const auto a = PR_through(moving, poses, reference), b = RP_through(fixed, poses, reference);
  if (!a || (b && b->departure < a->departure)) return b;
  return a;
}

/// Pivots 2^31 lengths of the task away or farther: rounding may put them anywhere, and the circle of a task length
/// leaves its line by less than 2^-34 of it.
struct FarPivots {
  bool fixed, moving;
};
template <class T>
FarPivots far_pivots(const Anchored<T>& w, const Anchor& anchor) {
  const T e(anchor.turn), least = w.cwiseAbs().maxCoeff() * T(0x1p-32);
  const Vector<T, 3> for_fixed{w[0], w[3], w[4]};                                          // K0, U
  const Vector<T, 3> for_moving{w[0], T(e * w[1] - 2 * w[3]), T(e * w[2] - 2 * w[4])};  // K0, e K
  return {for_fixed.cwiseAbs().maxCoeff() <= least, for_moving.cwiseAbs().maxCoeff() <= least};
}

}  // namespace

std::optional<Slider> PR_through(const Vector2& moving, std::span<const Pose> poses, const Pose& reference) {
  auto slider = line_through("PR", moving, poses, reference, to_fixed);
  if (slider) slider->line.offset += slider->line.normal.dot(Vector2(reference.x, reference.y));
  return slider;
}

std::optional<Slider> RP_through(const Vector2& fixed, std::span<const Pose> poses, const Pose& reference) {
  return line_through("RP", fixed, poses, reference, to_moving);
}

Line line_of(const FittedLine& fit) {
  const Vector2 normal{-fit.direction[1], fit.direction[0]};
  return {normal, normal.dot(fit.centre)};
}

template <class T>
Found<Dyads::Design> classify(const Anchored<T>& w, const Anchor& anchor, FivePoses poses, double task_size,
                              double threshold) {
  using std::sqrt;
  const AnchoredPivots<T> pivots = decode_pivots(w, anchor);
  const Pose& reference = poses[anchor.reference];
  const Pose turn{0, 0, reference.X3, reference.X4};
  const T length = T(anchor.length);
  const Vector2 moving = to_moving(turn, to_double(Vector<T, 2>(pivots.moving * length)));
  const Vector2 fixed = to_double(Vector<T, 2>(pivots.fixed * length));
  const double radius = static_cast<double>(T((pivots.moving - pivots.fixed).norm() * length));

  const FarPivots far = far_pivots(w, anchor);
  Found<Dyads::Design> found;
  std::optional<Slider> slider;
  if (far.fixed != far.moving)
    slider = far.fixed ? PR_through(moving, poses, reference) : RP_through(fixed, poses, reference);
  else if (!(radius <= task_size))
    slider = best_slider(moving, fixed, poses, reference);
  if (slider && (far.fixed != far.moving || slider->departure <= threshold * task_size)) {
    found.departure = slider->departure;
    if (slider->type[0] == 'P')
      found.design = PR::Design{moving, slider->line};
    else
      found.design = RP::Design{fixed + Vector2(reference.x, reference.y), slider->line};
    return found;
  }
  found.design = RR::Design{fixed + Vector2(reference.x, reference.y), moving, radius};
  if (slider && slider->departure <= near_slider_departure * task_size)
    found.slider = SliderRecord{slider->type, slider->line.record(), slider->departure};
  return found;
}

template Found<Dyads::Design> classify(const Anchored<double>&, const Anchor&, FivePoses, double, double);
template Found<Dyads::Design> classify(const Anchored<Quad>&, const Anchor&, FivePoses, double, double);

}  // namespace burmester::planar
