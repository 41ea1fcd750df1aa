// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/bench_page.hpp"

#include "report/plot.hpp"

namespace grainproof::report {
namespace {

constexpr const char* style =
    "body{font:15px/1.45 sans-serif;max-width:72em;margin:2em auto;padding:0 1em;color:#222}"
    "img{max-width:100%;height:auto}figure{margin:1em 0;break-inside:avoid}"
    "pre{font-size:12px;overflow-x:auto}.note{color:#555}";

/// Pictures share names of clip paths, so each stays a document of its own.
std::string as_data(const std::string& svg) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string text = "data:image/svg+xml,";
  for (const char c : svg) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 32 && byte < 127 && std::string("%\"'<>#&").find(c) == std::string::npos) {
      text += c;
      continue;
    }
    text += '%';
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

}  // namespace

std::string bench_page(const Machine& machine,
                       const std::vector<std::pair<std::string, std::string>>& pictures,
                       const std::string& tables) {
  std::string body = "<h1>Grainproof: benchmarks</h1>\n<p class=\"note\">" +
                     escaped("grainproof " + machine.version + ", " + machine.processor + ", " +
                             std::to_string(machine.threads) + " threads, " + machine.system) +
                     "</p>\n";
  for (const auto& [name, svg] : pictures)
    body += "<figure><img id=\"" + escaped(name) + "\" alt=\"" + escaped(name) + "\" src=\"" + as_data(svg) +
            "\"></figure>\n";
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width\"><title>Grainproof: "
         "benchmarks</title><style>" +
         std::string(style) + "</style></head>\n<body>\n" + body + "<pre>" + escaped(tables) +
         "</pre>\n</body></html>\n";
}

}  // namespace grainproof::report
