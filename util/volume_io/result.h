#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace vo {

/// Why something could not be done: one line, without a line end, that names the file, what was expected and
/// what was found.
struct Failure
{
    std::string text;
};

/// A value, or the reason why there is none.
template <class T>
class [[nodiscard]] Result
{
public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Failure failure) : content_(std::in_place_index<1>, std::move(failure)) {}

    explicit operator bool() const { return content_.index() == 0; }
    T& operator*() { return value(); }
    const T& operator*() const { return const_cast<Result*>(this)->value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &**this; }
    const Failure& failure() const
    {
        assert(!*this);
        return *std::get_if<1>(&content_);
    }

private:
    T& value()
    {
        assert(*this);
        return *std::get_if<0>(&content_);
    }

    std::variant<T, Failure> content_;
};

/// Success, or the reason why not. A default-constructed one is success.
template <>
class [[nodiscard]] Result<void>
{
public:
    Result() = default;
    Result(Failure failure) : failure_(std::move(failure)) {}

    explicit operator bool() const { return !failure_; }
    const Failure& failure() const
    {
        assert(failure_);
        return *failure_;
    }

private:
    std::optional<Failure> failure_;
};

} // namespace vo
