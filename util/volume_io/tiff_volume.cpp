#include "volume_reader.h"

#include <algorithm>
#include <cstring>
#include <list>
#include <map>

#include "byte_order.h"
#include "deflate_check.h"
#include "full_alpha.h"
#include "tiff_layout.h"

namespace vo {
namespace {

// LZW, the strongest of the compressions read, makes at most 1365 bytes of one: a block that is to become
// more than this is a lie, and would cost memory before it is found out.
constexpr std::int64_t kMostBytesPerEncodedByte = 4096;

/// Copies a row of pixels as they lie in a block to voxels as they lie in memory.
class PixelCopy
{
public:
    PixelCopy(const TiffLayout& layout, int channels)
        : channelBytes_(std::size_t(bytesPerChannel(layout.type))),
          pixelBytes_(std::size_t(layout.pixelBytes())), voxelBytes_(std::size_t(channels) * channelBytes_),
          addsAlpha_(layout.channels == 3), alpha_(fullAlpha(layout.type))
    {
    }

    /// Whether a row is copied byte by byte, so that it may be read straight to its place.
    bool plain() const { return pixelBytes_ == voxelBytes_; }

    void operator()(const std::byte* pixels, std::int64_t count, int plane, std::byte* voxels) const
    {
        if (plain()) {
            std::memcpy(voxels, pixels, std::size_t(count) * voxelBytes_);
            return;
        }
        voxels += std::size_t(plane) * channelBytes_;
        const std::size_t toAlpha = std::size_t(3 - plane) * channelBytes_;
        for (std::int64_t i = 0; i < count; ++i, pixels += pixelBytes_, voxels += voxelBytes_) {
            std::memcpy(voxels, pixels, pixelBytes_);
            if (addsAlpha_) std::memcpy(voxels + toAlpha, alpha_.data(), channelBytes_);
        }
    }

private:
    std::size_t channelBytes_;
    std::size_t pixelBytes_;
    std::size_t voxelBytes_;
    bool addsAlpha_;
    std::array<std::byte, 4> alpha_;
};

/// Blocks decoded last, so that the bricks of a compressed file decode what they share once.
class DecodedBlocks
{
public:
    using Bytes = std::vector<std::byte>;

    /// The block of that slice or layer, or null.
    const Bytes* find(std::int64_t page, std::int64_t index)
    {
        const auto known = places_.find({page, index});
        if (known == places_.end()) return nullptr;
        blocks_.splice(blocks_.begin(), blocks_, known->second);
        return &known->second->bytes;
    }

    /// Keeps a block in place of those that were used longest ago; the block, valid until the next call.
    const Bytes& keep(std::int64_t page, std::int64_t index, Bytes bytes)
    {
        size_ += bytes.size();
        blocks_.push_front({{page, index}, std::move(bytes)});
        places_[{page, index}] = blocks_.begin();
        while (size_ > kMostBytes && blocks_.size() > 1) {
            size_ -= blocks_.back().bytes.size();
            places_.erase(blocks_.back().place);
            blocks_.pop_back();
        }
        return blocks_.front().bytes;
    }

private:
    static constexpr std::size_t kMostBytes = std::size_t{128} << 20;

    struct Block
    {
        std::pair<std::int64_t, std::int64_t> place;
        Bytes bytes;
    };
    std::list<Block> blocks_; // the one used last comes first
    std::map<std::pair<std::int64_t, std::int64_t>, std::list<Block>::iterator> places_;
    std::size_t size_ = 0;
};

/// The part of one layer of blocks that a brick needs. Rows count from the top of the directory's picture.
struct Slab
{
    std::int64_t layer = 0;
    std::int64_t firstSlice = 0; // of the layer, as a z of the volume
    std::int64_t z0 = 0, z1 = 0; // slices needed, in the volume
    std::int64_t x0 = 0, x1 = 0; // columns needed
    std::int64_t row0 = 0, row1 = 0;
    std::int64_t rowOfY0 = 0; // the row that holds y = 0
};

class TiffReader final : public VolumeReader
{
public:
    explicit TiffReader(TiffHandle tiff) : tiff_(std::move(tiff)) {}

    /// Reads every directory and checks that the voxels that it promises are in the file.
    Result<void> open();
    Result<void> read(const Region& inside, const BrickView& brick) override;
    std::unique_ptr<VolumeReader> another() const override;

private:
    const std::string& path() const { return tiff_.file().path(); }
    std::string where(std::int64_t page) const { return path() + ": page " + std::to_string(page); }

