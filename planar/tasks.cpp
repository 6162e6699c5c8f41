#include "burmester/planar/tasks.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace burmester::planar {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

/// Poses with origins of size 1 and the angles given by `angle`.
template <class Angle>
FivePoseTask with_angles(Random& random, Angle angle, double origin_scale = 1, double offset = 0) {
  FivePoseTask task;
  for (int j = 0; j < 5; ++j)
    task[j] =
        pose_from_radians(offset + origin_scale * random.normal(), offset + origin_scale * random.normal(), angle(j));
  return task;
}

FivePoseTask generic(Random& r) {
  return with_angles(r, [&](int) { return r.uniform(-pi, pi); });
}
FivePoseTask small_rotations(Random& r) {
  return with_angles(r, [&](int) { return 1e-3 * r.normal(); });
}
FivePoseTask near_half_turns(Random& r) {
  FivePoseTask task = generic(r);
  const double from = angle_of(task[0]);
  for (int j = 1; j < 4; ++j)  // 1e-6, 1e-4 and 1e-2 short of or past half a turn
    task[j] = pose_from_radians(task[j].x, task[j].y, from + pi + std::pow(10.0, 2 * j - 8) * r.normal());
  return task;
}
FivePoseTask exact_half_turn(Random& r) {
  FivePoseTask task = generic(r);
  task[0] = {task[0].x, task[0].y, 0, 1};
  task[1] = {task[1].x, task[1].y, 1, 0};
  return task;
}
FivePoseTask large_coordinates(Random& r) {
  return with_angles(r, [&](int) { return r.uniform(-pi, pi); }, 1e3);
}
FivePoseTask small_coordinates(Random& r) {
  return with_angles(r, [&](int) { return r.uniform(-pi, pi); }, 1e-3);
}
FivePoseTask offset_origin(Random& r) {
  return with_angles(r, [&](int) { return r.uniform(-pi, pi); }, 1, 1e6);
}
FivePoseTask nearly_parallel(Random& r) {
  return with_angles(r, [&](int) { return 0.7 + 1e-6 * r.normal(); });
}
FivePoseTask close_pair(Random& r) {
  FivePoseTask task = generic(r);
  const double angle = angle_of(task[3]) + 1e-6 * r.normal();
  task[1] = pose_from_radians(task[3].x + 1e-6 * r.normal(), task[3].y + 1e-6 * r.normal(), angle);
  return task;
}

/// Pose at `angle` that brings the moving point m (in E) to the fixed place p.
Pose pose_through(Complex p, Complex m, double angle) {
  const Complex origin = p - std::polar(1.0, angle) * m;
  return pose_from_radians(origin.real(), origin.imag(), angle);
}

FivePoseTask planted_PR(Random& r) {
  const Complex m(r.normal(), r.normal()), point(r.normal(), r.normal()), along = std::polar(1.0, r.uniform(0, pi));
  FivePoseTask task;
  for (Pose& pose : task) pose = pose_through(point + r.normal() * along, m, r.uniform(-pi, pi));
  return task;
}
FivePoseTask planted_RP(Random& r) {  // a line of E passes through the fixed point
  const Complex fixed(r.normal(), r.normal()), point(r.normal(), r.normal()), along = std::polar(1.0, r.uniform(0, pi));
  FivePoseTask task;
  for (Pose& pose : task) pose = pose_through(fixed, point + r.normal() * along, r.uniform(-pi, pi));
  return task;
}

/// Coupler poses of a four-bar at random crank angles (the same assembly mode, so far as the angles allow).
FivePoseTask planted_four_bar(Random& r) {
  for (;;) {
    const Complex f1(r.normal(), r.normal()), f2(r.normal(), r.normal()), frame(r.normal(), r.normal());
    const double a = std::abs(r.normal()) + 0.1, c = std::abs(r.normal()) + 0.1, b = std::abs(r.normal()) + 0.1;
    const double turned = r.uniform(-pi, pi);
    FivePoseTask task;
    int found = 0;
    for (int tries = 0; tries < 40 && found < 5; ++tries) {
      const Complex m1 = f1 + std::polar(a, r.uniform(-pi, pi)), d = f2 - m1;
      const double g = std::abs(d), cosine = (g * g + c * c - b * b) / (2 * g * c);
      if (std::abs(cosine) > 1) continue;
      const Complex along = d / g * std::polar(1.0, std::acos(cosine));
      task[found++] = pose_through(m1, frame, std::arg(along) + turned);
    }
    if (found == 5) return task;
  }
}

