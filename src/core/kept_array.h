#pragma once

#include "core/large_pages.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace vo {

/// An array that is filled anew again and again: it keeps its memory, and new elements are not initialised.
template <class T>
class KeptArray
{
    static_assert(std::is_trivially_copyable_v<T>);

public:
    std::size_t size() const { return size_; }
    T* data() { return data_; }
    const T* data() const { return data_; }
    std::span<T> all() { return {data_, size_}; }
    std::span<const T> all() const { return {data_, size_}; }
    T& operator[](std::size_t i) { return data_[i]; }
    const T& operator[](std::size_t i) const { return data_[i]; }

    void clear() { size_ = 0; }
    /// What is there up to the smaller size stays.
    void resize(std::size_t size)
    {
        if (size > capacity_) reserve(std::max(size, capacity_ + capacity_ / 2));
        size_ = size;
    }
    /// Appends `count` elements for the caller to write. Earlier pointers are void.
    T* grow(std::size_t count)
    {
        resize(size_ + count);
        return data_ + size_ - count;
    }

private:
    void reserve(std::size_t capacity)
    {
        std::unique_ptr<T[]> small;
        LargePages large;
        if (capacity > kFew)
            large = allocateLargePages(checkedBytes(capacity));
        else
            small.reset(new T[capacity]);
        T* const larger = large ? reinterpret_cast<T*>(large.get()) : small.get();
        if (size_ > 0) std::memcpy(static_cast<void*>(larger), data_, size_ * sizeof(T));
        small_ = std::move(small);
        large_ = std::move(large);
        data_ = larger;
        capacity_ = capacity;
    }
    static std::size_t checkedBytes(std::size_t count)
    {
        if (count > std::size_t(-1) / 2 / sizeof(T)) throw std::bad_alloc();
        return count * sizeof(T);
    }

    static constexpr std::size_t kFew = 2 * kLargePageBytes / sizeof(T);
    std::unique_ptr<T[]> small_; ///< one of these
    LargePages large_;
    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

} // namespace vo
