#ifndef VO_FLOAT_TARGET_H
#define VO_FLOAT_TARGET_H

#include <vo/Error.h>

/** A framebuffer of 32-bit floats with depth and stencil, to draw into and then show. A volume drawn straight into
    8 bits loses what each slice rounds away (25 dB at an opacity of 0.02); here nothing is lost. Lives in the context
    that is current when it is made; all functions need that context. */
class VO_API voFloatTarget
{
public:
    /** width x height pixels, both at least 1, at most the limit of the context: else BAD_VALUE. */
    voFloatTarget(int width, int height);
    ~voFloatTarget();

    /** Drawing goes here, and the viewport covers it, until end(), which gives both back as they were. Clears nothing. */
    void begin();
    void end();
    /** Copies the picture to the framebuffer bound for drawing, lower left corner at (x, y), rounding to its format. */
    void show(int x, int y) const;
    /** width * height * 4 floats, red green blue alpha, rows from the bottom. */
    void readPixels(float *pixels) const;
    int getWidth() const;
    int getHeight() const;

private:
    struct Private;
    Private *d;
    voFloatTarget(const voFloatTarget &);
    voFloatTarget &operator=(const voFloatTarget &);
};

#endif
