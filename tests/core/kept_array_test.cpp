#include "core/kept_array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <utility>

namespace {

std::uint32_t valueAt(std::size_t i)
{
    return static_cast<std::uint32_t>(2654435761u * i);
}

} // namespace

TEST(KeptArray, growingIntoLargePagesKeepsWhatIsThere)
{
    vo::KeptArray<std::uint32_t> array;
    const std::size_t steps[]{3, 1000, vo::kLargePageBytes / 2, vo::kLargePageBytes, 3 * vo::kLargePageBytes};
    std::size_t filled = 0;
    for (const std::size_t size : steps) {
        array.resize(size);
        for (; filled < size; ++filled)
            array[filled] = valueAt(filled);
    }
    for (std::size_t i = 0; i < filled; ++i)
        ASSERT_EQ(array[i], valueAt(i)) << i;
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % vo::kLargePageBytes, 0u);
}

TEST(KeptArray, memoryStaysWhenItShrinks)
{
    vo::KeptArray<std::uint32_t> array;
    for (const std::size_t size : {std::size_t{100}, 2 * vo::kLargePageBytes}) {
        array.resize(size);
        const std::uint32_t* const memory = array.data();
        array.clear();
        array.resize(size);
        EXPECT_EQ(array.data(), memory);
    }
}

TEST(KeptArray, sizesBeyondAllMemoryThrowAndChangeNothing)
{
    vo::KeptArray<std::uint32_t> array;
    *array.grow(1) = 7;
    EXPECT_THROW(array.resize(SIZE_MAX / 2), std::bad_alloc);
    EXPECT_EQ(array.size(), 1u);
    EXPECT_EQ(array[0], 7u);
}
