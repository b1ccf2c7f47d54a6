#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
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
    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    std::span<T> all() { return {data_.get(), size_}; }
    std::span<const T> all() const { return {data_.get(), size_}; }
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
        return data_.get() + size_ - count;
    }

private:
    void reserve(std::size_t capacity)
    {
        std::unique_ptr<T[]> larger(new T[capacity]);
        if (size_ > 0) std::memcpy(static_cast<void*>(larger.get()), data_.get(), size_ * sizeof(T));
        data_ = std::move(larger);
        capacity_ = capacity;
    }

    std::unique_ptr<T[]> data_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

} // namespace vo
