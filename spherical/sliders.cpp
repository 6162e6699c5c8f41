#include "burmester/spherical/sliders.hpp"

#include <cmath>

#include "burmester/modules/framework/curve_report.hpp"
#include "burmester/spherical/axes_family.hpp"
#include "burmester/spherical/five_pose_certificate.hpp"

namespace burmester::spherical {
namespace {

/// a^T N b' = (R a) . b' times the squared norm of the quaternion of R.
Correlation<Rational> right_angle_after(const Quaternion<Rational>& turn) {
  Correlation<Rational> n;
  for (int i = 0; i < 3; ++i) n.row(i) = Space::act<Rational>(turn, Vector<Rational, 3>::Unit(i)).transpose();
  return n;
}

Bilinear<Rational> right_angles(FourPoses poses) {
  Bilinear<Rational> n;
  for (std::size_t j = 0; j < 4; ++j) n[j] = right_angle_after(relative_rotation<Rational>(poses[0], poses[j]));
  return n;
}

std::vector<FoundSlider> found_sliders(const std::vector<EnclosedAxes>& all, FourPoses poses) {
  const CertifiedAxes certified = certified_axes(all, poses[0], 0);
  std::vector<FoundSlider> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PR::Design design{certified.axes[i].fixed, certified.axes[i].moving};
    const double radius = error_bound(design, certified.boxes[i], poses[0]);
    FoundSlider& found = out.emplace_back();
    found.multiplicity = certified.boxes[i].multiplicity;
    found.slider = found_slider<PR, Dyads>(design, poses);
    if (std::isfinite(radius)) found.slider.certificate = {true, radius, Rung::exact};
  }
  return out;
}

}  // namespace

std::optional<std::vector<FoundSlider>> sliders(FourPoses poses) {
  const auto all = exact_axes(right_angles(poses));
  if (!all) return std::nullopt;
  return found_sliders(*all, poses);
}

std::optional<SliderFamily> slider_family(FourPoses poses) {
  const auto family = axes_family(right_angles(poses));
  if (!family) return std::nullopt;
  SliderFamily out{family->moving, family->fixed, {}};
  if (family->isolated) out.isolated = found_sliders(*family->isolated, poses);
  return out;
}

}  // namespace burmester::spherical
