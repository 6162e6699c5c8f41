// Drawings: polylines in a plane or on the unit sphere, with roles instead of colours. Pages and figures decide how a
// role looks.
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

/// A polyline on the unit sphere. `role` is one of: ground, link, coupler, guide, block, fixed_axis, moving_axis
/// (single points); task, body (an attitude that is asked for, one that the coupler takes: y tip, x axis, z tip of the
/// moving frame, as they pierce the sphere or point from there); path (of the moving x axis),
/// fixed_curve, moving_curve.
struct SphereStroke {
  std::string role;
  std::string label{};
  int dyad = 0;  ///< id of the dyad it belongs to, 0 for none
  int pose = 0;  ///< the pose, counted from 1, that it is drawn in; 0: in all
  bool closed = false;
  std::vector<std::array<double, 3>> points{};
};

/// An orthographic view: three orthogonal unit vectors.
struct SphereView {
  std::string name;
  std::array<double, 3> right{}, up{}, towards{};  ///< `towards`: from the centre to the eye
};

struct SphereDrawing {
  int linkage = 0;  ///< id; 0: the task and its curves
  std::vector<SphereStroke> strokes;
  std::vector<SphereView> views;
};

/// A still picture of its own.
///
/// In `plates`, curves. Roles: circle_points, centre_points (curves), pole, meeting (points), frame_link, bar, limit
/// (straight links), and link, coupler, fixed_pivot, moving_pivot, frame as above; the `dyad` of a part is its style,
/// 0 or 1 for the other of two, of a frame the number of the pose, from 0.
///
/// In `constructions`, the points and lines that lead to a pivot. Roles: given, image, pole, constructed (points),
/// bisector (a straight line through two points), chord, arc, link, circle, frame (x tip, origin, y tip of the moving
/// frame); the `dyad` of a part is the pose it belongs to, 0 for none.
struct Plate {
  std::string name;  ///< of its file
  std::string title, caption;
  std::vector<Part> parts;
  Snapshot lines;                  ///< one polyline for each part
  std::array<double, 4> window{};  ///< xmin, ymin, xmax, ymax
  /// If there are any: pictures in one window, drawn side by side under the title; then no parts of its own.
  std::vector<Plate> panels = {};
};

/// The constraint surfaces of a linkage's two dyads in the image space, projected. Roles: surface (lines of a
/// wireframe, the farthest first), axis, curve (the linkage's motion), pose (single points).
struct SurfaceDrawing {
  int linkage = 0;
  std::vector<Part> parts;
  Snapshot lines;  ///< one polyline for each part
};

/// Geometries fill `poses` and `linkages`, or `spheres`.
struct Drawing {
  std::vector<PoseDrawing> poses;
  std::vector<LinkageDrawing> linkages;
  std::vector<SphereDrawing> spheres = {};
  std::vector<Plate> plates = {};
  std::vector<SurfaceDrawing> surfaces = {};
  std::vector<Plate> constructions = {};
};

}  // namespace burmester
