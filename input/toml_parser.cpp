// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// toml++ itself, compiled here rather than taken from a shared library: with std::from_chars for numbers, where
// a library built for older compilers takes a stream for every one of them. A third of the time of reading.
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
