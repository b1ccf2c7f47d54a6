#pragma once

#include <fstream>

#include "volume_truth.h"

namespace vo {

/// Bytes of a file in the making, numbers in the order asked for.
class FileBytes
{
public:
    explicit FileBytes(bool bigEndian = false) : bigEndian_(bigEndian) {}

    template <class Number>
    FileBytes& put(Number number)
    {
        std::string raw(sizeof number, '\0');
        std::memcpy(raw.data(), &number, sizeof number);
        if (bigEndian_ != (nativeByteOrder() == ByteOrder::bigEndian)) std::reverse(raw.begin(), raw.end());
        text += raw;
        return *this;
    }
    template <class Number>
    FileBytes& putAt(std::size_t offset, Number number)
    {
        FileBytes one(bigEndian_);
        one.put(number);
        if (text.size() < offset + one.text.size()) text.resize(offset + one.text.size());
        text.replace(offset, one.text.size(), one.text);
        return *this;
    }

    std::string text;

private:
    bool bigEndian_;
};

inline void writeFile(const std::string& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// How a file's axes relate to those that are served: axis `fileAxis[a]` of the file, reversed or not, is
/// served as axis a.
struct AxisOrder
{
    std::array<int, 3> fileAxis{0, 1, 2};
    std::array<bool, 3> reversed{};

    std::array<std::int64_t, 3> sizeInFile(const std::array<std::int64_t, 3>& size) const
    {
        std::array<std::int64_t, 3> found{};
        for (std::size_t a = 0; a < 3; ++a)
            found[std::size_t(fileAxis[a])] = size[a];
        return found;
    }
    /// One voxel along axis i of the file, in the frame right, front, up, for spacings of the served axes.
    std::array<double, 3> step(int i, const std::array<double, 3>& spacing) const
    {
        std::array<double, 3> found{};
        for (std::size_t a = 0; a < 3; ++a)
            if (fileAxis[a] == i) found[a] = reversed[a] ? -spacing[a] : spacing[a];
        return found;
    }
};

/// All 48 of them.
inline std::vector<AxisOrder> allAxisOrders()
{
    std::vector<AxisOrder> orders;
    AxisOrder order;
    do
        for (int bits = 0; bits < 8; ++bits) {
            order.reversed = {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
            orders.push_back(order);
        }
    while (std::next_permutation(order.fileAxis.begin(), order.fileAxis.end()));
    return orders;
}

/// The voxels of `truth` as a file of this axis order holds them. Of four channels only `channels` are
/// written, side by side or one volume after another.
inline std::string voxelsInFile(const VolumeTruth& truth, const AxisOrder& order, bool bigEndian,
                                int channels = 0, bool planar = false)
{
    const auto size = order.sizeInFile(truth.info().size);
    const auto bytes = static_cast<std::size_t>(bytesPerChannel(truth.info().type));
    if (channels == 0) channels = truth.info().channels;
    std::string out;
    const auto putVoxel = [&](std::array<std::int64_t, 3> place, int channel) {
        std::array<std::int64_t, 3> v{};
        for (std::size_t a = 0; a < 3; ++a) {
            const std::int64_t at = place[std::size_t(order.fileAxis[a])];
            v[a] = order.reversed[a] ? truth.info().size[a] - 1 - at : at;
        }
        std::array<std::byte, 4> value{};
        truth.put(v[0], v[1], v[2], channel, value.data());
        if (bigEndian != (nativeByteOrder() == ByteOrder::bigEndian))
            std::reverse(value.begin(), value.begin() + std::ptrdiff_t(bytes));
        out.append(reinterpret_cast<const char*>(value.data()), bytes);
    };
    for (int plane = 0; plane < (planar ? channels : 1); ++plane)
        for (std::int64_t z = 0; z < size[2]; ++z)
            for (std::int64_t y = 0; y < size[1]; ++y)
                for (std::int64_t x = 0; x < size[0]; ++x)
                    for (int c = planar ? plane : 0; c < (planar ? plane + 1 : channels); ++c)
                        putVoxel({x, y, z}, c);
    return out;
}

/// Reads the volume and compares every voxel; of a volume of three channels the fourth must be `alpha`.
inline void expectVoxels(const std::string& path, const VolumeTruth& truth)
{
    auto volume = openVolume(path);
    ASSERT_TRUE(volume) << volume.failure().text;
    expectReadsAs(*volume, truth);
}

/// A NIfTI header.
struct NiftiFile
{
    int version = 1;
    bool bigEndian = false;
    std::vector<std::int64_t> dim; // fastest first
    int datatype = 2, bits = 8;
    int intent = 0;
    std::array<double, 3> pixdim{1, 1, 1};
    std::array<std::array<double, 3>, 3> steps{}; // along the file's axes, right, front, up
    int sform = 1, qform = 0;
    std::array<double, 3> quaternion{}; // b, c, d
    double qfac = 1;
    double slope = 0, intercept = 0;
    int units = 2;            // mm
    std::int64_t offset = -1; // of the voxels; -1: where the header ends
    bool pair = false;

    std::string header() const
    {
        FileBytes h(bigEndian);
        const int length = version == 1 ? 348 : 540;
        const std::int64_t first = offset >= 0 ? offset : pair ? 0 : length + 4;
        h.text.resize(static_cast<std::size_t>(length + 4));
        h.putAt(0, std::int32_t(length));
        const std::string magic = std::string(pair ? "ni" : "n+") + char('0' + version) + '\0';
        if (version == 1)
            put1(h, first, magic);
        else
            put2(h, first, magic);
        h.text.resize(static_cast<std::size_t>(pair ? length + 4 : std::max<std::int64_t>(first, length)));
        return h.text;
    }

private:
    void put1(FileBytes& h, std::int64_t first, const std::string& magic) const
    {
        for (std::size_t i = 0; i < 8; ++i)
            h.putAt(40 + 2 * i, std::int16_t(i == 0 ? dim.size() : i <= dim.size() ? dim[i - 1] : 1));
        h.putAt(68, std::int16_t(intent)).putAt(70, std::int16_t(datatype)).putAt(72, std::int16_t(bits));
        h.putAt(76, float(qfac));
        for (std::size_t i = 0; i < 3; ++i)
            h.putAt(80 + 4 * i, float(pixdim[i])).putAt(256 + 4 * i, float(quaternion[i]));
        h.putAt(108, float(first)).putAt(112, float(slope)).putAt(116, float(intercept));
        h.text[123] = char(units);
        h.putAt(252, std::int16_t(qform)).putAt(254, std::int16_t(sform));
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t i = 0; i < 3; ++i)
                h.putAt(280 + 16 * row + 4 * i, float(steps[i][row]));
        h.text.replace(344, 4, magic);
    }
    void put2(FileBytes& h, std::int64_t first, const std::string& magic) const
    {
        h.text.replace(4, 8, magic + "\r\n\032\n");
        h.putAt(12, std::int16_t(datatype)).putAt(14, std::int16_t(bits));
        for (std::size_t i = 0; i < 8; ++i)
            h.putAt(16 + 8 * i, std::int64_t(i == 0            ? std::int64_t(dim.size())
                                             : i <= dim.size() ? dim[i - 1]
                                                               : 1));
        h.putAt(104, qfac);
        for (std::size_t i = 0; i < 3; ++i)
            h.putAt(112 + 8 * i, pixdim[i]).putAt(352 + 8 * i, quaternion[i]);
        h.putAt(168, first).putAt(176, slope).putAt(184, intercept);
        h.putAt(344, std::int32_t(qform)).putAt(348, std::int32_t(sform));
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t i = 0; i < 3; ++i)
                h.putAt(400 + 32 * row + 8 * i, steps[i][row]);
        h.putAt(500, std::int32_t(units)).putAt(504, std::int32_t(intent));
    }
};

/// A DICOM picture, explicit, little-endian.
struct DicomFile
{
    int columns = 5, rows = 4;
    int bitsAllocated = 16, bitsStored = 16;
    bool isSigned = true;
    int channels = 1;
    std::string colours = "MONOCHROME2";
    std::string series = "1.2.3", description = "first", instance = "1";
    std::string position = "0\\0\\0", orientation = "1\\0\\0\\0\\1\\0", spacing = "0.5\\0.25";
    std::string slope = "1", intercept = "0", frames;
    std::string pixels; // as they lie in the file
    bool rle = false;
    std::string behind; // the pixels

