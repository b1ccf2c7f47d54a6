// Every signature of the interface in both dialects: signatures/ was compiled as C++98 and as C++20 with all
// warnings.

#include "../legacy/expect_error.h"

#include <vo/Volumizer.h>

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#define DIALECT cxx98
#include "signatures/groups.h"
#undef DIALECT
#define DIALECT cxx20
#include "signatures/groups.h"

void noteRow(const char* row);

namespace {

std::vector<std::string> noted;

/// The rows that the groups note, in their order, with what went wrong on the way.
std::vector<std::string> rowsOf(std::initializer_list<void (*)()> groups)
{
    noted.clear();
    for (const auto group : groups)
        group();
    return noted;
}

std::vector<std::string> rowsIn98()
{
    using namespace cxx98;
    return rowsOf({basics, enumerations, errors, geometry, geometryActions, appearance, appearanceActions,
                   lookup, utilities, contradictions});
}

std::vector<std::string> rowsIn20()
{
    using namespace cxx20;
    return rowsOf({basics, enumerations, errors, geometry, geometryActions, appearance, appearanceActions,
                   lookup, utilities, contradictions});
}

TEST(SignaturesTest, everyRowIsUsedInBothDialects)
{
    const std::vector<std::string> rows = rowsIn98();
    EXPECT_GT(rows.size(), 170u);
    EXPECT_EQ(rowsIn20(), rows);
    const std::set<std::string> different(rows.begin(), rows.end());
    EXPECT_EQ(different.size(), rows.size());
}

#if defined(VI_TRUE) || defined(voewport) || defined(voInterleavedArrayFormat)
constexpr bool slipsAreDefined = true;
#else
constexpr bool slipsAreDefined = false;
#endif
// Programs may have these names for themselves.
enum { VI_TRUE, voInterleavedArrayFormat, voewport };

TEST(SignaturesTest, namesThatAreSlipsAreNotDefined)
{
    EXPECT_FALSE(slipsAreDefined);
    EXPECT_EQ(VI_TRUE + voInterleavedArrayFormat, 1);
}

} // namespace

void noteRow(const char* row)
{
    noted.emplace_back(row);
}
