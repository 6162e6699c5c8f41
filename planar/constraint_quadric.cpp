#include "burmester/planar/constraint_quadric.hpp"

namespace burmester::planar {
namespace {

Vector2 vector_of(const std::vector<double>& p) { return {p[0], p[1]}; }

Line line_of(const LineRecord& record) { return Line::through(vector_of(record.point), record.angle); }

}  // namespace

Quadric<double> constraint_quadric(const Family::Design& design) {
  Quadric<double> out = Family::Types::visit(
      design, []<class D>(const typename D::Design& d) { return constraint_quadric(D::encode(d)); });
  if (const auto* d = std::get_if<RR::Design>(&design)) {
    const double here = (d->moving - d->fixed).norm(), turned = (d->moving + d->fixed).norm();
    out.q[0] = (here - d->length) * (here + d->length) / 4;
    out.q[1] = (turned - d->length) * (turned + d->length) / 4;
  }
  return out;
}

std::optional<Family::Design> design_of(const DyadRecord& r) {
  const bool fixed = r.fixed.size() == 2, moving = r.moving.size() == 2, line = r.line && r.line->point.size() == 2;
  if (r.type == RR::name && fixed && moving && r.length)
    return RR::Design{vector_of(r.fixed), vector_of(r.moving), *r.length};
  if (r.type == PR::name && moving && line) return PR::Design{vector_of(r.moving), line_of(*r.line)};
  if (r.type == RP::name && fixed && line) return RP::Design{vector_of(r.fixed), line_of(*r.line)};
  if (r.type == PP::name && r.angle) return PP::Design{*r.angle};
  return std::nullopt;
}

}  // namespace burmester::planar
