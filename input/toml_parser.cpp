// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// toml++ itself, compiled here rather than taken from a shared library: with std::from_chars for numbers,
// where a library built for older compilers takes a stream for every one of them. A third of the time of
// reading.
//
// Without assertions it takes for granted what they would check, and a malformed file can break it: a key
// that begins with none of a key's characters. Neither is wanted here, since its parser refuses such a file
// by itself.
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
