// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/doctor.hpp"

#include <array>
#include <fstream>

#include "app/exit_code.hpp"
#include "app/resources.hpp"
#include "comparisons/peers/process.hpp"
#include "model/errors.hpp"
#include "opencl/engine.hpp"
#include "report/machine.hpp"
#include "report/numbers.hpp"

namespace grainproof::app {
namespace {

void show_machine(std::ostream& out, const report::Paint& paint) {
  const report::Machine machine = report::this_machine();
  out << paint.bold("Machine") << "\n  " << machine.processor << ", " << machine.threads << " threads, "
      << report::brief(static_cast<double>(machine.memory_bytes) / 1073741824.0) << " GiB\n  "
      << machine.system << "\n  grainproof " << machine.version << ", kernels and scenes in "
      << data_root().string() << "\n";
}

void show_devices(std::ostream& out, const report::Paint& paint) {
  out << paint.bold("OpenCL devices") << "\n";
  const auto devices = opencl::list_devices();
  if (devices.empty()) {
    out << "  none found. Install a driver: apt-get install pocl-opencl-icd (processor), or your GPU's own;\n"
           "  in a container a GPU needs its .icd file in /etc/OpenCL/vendors too.\n";
    return;
  }
  report::TextTable table({{"--device"}, {"kind"}, {"name"}, {"precisions"}, {"platform"}});
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const auto& device = devices[i];
    const std::string precisions = device.double_precision
                                       ? "single, mixed, double"
                                       : "single (no double: " + device.no_double_because + ")";
    table.add({std::to_string(i), device.gpu ? "GPU" : "CPU", device.name, precisions,
               device.platform + ", " + device.version});
  }
  out << table.text(paint, "  ");
}

/// A peer program, how it tells its version, and the Debian package that has it.
struct Peer {
  const char* program;
  const char* package;
  std::vector<std::string> version_command;
  std::string version_after;  ///< what stands before the version in the output
};

std::string version_of(const Peer& peer) {
  const TemporaryFolder folder;
  run_program(peer.version_command, folder.path(), folder.path() / "version");
  std::ifstream output(folder.path() / "version");
  for (std::string line; std::getline(output, line);)
    if (const std::size_t at = line.find(peer.version_after); at != std::string::npos)
      return line.substr(at + peer.version_after.size(),
                         line.find_first_of(",)", at) - at - peer.version_after.size());
  return "version unknown";
}

void show_peers(std::ostream& out, const report::Paint& paint) {
  const std::array peers{
      Peer{"liggghts", "liggghts", {"liggghts", "-in", "/dev/null", "-log", "none"}, "Version "},
      Peer{"lmp", "lammps", {"lmp", "-in", "/dev/null", "-log", "none"}, "LAMMPS ("},
  };
  report::TextTable table({{"peer"}, {"found"}, {"version, or how to get it"}});
  for (const Peer& peer : peers) {
    const auto program = find_program(peer.program);
    table.add({peer.package, program ? program->string() : "no",
               program ? version_of(peer) : std::string("apt-get install ") + peer.package});
  }
  out << paint.bold("Peers") << "\n"
      << table.text(paint, "  ") << "  any program of your own: --engines external:COMMAND\n";
}

}  // namespace

int doctor(Terminal& terminal) {
  show_machine(terminal.out, terminal.paint());
  show_devices(terminal.out, terminal.paint());
  show_peers(terminal.out, terminal.paint());
  return all_held;
}

}  // namespace grainproof::app
