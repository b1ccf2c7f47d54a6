#pragma once

#include "x3d/read_scene.h"
#include "x3d/styled_view.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

namespace vo {

/// A scene in XML, whose nodes begin in line 2, and what is drawn of it. With a folder it is written there
/// first, so that it finds files.
struct ViewedScene
{
    explicit ViewedScene(const std::string& nodes, const std::string& version = "4.0",
                         const std::string& folder = "")
    {
        const std::string text =
            "<X3D profile='Full' version='" + version + "'><Scene>\n" + nodes + "</Scene></X3D>";
        const std::string path = (std::filesystem::path(folder) / "s.x3d").string();
        if (!folder.empty()) std::ofstream(path) << text;
        isRead = folder.empty() ? readSceneText(scene, text, path) : readScene(scene, path);
        view = std::make_unique<SceneView>(scene);
        draw();
    }

    const StyledScene& draw(const ViewRequest& request = {}) { return drawn = view->styledScene(request); }

    /// Without the names of folders.
    std::string messages() const
    {
        std::string lines;
        for (const SceneMessage& message : scene.messages) {
            std::string line = messageLine(message);
            if (line.starts_with('/')) line.erase(0, line.find("s.x3d"));
            lines += line + "\n";
        }
        return lines;
    }

    Scene scene;
    bool isRead = false;
    std::unique_ptr<SceneView> view;
    StyledScene drawn;
};

} // namespace vo
