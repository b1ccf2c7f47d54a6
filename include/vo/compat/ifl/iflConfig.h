#ifndef VO_COMPAT_IFL_CONFIG_H
#define VO_COMPAT_IFL_CONFIG_H

#include <ifl/iflTypes.h>

/** How pixels lie in the memory of a program: type of a channel, and order of the channels. */
class iflConfig
{
public:
    explicit iflConfig(iflDataType type = iflUChar, iflOrder channelOrder = iflInterleaved)
        : dataType(type), order(channelOrder)
    {
    }
    iflDataType getDataType() const { return dataType; }
    iflOrder getOrder() const { return order; }

private:
    iflDataType dataType;
    iflOrder order;
};

#endif
