// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>

namespace grainproof::fuzz {

/// Numbers at which something changes: signs, zeros, the ends of ranges and of formats.
inline constexpr std::string_view edges[] = {"0",
                                             "0.0",
                                             "-0.0",
                                             "1",
                                             "-1",
                                             "1.0",
                                             "2",
                                             "3",
                                             "0.5",
                                             "-0.5",
                                             "2.0",
                                             "0.9999999999999999",
                                             "1.0000000000000002",
                                             "1e308",
                                             "-1e308",
                                             "1.7976931348623157e308",
                                             "2.2250738585072014e-308",
                                             "5e-324",
                                             "1e-300",
                                             "1e-160",
                                             "1e160",
                                             "nan",
                                             "inf",
                                             "-inf",
                                             "1e400",
                                             "9007199254740992",
                                             "9007199254740993",
                                             "9223372036854775807",
                                             "-9223372036854775808",
                                             "9223372036854775808",
                                             "1e15",
                                             "1e-15",
                                             "1e16",
                                             "0x10",
                                             "0o17",
                                             "0b11",
                                             "1_000",
                                             "64",
                                             "1000000",
                                             "20000001",
                                             "1e6",
                                             "1e-6",
                                             "+1",
                                             "01",
                                             "1.",
                                             ".5",
                                             "1e",
                                             "-"};

/// Values of every type that TOML has, where another was meant.
inline constexpr std::string_view odd_values[] = {
    "true",
    "false",
    "\"\"",
    "\"text\"",
    "'literal'",
    "[]",
    "{}",
    "[1]",
    "[1, 2]",
    "[0, 0, 0]",
    "[1.0, 2.0, 3.0]",
    "[[0, 0, 0]]",
    "[[[0]]]",
    "{ a = 1 }",
    "[{}]",
    "1979-05-27",
    "1979-05-27T07:32:00Z",
    "07:32:00",
    "\"contact/64\"",
    "\"contact/0\"",
    "\"contact/nan\"",
    "\"contact/1e9\"",
    "\"contact/-1\"",
    "{ uniform = [0.01, 0.02], seed = 1 }",
    "{ kind = \"random\", count = 3, seed = 1 }",
    "{ kind = \"lattice\", counts = [2, 2, 2], origin = [0, 0, 0] }",
    "{ kind = \"file\", path = \"/dev/null\" }",
    "{ kind = \"file\", path = \".\" }",
    "[\"open\", \"periodic\", \"wall\"]"};

/// Pieces of rubbish.
inline constexpr std::string_view rubbish[] = {
    "[",      "]",       "{",    "}",        "\"",           "'",  "=",  ",",
    ".",      "#",       "\n",   "\r",       "\t",           "\0", "[[", "]]",
    "\"\"\"", "\\u0000", "\xff", "\xc3\x28", "\xef\xbb\xbf", "…"};

}  // namespace grainproof::fuzz