    Result<void> addCurrentPage(std::int64_t page);
    Result<void> checkAnnouncedCount() const;
    Result<void> useStripsOfAllSlices();
    Result<void> checkBlocks(const std::string& place) const;
    Result<void> loadPage(std::int64_t page);

    TiffBlock block(std::int64_t index) const;
    Result<void> readSlab(const Slab& slab, const BrickView& brick);
    Result<void> readRows(const Slab& part, const TiffBlock& block, std::int64_t across, std::int64_t down,
                          int plane, const BrickView& brick);
    Result<void> decodeBlock(const Slab& part, std::int64_t index, std::int64_t across, std::int64_t down,
                             int plane, const BrickView& brick);
    Result<DecodedBlocks::Bytes> decoded(const Slab& part, std::int64_t index, std::int64_t down);

    TiffHandle tiff_;
    std::vector<std::uint64_t> pages_; // where each slice's directory lies; one for SGI's 3D TIFF
    TiffLayout layout_;                // of the page loaded last
    std::int64_t loadedPage_ = 0;
    std::vector<TiffBlock> strips_; // SGI's 3D TIFF in strips only
    bool rowsRunThrough_ = false;   // strips of SGI's 3D TIFF that pass from slice to slice
    std::int64_t announcedPages_ = 0;
    std::vector<std::byte> encoded_, converted_;
    DecodedBlocks blocks_;
};

/// Number of slices that the first page promises, or 0: PageNumber's second value, ImageJ's "images=30".
std::int64_t announcedPages(TIFF* tiff)
{
    std::uint16_t page = 0;
    std::uint16_t pages = 0;
    if (TIFFGetField(tiff, TIFFTAG_PAGENUMBER, &page, &pages) && pages > 0) return pages;
    const char* description = nullptr;
    if (!TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &description) || !description) return 0;
    if (std::strncmp(description, "ImageJ=", 7) != 0) return 0;
    const char* images = std::strstr(description, "\nimages=");
    return images ? std::strtol(images + 8, nullptr, 10) : 0;
}

bool isReducedCopyOrMask(TIFF* tiff)
{
    std::uint32_t kind = 0;
    return TIFFGetField(tiff, TIFFTAG_SUBFILETYPE, &kind) &&
           (kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) != 0;
}

Result<void> TiffReader::open()
{
    description_.format = "TIFF";
    announcedPages_ = announcedPages(tiff_.get());
    for (std::int64_t page = 0;; ++page) {
        if (auto added = addCurrentPage(page); !added) return added;
        if (TIFFLastDirectory(tiff_.get())) break;
        tiff_.takeComplaint();
        if (!TIFFReadDirectory(tiff_.get()))
            return Failure{path() + ": cut off or damaged: expected another page after page " +
                           std::to_string(page) + tiff_.takeComplaint()};
    }
    if (pages_.empty())
        return Failure{path() + ": expected at least one page, found reduced copies and masks alone"};
    if (info_.size[2] == 1) info_.size[2] = static_cast<std::int64_t>(pages_.size());
    if (auto checked = checkAnnouncedCount(); !checked) return checked;
    auto bytes = volumeBytes(info_.size, info_.bytesPerVoxel());
    return bytes ? Result<void>() : Failure{path() + ": " + bytes.failure().text};
}

Result<void> TiffReader::addCurrentPage(std::int64_t page)
{
    if (isReducedCopyOrMask(tiff_.get())) return {};
    auto layout = currentLayout(tiff_, where(page));
    if (!layout) return layout.failure();
    VolumeInfo info;
    info.size = {layout->width, layout->height, layout->depth};
    info.channels = layout->channels == 3 ? 4 : layout->channels;
    info.type = layout->type;

    description_.alphaAdded = layout->channels == 3 && (pages_.empty() || description_.alphaAdded);
    if (pages_.empty()) {
        info_ = info;
    } else if (info_.size[2] > 1 || layout->depth > 1) {
        return Failure{where(page) +
                       ": expected either several pages or one of several slices (ImageDepth), found both"};
    } else if (info != info_) {
        const auto text = [](const VolumeInfo& kind) {
            return std::to_string(kind.size[0]) + " x " + std::to_string(kind.size[1]) + ", " +
                   std::to_string(kind.channels) + " channels of " + channelTypeName(kind.type);
        };
        return Failure{where(page) + ": expected a page like the first (" + text(info_) + "), found " +
                       text(info)};
    }
    layout_ = *layout;
    loadedPage_ = static_cast<std::int64_t>(pages_.size());
    pages_.push_back(TIFFCurrentDirOffset(tiff_.get()));
    if (layout_.depth > 1 && !layout_.tiled)
        if (auto found = useStripsOfAllSlices(); !found) return found;
    return checkBlocks(where(page));
}

Result<void> TiffReader::checkAnnouncedCount() const
{
    const auto found = static_cast<std::int64_t>(pages_.size());
    // Fewer announced than found is harmless: some programs append pages and leave the number as it was.
    if (announcedPages_ <= found || info_.size[2] > found) return {};
    return Failure{path() + ": expected " + std::to_string(announcedPages_) +
                   " pages, as the first one announces, found " + std::to_string(found)};
}

Result<void> TiffReader::useStripsOfAllSlices()
{
    auto strips = allStrips(tiff_, path());
    if (!strips) return strips.failure();
    const auto found = static_cast<std::int64_t>(strips->size());
    const std::int64_t perSlice = layout_.blockCount();
    TiffLayout through = layout_;
    through.height = layout_.height * layout_.depth;
    through.depth = 1;
    if (layout_.planar || (found != perSlice && found != through.blockCount()))
        return Failure{path() + ": expected " + std::to_string(perSlice) +
                       " strips, channels together, for " + std::to_string(layout_.depth) +
                       " slices, found " + std::to_string(found) +
                       (layout_.planar ? ", channels apart" : "")};
    rowsRunThrough_ = found != perSlice;
    if (rowsRunThrough_) layout_ = through;
    strips_ = std::move(*strips);
    return {};
}

Result<void> TiffReader::checkBlocks(const std::string& place) const
{
    const char* kind = layout_.tiled ? "tile " : "strip ";
    const std::int64_t count = layout_.blockCount();
    const std::int64_t known = !strips_.empty() ? static_cast<std::int64_t>(strips_.size())
                               : layout_.tiled  ? TIFFNumberOfTiles(tiff_.get())
                                                : TIFFNumberOfStrips(tiff_.get());
    if (count != known)
        return Failure{place + ": expected " + std::to_string(count) + " strips or tiles, found " +
                       std::to_string(known)};
    const std::int64_t fileSize = tiff_.file().size();
    for (std::int64_t index = 0; index < count; ++index) {
        const TiffBlock block = this->block(index);
        if (block.offset <= 0 || block.bytes <= 0 || block.bytes > fileSize ||
            block.offset > fileSize - block.bytes)
            return Failure{place + ": cut off or damaged: expected " + kind + std::to_string(index) + " of " +
                           std::to_string(block.bytes) + " bytes at byte " + std::to_string(block.offset) +
                           ", found a file of " + std::to_string(fileSize) + " bytes"};
        const std::int64_t row = index / layout_.blocksAcross() % layout_.blocksDown();
        const std::int64_t needed = layout_.rowsInBlock(row) * layout_.blockRowBytes() * layout_.blockDepth;
        const std::int64_t held =
            layout_.encoded ? std::min(block.bytes, needed) * kMostBytesPerEncodedByte : block.bytes;
        if (held < needed)
            return Failure{place + ": damaged: expected " + std::to_string(needed) + " bytes in " + kind +
                           std::to_string(index) + ", found " + (layout_.encoded ? "at most " : "") +
                           std::to_string(held)};
    }
    return {};
}

Result<void> TiffReader::loadPage(std::int64_t page)
{
    if (page == loadedPage_) return {};
    tiff_.takeComplaint();
    loadedPage_ = -1;
    if (!TIFFSetSubDirectory(tiff_.get(), pages_[std::size_t(page)]))
        return Failure{where(page) + ": cannot be read again" + tiff_.takeComplaint()};
    auto layout = currentLayout(tiff_, where(page));
    if (!layout) return layout.failure();
    // The file may have been replaced since it was opened.
    if (layout->width != info_.size[0] || layout->height != info_.size[1] || layout->type != info_.type ||
        (layout->channels == 3 ? 4 : layout->channels) != info_.channels)
        return Failure{where(page) + ": has changed since the file was opened"};
    layout_ = *layout;
    if (auto checked = checkBlocks(where(page)); !checked) return checked;
    loadedPage_ = page;
    return {};
}

TiffBlock TiffReader::block(std::int64_t index) const
{
    if (!strips_.empty()) return strips_[std::size_t(index)];
    const auto number = static_cast<std::uint32_t>(index);
    const auto clamped = [](std::uint64_t value) {
        return static_cast<std::int64_t>(std::min<std::uint64_t>(value, INT64_MAX));
    };
    return {clamped(TIFFGetStrileOffset(tiff_.get(), number)),
            clamped(TIFFGetStrileByteCount(tiff_.get(), number))};
}

Result<void> TiffReader::read(const Region& inside, const BrickView& brick)
{
    const std::int64_t z1 = inside.origin[2] + inside.size[2];
    const bool isStack = static_cast<std::int64_t>(pages_.size()) == info_.size[2];
    for (std::int64_t z = inside.origin[2]; z < z1;) {
        if (isStack)
            if (auto loaded = loadPage(z); !loaded) return loaded;
        Slab slab;
        slab.layer = isStack || rowsRunThrough_ ? 0 : z / layout_.blockDepth;
        slab.firstSlice = isStack || rowsRunThrough_ ? z : slab.layer * layout_.blockDepth;
        slab.z0 = z;
        slab.z1 = std::min(z1, slab.firstSlice + layout_.blockDepth);
        slab.x0 = inside.origin[0];
        slab.x1 = inside.origin[0] + inside.size[0];
        slab.rowOfY0 = rowsRunThrough_ ? z * info_.size[1] : 0;
        slab.row0 = slab.rowOfY0 + inside.origin[1];
        slab.row1 = slab.row0 + inside.size[1];
        if (auto read = readSlab(slab, brick); !read) return read;
        counters_.slices += slab.z1 - slab.z0;
        z = slab.z1;
    }
    return {};
}

Result<void> TiffReader::readSlab(const Slab& slab, const BrickView& brick)
{
    const std::int64_t width = layout_.blockWidth;
    const std::int64_t height = layout_.blockHeight;
    for (int plane = 0; plane < layout_.planes(); ++plane)
        for (std::int64_t down = slab.row0 / height; down * height < slab.row1; ++down)
            for (std::int64_t across = slab.x0 / width; across * width < slab.x1; ++across) {
                Slab part = slab;
                part.x0 = std::max(slab.x0, across * width);
                part.x1 = std::min(slab.x1, (across + 1) * width);
                part.row0 = std::max(slab.row0, down * height);
                part.row1 = std::min(slab.row1, (down + 1) * height);
                const std::int64_t index = layout_.blockIndex(across, down, slab.layer, plane);
                auto read = layout_.encoded ? decodeBlock(part, index, across, down, plane, brick)
                                            : readRows(part, block(index), across, down, plane, brick);
                if (!read) return read;
            }
    return {};
}

Result<void> TiffReader::readRows(const Slab& part, const TiffBlock& block, std::int64_t across,
                                  std::int64_t down, int plane, const BrickView& brick)
{
    const PixelCopy copy(layout_, info_.channels);
    const std::int64_t count = part.x1 - part.x0;
    const bool rowsTouch = copy.plain() && count == layout_.blockWidth && count == brick.width();
    const std::int64_t rowsAtOnce = rowsTouch ? part.row1 - part.row0 : 1;
    const std::int64_t bytes = rowsAtOnce * count * layout_.pixelBytes();
    if (!copy.plain()) converted_.resize(static_cast<std::size_t>(bytes));

    for (std::int64_t z = part.z0; z < part.z1; ++z)
        for (std::int64_t row = part.row0; row < part.row1; row += rowsAtOnce) {
            const std::int64_t rowInBlock =
                (z - part.firstSlice) * layout_.blockHeight + row - down * layout_.blockHeight;
            const std::int64_t column = part.x0 - across * layout_.blockWidth;
            std::byte* voxels = brick.voxel(part.x0, row - part.rowOfY0, z);
            const std::span<std::byte> pixels(copy.plain() ? voxels : converted_.data(),
                                              static_cast<std::size_t>(bytes));
            const std::int64_t offset =
                block.offset + rowInBlock * layout_.blockRowBytes() + column * layout_.pixelBytes();
            if (auto read = tiff_.file().readAt(offset, pixels); !read) return read;
            if (layout_.swapped) swapBytes(pixels, bytesPerChannel(layout_.type));
            if (!copy.plain()) copy(pixels.data(), count, plane, voxels);
            counters_.rows += rowsAtOnce;
            counters_.bytes += bytes;
        }
    return {};
}

Result<void> TiffReader::decodeBlock(const Slab& part, std::int64_t index, std::int64_t across,
                                     std::int64_t down, int plane, const BrickView& brick)
{
    const DecodedBlocks::Bytes* decoded = blocks_.find(loadedPage_, index);
    if (!decoded) {
        auto fresh = this->decoded(part, index, down);
        if (!fresh) return fresh.failure();
        decoded = &blocks_.keep(loadedPage_, index, std::move(*fresh));
    }
    const PixelCopy copy(layout_, info_.channels);
    for (std::int64_t z = part.z0; z < part.z1; ++z)
        for (std::int64_t row = part.row0; row < part.row1; ++row) {
            const std::int64_t rowInBlock =
                (z - part.firstSlice) * layout_.blockHeight + row - down * layout_.blockHeight;
            const std::int64_t column = part.x0 - across * layout_.blockWidth;
            copy(decoded->data() + rowInBlock * layout_.blockRowBytes() + column * layout_.pixelBytes(),
                 part.x1 - part.x0, plane, brick.voxel(part.x0, row - part.rowOfY0, z));
        }
    return {};
}

/// Reads and decodes a block.
Result<DecodedBlocks::Bytes> TiffReader::decoded(const Slab& part, std::int64_t index, std::int64_t down)
{
    const TiffBlock source = block(index);
    const std::int64_t rows = layout_.rowsInBlock(down) * layout_.blockDepth;
    encoded_.resize(static_cast<std::size_t>(source.bytes));
    DecodedBlocks::Bytes bytes(static_cast<std::size_t>(rows * layout_.blockRowBytes()));
    if (auto read = tiff_.file().readAt(source.offset, encoded_); !read) return read.failure();

    // libtiff knows the strips of the first slice alone. All it takes from the number is how many rows to
    // expect.
    const auto number =
        static_cast<std::uint32_t>(layout_.tiled ? index : index % TIFFNumberOfStrips(tiff_.get()));
    tiff_.takeComplaint();
    const int good =
        TIFFReadFromUserBuffer(tiff_.get(), number, encoded_.data(), static_cast<tmsize_t>(encoded_.size()),
                               bytes.data(), static_cast<tmsize_t>(bytes.size()));
    if (layout_.reversedBits)
        TIFFReverseBits(reinterpret_cast<std::uint8_t*>(encoded_.data()),
                        static_cast<tmsize_t>(encoded_.size()));
    const bool sound = !layout_.deflated || isSoundDeflate(encoded_, static_cast<std::int64_t>(bytes.size()));
    if (!good || !sound || tiff_.sawError())
        return Failure{where(part.z0) + ": damaged: cannot decode " + (layout_.tiled ? "tile " : "strip ") +
                       std::to_string(index) + tiff_.takeComplaint()};
    counters_.rows += rows;
    counters_.bytes += source.bytes;
    return bytes;
}

std::unique_ptr<VolumeReader> TiffReader::another() const
{
    // The strips of SGI's 3D TIFF are those of the directory that libtiff has loaded.
    if (pages_.size() < 2) return nullptr;
    auto file = InputFile::open(path());
    if (!file || file->size() != tiff_.file().size()) return nullptr;
    auto tiff = TiffHandle::read(std::move(*file));
    if (!tiff) return nullptr;
    auto reader = std::make_unique<TiffReader>(std::move(*tiff));
    reader->info_ = info_;
    reader->description_ = description_;
    reader->pages_ = pages_;
    reader->loadedPage_ = -1;
    return reader;
}

} // namespace

Result<VolumeFile> openTiffVolume(const std::string& path)
{
    auto file = InputFile::open(path);
    if (!file) return file.failure();
    auto tiff = TiffHandle::read(std::move(*file));
    if (!tiff) return tiff.failure();
    auto reader = std::make_unique<TiffReader>(std::move(*tiff));
    if (auto opened = reader->open(); !opened) return opened.failure();
    return VolumeFile(std::move(reader));
}

} // namespace vo
