#pragma once

// Before any header of <vo/...>.
#include "gl.h"

#include "volume_view/options.h"

#include "volume_view/lookup_file.h"
#include "volume_view/lookup_ramp.h"

#include <vo/Volumizer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

/* The table of the vogl programs: a file's (-lutFile), or a grey ramp (-lut, or the whole data range) that
   the middle mouse button moves. The ramp's alpha rises with its grey, from 0 to the opacity at which a tenth
   of the volume's longest side, all of it at the ramp's top, lets 1/e of the light through: so that the
   inside shows, however far apart the slices are. */

/** One table. Programs that draw several volumes, or parts, have several. */
class VoglLookup
{
public:
    VoglLookup() = default;
    ~VoglLookup() { free(); }
    VoglLookup(const VoglLookup&) = delete;
    VoglLookup& operator=(const VoglLookup&) = delete;

    /** Reads the file, or without one (an empty name) takes a ramp over these values of the volume; none:
        over its whole data range. Leaves by exit(1) after one line on stderr when the file cannot be read. */
    void read(const char* program, const std::string& fileName, std::optional<vo::Options::Ramp> lut);
    /** Colours the ramp, so that it can be told from others. */
    void setTint(float red, float green, float blue) { tint_ = {red, green, blue}; }
    /** The same of the file's table that was read, if any. */
    void tintFile(float red, float green, float blue);
    /** Opacity at the ramp's top, for programs whose tables hold no opacities of slices. */
    void setRampOpacity(double opacity) { rampOpacity_ = opacity; }
    /** With -color, or with colours of its own and without -monochrome. */
    voRenderingMode renderingMode() const;

    /** Makes the table and enables it. It begins and ends at these values of the file. Volumes of several
        channels bring their own colours and opacities, and get no table unless one is asked for. */
    void make(voBrickSetCollection* aVolume, voRenderingMode renderingMode, double low, double high);
    /** From now on it is the one that slices are drawn with; if there is none, they are drawn without. */
    void enable();
    /** The table itself, NULL if there is none: for those who enable it in their own time. */
    voLookupTable* get() const { return table_; }
    /** Slices are drawn without a table. */
    static void disable();
    /** Moves the ramp; in parts of the data range. Nothing happens with a table from a file, or without a
        table. */
    void moveRamp(double center, double width);
    /** The present entries: red, green, blue and alpha each. None before make. */
    std::vector<float> rgbaEntries() const;
    void free();

private:
    void loadRamp();

    std::optional<vo::LookupFile> file_;
    std::optional<vo::Options::Ramp> lut_;
    std::array<float, 3> tint_{1, 1, 1};
    std::optional<double> rampOpacity_;
    vo::RampSettings ramp_{};
    double dataLow_ = 0, dataHigh_ = 1;
    int components_ = 4;
    std::vector<float> entries_;
    voLookupTable* table_ = nullptr;
};

/** That of the options. */
VoglLookup& voglLookup();

/** Reads the file of -lutFile, if any, and settles -color and -monochrome: without either, a table with
   colours asks for RGBA. Leaves by exit(1) after one line on stderr when the file cannot be read. */
voRenderingMode readLookupTable(const char* program);

/** Makes the table of the options and enables it; see VoglLookup::make. */
void initLookupTable(voBrickSetCollection* aVolume, voRenderingMode renderingMode, double low, double high);

/** Moves the ramp of the options; see VoglLookup::moveRamp. */
void moveLookupRamp(double center, double width);

void deleteLookupTable();