FivePoseTask equal_poses(Random& r) {
  FivePoseTask task = generic(r);
  task[3] = task[1];
  return task;
}
FivePoseTask all_parallel(Random& r) {
  return with_angles(r, [](int) { return 0.7; });
}
FivePoseTask circular_translation(Random& r) {
  FivePoseTask task = all_parallel(r);
  for (Pose& pose : task) {
    const double t = r.uniform(-pi, pi);
    pose.x = 0.3 + 2 * std::cos(t), pose.y = -1.1 + 2 * std::sin(t);
  }
  return task;
}
FivePoseTask straight_translation(Random& r) {
  FivePoseTask task = all_parallel(r);
  for (Pose& pose : task) pose.y = 0.3 + 0.7 * pose.x;
  return task;
}
FivePoseTask rotation_about_point(Random& r) {
  FivePoseTask task;
  for (Pose& pose : task) pose = pose_through({0.4, -0.8}, {1.1, 0.6}, r.uniform(-pi, pi));
  return task;
}
FivePoseTask four_parallel(Random& r) {
  return with_angles(r, [](int j) { return j == 2 ? -0.4 : 0.7; });
}
FivePoseTask two_orientations(Random& r) {
  return with_angles(r, [](int j) { return j == 2 || j == 4 ? -0.4 : 0.7; });
}
/// Elliptic (Cardan) motion: two points of E on two fixed lines; a whole circle of points moves on lines.
FivePoseTask cardan_motion(Random& r) {
  FivePoseTask task;
  for (Pose& pose : task) {
    const double angle = r.uniform(-pi, pi);
    // the point at the origin of E runs along y = 0, the point (2, 0) of E along x = 0
    pose = pose_from_radians(-2 * std::cos(angle), 0, angle);
  }
  return task;
}
/// The inverse of the Cardan motion (Oldham): two lines of E pass through two fixed points.
FivePoseTask oldham_motion(Random& r) {
  FivePoseTask task;
  for (Pose& pose : task) {
    const double angle = r.uniform(-pi, pi);
    const Complex back = -std::polar(1.0, -angle) * Complex(-2 * std::cos(-angle), 0) * std::polar(1.0, 2 * angle);
    pose = pose_from_radians(back.real(), back.imag(), angle);
  }
  return task;
}

}  // namespace

const std::vector<TaskClass>& random_task_classes() {
  static const std::vector<TaskClass> classes{
      {"generic", "origins normal, angles uniform", generic},
      {"small_rotations", "rotations of 1e-3", small_rotations},
      {"near_half_turns", "three poses half a turn from the first, to 1e-6, 1e-4 and 1e-2", near_half_turns},
      {"exact_half_turn", "two poses exactly half a turn apart", exact_half_turn},
      {"large_coordinates", "lengths times 1e3", large_coordinates},
      {"small_coordinates", "lengths times 1e-3", small_coordinates},
      {"offset_origin", "the fixed frame's origin 1e6 away", offset_origin},
      {"nearly_parallel", "orientations equal to 1e-6", nearly_parallel},
      {"close_pair", "two poses 1e-6 apart", close_pair},
      {"planted_PR", "a point of the body moves on a line", planted_PR},
      {"planted_RP", "a line of the body passes through a fixed point", planted_RP},
      {"planted_four_bar", "coupler poses of a four-bar", planted_four_bar}};
  return classes;
}

const std::vector<TaskClass>& degenerate_task_classes() {
  static const std::vector<TaskClass> classes{
      {"equal_poses", "two poses equal: in effect four poses", equal_poses},
      {"all_parallel", "one orientation: only the double slider", all_parallel},
      {"circular_translation", "one orientation, origins on a circle", circular_translation},
      {"straight_translation", "one orientation, origins on a line", straight_translation},
      {"rotation_about_point", "rotations about one point", rotation_about_point},
      {"four_parallel", "four orientations equal: no finite dyad", four_parallel},
      {"two_orientations", "orientations 3 + 2: two dyads remain", two_orientations},
      {"cardan_motion", "a circle of points moves on lines", cardan_motion},
      {"oldham_motion", "the inverse of the Cardan motion", oldham_motion}};
  return classes;
}

const TaskClass* find_task_class(std::string_view name) {
  return find_class<FivePoseTask>(name, {&random_task_classes(), &degenerate_task_classes()});
}

}  // namespace burmester::planar
