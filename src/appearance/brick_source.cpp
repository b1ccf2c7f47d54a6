#include "appearance/brick_source.h"

#include <cassert>
#include <cstdlib>

namespace vo {

void MemoryBrickSource::Free::operator()(std::byte* p) const
{
    std::free(p);
}

MemoryBrickSource::MemoryBrickSource(std::size_t brickCount) : slots_(brickCount) {}

std::span<std::byte> MemoryBrickSource::voxels(std::size_t brick) const
{
    assert(brick < slots_.size());
    return slots_[brick].voxels;
}

// calloc, since large blocks then stay untouched zero pages until somebody writes to them: the partial bricks
// of a big volume cost no memory where they are empty.
bool MemoryBrickSource::allocate(std::size_t brick, std::size_t bytes)
{
    assert(brick < slots_.size());
    std::unique_ptr<std::byte, Free> fresh(static_cast<std::byte*>(std::calloc(bytes, 1)));
    if (!fresh) return false;
    Slot& slot = slots_[brick];
    slot.own = std::move(fresh);
    slot.voxels = {slot.own.get(), bytes};
    return true;
}

void MemoryBrickSource::release(std::size_t brick)
{
    assert(brick < slots_.size());
    slots_[brick] = {};
}

void MemoryBrickSource::borrow(std::size_t brick, std::span<std::byte> voxels)
{
    assert(brick < slots_.size());
    slots_[brick].own.reset();
    slots_[brick].voxels = voxels;
}

bool MemoryBrickSource::owns(std::size_t brick) const
{
    assert(brick < slots_.size());
    return slots_[brick].own != nullptr;
}

} // namespace vo
