#include "burmester/planar/drawing/surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "burmester/planar/drawing/chart.hpp"

namespace burmester::planar {
namespace {

using Vector3 = Vector<double, 3>;  // X1, X2, X3; X4 = 1

constexpr int levels = 9, generators = 24, steps = 96;
constexpr double steepest = 3.7;  // tan(150 deg / 2)

Vector2 along(const Line& line) { return {line.normal[1], -line.normal[0]}; }

/// The place of a dyad's joint: angle of the link, or place on the guide.
double joint_of(const RR::Design& d, const Pose& x) {
  const Vector2 link = to_fixed(x, d.moving) - d.fixed;
  return std::atan2(link[1], link[0]);
}
double joint_of(const PR::Design& d, const Pose& x) { return along(d.line).dot(to_fixed(x, d.moving)); }
double joint_of(const RP::Design& d, const Pose& x) { return along(d.line).dot(to_moving(x, d.fixed)); }

/// The pose of the orientation X3 : X4 = t : 1 with the joint there.
Pose assembled(const Vector2& pivot, const Vector2& carried, double t) {
  const Vector2 origin = pivot - rotated({0, 0, t, 1}, carried);
  return {origin[0], origin[1], t, 1};
}
Pose pose_at(const RR::Design& d, double t, double angle) {
  return assembled(d.fixed + d.length * Vector2(std::cos(angle), std::sin(angle)), d.moving, t);
}
Pose pose_at(const PR::Design& d, double t, double s) {
  return assembled(d.line.offset * d.line.normal + s * along(d.line), d.moving, t);
}
Pose pose_at(const RP::Design& d, double t, double s) {
  return assembled(d.fixed, d.line.offset * d.line.normal + s * along(d.line), t);
}

struct Interval {
  double low, high;
  double at(int i, int n) const { return low + (high - low) * i / n; }
};

/// What part of a joint's travel is drawn: all of a link's circle, or what the poses use of it and `more` lengths.
template <class Design>
Interval travel(const Design& d, const std::vector<Pose>& poses, double more) {
  double unit = 1, period = 0;
  if constexpr (std::is_same_v<Design, RR::Design>) unit = d.length, period = 2 * std::numbers::pi;
  const double first = joint_of(d, poses[0]);
  Interval out{first, first};
  for (const Pose& x : poses) {
    const double turn = joint_of(d, x) - first, there = first + (period > 0 ? std::remainder(turn, period) : turn);
    out = {std::min(out.low, there), std::max(out.high, there)};
  }
  out = {out.low - more / unit, out.high + more / unit};
  if (period > 0 && out.high - out.low > period) return {first, first + period};
  return out;
}

/// The box that is shown, and how it is seen.
class View {
 public:
  explicit View(const std::vector<Vector3>& points) : low_(points[0]), high_(points[0]) {
    for (const Vector3& p : points) low_ = low_.cwiseMin(p), high_ = high_.cwiseMax(p);
    const double flat = std::max({high_[0] - low_[0], high_[1] - low_[1], 0.2}),
                 tall = std::max(high_[2] - low_[2], 0.2);
    low_ -= Vector3(flat, flat, tall) * 0.3, high_ += Vector3(flat, flat, tall) * 0.3;
    rise_ = 0.7 * flat / tall;
  }
  const Vector3& low() const { return low_; }
  const Vector3& high() const { return high_; }
  bool holds(const Vector3& p) const {
    const double slack = 1e-9 * (high_ - low_).maxCoeff();
    return ((p - low_).array() >= -slack).all() && ((high_ - p).array() >= -slack).all();
  }
  std::array<double, 2> place(const Vector3& p) const {
    const Vector2 flat = turned(p);
    return {flat[0], rise_ * p[2] * std::cos(tilt) + flat[1] * std::sin(tilt)};
  }
  /// Towards the eye.
  double nearness(const Vector3& p) const { return rise_ * p[2] * std::sin(tilt) - turned(p)[1] * std::cos(tilt); }

 private:
  static constexpr double turn = 0.6, tilt = 0.4;  // radians
  static Vector2 turned(const Vector3& p) {
    return {std::cos(turn) * p[0] - std::sin(turn) * p[1], std::sin(turn) * p[0] + std::cos(turn) * p[1]};
  }
  Vector3 low_, high_;
  double rise_ = 1;
};

struct Stroke {
  Part part;
  std::vector<Vector3> points;
};

class Picture {
 public:
  Picture(const std::array<SketchDyad, 2>& dyads, const std::vector<Pose>& poses, const std::vector<Stretch>& motion)
      : chart_(chart_for(poses, dyads[0].design, dyads[1].design)), dyads_(dyads), motion_(motion) {
    const Point3<double> unit(1, 0, 0, 0), middle = Space::point<double>(chart_.middle);
    for (SketchDyad& dyad : dyads_)
      dyad.design = Family::Types::visit(
          dyad.design, [&]<class D>(const typename D::Design& d) { return Family::Design(D::moved(d, unit, middle)); });
    for (std::size_t i = 0; i < poses.size(); ++i)
      if (const auto X = image_of(poses[i])) {
        shown_.push_back(relative(poses[i]));
        points_.push_back({{"pose", std::to_string(i + 1), false, 0}, {*X}});
      }
  }

