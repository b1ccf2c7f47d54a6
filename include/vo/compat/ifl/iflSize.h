#ifndef VO_COMPAT_IFL_SIZE_H
#define VO_COMPAT_IFL_SIZE_H

/** Pixels along x, y and z, and channels of a pixel. */
class iflSize
{
public:
    int x, y, z, c;

    iflSize() : x(0), y(0), z(0), c(0) {}
    iflSize(int xSize, int ySize, int zSize = 1, int channels = 1) : x(xSize), y(ySize), z(zSize), c(channels) {}
    bool operator==(const iflSize &other) const
    {
        return x == other.x && y == other.y && z == other.z && c == other.c;
    }
    bool operator!=(const iflSize &other) const { return !(*this == other); }
};

#endif
