// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/judge.hpp"

#include <utility>

#include "comparisons/judging/observing.hpp"
#include "comparisons/judging/outcomes.hpp"
#include "comparisons/judging/rows.hpp"
#include "comparisons/judging/searching.hpp"

namespace grainproof {

struct Judge::Parts {
  const Case& subject;
  Oracles oracles;
  Records records;
};

Judge::Judge(const Case& subject, Oracles oracles)
    : parts_(std::make_unique<Parts>(Parts{subject, std::move(oracles), {}})) {}

Judge::~Judge() = default;

std::vector<Row> Judge::rows(Engine& engine, const Progress& progress) {
  const Case& subject = parts_->subject;
  std::vector<Refusal> refusals;
  std::vector<Row> rows = rows_of_outcomes(subject, engine, refusals);
  std::vector<Claim> claims = claims_for(subject, engine, parts_->oracles, refusals);
  std::string precision = observe_claims(subject, engine, claims, parts_->records, progress);
  if (const std::string stated = search_claims(subject, engine, claims); !stated.empty()) precision = stated;
  const Row common = row_of(subject, engine.name(), precision);
  for (const Claim& claim : claims)
    for (Row& row : rows_of_claim(subject, claim, common)) rows.push_back(std::move(row));
  for (Row& row : rows_of_refusals(refusals, common)) rows.push_back(std::move(row));
  return rows;
}

std::vector<Row> judge(const Case& subject, Engine& engine, const Oracles& oracles,
                       const Progress& progress) {
  return Judge(subject, oracles).rows(engine, progress);
}

}  // namespace grainproof
