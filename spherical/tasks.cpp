#include "burmester/spherical/tasks.hpp"

#include <cmath>
#include <numbers>

namespace burmester::spherical {
namespace {

using ImagePoint = Space::Point<double>;
constexpr double pi = std::numbers::pi;

ImagePoint about(const Axis& axis, double angle) {
  return Space::point<double>(pose_from_axis_radians({axis[0], axis[1], axis[2]}, angle));
}
ImagePoint product(const ImagePoint& x, const ImagePoint& y) { return Space::product<double>(x, y).normalized(); }

/// A rotation that brings `from` to `to`, then turned about `to`.
ImagePoint bring(const Axis& from, const Axis& to, double angle) {
  ImagePoint shortest;
  shortest << 1 + from.dot(to), from.cross(to);
  return product(about(to, angle), shortest);
}

template <class Angle>
FivePoseTask with_angles(Random& random, Angle angle) {
  FivePoseTask task;
  for (Pose& pose : task) {
    const Axis axis = Space::random_feature(random);
    pose = Space::pose(about(axis, angle()));
  }
  return task;
}

FivePoseTask generic(Random& r) {
  FivePoseTask task;
  for (Pose& pose : task) pose = Space::random_pose(r);
  return task;
}
FivePoseTask small_rotations(Random& r) {
  return with_angles(r, [&] { return 1e-3 * r.normal(); });
}
FivePoseTask near_half_turns(Random& r) {
  FivePoseTask task = generic(r);
  for (std::size_t j = 1; j < 4; ++j) {  // 1e-6, 1e-4 and 1e-2 short of or past half a turn from the first
    const Axis axis = Space::random_feature(r);
    const ImagePoint turn = about(axis, pi + std::pow(10.0, 2 * static_cast<int>(j) - 8) * r.normal());
    task[j] = Space::pose(product(turn, Space::point<double>(task[0])));
  }
  return task;
}
FivePoseTask four_half_turns(Random& r) {  // exact in the doubles: the scalar product of the quaternions is zero
  FivePoseTask task{};
  for (std::size_t j = 1; j < 5; ++j) {
    const Axis axis = Space::random_feature(r);
    task[j] = {0, axis[0], axis[1], axis[2]};
  }
  return task;
}
FivePoseTask close_pair(Random& r) {
  FivePoseTask task = generic(r);
  const Axis axis = Space::random_feature(r);
  task[1] = Space::pose(product(about(axis, 1e-6), Space::point<double>(task[3])));
  return task;
}
FivePoseTask nearly_coaxial(Random& r) {
  const Axis common = Space::random_feature(r);
  const ImagePoint first = Space::point<double>(Space::random_pose(r));
  FivePoseTask task;
  for (Pose& pose : task) {
    const Axis off = common + 1e-4 * Axis(r.normal(), r.normal(), r.normal());
    pose = Space::pose(product(about(off.normalized(), r.uniform(-pi, pi)), first));
  }
  return task;
}
FivePoseTask four_bar(Random& r) { return planted_four_bar(r).task; }
FivePoseTask slider(Random& r) { return planted_slider(r).task; }

FivePoseTask equal_poses(Random& r) {
  FivePoseTask task = generic(r);
  const Pose& p = task[1];
  task[3] = {-p.w, -p.x, -p.y, -p.z};
  return task;
}
FivePoseTask coaxial(Random& r, int count) {
  const Axis axis = Space::random_feature(r);
  FivePoseTask task = generic(r);
  const ImagePoint first = Space::point<double>(task[0]);
  for (std::size_t j = 1; j < static_cast<std::size_t>(count); ++j)
    task[j] = Space::pose(product(about(axis, r.uniform(-pi, pi)), first));
  return task;
}
FivePoseTask common_axis(Random& r) { return coaxial(r, 5); }
FivePoseTask four_coaxial(Random& r) { return coaxial(r, 4); }

/// An axis of the body is in one place in three orientations and in another in two: it keeps its angle from a plane of
/// axes.
FivePoseTask axis_in_two_places(Random& r) {
  const Axis axis = Space::random_feature(r);
  FivePoseTask task = generic(r);
  for (const std::array<std::size_t, 2>& pair : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {3, 4}})
    task[pair[1]] = Space::pose(product(Space::point<double>(task[pair[0]]), about(axis, r.uniform(-pi, pi))));
  return task;
}

}  // namespace

PlantedFourBar planted_four_bar(Random& r) {
  for (;;) {
    PlantedFourBar out;
    for (RR::Design& dyad : out.dyads) dyad = RR::random_design(r);
    const auto& [first, second] = out.dyads;
    std::size_t found = 0;
    for (int tries = 0; tries < 40 && found < 5; ++tries) {
      const Axis start = Space::act<double>(about(first.fixed.unitOrthogonal(), first.arc), first.fixed);
      const Axis at = Space::act<double>(about(first.fixed, r.uniform(-pi, pi)), start).normalized();
      const ImagePoint loose = bring(first.moving, at, 0);
      // turned by t about `at`: fixed . moving = along + A cos t + B sin t
      const Axis m = Space::act<double>(loose, second.moving).normalized();
      const double along = at.dot(m) * at.dot(second.fixed);
      const double A = second.fixed.dot(m) - along, B = second.fixed.dot(at.cross(m)), size = std::hypot(A, B);
      const double cosine = (std::cos(second.arc) - along) / size;
      if (!(std::abs(cosine) < 1)) continue;
      out.task[found++] = Space::pose(product(about(at, std::atan2(B, A) + std::acos(cosine)), loose));
    }
    if (found == 5) return out;
  }
}

PlantedSlider planted_slider(Random& r) {
  PlantedSlider out{{}, PR::random_design(r)};
  const Axis start = out.slider.fixed.unitOrthogonal();
  for (Pose& pose : out.task) {
    const Axis at = Space::act<double>(about(out.slider.fixed, r.uniform(-pi, pi)), start).normalized();
    pose = Space::pose(bring(out.slider.moving, at, r.uniform(-pi, pi)));
  }
  return out;
}

const std::vector<TaskClass>& random_task_classes() {
  static const std::vector<TaskClass> classes{
      {"generic", "uniform on the rotation group", generic},
      {"small_rotations", "rotations of 1e-3 about random axes", small_rotations},
      {"near_half_turns", "three orientations half a turn from the first, to 1e-6, 1e-4 and 1e-2", near_half_turns},
      {"four_half_turns", "four orientations exactly half a turn from the first", four_half_turns},
      {"planted_four_bar", "coupler orientations of a four-bar", four_bar},
      {"planted_slider", "an axis of the body moves in a plane", slider},
      {"close_pair", "two orientations 1e-6 apart", close_pair},
      {"nearly_coaxial", "axes of all rotations within 1e-4 of each other", nearly_coaxial}};
  return classes;
}

const std::vector<TaskClass>& degenerate_task_classes() {
  static const std::vector<TaskClass> classes{
      {"equal_poses", "two orientations equal: in effect four", equal_poses},
      {"common_axis", "all rotations about one axis", common_axis},
      {"four_coaxial", "rotations between four of the orientations about one axis", four_coaxial},
      {"axis_in_two_places", "an axis of the body takes only two places, three and two times", axis_in_two_places}};
  return classes;
}

const TaskClass* find_task_class(std::string_view name) {
  return find_class<FivePoseTask>(name, {&random_task_classes(), &degenerate_task_classes()});
}

}  // namespace burmester::spherical
