#include "raw_files.h"

#include "data_type.h"

#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>

namespace {

int readNumber(const char* program, const char* what, const char* word, int least)
{
    int number = 0;
    const char* end = word + strlen(word);
    const auto [stopped, error] = std::from_chars(word, end, number);
    if (error != std::errc() || stopped != end || number < least)
        voglFail(program, std::string("expected ") + what + ", " + std::to_string(least) +
                              " or more, found '" + word + "'");
    return number;
}

} // namespace

VoglSource openRawFiles(const char* program, std::span<char* const> arguments, bool bigEndian)
{
    const int headerLength = readNumber(program, "the bytes of the header", arguments[0], 0);
    const char* const axes[] = {"the voxels along x", "the voxels along y", "the voxels along z"};
    VoglSource source;
    vo::RawLayout layout;
    for (std::size_t i = 0; i < 3; i++)
        layout.info.size[i] = source.size[i] = readNumber(program, axes[i], arguments[1 + i], 1);
    const auto type = vo::rawChannelType("the type", arguments[4]);
    if (!type) voglFail(program, type.failure().text);
    source.dataType = dataTypeOf(*type);
    layout.info.type = *type;
    layout.headerLength = headerLength;
    layout.byteOrder = bigEndian ? vo::ByteOrder::bigEndian : vo::ByteOrder::littleEndian;

    const std::vector<std::string> names(arguments.begin() + 5, arguments.end());
    source.name = names.front();
    auto opened = names.size() == 1 ? vo::openRawVolume(names[0], layout) : vo::openRawSlices(names, layout);
    if (!opened) voglFail(program, opened.failure().text);
    for (const std::string& note : opened->description().notes)
        fprintf(stderr, "%s: %s: %s\n", program, source.name.c_str(), note.c_str());
    // The function that reads bricks keeps the files open.
    const auto file = std::make_shared<vo::VolumeFile>(std::move(*opened));
    source.readBrick = [=](void* data, const int origin[3], const int size[3]) {
        const vo::Region region{{origin[0], origin[1], origin[2]}, {size[0], size[1], size[2]}};
        const auto bytes = vo::volumeBytes(region.size, file->info().bytesPerVoxel());
        if (!bytes) voglFail(program, bytes.failure().text);
        const auto read = file->readBrick(region, {static_cast<std::byte*>(data), std::size_t(*bytes)});
        if (!read) voglFail(program, read.failure().text);
        return 0;
    };
    return source;
}