    std::string bytes() const
    {
        std::string meta = element(2, 0x10, "UI", rle ? "1.2.840.10008.1.2.5" : "1.2.840.10008.1.2.1");
        meta = element(2, 2, "UI", "1.2.840.10008.5.1.4.1.1.4") + element(2, 3, "UI", "1.2.3." + instance) +
               meta;
        std::string all = std::string(128, '\0') + "DICM" +
                          element(2, 0, "UL", number<std::uint32_t>(std::uint32_t(meta.size()))) + meta;
        all += element(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.4");
        all += element(8, 0x103e, "LO", description);
        all += element(0x20, 0xe, "UI", series) + element(0x20, 0x13, "IS", instance);
        if (!position.empty()) all += element(0x20, 0x32, "DS", position);
        if (!orientation.empty()) all += element(0x20, 0x37, "DS", orientation);
        all += shortElement(0x28, 2, channels) + element(0x28, 4, "CS", colours);
        if (channels > 1) all += shortElement(0x28, 6, 0);
        if (!frames.empty()) all += element(0x28, 8, "IS", frames);
        all += shortElement(0x28, 0x10, rows) + shortElement(0x28, 0x11, columns);
        all += element(0x28, 0x30, "DS", spacing);
        all += shortElement(0x28, 0x100, bitsAllocated) + shortElement(0x28, 0x101, bitsStored);
        all += shortElement(0x28, 0x102, bitsStored - 1) + shortElement(0x28, 0x103, isSigned);
        all += element(0x28, 0x1052, "DS", intercept) + element(0x28, 0x1053, "DS", slope);
        return all + pixelElement() + behind;
    }

private:
    template <class Number>
    static std::string number(Number value)
    {
        return FileBytes().put(value).text;
    }
    static std::string element(int group, int tag, const std::string& type, std::string value)
    {
        if (value.size() % 2) value += type == "UI" ? '\0' : ' ';
        return number(std::uint16_t(group)) + number(std::uint16_t(tag)) + type +
               number(std::uint16_t(value.size())) + value;
    }
    static std::string shortElement(int group, int tag, int value)
    {
        return element(group, tag, "US", number(std::uint16_t(value)));
    }
    std::string pixelElement() const
    {
        const std::string tag = number(std::uint16_t(0x7fe0)) + number(std::uint16_t(0x10));
        if (!rle)
            return tag + "OW" + number(std::uint16_t(0)) + number(std::uint32_t(pixels.size())) + pixels;
        const std::string fragment = runLengths();
        const std::string item = number(std::uint16_t(0xfffe)) + number(std::uint16_t(0xe000));
        return tag + "OB" + number(std::uint16_t(0)) + number(std::uint32_t(0xffffffff)) + item +
               number(std::uint32_t(0)) + item + number(std::uint32_t(fragment.size())) + fragment +
               number(std::uint16_t(0xfffe)) + number(std::uint16_t(0xe0dd)) + number(std::uint32_t(0));
    }
    /// A segment for each byte of a pixel, the highest first, without a single run.
    std::string runLengths() const
    {
        const std::size_t width = std::size_t(bitsAllocated / 8);
        std::vector<std::string> segments;
        for (std::size_t byte = width; byte-- > 0;) {
            std::string plane, packed;
            for (std::size_t i = byte; i < pixels.size(); i += width)
                plane += pixels[i];
            for (std::size_t i = 0; i < plane.size(); i += 128) {
                const std::string run = plane.substr(i, 128);
                packed += char(run.size() - 1) + run;
            }
            if (packed.size() % 2) packed += '\x80'; // does nothing
            segments.push_back(packed);
        }
        std::string head = number(std::uint32_t(segments.size()));
        std::uint32_t offset = 64;
        for (const std::string& segment : segments) {
            head += number(offset);
            offset += std::uint32_t(segment.size());
        }
        head.resize(64);
        for (const std::string& segment : segments)
            head += segment;
        return head;
    }
};

} // namespace vo
