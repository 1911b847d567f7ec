// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/design_report.hpp"

#include <limits>
#include <sstream>

#include "sim_harness/design/input_template.hpp"
#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/csv_table.hpp"

namespace lac::sim {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const std::vector<std::string> kHeader{
    "wind [m/s]",   "k0.5 [rad/m]", "eddy [m]",       "[D]",      "class",
    "cut-off [Hz]", "fit [Hz]",     "gates from [m]", "lead [s]", "filter [s]",
    "actuator [s]", "window/2 [s]", "buffer [s]",     "late [s]"};

std::string gates_text(const FeedforwardPoint& p) {
  return p.is_usable ? format_value(p.nearest_gate_m, 1) : "none leads enough";
}

std::vector<std::string> row(const FeedforwardPoint& p, double diameter_m) {
  const double eddy_m = p.figures.smallest_eddy_m().value_or(kNaN);
  const auto eddy_class = p.figures.eddy_class(diameter_m);
  return {format_value(p.mean_speed_mps, 1),
          format_value(p.figures.k05_radpm.value_or(kNaN), 4),
          format_value(eddy_m, 0),
          format_value(eddy_m / diameter_m, 2),
          eddy_class ? text_of(*eddy_class) : "n/a",
          format_value(p.cutoff_hz, 4),
          format_value(p.figures.fitted_cutoff_hz.value_or(kNaN), 4),
          gates_text(p),
          format_value(p.lead_s, 2),
          format_value(p.filter_s, 2),
          format_value(p.actuator_s, 2),
          format_value(p.half_window_s, 2),
          format_value(p.buffer_s(), 2),
          format_value(p.late_s, 2)};
}

std::vector<std::string> origin(const DesignResult& r) {
  const FeedforwardTiming& t = r.design.timing;
  std::ostringstream delays;
  delays << "delays at " << t.delay_frequency_hz << " Hz; a gate must lead by " << t.lead_margin_s
         << " s more than needed";
  std::ostringstream quadrature;
  quadrature.precision(1);
  quadrature << "quadrature: |G_RL| at the cut-off moves by " << std::scientific
             << r.quadrature_error << " with finer steps";
  std::ostringstream left;
  left << "left of the variance of the rotor's wind:";
  for (const FeedforwardPoint& p : r.points) left << ' ' << format_value(100.0 * p.share_left, 1);
  left << " %, by the best filter there is:";
  for (std::size_t i = 0; i < r.points.size(); ++i) {
    left << ' '
         << format_value(100.0 * share_left_of_wiener(r.curves.curve(i, r.points[i].first_plane)),
                         1);
  }
  left << " %";
  return {"lac design " + r.design.file.filename().string(),
          "turbulence: " + describe_turbulence(r.design.turbulence),
          "lidar: " + describe(r.design.lidar),
          "model: " + describe_model(r.design),
          delays.str(),
          quadrature.str(),
          left.str()};
}

std::string table_text(const DesignResult& r) {
  TextTable table(kHeader);
  for (const FeedforwardPoint& p : r.points) table.add_row(row(p, 2.0 * r.design.rotor_radius_m));
  return table.text();
}

/// What the design writes, and with it takes out of the template; lower case.
std::vector<std::string> designed_keys(const DesignResult& r) {
  std::vector<std::string> keys{"cutoffwindspeed", "cutofffrequency", "filterorder",
                                "filterdamping"};
  if (r.design.timing.trim_lateness) keys.insert(keys.end(), {"buffertrimwindspeed", "buffertrim"});
  return keys;
}

/// Comments with the origin of the numbers, and the rows.
std::string schedule_block(const DesignResult& r) {
  std::string text;
  for (const std::string& line : origin(r)) text += line + "\n";
  std::ostringstream rows;
  const auto row_of = [&](const char* what, const auto& value) {
    for (const FeedforwardPoint& p : r.points) rows << value(p) << ' ';
    rows << what << '\n';
  };
  const auto speed = [](const FeedforwardPoint& p) { return shortest(p.mean_speed_mps); };
  row_of("! CutOffWindSpeed - mean wind speed of the schedule [m/s]", speed);
  const bool second = r.design.timing.filter_order == 2;
  row_of(second ? "! CutOffFrequency - natural frequency of the second-order low-pass there [Hz]"
                : "! CutOffFrequency - of the first-order low-pass there [Hz]",
         [](const FeedforwardPoint& p) { return format_value(p.low_pass.frequency_hz, 5); });
  if (second) {
    rows << "2 ! FilterOrder - of the low-pass [-]\n";
    row_of("! FilterDamping - its damping there [-]",
           [](const FeedforwardPoint& p) { return format_value(p.low_pass.damping, 3); });
  }
  if (r.design.timing.trim_lateness) {
    row_of("! BufferTrimWindSpeed - mean wind speed of the trim [m/s]", speed);
    row_of("! BufferTrim - added to the computed buffer time: the estimate is late [s]",
           [](const FeedforwardPoint& p) { return format_value(p.trim_s, 3); });
  }
  return commented(text + table_text(r)) + rows.str();
}

}  // namespace

std::string design_table(const DesignResult& r) {
  std::string text;
  for (const std::string& line : origin(r)) text += line + "\n";
  return text + table_text(r);
}

std::string designed_ffp_input(std::string_view template_text, const DesignResult& r) {
  return with_keys_replaced(template_text, designed_keys(r), schedule_block(r));
}

std::string schedule_csv(const DesignResult& r) {
  std::string text =
      csv_line({"mean_speed [m/s]", "k05 [rad/m]", "smallest_eddy [m]", "cutoff [Hz]",
                "fitted_cutoff [Hz]", "nearest_gate [m]", "usable [-]", "lead [s]", "filter [s]",
                "actuator [s]", "half_window [s]", "buffer [s]", "late [s]"});
  for (const FeedforwardPoint& p : r.points) {
    text +=
        csv_line({csv_number(p.mean_speed_mps), csv_number(p.figures.k05_radpm.value_or(kNaN)),
                  csv_number(p.figures.smallest_eddy_m().value_or(kNaN)), csv_number(p.cutoff_hz),
                  csv_number(p.figures.fitted_cutoff_hz.value_or(kNaN)),
                  csv_number(p.nearest_gate_m), p.is_usable ? "1" : "0", csv_number(p.lead_s),
                  csv_number(p.filter_s), csv_number(p.actuator_s), csv_number(p.half_window_s),
                  csv_number(p.buffer_s()), csv_number(p.late_s)});
  }
  return text;
}

std::string curves_csv(const DesignResult& r) {
  std::string text = csv_line({"mean_speed [m/s]", "frequency [Hz]", "k1 [rad/m]",
                               "s_rr [m^2/s^2/Hz]", "s_ll [m^2/s^2/Hz]", "re_s_rl [m^2/s^2/Hz]",
                               "im_s_rl [m^2/s^2/Hz]", "coherence [-]", "gain [-]"});
  for (std::size_t i = 0; i < r.points.size(); ++i) {
    const CorrelationCurve c = r.curves.curve(i, r.points[i].first_plane);
    const std::vector<double> coherence = c.coherence(), gain = c.gain();
    for (std::size_t j = 0; j < gain.size(); ++j) {
      text += csv_line({csv_number(c.mean_speed_mps), csv_number(c.frequency_hz(j)),
                        csv_number(c.k1_radpm[j]), csv_number(c.s_rr[j]), csv_number(c.s_ll[j]),
                        csv_number(c.s_rl[j].real()), csv_number(c.s_rl[j].imag()),
                        csv_number(coherence[j]), csv_number(gain[j])});
    }
  }
  return text;
}

}  // namespace lac::sim
