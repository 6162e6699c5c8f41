// The examples of J. Angeles, S. Bai, "A robust solution of the spherical Burmester problem": attitudes and dyads.
// Dyads from 60-digit arithmetic on these attitudes. Of example 1 the printed axes are these ones truncated to four
// digits; of example 2 (its attitudes moved by at most 0.016 deg so that the slider is exact) the printed columns a0
// and b are exchanged.
#pragma once

#include <array>
#include <vector>

#include "burmester/modules/framework/problem.hpp"
#include "burmester/modules/framework/record.hpp"
#include "burmester/spherical/family.hpp"

namespace burmester::testing {

struct SphericalExample {
  std::vector<spherical::Pose> poses;
  std::vector<spherical::RR::Design> dyads;

  Problem problem() const {
    Problem out;
    out.geometry = "spherical";
    for (const spherical::Pose& p : poses) out.poses.push_back({p.w, p.x, p.y, p.z});
    return out;
  }
  /// The dyads as records, sliders as PR, and all pairs of them as linkages.
  Synthesis answer() const {
    Synthesis out;
    for (const spherical::RR::Design& d : dyads) {
      const auto design = spherical::Family::decode(spherical::RR::encode(d));
      out.dyads.push_back(std::holds_alternative<spherical::PR::Design>(*design)
                              ? spherical::PR::record({d.fixed, d.moving})
                              : spherical::RR::record(d));
      out.dyads.back().id = static_cast<int>(out.dyads.size());
    }
    for (std::size_t i = 0; i < dyads.size(); ++i)
      for (std::size_t j = i + 1; j < dyads.size(); ++j) {
        LinkageRecord& l = out.linkages.emplace_back();
        l.id = static_cast<int>(out.linkages.size());
        l.dyads[0] = static_cast<int>(i) + 1, l.dyads[1] = static_cast<int>(j) + 1;
      }
    return out;
  }
};

inline SphericalExample angeles_bai_1() {
  using spherical::pose_from_globe_degrees;
  constexpr double degree = 3.14159265358979323846 / 180;
  return {{pose_from_globe_degrees(0, 0, 0), pose_from_globe_degrees(-10, 6, 0), pose_from_globe_degrees(-51, -52, -12),
           pose_from_globe_degrees(15, -56, 47), pose_from_globe_degrees(33, -40, 47)},
          {{{0.2640466294743534, -0.663651655704157, -0.6998898894428784},
            {0.7085790279115382, -0.6418147356202265, -0.29323984440160644},
            35.08752256387994 * degree},
           {{0.11438567285118437, 0.7263033807215935, -0.6777900242691433},
            {0.03850018330177807, 0.31637010830067996, 0.9478542559167762},
            114.0956785806511 * degree},
           {{0.5218800424400694, 0.8413857164607459, -0.14039692816649757},
            {0.1642313954817287, 0.6977365201145962, 0.6972745493967909},
            54.90881132896959 * degree},
           {{0.9524952675521686, -0.2535884257361309, 0.16865845849939917},
            {0.8077994700250476, 0.14938415597112395, 0.5702143370453318},
            34.135322118552374 * degree}}};
}

inline SphericalExample angeles_bai_2_exact() {
  using spherical::pose_from_axis_radians;
  constexpr double degree = 3.14159265358979323846 / 180;
  return {
      {pose_from_axis_radians({0, 0, 1}, 0),
       pose_from_axis_radians({-0.22879137954403705, -0.4556458041229146, -0.8602565930183382}, 0.25631959834509277),
       pose_from_axis_radians({-0.0577896395145427, 0.2370181386939884, -0.9697849037259842}, 1.1306901368645705),
       pose_from_axis_radians({0.5049213940224437, 0.8505820406369593, -0.14684882704433916}, 1.1939352063107442),
       pose_from_axis_radians({0.7119539995541221, 0.6601909263873552, 0.23931034920097974}, 1.3667696515817636)},
      {{{0.2851174012296429, 0.38684470824486217, 0.8769602267030143},
        {0.12136108435658095, -0.7092551033834765, -0.6944268755803514},
        148.07642424013696 * degree},
       {{0.7226597483646462, 0.5295437818420705, 0.44423672878989184},
        {0.2309171831869252, 0.45663397939865763, 0.8591639327669442},
        37.78135573307057 * degree},
       {{0.9575295439763044, -0.2428768071313359, 0.15539636086542807},
        {0.8135569776919207, 0.16489074952364224, 0.5576164315820679},
        34.34979116942731 * degree},
       {{0.5221393938323564, 0.8442635990986221, -0.12078670723809137},
        {0.06550500280810398, 0.10150775244309242, 0.9926758135469315},
        90 * degree}}};
}

}  // namespace burmester::testing
