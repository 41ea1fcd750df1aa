// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/lammps/deck.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "comparisons/lammps/styles.hpp"
#include "comparisons/lammps/walls.hpp"
#include "comparisons/peers/deck.hpp"

namespace grainproof::lammps {
namespace {

using peers::TypeTable;

std::string style_name(const std::string& style) {
  return "gran/" + style.substr(0, style.find(' '));
}

/// Those of walls come after them and have no atoms.
std::size_t particle_types(const TypeTable& table) {
  return static_cast<std::size_t>(std::count_if(table.types.begin(), table.types.end(),
                                                [](const peers::AtomType& type) { return type.mass > 0.0; }));
}

/// The styles of all pairs, each once: parameters are global to a style, so every set of them is a
/// style of its own in a hybrid.
std::vector<std::string> styles_of(const Scene& scene, const TypeTable& table) {
  std::vector<std::string> styles;
  for (std::size_t a = 0; a < particle_types(table); ++a)
    for (std::size_t b = a; b < particle_types(table); ++b) {
      const std::string style = style_of(scene, table.types[a], table.types[b]);
      if (!style.empty() && std::find(styles.begin(), styles.end(), style) == styles.end())
        styles.push_back(style);
    }
  std::sort(styles.begin(), styles.end());  // those of one name together: they are numbered within it
  return styles;
}

/// As pair_coeff calls a style of a hybrid: with a number where its name comes more than once.
std::string called(const std::vector<std::string>& styles, const std::string& style) {
  const std::string name = style_name(style);
  const auto same = [&](const std::string& other) { return style_name(other) == name; };
  if (std::count_if(styles.begin(), styles.end(), same) == 1) return name;
  const auto here = std::find(styles.begin(), styles.end(), style);
  return name + ' ' + std::to_string(std::count_if(styles.begin(), here, same) + 1);
}

std::string contacts(const Scene& scene, const TypeTable& table) {
  const std::vector<std::string> styles = styles_of(scene, table);
  if (styles.empty()) return "comm_modify cutoff 1e-3\npair_style none\n";
  std::ostringstream out;
  out << "pair_style hybrid";
  for (const std::string& style : styles) out << " gran/" << style;
  out << "\npair_coeff * * none\n";
  for (std::size_t a = 0; a < particle_types(table); ++a)
    for (std::size_t b = a; b < particle_types(table); ++b)
      if (const std::string style = style_of(scene, table.types[a], table.types[b]); !style.empty())
        out << "pair_coeff " << a + 1 << ' ' << b + 1 << ' ' << called(styles, style) << '\n';
  return out.str();
}

/// A fix has one set of parameters, so there is one a wall and type of particle.
std::string walls(const Scene& scene, const TypeTable& table) {
  std::ostringstream out = peers::exact_text();
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    out << wall_region(scene, w);
    for (std::size_t t = 0; t < table.types.size(); ++t) {
      if (!table.types[t].moves) continue;
      const std::string style = style_of(scene, table.types[t], table.types[table.of_wall[w]]);
      if (style.empty()) continue;
      out << "group touching" << t << " type " << t + 1 << "\nfix wall" << w << '_' << t << " touching" << t
          << ' ' << wall_fix(scene, w, style) << '\n';
    }
  }
  return out.str();
}

}  // namespace

std::string scene_deck(const Scene& scene, const Request& request, const std::filesystem::path& folder,
                       int number) {
  const TypeTable table = peers::atom_types(scene);
  peers::write_inputs(scene, request, table, folder, number);
  return "clear\natom_style sphere\n" + peers::set_up(scene, "comm_modify vel yes", false, number) +
         contacts(scene, table) + walls(scene, table) + peers::motion(scene, table) +
         peers::fields(scene, table) + peers::output_and_run(scene, request, "format line", number);
}

}  // namespace grainproof::lammps
