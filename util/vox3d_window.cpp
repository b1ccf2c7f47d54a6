#include "vox3d_window.h"

namespace vo {

const char* const kWindowKeys = "";

Result<bool> showInWindow(voX3DScene&, voX3DView&, const Vox3dOptions&, std::string& whyNot)
{
    whyNot = "not yet";
    return false;
}

} // namespace vo
