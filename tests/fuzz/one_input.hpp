// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace grainproof::fuzz {

enum class Answer { read, refused };

struct Judged {
  Answer answer;
  std::string complaint;  ///< what is wrong with the answer; empty where nothing is
};

/// Reads a file of this text: it must be refused with a place and a reason, or be read and keep every
/// constraint; and what is read and `run` must complete, go wrong by name or be refused by name.
Judged judge(const std::string& text, bool run);

}  // namespace grainproof::fuzz
