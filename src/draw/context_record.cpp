#define GLAD_GL_IMPLEMENTATION
#include "draw/context_record.h"

#include "core/log.h"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <optional>
#include <utility>

namespace vo {

namespace {

struct PendingTable
{
    bool pending = false;
    std::shared_ptr<TableSlot> slot;
};

/// The records of all contexts of the process, and what waits for one.
struct Registry
{
    std::mutex mutex;
    std::vector<std::unique_ptr<ContextRecord>> records;
    std::uint64_t nextSerial = 1;
    PendingTable pendingTables[2];
};

Registry& registry()
{
    // Never destroyed: textures of static volumes are forgotten after main.
    static Registry* instance = new Registry;
    return *instance;
}

GLADapiproc loadFunction(void* getFunction, const char* name)
{
    return reinterpret_cast<GLADapiproc>(reinterpret_cast<GetGlFunction>(getFunction)(name));
}

DriverQuirks findQuirks(const GladGLContext& gl)
{
    DriverQuirks quirks;
    const char* renderer = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    const bool llvmpipe = renderer && std::strstr(renderer, "llvmpipe");
    // Mesa's software rasteriser takes an 8-bit path for R8, RG8 and RGBA8 with CLAMP_TO_EDGE: 11 values over
    // a ramp where 256 are right.
    quirks.filters8BitTexturesCoarsely = llvmpipe;
    // Everything else it filters in floats, where hardware may have 8 bits of weight.
    quirks.filtersFloatTexturesExactly = llvmpipe;
    for (const char* name : {"llvmpipe", "softpipe", "SWR", "swrast"})
        quirks.drawsOnProcessor |= renderer && std::strstr(renderer, name);
    return quirks;
}

bool isCoreProfile(const GladGLContext& gl)
{
    GLint profile = 0;
    gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    return (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) == 0;
}

ContextRecord* findRecord(Registry& all, void* handle)
{
    for (std::size_t i = 0; i < all.records.size(); ++i) {
        ContextRecord& record = *all.records[i];
        if (record.handle() == handle && record.ownsCurrentContext()) return &record;
    }
    return nullptr;
}

/// A context at this handle whose marker is gone was destroyed, and its objects with it.
void dropDeadRecords(Registry& all, const PlatformContext& platform)
{
    const bool handlesAreUnique = reinterpret_cast<void*>(platform.getFunction) != platform.handle;
    if (!handlesAreUnique) return;
    std::erase_if(all.records, [&](const auto& record) { return record->handle() == platform.handle; });
}

void doDeferredWork(Registry& all, ContextRecord& record)
{
    for (const std::uint64_t id : record.doomedTextures) {
        record.cellRanges.forget(id);
        record.rayCaster.forget(id);
        record.polygonFiller.forget(id);
        const auto found = record.textures.find(id);
        if (found == record.textures.end()) continue;
        record.textureIds.erase(found->second.name);
        record.gl.DeleteTextures(1, &found->second.name);
        record.textures.erase(found);
    }
    record.doomedTextures.clear();
    for (const auto& slot : record.retiredTables)
        for (auto& active : record.state.activeTables)
            if (active == slot) active.reset();
    record.retiredTables.clear();
    for (int kind = 0; kind < 2; ++kind)
        if (std::exchange(all.pendingTables[kind].pending, false))
            record.state.activeTables[kind] = std::move(all.pendingTables[kind].slot);
}

} // namespace

ContextRecord::ContextRecord(const PlatformContext& platform, std::uint64_t serial)
    : handle_(platform.handle), serial_(serial)
{
    const int version =
        gladLoadGLContextUserPtr(&gl, loadFunction, reinterpret_cast<void*>(platform.getFunction));
    if (version < GLAD_MAKE_VERSION(3, 3)) {
        failure_ = "the current context has OpenGL " + std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                   std::to_string(GLAD_VERSION_MINOR(version)) + ", 3.3 or later is needed";
        return;
    }
    usable_ = true;
    core = isCoreProfile(gl);
    quirks = findQuirks(gl);
    gl.GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &max3dSize);
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max2dSize);
    GLint bound = 0;
    gl.GetIntegerv(GL_COPY_READ_BUFFER_BINDING, &bound);
    gl.GenBuffers(1, &marker_);
    gl.BindBuffer(GL_COPY_READ_BUFFER, marker_);
    gl.BufferData(GL_COPY_READ_BUFFER, static_cast<GLsizeiptr>(serial_), nullptr, GL_STATIC_DRAW);
    gl.BindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(bound));
    debug(2, std::string("new OpenGL context, ") + (core ? "core" : "compatibility") + " profile, " +
                 reinterpret_cast<const char*>(gl.GetString(GL_RENDERER)));
}

bool ContextRecord::ownsCurrentContext() const
{
    if (!usable_) return true;
    if (!gl.IsBuffer(marker_)) return false;
    GLint bound = 0, size = 0;
    gl.GetIntegerv(GL_COPY_READ_BUFFER_BINDING, &bound);
    gl.BindBuffer(GL_COPY_READ_BUFFER, marker_);
    gl.GetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &size);
    gl.BindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(bound));
    return size == static_cast<GLint>(serial_);
}

const TableSlot* activeTable(const ContextRecord& context, TableKind kind)
{
    const TableSlot* slot = context.state.activeTables[static_cast<int>(kind)].get();
    return slot && slot->serial ? slot : nullptr;
}

ContextRecord* currentContext()
{
    const PlatformContext platform = currentPlatformContext();
    if (!platform.handle) return nullptr;
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    ContextRecord* record = findRecord(all, platform.handle);
    if (!record) {
        dropDeadRecords(all, platform);
        all.records.push_back(std::make_unique<ContextRecord>(platform, all.nextSerial++));
        record = all.records.back().get();
    }
    if (record->usable()) doDeferredWork(all, *record);
    return record;
}

void waitForOpenGl(const ContextRecord& context)
{
    context.gl.Finish();
}

void forgetTexture(std::uint64_t textureId)
{
    Registry& all = registry();
    {
        const std::lock_guard lock(all.mutex);
        for (const auto& record : all.records)
            record->doomedTextures.push_back(textureId);
        if (all.records.empty()) return;
    }
    currentContext();
}

void activateTable(TableKind kind, std::shared_ptr<TableSlot> slot)
{
    ContextRecord* record = currentContext();
    const int index = static_cast<int>(kind);
    if (record) {
        record->state.activeTables[index] = std::move(slot);
        return;
    }
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    all.pendingTables[index] = {true, std::move(slot)};
}

void retireTable(const std::shared_ptr<TableSlot>& slot)
{
    Registry& all = registry();
    {
        const std::lock_guard lock(all.mutex);
        for (const auto& record : all.records)
            record->retiredTables.push_back(slot);
        for (PendingTable& pending : all.pendingTables)
            if (pending.slot == slot) pending.slot.reset();
        if (all.records.empty()) return;
    }
    currentContext();
}

} // namespace vo
