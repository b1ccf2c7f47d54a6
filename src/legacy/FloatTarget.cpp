#include "draw/float_target.h"

#include "legacy/inside.h"
#include "legacy/report.h"

#include <vo/FloatTarget.h>

#include <memory>

using vo::badValue;
using vo::guarded;

struct voFloatTarget::Private
{
    std::unique_ptr<vo::FloatTarget> target; ///< none when the constructor failed
};

namespace {

vo::FloatTarget& requiredTarget(const std::unique_ptr<vo::FloatTarget>& target)
{
    if (!target) vo::unsupported("the target could not be made");
    return *target;
}

} // namespace

voFloatTarget::voFloatTarget(int width, int height) : d(new Private)
{
    guarded("voFloatTarget", [&] {
        vo::ContextRecord& context = vo::requireContext();
        const int limit = vo::FloatTarget::largestSize(context);
        if (width < 1 || height < 1 || width > limit || height > limit)
            badValue(std::to_string(width) + " x " + std::to_string(height) + " pixels, 1 to " +
                     std::to_string(limit) + " are possible");
        d->target = std::make_unique<vo::FloatTarget>(context, width, height);
    });
}

voFloatTarget::~voFloatTarget()
{
    delete d;
}

void voFloatTarget::begin()
{
    guarded("voFloatTarget::begin", [&] { requiredTarget(d->target).begin(); });
}

void voFloatTarget::end()
{
    guarded("voFloatTarget::end", [&] { requiredTarget(d->target).end(); });
}

void voFloatTarget::show(int x, int y) const
{
    guarded("voFloatTarget::show", [&] { requiredTarget(d->target).show(x, y); });
}

void voFloatTarget::readPixels(float* pixels) const
{
    guarded("voFloatTarget::readPixels", [&] {
        if (!pixels) badValue("pixels is NULL");
        requiredTarget(d->target).readPixels(pixels);
    });
}

int voFloatTarget::getWidth() const
{
    return d->target ? d->target->width() : 0;
}

int voFloatTarget::getHeight() const
{
    return d->target ? d->target->height() : 0;
}
