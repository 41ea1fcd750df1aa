// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string_view>
#include <vector>

#include "model/engine.hpp"

/// Exact solutions as engines: each recognises from the scene alone whether it applies, and is
/// evaluated at the very times asked for (Frame::time is the time asked).
namespace grainproof::analytic {

/// In the order in which "analytic" tries them.
std::vector<std::string_view> closed_form_names();

/// Throws InputRefused, with the names there are, for a name that is none.
std::unique_ptr<Engine> make_closed_form(std::string_view name);

/// "analytic": the first closed form that supports the scene.
std::unique_ptr<Engine> make_analytic_engine();

}  // namespace grainproof::analytic
