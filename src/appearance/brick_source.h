#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace vo {

/// Hands out the voxels of bricks, numbered through all sets of a volume. The collection asks nothing else,
/// so voxels may come from memory (MemoryBrickSource), and later from a file, a page cache or a pyramid
/// (docs/brick-sources.md).
class BrickSource
{
public:
    virtual ~BrickSource() = default;

    /// The voxels of a brick in its external format, x fastest; empty when there are none (yet). Valid until
    /// the next call that changes this brick.
    virtual std::span<std::byte> voxels(std::size_t brick) const = 0;
    /// Gives the brick `bytes` bytes of zeroed storage of its own, in place of what it had. False, and
    /// nothing changed, when there is no memory or the source cannot.
    virtual bool allocate(std::size_t brick, std::size_t bytes) = 0;
    /// Lets storage of the source go; borrowed memory is forgotten.
    virtual void release(std::size_t brick) = 0;
    /// Uses memory of somebody else, which must outlive its use.
    virtual void borrow(std::size_t brick, std::span<std::byte> voxels) = 0;
    /// True when the source owns the brick's storage.
    virtual bool owns(std::size_t brick) const = 0;
};

/// Bricks in main memory.
class MemoryBrickSource final : public BrickSource
{
public:
    explicit MemoryBrickSource(std::size_t brickCount);

    std::span<std::byte> voxels(std::size_t brick) const override;
    bool allocate(std::size_t brick, std::size_t bytes) override;
    void release(std::size_t brick) override;
    void borrow(std::size_t brick, std::span<std::byte> voxels) override;
    bool owns(std::size_t brick) const override;

private:
    struct Free
    {
        void operator()(std::byte* p) const;
    };
    struct Slot
    {
        std::unique_ptr<std::byte, Free> own;
        std::span<std::byte> voxels;
    };
    std::vector<Slot> slots_;
};

} // namespace vo
