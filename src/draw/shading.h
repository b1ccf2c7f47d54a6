#pragma once

#include "core/record_layout.h"
#include "draw/context_record.h"
#include "draw/draw_state.h"
#include "draw/programs.h"

namespace vo {

/// The program for what is drawn in a state.
ProgramVariant variantFor(const ContextRecord& context, const DrawState& state, const RecordLayout& layout);

/// The active post-interpolation table on its unit; sent when it is another one than last time.
void bindTable(ContextRecord& context, const DrawState& state);

} // namespace vo
