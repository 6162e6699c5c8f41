#include "burmester/planar/drawing.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "burmester/planar/constraint_quadric.hpp"
#include "burmester/planar/drawing/curve_plates.hpp"
#include "burmester/planar/drawing/construction.hpp"
#include "burmester/planar/drawing/motion.hpp"
#include "burmester/planar/drawing/sketch.hpp"
#include "burmester/planar/drawing/stage.hpp"
#include "burmester/planar/drawing/surfaces.hpp"
#include "burmester/planar/pose_format.hpp"

namespace burmester::planar {
namespace {

std::array<double, 2> pair_of(const Vector2& p) { return {p[0], p[1]}; }

PoseDrawing drawn(const Pose& pose, int number) {
  return {std::to_string(number), {pose.x, pose.y}, pair_of(rotated(pose, {1, 0})), pair_of(rotated(pose, {0, 1}))};
}

std::optional<SketchDyad> dyad_of(const Synthesis& answer, int id) {
  for (const DyadRecord& record : answer.dyads)
    if (record.id == id)
      if (const auto design = design_of(record)) return SketchDyad{id, *design};
  return std::nullopt;
}

/// A box that grows.
struct Box {
  Vector2 low{1e9, 1e9}, high{-1e9, -1e9};

  void take(const Vector2& p) { low = low.cwiseMin(p), high = high.cwiseMax(p); }
  Box with_margin(double share) const {
    const double margin = std::max(share * (high - low).maxCoeff(), 1e-3);
    return {low - Vector2(margin, margin), high + Vector2(margin, margin)};
  }
};

/// All of it in the task poses but what is out of view; of the motion what leaves that by less than a third.
Box window_of(const LinkageDrawing& drawing) {
  Box box;
  const auto each_point = [&](const Snapshot& snapshot, auto take) {
    for (std::size_t k = 0; k < snapshot.size(); ++k)
      if (drawing.parts[k].role != "guide" && drawing.parts[k].role != "ground")
        for (const auto& p : snapshot[k]) take(Vector2(p[0], p[1]));
  };
  for (const Snapshot& s : drawing.at_pose)
    each_point(s, [&](const Vector2& p) {
      if (p.norm() < 1.3) box.take(p);
    });
  const Box limits = box.with_margin(0.33);
  for (const MotionDrawing& m : drawing.motions)
    for (const Snapshot& s : m.frames)
      each_point(s, [&](const Vector2& p) {
        if (p.norm() < horizon) box.take(p.cwiseMax(limits.low).cwiseMin(limits.high));
      });
  return box.with_margin(0.05);
}

MotionDrawing drawn(const Stretch& stretch, const Sketch& sketch) {
  MotionDrawing out;
  for (const int j : stretch.poses) out.poses.push_back(j + 1);
  out.pose_frames = stretch.pose_frames;
  out.closed = stretch.closed;
  for (const Pose& pose : stretch.frames) out.frames.push_back(sketch.at(pose));
  return out;
}

void to_problem(const Stage& stage, Snapshot& snapshot) {
  for (Polyline& line : snapshot)
    for (auto& p : line) p = pair_of(stage.in_problem({p[0], p[1]}));
}


void to_problem(const Stage& stage, LinkageDrawing& drawing) {
  for (Snapshot& s : drawing.at_pose) to_problem(stage, s);
  for (MotionDrawing& m : drawing.motions)
    for (Snapshot& s : m.frames) to_problem(stage, s);
}

void add_linkage(Drawing& drawing, int id, const std::array<SketchDyad, 2>& dyads, const std::vector<Pose>& poses) {
  const Stage stage = stage_of(poses, dyads[0].design, dyads[1].design);
  std::vector<Pose> on_stage;
  for (const Pose& p : poses) on_stage.push_back(stage.pose(p));
  const std::array<SketchDyad, 2> small{{{dyads[0].id, stage.design(dyads[0].design)},
                                         {dyads[1].id, stage.design(dyads[1].design)}}};
  const Motions motions = motions_through(on_stage, small[0].design, small[1].design);

  std::vector<Pose> everywhere = motions.shown;
  for (const Stretch& s : motions.stretches) everywhere.insert(everywhere.end(), s.frames.begin(), s.frames.end());
  const Sketch sketch(small, everywhere);
  LinkageDrawing out;
  out.id = id;
  out.parts = sketch.parts();
  for (const Pose& p : motions.shown) out.at_pose.push_back(sketch.at(p));
  for (const Stretch& s : motions.stretches) out.motions.push_back(drawn(s, sketch));
  const Box box = window_of(out);
  const Vector2 low = stage.in_problem(box.low), high = stage.in_problem(box.high);
  out.window = {low[0], low[1], high[0], high[1]};
  to_problem(stage, out);
  drawing.linkages.push_back(std::move(out));
  drawing.surfaces.push_back(draw_surfaces(id, small, on_stage, motions.stretches));
}

/// Of the dyad with this given fixed pivot, if it is listed.
void add_constructions(Drawing& out, const std::vector<Pose>& poses, const std::vector<double>& fixed,
                       const Synthesis& answer, int number) {
  for (const DyadRecord& record : answer.dyads)
    if (record.fixed == fixed)
      if (const auto design = design_of(record)) {
        for (auto& drawing : three_pose_constructions(poses, *design, number))
          out.constructions.push_back(std::move(drawing));
        return;
      }
}

}  // namespace

Drawing draw_synthesis(const Problem& problem, const Synthesis& answer) {
  Drawing out;
  const std::vector<Pose> poses = poses_of(problem);
  for (const Pose& p : poses) out.poses.push_back(drawn(p, static_cast<int>(out.poses.size()) + 1));
  if (poses.empty()) return out;
  for (const LinkageRecord& linkage : answer.linkages) {
    const auto a = dyad_of(answer, linkage.dyads[0]), b = dyad_of(answer, linkage.dyads[1]);
    if (a && b) add_linkage(out, linkage.id, {*a, *b}, poses);
  }
  if (poses.size() == 4) {
    const std::vector<CandidateRecord> none;
    out.plates =
        four_pose_plates(std::span(poses).first<4>(), answer.curves, answer.candidates ? *answer.candidates : none);
  }
  if (poses.size() == 3)
    for (std::size_t k = 0; k < problem.fixed.size(); ++k)
      add_constructions(out, poses, problem.fixed[k], answer, static_cast<int>(k) + 1);
  return out;
}

}  // namespace burmester::planar