  SurfaceDrawing draw(int linkage) {
    SurfaceDrawing out;
    out.linkage = linkage;
    if (points_.empty()) return out;
    const View view(box());
    std::vector<Stroke> strokes;
    for (const SketchDyad& dyad : dyads_) add_surface(dyad, view, strokes);
    const auto nearness = [&view](const Stroke& s) {
      double sum = 0;
      for (const Vector3& p : s.points) sum += view.nearness(p);
      return sum / static_cast<double>(s.points.size());
    };
    std::stable_sort(strokes.begin(), strokes.end(),
                     [&](const Stroke& a, const Stroke& b) { return nearness(a) < nearness(b); });
    add_axes(view, strokes);
    for (const Stretch& stretch : motion_) add_curve(stretch, view, strokes);
    strokes.insert(strokes.end(), points_.begin(), points_.end());
    for (const Stroke& s : strokes) {
      out.parts.push_back(s.part);
      out.lines.emplace_back();
      for (const Vector3& p : s.points) out.lines.back().push_back(view.place(p));
    }
    return out;
  }

 private:
  /// As seen from the middle orientation.
  Pose relative(const Pose& pose) const {
    return Space::pose(Space::product<double>(Space::point<double>(pose),
                                              Space::conjugate<double>(Space::point<double>(chart_.middle))));
  }
  /// Empty where it is out of the picture.
  std::optional<Vector3> image_of(const Pose& pose) const {
    const Vector<double, 4> X = image_point(relative(pose));
    if (!(std::abs(X[2]) <= steepest * std::abs(X[3]))) return std::nullopt;
    return Vector3(X.head<3>() / X[3]);
  }
  static Vector3 image_of(double t, const Pose& pose) {
    const Vector<double, 4> X = image_point(pose);
    return {X[0] / X[3], X[1] / X[3], t};
  }

  /// The poses, and those circles of links at their levels that are no wider than the stage.
  std::vector<Vector3> box() const {
    std::vector<Vector3> out;
    for (const Stroke& p : points_) out.push_back(p.points[0]);
    for (const SketchDyad& dyad : dyads_)
      if (const auto* d = std::get_if<RR::Design>(&dyad.design); d && d->length <= 2)
        for (const Stroke& p : points_)
          for (int i = 0; i < 8; ++i)
            out.push_back(image_of(p.points[0][2], pose_at(*d, p.points[0][2], i * std::numbers::pi / 4)));
    return out;
  }

  static void add_clipped(const Part& part, const std::vector<Vector3>& line, const View& view,
                          std::vector<Stroke>& out) {
    bool inside = false;
    for (const Vector3& p : line) {
      const bool now = view.holds(p);
      if (now && !inside) out.push_back({part, {}});
      if (now) out.back().points.push_back(p);
      inside = now;
    }
  }

  /// Straight lines need no points between but where they leave the box.
  void add_surface(const SketchDyad& dyad, const View& view, std::vector<Stroke>& out) const {
    const Part part{"surface", "", false, dyad.id};
    const Interval t{view.low()[2], view.high()[2]};
    std::visit(
        [&]<class Design>(const Design& d) {
          if constexpr (!std::is_same_v<Design, PP::Design>) {
            const Interval joint = travel(d, shown_, (view.high() - view.low()).head<2>().norm());
            const auto line = [&](auto t_at, auto joint_at) {
              std::vector<Vector3> points;
              for (int k = 0; k <= steps; ++k) points.push_back(image_of(t_at(k), pose_at(d, t_at(k), joint_at(k))));
              add_clipped(part, points, view, out);
            };
            for (int i = 0; i < levels; ++i)
              line([&](int) { return t.at(i, levels - 1); }, [&](int k) { return joint.at(k, steps); });
            for (int i = 0; i < generators; ++i)
              line([&](int k) { return t.at(k, steps); }, [&](int) { return joint.at(i, generators); });
          } else {
            add_plane(part, std::tan(d.angle / 2), view, out);
          }
        },
        dyad.design);
  }

  static void add_plane(const Part& part, double t, const View& view, std::vector<Stroke>& out) {
    const Vector3 &low = view.low(), &high = view.high();
    for (int i = 0; i < levels; ++i) {
      const double u = Interval{low[0], high[0]}.at(i, levels - 1), v = Interval{low[1], high[1]}.at(i, levels - 1);
      add_clipped(part, {{u, low[1], t}, {u, high[1], t}}, view, out);
      add_clipped(part, {{low[0], v, t}, {high[0], v, t}}, view, out);
    }
  }

  static void add_axes(const View& view, std::vector<Stroke>& out) {
    const Vector3 corner = view.low(), size = view.high() - view.low();
    for (int i = 0; i < 3; ++i) {
      Vector3 tip = corner;
      tip[i] += 0.25 * size[i];
      out.push_back({{"axis", fmt::format("X{}", i + 1), false, 0}, {corner, tip}});
    }
  }

  void add_curve(const Stretch& stretch, const View& view, std::vector<Stroke>& out) const {
    std::vector<Pose> frames = stretch.frames;
    if (stretch.closed && !frames.empty()) frames.push_back(frames.front());
    std::vector<Vector3> run;
    const auto finish = [&] {
      add_clipped({"curve", "", false, 0}, run, view, out);
      run.clear();
    };
    for (const Pose& pose : frames) {
      const auto X = image_of(pose);
      X ? run.push_back(*X) : finish();
    }
    finish();
  }

  Chart chart_;
  std::array<SketchDyad, 2> dyads_;
  const std::vector<Stretch>& motion_;
  std::vector<Pose> shown_;
  std::vector<Stroke> points_;
};

}  // namespace

SurfaceDrawing draw_surfaces(int linkage, const std::array<SketchDyad, 2>& dyads, const std::vector<Pose>& poses,
                             const std::vector<Stretch>& motion) {
  return Picture(dyads, poses, motion).draw(linkage);
}

}  // namespace burmester::planar
