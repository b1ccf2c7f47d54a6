#ifndef VO_COMPAT_IFL_FILE_H
#define VO_COMPAT_IFL_FILE_H

#include <ifl/iflConfig.h>
#include <ifl/iflError.h>
#include <ifl/iflSize.h>
#include <ifl/iflTypes.h>

#include <fcntl.h>
#include <stddef.h>

/** An image or a volume in a file, to be read: every format that the programs of this project read, by the rules of
    docs/formats.md. x fastest, then y, then z, the first row of a TIFF page at y = 0; three channels arrive as four
    with full alpha, and values in this machine's byte order. Nothing is printed. */
class IFL_API iflFile
{
public:
    /** Opens a file to read (flags O_RDONLY). NULL when that fails; *status, if given, says why. The caller owns what is
        returned. */
    static iflFile *open(const char *fileName, int flags = O_RDONLY, iflStatus *status = NULL);
    /** Closes the file if it is open. */
    ~iflFile();

    /** Closes the file. The object stays, and what it tells of the file; it is the caller's to delete. */
    iflStatus close();

    iflStatus getDimensions(iflSize &size) const;
    iflDataType getDataType() const;
    iflColorModel getColorModel() const;
    /** Channels of a pixel: 1, 2 or 4. */
    int getNumChannels() const;

    /** Reads the box of nx * ny * nz pixels at (x, y, z) into data, which has room for them as config says; NULL: in the
        file's type, interleaved. Pixels outside the image are 0. Where config has another type than the file, values
        are not scaled; integers get them rounded and clamped to their range, and 0 for NaN. iflBit: iflUNSUPPORTED.
        After a failure data holds no useful values. */
    iflStatus getTile(int x, int y, int z, int nx, int ny, int nz, void *data, const iflConfig *config = NULL);

private:
    struct Private;
    Private *d;
    explicit iflFile(Private *contents);
    iflFile(const iflFile &);
    iflFile &operator=(const iflFile &);
};

#endif
