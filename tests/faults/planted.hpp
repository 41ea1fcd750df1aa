// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace grainproof::faults {

/// Which of the faults that are compiled into this program is planted, counted from 1; 0 is none.
extern int planted;

}  // namespace grainproof::faults
