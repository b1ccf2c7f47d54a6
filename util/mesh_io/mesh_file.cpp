#include <algorithm>
#include <new>
#include <stdexcept>

#include "mesh_assembly.h"
#include "volume_io/deflate_stream.h"
#include "volume_io/printable_text.h"

namespace vo {
namespace {

/// A gzip file does not say how much it holds.
Result<std::string> decompressed(const InputFile& file)
{
    constexpr std::size_t kChunk = 1 << 20;
    DeflateStream stream(file, 0);
    std::string bytes;
    for (;;) {
        const std::size_t before = bytes.size();
        if (bytes.capacity() < before + kChunk) bytes.reserve(2 * before + kChunk);
        bytes.resize(before + kChunk);
        const auto count = stream.readSome(std::as_writable_bytes(std::span(bytes)).subspan(before));
        if (!count) return count.failure();
        bytes.resize(before + static_cast<std::size_t>(*count));
        if (*count < static_cast<std::int64_t>(kChunk)) return bytes;
    }
}

bool endsIn(std::string path, std::string_view ending)
{
    if (path.ends_with(".gz")) path.resize(path.size() - 3);
    return path.ends_with(ending);
}

Result<Mesh> readByContent(const std::string& path)
{
    if (endsIn(path, ".node") || endsIn(path, ".ele")) return readTetGen(path);
    const auto bytes = readWholeFile(path);
    if (!bytes) return bytes.failure();
    const std::string_view text = *bytes;
    if (text.starts_with("# vtk DataFile")) return readLegacyVtk(path, text);
    const std::string_view start = text.substr(0, 4096);
    const std::size_t first = std::min(start.find_first_not_of(" \t\r\n\xef\xbb\xbf"), start.size());
    if (start.substr(first).starts_with("<")) return readVtu(path, text);
    if (start.find("$MeshFormat") != start.npos) return readGmsh(path, text);
    if (start.find("View") != start.npos || endsIn(path, ".pos")) return readGmshView(path, text);
    const std::string found = text.empty() ? "nothing" : printable(std::string(start), 40);
    return Failure{path +
                   ": expected a mesh (VTK, VTU, Gmsh's .msh or .pos, TetGen's .node and .ele), found \"" +
                   found + "\""};
}

} // namespace

Result<std::string> readWholeFile(const std::string& path)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    std::array<std::byte, 3> start{};
    if (file->size() >= 3) {
        if (auto read = file->readAt(0, start); !read) return read.failure();
        if (beginsLikeGzip(start)) return decompressed(*file);
    }
    std::string bytes(static_cast<std::size_t>(file->size()), '\0');
    if (auto read = file->readAt(0, std::as_writable_bytes(std::span(bytes))); !read) return read.failure();
    return bytes;
}

Result<Mesh> readMesh(const std::string& path)
{
    try {
        return readByContent(path);
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    return Failure{path + ": expected memory for the mesh, found less"};
}

} // namespace vo
