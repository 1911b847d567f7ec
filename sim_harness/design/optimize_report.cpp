// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/optimize_report.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/csv_table.hpp"

namespace lac::sim {
namespace {

constexpr double kWidth_px = 520.0, kMargin_px = 60.0;

std::string px(double value) {
  return format_value(value, 1);
}

std::string degrees(double rad) {
  return format_value(deg_from_rad(rad), 1);
}

std::string in_place(const LidarLayout& l) {
  return std::to_string(l.beams) + " beams, azimuth " + degrees(l.azimuth_rad) +
         " deg, elevation " + degrees(l.elevation_rad) + " deg, " + std::to_string(l.gates) +
         " gates from " + format_value(l.first_gate_m, 1) + " to " +
         format_value(l.last_gate_m, 1) + " m";
}

/// White where nothing is seen, dark blue at the best.
std::string colour(double share) {
  const double dark = std::pow(std::clamp(share, 0.0, 1.0), 3.0);  // the top is flat
  const auto mix = [&](double at_zero, double at_one) {
    return std::to_string(std::lround(std::lerp(at_zero, at_one, dark)));
  };
  return "rgb(" + mix(255, 8) + "," + mix(255, 48) + "," + mix(255, 107) + ")";
}

/// Pixels of a map; the y axis upwards.
struct Axes {
  const LayoutMap& map;
  double step(const std::vector<double>& v) const {
    return v.size() > 1 ? v[1] - v[0] : rad_from_deg(1.0);
  }
  double scale() const {
    const auto& a = map.azimuth_rad;
    return kWidth_px / (a.back() - a.front() + step(a));
  }
  double height_px() const {
    const auto& e = map.elevation_rad;
    return scale() * (e.back() - e.front() + step(e));
  }
  double x(double azimuth_rad) const {
    const auto& a = map.azimuth_rad;
    return kMargin_px + scale() * (azimuth_rad - a.front() + 0.5 * step(a));
  }
  double y(double elevation_rad) const {
    const auto& e = map.elevation_rad;
    return height_px() - scale() * (elevation_rad - e.front() + 0.5 * step(e)) + 10.0;
  }
};

std::string cell(const Axes& axes, std::size_t i, std::size_t j, double most) {
  const LayoutMap& m = axes.map;
  const LayoutFigures& f = m.at(i, j);
  const double w = axes.scale() * axes.step(m.azimuth_rad);
  const double h = axes.scale() * axes.step(m.elevation_rad);
  const double x = axes.x(m.azimuth_rad[i]) - 0.5 * w, y = axes.y(m.elevation_rad[j]) - 0.5 * h;
  std::string text = "<rect x='" + px(x) + "' y='" + px(y) + "' width='" + px(w + 0.3) +
                     "' height='" + px(h + 0.3) + "' fill='" + colour(f.k05_radpm / most) +
                     "'><title>" + degrees(m.azimuth_rad[i]) + ", " + degrees(m.elevation_rad[j]) +
                     " deg: " + format_value(f.k05_radpm, 5) + " rad/m</title></rect>";
  if (!f.is_allowed()) {
    text += "<path d='M" + px(x) + " " + px(y) + " l" + px(w) + " " + px(h) +
            "' stroke='#a00' stroke-width='0.7'/>";
  }
  return text + "\n";
}

std::string label(double x, double y, const std::string& text) {
  return "<text x='" + px(x) + "' y='" + px(y) + "'>" + text + "</text>";
}

std::string heat_map(const OptimizedLidar& o) {
  const Axes axes{o.map};
  const double bottom = axes.height_px() + 10.0;
  std::string svg = "<svg width='" + px(kWidth_px + 2.0 * kMargin_px) + "' height='" +
                    px(bottom + 50.0) + "' font-size='13'>\n";
  for (std::size_t j = 0; j < o.map.elevation_rad.size(); ++j)
    for (std::size_t i = 0; i < o.map.azimuth_rad.size(); ++i)
      svg += cell(axes, i, j, o.figures.k05_radpm);
  svg += "<circle cx='" + px(axes.x(o.best.azimuth_rad)) + "' cy='" +
         px(axes.y(o.best.elevation_rad)) +
         "' r='6' fill='none' stroke='#e60' stroke-width='3'/>\n";
  const auto& a = o.map.azimuth_rad;
  const auto& e = o.map.elevation_rad;
  for (const double v : {a.front(), 0.5 * (a.front() + a.back()), a.back()})
    svg += label(axes.x(v) - 10.0, bottom + 18.0, degrees(v));
  for (const double v : {e.front(), 0.5 * (e.front() + e.back()), e.back()})
    svg += label(20.0, axes.y(v) + 4.0, degrees(v));
  svg += label(kMargin_px + 0.5 * kWidth_px - 60.0, bottom + 38.0, "azimuth [deg]");
  return svg + label(2.0, axes.y(0.5 * (e.front() + e.back())) + 24.0, "elev. [deg]") + "</svg>\n";
}

}  // namespace

const OptimizedLidar& best_of(const std::vector<OptimizedLidar>& found) {
  return *std::ranges::max_element(found, {},
                                   [](const OptimizedLidar& o) { return o.figures.k05_radpm; });
}

std::string optimize_table(const DesignCase& d, const std::vector<OptimizedLidar>& found,
                           double as_it_is_radpm) {
  TextTable table({"beams", "by", "azimuth [deg]", "elevation [deg]", "gates from [m]", "to [m]",
                   "k0.5 [rad/m]", "eddy [m]", "lead to spare [s]", "layouts"});
  const auto add = [&](const std::string& by, const LidarLayout& l, const LayoutFigures& f,
                       const std::string& judged) {
    table.add_row({std::to_string(l.beams), by, degrees(l.azimuth_rad), degrees(l.elevation_rad),
                   format_value(l.first_gate_m, 1), format_value(l.last_gate_m, 1),
                   format_value(f.k05_radpm, 5), format_value(2.0 * kPi / f.k05_radpm, 0),
                   d.optimize->lead_at_mps ? format_value(f.lead_margin_s, 2) : "not asked",
                   judged});
  };
  for (const OptimizedLidar& o : found) {
    add("grid", o.best_of_grid, o.grid_figures, std::to_string(o.map.figures.size()));
    add("search", o.best, o.figures, std::to_string(o.judged));
  }
  return "lac optimize " + d.file.filename().string() +
         "\nturbulence: " + describe_turbulence(d.turbulence) + "\nmodel: " + describe_model(d) +
         "\nk0.5 at " + format_value(d.optimize->wind_speed_mps, 1) +
         " m/s; of the lidar as it is (" + describe(d.lidar) +
         "): " + format_value(as_it_is_radpm, 5) + " rad/m\n" + table.text();
}

std::string map_csv(const std::vector<OptimizedLidar>& found) {
  std::string text =
      csv_line({"beams", "azimuth [deg]", "elevation [deg]", "k05 [rad/m]", "allowed [-]"});
  for (const OptimizedLidar& o : found) {
    for (std::size_t j = 0; j < o.map.elevation_rad.size(); ++j) {
      for (std::size_t i = 0; i < o.map.azimuth_rad.size(); ++i) {
        const LayoutFigures& f = o.map.at(i, j);
        text +=
            csv_line({std::to_string(o.best.beams), csv_number(deg_from_rad(o.map.azimuth_rad[i])),
                      csv_number(deg_from_rad(o.map.elevation_rad[j])), csv_number(f.k05_radpm),
                      f.is_allowed() ? "1" : "0"});
      }
    }
  }
  return text;
}

std::string map_page(const DesignCase& d, const std::vector<OptimizedLidar>& found) {
  std::string page =
      "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>k0.5 over the beam "
      "angles</title>\n<style>body{font-family:sans-serif;margin:2em;max-width:60em}</style></head>"
      "<body>\n<h1>Wavenumber of coherence 1/2 over the beam angles</h1>\n<p>" +
      describe_turbulence(d.turbulence) + ". " + describe_model(d) + ".</p>\n";
  for (const OptimizedLidar& o : found) {
    page += "<h2>" + std::to_string(o.best.beams) +
            " beams</h2>\n<p>Best (ring): " + in_place(o.best) + ": k0.5 " +
            format_value(o.figures.k05_radpm, 5) +
            " rad/m. The darker the better; crossed out: breaks a constraint.</p>\n" + heat_map(o);
  }
  return page + "</body></html>\n";
}

}  // namespace lac::sim
