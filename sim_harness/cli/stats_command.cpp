// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/stats_command.hpp"

#include <algorithm>
#include <ostream>

#include "core/error.hpp"
#include "sim_harness/cli/written_table.hpp"
#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/csv_table.hpp"
#include "sim_harness/tables/time_series.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr int kDigits = 5;

struct FileFigures {
  fs::path file;
  double duration_s = 0.0;
  std::vector<ChannelFigures> channels;
};

FileFigures figures_of(const fs::path& file, const StatsOptions& o) {
  const Recording recording = read_time_series(file, o.missing_rows);
  try {
    return {file, figures_duration_s(recording, o.figures),
            channel_figures(recording, o.figures, o.channels)};
  } catch (const Error& e) {
    throw Error(file.string() + ": " + e.what());
  }
}

std::string exponent_text(double m) {
  return "DEL m=" + format_value(m, m == static_cast<int>(m) ? 0 : 2);
}

TextTable table_of(const FileFigures& f, const FigureOptions& o) {
  std::vector<std::string> header{"channel", "unit", "mean", "std", "min", "at s", "max", "at s"};
  for (const double m : o.woehler_exponents) header.push_back(exponent_text(m));
  header.insert(header.end(), {"travel", "kWh"});
  TextTable table(header);
  const auto number = [](double x) { return format_significant(x, kDigits); };
  for (const ChannelFigures& c : f.channels) {
    const Statistics& s = c.statistics;
    std::vector<std::string> cells{c.channel.name, c.channel.unit,
                                   number(s.mean), number(s.standard_deviation),
                                   number(s.min),  format_value(c.min_time_s, 2),
                                   number(s.max),  format_value(c.max_time_s, 2)};
    for (const double load : c.damage_equivalent) cells.push_back(number(load));
    cells.push_back(c.travel ? number(*c.travel) : "");
    cells.push_back(c.energy_kWh ? number(*c.energy_kWh) : "");
    table.add_row(cells);
  }
  return table;
}

void print(const FileFigures& f, const FigureOptions& o, std::ostream& out) {
  out << f.file.string() << ": " << format_significant(f.duration_s, kDigits) << " s\n"
      << table_of(f, o).text();
  for (const ChannelFigures& c : f.channels) {
    if (c.not_finite > 0)
      out << c.channel.name << ": no figures, " << c.not_finite << " samples are not finite\n";
  }
  out << '\n';
}

/// One row per file; a column for every figure that one of them has.
std::string csv_text(const std::vector<FileFigures>& files, const FigureOptions& o) {
  std::vector<std::string> header{"file", kDelReferenceColumn, kDelRainflowColumn};
  const std::size_t words = header.size();
  std::vector<std::vector<NamedFigure>> rows;
  for (const FileFigures& f : files) {
    rows.push_back(named_figures(f.channels, o));
    rows.back().insert(rows.back().begin(), {"duration", "s", f.duration_s});
    for (const NamedFigure& figure : rows.back()) {
      if (std::find(header.begin(), header.end(), figure.header()) == header.end())
        header.push_back(figure.header());
    }
  }
  std::string text = csv_line(header);
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::vector<std::string> cells{files[i].file.string(), word_of(o.reference),
                                   word_of(o.counting)};
    for (std::size_t k = words; k < header.size(); ++k) {
      const auto found = std::find_if(rows[i].begin(), rows[i].end(), [&](const NamedFigure& f) {
        return f.header() == header[k];
      });
      cells.push_back(found == rows[i].end() ? "" : csv_number(found->value));
    }
    text += csv_line(cells);
  }
  return text;
}

}  // namespace

void stats_command(const StatsOptions& options, std::ostream& out) {
  std::vector<FileFigures> files;
  for (const fs::path& input : options.inputs) {
    for (const fs::path& file : time_series_of(input)) {
      files.push_back(figures_of(file, options));
      print(files.back(), options.figures, out);
    }
  }
  for (const double m : options.figures.woehler_exponents)
    out << exponent_text(m) << ": " << options.figures.convention(m).text() << '\n';
  write_table(options.csv, csv_text(files, options.figures), out);
}

}  // namespace lac::sim
