// What a linkage looks like: its parts, and for every pose of the body one polyline for each part.
//   RR  fixed pivot, link, moving pivot           PR  fixed guide, block, moving pivot
//   RP  fixed pivot, block, guide on the body     PP  fixed guide, block, guide across it, block on the body
// The coupler is a polygon through the origin of E and what each dyad holds it by: the moving pivot, or a point of the
// guide that it carries. All lengths are in units of the stage.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "burmester/modules/framework/drawing.hpp"
#include "burmester/planar/family.hpp"

namespace burmester::planar {

struct SketchDyad {
  int id = 0;
  Family::Design design;
};

class Sketch {
 public:
  /// Guides are made long enough for all poses of `everywhere`.
  Sketch(const std::array<SketchDyad, 2>& dyads, const std::vector<Pose>& everywhere);

  const std::vector<Part>& parts() const { return parts_; }
  Snapshot at(const Pose& pose) const;

 private:
  using Shape = std::function<std::vector<Vector2>(const Pose&)>;
  struct Segment {
    Vector2 from, to;
  };

  void add(const std::string& role, const std::string& label, int dyad, Shape shape);
  void add_dyad(const RR::Design& d, int id, const std::string& letter);
  void add_dyad(const PR::Design& d, int id, const std::string& letter);
  void add_dyad(const RP::Design& d, int id, const std::string& letter);
  void add_dyad(const PP::Design& d, int id, const std::string& letter);
  void add_ground();
  void add_body();

  std::vector<Pose> everywhere_;
  std::vector<Segment> bases_;     // what a dyad holds on to in S: its fixed pivot, its fixed guide
  std::vector<Vector2> couplings_;  // in E
  std::vector<Part> parts_;
  std::vector<Shape> shapes_;
};

}  // namespace burmester::planar
