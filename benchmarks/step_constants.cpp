// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <span>
#include <string>

#include "benchmarks/common/contact_errors.hpp"

/// Writes analytic/measured_errors.cpp anew: bench_step_constants > analytic/measured_errors.cpp
/// With names of integrators, their rows alone: for one that is new.
namespace grainproof::bench {
namespace {

using analytic::ErrorLaw;

constexpr ErrorLaw laws[] = {ErrorLaw::linear, ErrorLaw::no_tension,    ErrorLaw::linear_history,
                             ErrorLaw::hertz,  ErrorLaw::hertz_history, ErrorLaw::drag};
constexpr double restitutions[] = {1.0, 0.9, 0.8, 0.6, 0.4, 0.2};
constexpr double no_rebound[] = {1.0};

void write_row(ErrorLaw law, Integrator integrator, double restitution) {
  std::printf("    MeasuredErrors{ErrorLaw::%s, Integrator::%s, %.1f, {", std::string(name_of(law)).c_str(),
              std::string(name_of(integrator)).c_str(), restitution);
  const char* before = "";
  for (double steps : analytic::measured_at) {
    std::printf("%s%.3g", before, contact_error(law, integrator, restitution, steps));
    before = ", ";
  }
  std::printf("}},\n");
  std::fflush(stdout);
}

void write_table(std::span<char* const> wanted) {
  for (ErrorLaw law : laws)
    for (const auto& [name, integrator] : integrator_names) {
      if (!wanted.empty() && std::ranges::find(wanted, name) == wanted.end()) continue;
      if (integrator == Integrator::euler_trapezoid_implicit_drag && law != ErrorLaw::drag) continue;
      if (!can_be_measured(law, integrator)) continue;
      for (double restitution : law == ErrorLaw::drag ? std::span<const double>(no_rebound) : restitutions)
        write_row(law, integrator, restitution);
    }
}

constexpr const char* head =
    "// SPDX-FileCopyrightText: 2026 The Grainproof authors\n"
    "// SPDX-License-Identifier: BSD-3-Clause\n"
    "#include \"analytic/measured_errors.hpp\"\n\n"
    "/// Written by bench_step_constants, which measures every row again.\n"
    "namespace grainproof::analytic {\n"
    "namespace {\n\n"
    "// clang-format off\n"
    "constexpr std::array table{\n";

constexpr const char* tail =
    "};\n"
    "// clang-format on\n\n"
    "}  // namespace\n\n"
    "std::span<const MeasuredErrors> measured_errors() {\n"
    "  return table;\n"
    "}\n\n"
    "}  // namespace grainproof::analytic\n";

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  const std::span<char* const> wanted(argv + 1, static_cast<std::size_t>(argc - 1));
  if (wanted.empty()) std::printf("%s", grainproof::bench::head);
  grainproof::bench::write_table(wanted);
  if (wanted.empty()) std::printf("%s", grainproof::bench::tail);
}
