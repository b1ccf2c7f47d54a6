#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>

namespace vo::test {

/// Calls check() with each instruction set that this machine has.
template <class Check>
void forTargets(const Check& check)
{
    for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
        hwy::SetSupportedTargetsForTest(targets & -targets);
        SCOPED_TRACE(hwy::TargetName(targets & -targets));
        check();
    }
    hwy::SetSupportedTargetsForTest(0);
}

} // namespace vo::test
