// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/fields.hpp"
#include "reference_cpu/memories.hpp"
#include "reference_cpu/reference_run.hpp"

// What a run needs to go on with the same bits, in the order and numbering of its own. Whatever a step reads
// that neither the scene nor the time tells belongs here.
namespace grainproof::reference {

void pack_bodies(Sections& own, const Bodies& bodies) {
  pack(own, "bodies.body", bodies.body);
  pack(own, "bodies.spin", bodies.spin);
  pack(own, "bodies.acceleration", bodies.acceleration);
  pack(own, "bodies.angular_acceleration", bodies.angular_acceleration);
  pack(own, "bodies.orientation", bodies.orientation);
  pack(own, "bodies.origin", bodies.origin);
}

void unpack_bodies(const Sections& own, Bodies& bodies) {
  std::vector<std::int32_t> origin;
  unpack(own, "bodies.origin", origin);
  if (origin.size() != bodies.size()) throw InputRefused("the checkpoint has another number of particles");
  reorder(bodies, origin);
  unpack(own, "bodies.body", bodies.body);
  unpack(own, "bodies.spin", bodies.spin);
  unpack(own, "bodies.acceleration", bodies.acceleration);
  unpack(own, "bodies.angular_acceleration", bodies.angular_acceleration);
  unpack(own, "bodies.orientation", bodies.orientation);
}

Checkpoint ReferenceRun::checkpoint() {
  raise_trouble();
  Checkpoint made = portable();
  made.maker = checkpoint_maker;
  pack_one(made.own, "step", step_);
  pack_one(made.own, "first_step", first_step_);
  pack_bodies(made.own, bodies_);
  pack_memories(made.own, history_);
  pack(made.own, "touching", touching_.memories());
  neighbours_.pack_into(made.own);
  space_order_.pack_into(made.own);
  if (!ledger_) return made;
  made.ledger = ledger();
  ledger_->pack_into(made.own);
  return made;
}

void ReferenceRun::restore(const Sections& own) {
  unpack_one(own, "step", step_);
  unpack_one(own, "first_step", first_step_);
  bodies_ = bodies_of(scene_);
  unpack_bodies(own, bodies_);
  history_ = ContactHistory(unpacked_memories(own));
  std::vector<Touching::Memory> touching;
  unpack(own, "touching", touching);
  touching_ = Touching(std::move(touching));
  neighbours_.unpack_from(own);
  space_order_.unpack_from(own);
  if (ledger_) ledger_->unpack_from(own);
  walls_.move_to(time());
  watch_ = Watch(scene_.run.overlap_limit);
}

}  // namespace grainproof::reference
