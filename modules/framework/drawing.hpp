// Drawings: polylines in a plane, with roles instead of colours. Pages and figures decide how a role looks.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace burmester {

using Polyline = std::vector<std::array<double, 2>>;

/// What a polyline stands for. `role` is one of: ground, link, coupler, guide (a straight guide line), block (a
/// slider), fixed_pivot, moving_pivot (single points), frame (x tip, origin, y tip of the moving frame).
struct Part {
  std::string role;
  std::string label;
  bool closed = false;
  int dyad = 0;  ///< id of the dyad it belongs to, 0 for none
};

/// One polyline for each part, in the order of the parts.
using Snapshot = std::vector<Polyline>;

/// One connected stretch of the linkage's motion, sampled for the eye (no verdict follows from it).
struct MotionDrawing {
  std::vector<int> poses;        ///< the task poses on it, counted from 1
  std::vector<int> pose_frames;  ///< the frames that show these poses exactly
  bool closed = false;
  std::vector<Snapshot> frames;
};

struct LinkageDrawing {
  int id = 0;
  std::vector<Part> parts;
  std::vector<Snapshot> at_pose;
  std::vector<MotionDrawing> motions;
  std::array<double, 4> window{};  ///< xmin, ymin, xmax, ymax
};

struct PoseDrawing {
  std::string label;
  std::array<double, 2> origin{}, x_axis{}, y_axis{};  ///< axes: unit vectors of the moving frame
};

/// A geometric construction, finished: the points and lines that lead to a pivot. Roles: given, image, pole,
/// constructed (points), bisector (a straight line through two points), chord, arc, link, circle, frame (x tip, origin,
/// y tip of the moving frame). The `dyad` of a part is here the pose it belongs to, 0 for none.
struct ConstructionDrawing {
  std::string name;     ///< of its file
  std::string title;
  std::string caption;  ///< how to read it
  std::vector<Part> parts;
  Snapshot lines;                  ///< one polyline for each part
  std::array<double, 4> window{};  ///< xmin, ymin, xmax, ymax
};

struct Drawing {
  std::vector<PoseDrawing> poses;
  std::vector<LinkageDrawing> linkages;
  std::vector<ConstructionDrawing> constructions = {};
};

}  // namespace burmester
