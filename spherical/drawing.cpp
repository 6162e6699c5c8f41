#include "burmester/spherical/drawing.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

#include "burmester/spherical/drawing/sketch.hpp"
#include "burmester/spherical/drawing/views.hpp"
#include "burmester/spherical/pose_format.hpp"

namespace burmester::spherical {
namespace {

void append(std::vector<SphereStroke>& strokes, std::vector<SphereStroke> more) {
  strokes.insert(strokes.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<SphereStroke> task_strokes(const std::vector<Pose>& poses) {
  std::vector<SphereStroke> out;
  for (std::size_t j = 0; j < poses.size(); ++j) {
    const int number = static_cast<int>(j) + 1;
    out.push_back({.role = "task", .label = std::to_string(number), .pose = number, .points = attitude(poses[j])});
  }
  return out;
}

/// Axes are lines: the curve and its opposite, unless it runs through both ends of its axes anyway. A curve of moving
/// axes as it lies in the pose `frame`.
void append_curve(const char* role, const std::vector<PointRecord>& axes, bool closed, const Pose& frame,
                  std::vector<SphereStroke>& strokes) {
  SphereStroke curve{.role = role, .closed = closed}, opposite = curve;
  for (const auto& a : axes) {
    const Axis p = carried(frame, Axis(a[0], a[1], a[2]));
    curve.points.push_back(coordinates(p)), opposite.points.push_back(coordinates(-p));
  }
  const bool own_opposite = std::any_of(axes.begin(), axes.end(), [&](const auto& a) {
    return Space::distance(Axis(a[0], a[1], a[2]), -Axis(axes[0][0], axes[0][1], axes[0][2])) < arc_step / 10;
  });
  strokes.push_back(std::move(curve));
  if (!own_opposite) strokes.push_back(std::move(opposite));
}

SphereDrawing task_drawing(const std::vector<Pose>& poses, const Synthesis& answer) {
  SphereDrawing out{0, {}, {}};
  for (const CurveRecord& curve : answer.curves) {
    append_curve("fixed_curve", curve.fixed, curve.closed, {}, out.strokes);
    append_curve("moving_curve", curve.moving, curve.closed, poses.front(), out.strokes);
  }
  append(out.strokes, task_strokes(poses));
  out.views = views_of(out.strokes);
  return out;
}

std::optional<SketchDyad> dyad_of(const Synthesis& answer, int id) {
  for (const DyadRecord& record : answer.dyads)
    if (record.id == id) return sketch_dyad(record);
  return std::nullopt;
}

/// Of the moving x axis, in steps that the eye needs.
SpherePoints path_of(const std::vector<Pose>& frames) {
  std::vector<Axis> kept;
  for (const Pose& pose : frames)
    if (const Axis x = carried(pose, Axis::UnitX());
        kept.empty() || &pose == &frames.back() || Space::distance(kept.back(), x) > arc_step / 2)
      kept.push_back(x);
  SpherePoints out;
  for (const Axis& x : kept) out.push_back(coordinates(x));
  return out;
}

SphereDrawing linkage_drawing(int id, const std::array<SketchDyad, 2>& dyads, const std::vector<Pose>& poses) {
  const Motions motions = motions_through(poses, dyads);
  SphereDrawing out{id, fixed_strokes(dyads), {}};
  for (const std::vector<Pose>& path : motions.paths) {
    out.strokes.push_back({.role = "path", .points = path_of(path)});
  }
  append(out.strokes, task_strokes(poses));
  for (std::size_t j = poses.size(); j-- > 0;)
    append(out.strokes, moving_strokes(dyads, motions.shown[j], static_cast<int>(j) + 1));
  out.views = views_of(out.strokes);
  return out;
}

}  // namespace

Drawing draw_synthesis(const Problem& problem, const Synthesis& answer) {
  Drawing out;
  const std::vector<Pose> poses = poses_of(problem);
  if (poses.empty()) return out;
  out.spheres.push_back(task_drawing(poses, answer));
  for (const LinkageRecord& linkage : answer.linkages) {
    const auto a = dyad_of(answer, linkage.dyads[0]), b = dyad_of(answer, linkage.dyads[1]);
    if (a && b) out.spheres.push_back(linkage_drawing(linkage.id, compact({*a, *b}), poses));
  }
  return out;
}

}  // namespace burmester::spherical
