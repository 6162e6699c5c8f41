#include "report/report.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "burmester/modules/framework/json_text.hpp"
#include "report/figure.hpp"
#include "report/page.hpp"

namespace burmester {
namespace {

using json = nlohmann::ordered_json;

/// Rounds to a step of a power of ten.
class Rounding {
 public:
  explicit Rounding(double size) {
    const double exponent = size > 0 && std::isfinite(size) ? std::floor(std::log10(size)) - 6 : -6;
    factor_ = std::pow(10, std::clamp(-exponent, -300.0, 300.0));
  }
  double operator()(double value) const {
    const double rounded = std::round(value * factor_) / factor_;
    return std::isfinite(rounded) ? rounded : value;
  }
  json operator()(const std::array<double, 2>& point) const { return {(*this)(point[0]), (*this)(point[1])}; }
  json operator()(const Snapshot& snapshot) const {
    json out = json::array();
    for (const Polyline& line : snapshot) {
      out.push_back(json::array());
      for (const auto& point : line) out.back().push_back((*this)(point));
    }
    return out;
  }
  json operator()(const std::vector<Snapshot>& snapshots) const {
    json out = json::array();
    for (const Snapshot& snapshot : snapshots) out.push_back((*this)(snapshot));
    return out;
  }

 private:
  double factor_;
};

json linkage_of(const LinkageDrawing& linkage) {
  const auto& w = linkage.window;
  const Rounding rounded(std::max(w[2] - w[0], w[3] - w[1]));
  json parts = json::array(), motions = json::array();
  for (const Part& part : linkage.parts)
    parts.push_back(
        {{"role", part.role}, {"label", part.label}, {"closed", part.closed}, {"dyad", part.dyad}});
  for (const MotionDrawing& motion : linkage.motions)
    motions.push_back({{"poses", motion.poses},
                       {"pose_frames", motion.pose_frames},
                       {"closed", motion.closed},
                       {"frames", rounded(motion.frames)}});
  return {{"id", linkage.id},
          {"parts", parts},
          {"at_pose", rounded(linkage.at_pose)},
          {"motions", motions},
          {"window", {rounded(w[0]), rounded(w[1]), rounded(w[2]), rounded(w[3])}}};
}

json sphere_of(const SphereDrawing& sphere) {
  const Rounding rounded(1);
  json strokes = json::array(), views = json::array();
  for (const SphereStroke& s : sphere.strokes) {
    json points = json::array();
    for (const auto& p : s.points) points.push_back({rounded(p[0]), rounded(p[1]), rounded(p[2])});
    strokes.push_back({{"role", s.role},
                       {"label", s.label},
                       {"dyad", s.dyad},
                       {"pose", s.pose},
                       {"closed", s.closed},
                       {"points", points}});
  }
  for (const SphereView& v : sphere.views)
    views.push_back({{"name", v.name}, {"right", v.right}, {"up", v.up}, {"towards", v.towards}});
  return {{"linkage", sphere.linkage}, {"strokes", strokes}, {"views", views}};
}

/// Inside a script element no text may close it or open a comment.
std::string for_script(std::string text) {
  for (std::size_t at = 0; (at = text.find('<', at)) != text.npos; at += 6) text.replace(at, 1, "\\u003c");
  return text;
}

void fill(std::string& page, std::string_view placeholder, std::string_view text) {
  const std::size_t at = page.find(placeholder);
  if (at == page.npos) throw std::logic_error("the report page has no place for " + std::string(placeholder));
  page.replace(at, placeholder.size(), text);
}

/// The constructions, each a figure with its caption; nothing where there are none.
std::string constructions_of(const json& result, const Drawing& drawing) {
  if (drawing.constructions.empty()) return "";
  const std::string task = result.value("name", ""), unit = result.value("/units/length"_json_pointer, "");
  std::string out = "<section id=\"constructions\" aria-labelledby=\"h-constructions\">\n"
                    "<h2 id=\"h-constructions\">Constructions</h2>\n";
  for (const Plate& construction : drawing.constructions)
    out += "<figure class=\"figure\">\n" + construction_figure(construction, task, unit) + "<figcaption>" +
           construction.caption + "</figcaption>\n</figure>\n";
  return out + "</section>\n";
}

}  // namespace

json drawing_document(const Drawing& drawing) {
  json poses = json::array(), linkages = json::array(), spheres = json::array();
  for (const PoseDrawing& pose : drawing.poses)
    poses.push_back(
        {{"label", pose.label}, {"origin", pose.origin}, {"x_axis", pose.x_axis}, {"y_axis", pose.y_axis}});
  for (const LinkageDrawing& linkage : drawing.linkages) linkages.push_back(linkage_of(linkage));
  for (const SphereDrawing& sphere : drawing.spheres) spheres.push_back(sphere_of(sphere));
  return {{"poses", poses}, {"linkages", linkages}, {"spheres", spheres}};
}

std::string report_page(const json& result, const Drawing& drawing) {
  std::string page(page_html);
  fill(page, "/*BURMESTER_CSS*/", page_css);
  fill(page, "/*BURMESTER_TOOLS_JS*/", page_tools_js);
  fill(page, "/*BURMESTER_REPORT_JS*/", page_report_js);
  fill(page, "/*BURMESTER_PLANE_JS*/", page_plane_js);
  fill(page, "/*BURMESTER_SPHERE_JS*/", page_sphere_js);
  fill(page, "/*BURMESTER_TABLES_JS*/", page_tables_js);
  fill(page, "/*BURMESTER_WORDS_JS*/", page_words_js);
  fill(page, "/*BURMESTER_JS*/", page_js);
  fill(page, "/*BURMESTER_DATA*/",
       for_script(json_line({{"result", result}, {"drawing", drawing_document(drawing)}})));
  fill(page, "<!--BURMESTER_CONSTRUCTIONS-->", constructions_of(result, drawing));  // last: data hold no "<"
  return page;
}

}  // namespace burmester
