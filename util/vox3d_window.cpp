#include "window.h" // OpenGL's loader comes before headers that name OpenGL's own

#include "vox3d_window.h"

#include "scaled_target.h"
#include "utility.h"
#include "vox3d_navigation.h"

#include <vo/Error.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>

namespace vo {

const char* const kWindowKeys = R"(In the window:
  Left drag           EXAMINE: turn the scene; FLY: forward, back and round
  Middle, right drag  move the scene; wheel: nearer and farther
  e, f                EXAMINE, FLY
  v, 1 to 9           the next viewpoint, one by its number
  s                   the next style for volumes; after the last one their own
  l                   the light at the head, on and off
  p                   time stands still and goes on
  r                   back to the viewpoint
  h                   print this list
  Escape              leave
A click reaches the TouchSensors of the scene.
)";

namespace {

constexpr double kTurnPerPixel = 0.01;
/// Radii a second, and radians a second, for a drag over half of the window.
constexpr double kFlySpeed = 1.5, kFlyTurn = 1.2;
/// Frames that move and take longer have fewer pixels.
constexpr double kFrameSeconds = 0.08;

double now()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Nodes may stand in more places than anyone waits for.
constexpr int kMostPlaces = 1'000'000;

void eachNode(const voX3DNode& node, int& rest, const std::function<void(voX3DNode)>& take)
{
    if (rest-- <= 0) return;
    take(node);
    for (int i = 0; i < node.getInlinedCount(); ++i)
        eachNode(node.getInlined(i), rest, take);
    for (int i = 0; i < node.getFieldCount(); ++i) {
        const char* const field = node.getFieldName(i);
        const auto type = node.getFieldType(field);
        if (type != voX3DScope::SF_NODE && type != voX3DScope::MF_NODE) continue;
        for (int k = 0; k < node.getCount(field); ++k)
            eachNode(node.getNode(field, k), rest, take);
    }
}

void eachNode(const voX3DScene& scene, const std::function<void(voX3DNode)>& take)
{
    int rest = kMostPlaces;
    for (int i = 0; i < scene.getRootCount(); ++i)
        eachNode(scene.getRoot(i), rest, take);
}

/// Other styles for the volumes of a scene, behind their own where that has no surfaces of its own.
class StyleToggle
{
public:
    explicit StyleToggle(voX3DScene& scene) : scene_(scene)
    {
        eachNode(scene, [this](voX3DNode node) {
            if (node.isType("VolumeData")) own_.push_back({node, node.getNode("renderStyle")});
        });
    }

    void next()
    {
        static constexpr const char* kTypes[] = {
            "CartoonVolumeStyle",    "EdgeEnhancementVolumeStyle", "SilhouetteEnhancementVolumeStyle",
            "ToneMappedVolumeStyle", "ShadedVolumeStyle",          "ProjectionVolumeStyle"};
        index_ = (index_ + 1) % (std::size(kTypes) + 1);
        for (auto& [volume, style] : own_)
            volume.setNode("renderStyle", index_ == 0 ? style : behind(style, kTypes[index_ - 1]));
        std::printf("style: %s\n", index_ == 0 ? "the scene's own" : kTypes[index_ - 1]);
    }

private:
    voX3DNode behind(const voX3DNode& own, const char* type)
    {
        voX3DNode style = scene_.createNode(type);
        if (style.isType("ShadedVolumeStyle")) style.setInt("lighting", 1);
        if (style.isType("SilhouetteEnhancementVolumeStyle"))
            style.setFloat("silhouetteRetainedOpacity", 0.05f);
        if (style.isType("SilhouetteEnhancementVolumeStyle"))
            style.setFloat("silhouetteBoundaryOpacity", 0.6f);
        if (style.isType("ProjectionVolumeStyle") || own.isNull() ||
            !own.isType("X3DComposableVolumeRenderStyleNode"))
            return style;
        voX3DNode list = scene_.createNode("ComposedVolumeStyle");
        const voX3DNode both[2] = {own, style};
        list.setNodes("renderStyle", both, 2);
        return list;
    }

    voX3DScene& scene_;
    std::vector<std::pair<voX3DNode, voX3DNode>> own_;
    std::size_t index_ = 0;
};

/// A window's scene, moved by its viewer.
class Viewer
{
public:
    Viewer(voX3DScene& scene, voX3DView& view, const Vox3dOptions& options, Window& window)
        : view_(view), options_(options), window_(window), styles_(scene), target_(window.gl())
    {
        current_ = this;
        eachNode(scene, [this](const voX3DNode& node) {
            hasSensors_ = hasSensors_ || node.isType("TouchSensor");
            if (node.isType("NavigationInfo") && node.getCount("type") > 0 && !isFlying_)
                isFlying_ = std::string_view(node.getString("type")) == "FLY";
        });
        started_ = now();
        connect();
    }
    ~Viewer()
    {
        view_.releaseDrawing();
        current_ = nullptr;
    }
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    Result<void> run()
    {
        double last = now();
        while (window_.handleEvents(!isBusy())) {
            const double time = now(), passed = std::min(time - last, 0.2);
            last = time;
            int width = 0, height = 0;
            window_.framebufferSize(width, height);
            if (width < 1 || height < 1 || !isBusy()) continue;
            advance(time, passed);
            if (!draw(width, height))
                return Failure{std::string("cannot draw: ") + voError::getErrorString()};
        }
        return {};
    }

private:
    bool isBusy() { return window_.needsDrawing() || isCoarse_ || isMoving() || timeGoesOn(); }
    bool isMoving() const { return isHeld_ && isFlying_; }
    bool timeGoesOn() { return !isPaused_ && (view_.isAnimated() || view_.getCycle() > 0); }

    void connect()
    {
        ScreenCallbacks callbacks{};
        callbacks.press = [](Button button, double x, double y, int width, int height) {
            current_->press(button, x, y, width, height);
        };
        callbacks.drag = [](Button button, double x, double y, int width, int height) {
            current_->drag(button, x, y, width, height);
        };
        callbacks.release = [](Button, double, double, int, int) { current_->release(); };
        if (hasSensors_)
            callbacks.hover = [](double x, double y, int width, int height) {
                current_->point(x, y, width, height);
            };
        callbacks.scroll = [](double steps) { current_->scroll(steps); };
        callbacks.key = [](int key) { return current_->key(key); };
        window_.setCallbacks(callbacks);
    }

    void advance(double time, double passed)
    {
        if (isPaused_) started_ += passed;
        view_.setTime(options_.time + time - started_);
        if (!isMoving()) return;
        MovedEye& eye = moved();
        eye.look({0, 1, 0}, kFlyTurn * passed * (x_ - pressX_) / 256);
        eye.move({0, 0, eye.radius * kFlySpeed * passed * (pressY_ - y_) / 256});
    }

    /// While something moves, with as many pixels as are drawn in time.
    bool draw(int width, int height)
    {
        const bool isInMotion = isHeld_ || timeGoesOn();
        const double scale = isInMotion ? std::clamp(std::sqrt(fullSeconds_ / kFrameSeconds), 1.0, 8.0) : 1.0;
        const int drawnWidth = std::max(int(width / scale), 1),
                  drawnHeight = std::max(int(height / scale), 1);
        if (eye_) eye_->resize(width_, height_, width, height);
        width_ = width;
        height_ = height;
        view_.setSize(drawnWidth, drawnHeight);
        if (eye_) eye_->apply(view_);
        const double before = now();
        target_.begin(drawnWidth, drawnHeight);
        const bool done = view_.draw(engine());
        target_.show(width, height);
        window_.swap();
        const double pixels = double(width) * height / (double(drawnWidth) * drawnHeight);
        fullSeconds_ = (now() - before) * pixels;
        isCoarse_ = scale > 1; // a whole picture is to come
        return done;
    }

    voEngine engine() const
    {
        return options_.engine == Vox3dOptions::Engine::automatic ? voEngineScope::AUTOMATIC
               : options_.engine == Vox3dOptions::Engine::cast    ? voEngineScope::CAST
                                                                  : voEngineScope::SLICES;
    }

    /// The eye, which from now on no viewpoint moves.
    MovedEye& moved()
    {
        if (!eye_) {
            view_.setSize(width_, height_);
            eye_ = MovedEye::of(view_);
        }
        return *eye_;
    }

    bool point(double x, double y, int width, int height)
    {
        if (!hasSensors_) return false;
        const double column = x / width * view_.getWidth(), row = (1 - y / height) * view_.getHeight();
        return view_.movePointer(int(column), int(row));
    }

    void press(Button button, double x, double y, int width, int height)
    {
        pressX_ = lastX_ = x_ = x;
        pressY_ = lastY_ = y_ = y;
        isTouching_ = button == Button::Left && point(x, y, width, height);
        if (isTouching_) view_.pressPointer();
        isHeld_ = !isTouching_;
    }

    void drag(Button button, double x, double y, int width, int height)
    {
        x_ = x;
        y_ = y;
        if (isTouching_) {
            point(x, y, width, height);
            return;
        }
        const double across = x - lastX_, down = y - lastY_;
        lastX_ = x;
        lastY_ = y;
        MovedEye& eye = moved();
        if (button == Button::Left) {
            if (!isFlying_) eye.examine({down, across, 0}, kTurnPerPixel * std::hypot(across, down));
            return;
        }
        const double depth = eye.isOrthographic() ? 1 : std::max(-eye.centerInEye()[2], eye.radius * 0.01);
        eye.move({2 * across / width * depth / eye.projection[0],
                  -2 * down / height * depth / eye.projection[5], 0});
    }

    void release()
    {
        if (std::exchange(isTouching_, false)) view_.releasePointer();
        isHeld_ = false;
    }

    void scroll(double steps) { moved().approach(std::pow(0.9, steps)); }

    bool key(int code)
    {
        switch (code) {
        case kEscapeKey: return false;
        case 'e':
        case 'f': isFlying_ = code == 'f'; break;
        case 'h': std::printf("%s", kWindowKeys); break;
        case 'l': view_.setHeadlight(isLit_ = !isLit_); break;
        case 'p': isPaused_ = !isPaused_; break;
        case 'r': goTo(viewpoint_); break;
        case 's': styles_.next(); break;
        case 'v': goTo(viewpoint_ + 1); break;
        default:
            if (code >= '1' && code <= '9') goTo(code - '1');
        }
        std::fflush(stdout);
        return true;
    }

    /// A viewpoint by its index; after the last one comes the first.
    void goTo(int index)
    {
        const int count = view_.getViewpointCount();
        eye_.reset();
        if (count == 0) {
            view_.setViewpoint(voX3DNode());
            return;
        }
        viewpoint_ = index % count;
        view_.setViewpoint(view_.getViewpoint(viewpoint_));
        std::printf("viewpoint %d of %d\n", viewpoint_ + 1, count);
    }

    static Viewer* current_;

    voX3DView& view_;
    const Vox3dOptions& options_;
    Window& window_;
    StyleToggle styles_;
    ScaledTarget target_;
    std::optional<MovedEye> eye_;
    int width_ = 512, height_ = 512, viewpoint_ = 0;
    bool isFlying_ = false, isHeld_ = false, isTouching_ = false, isPaused_ = false, isLit_ = true;
    bool isCoarse_ = false, hasSensors_ = false;
    double started_ = 0, fullSeconds_ = 0;
    double pressX_ = 0, pressY_ = 0, lastX_ = 0, lastY_ = 0, x_ = 0, y_ = 0;
};

Viewer* Viewer::current_ = nullptr;

} // namespace

Result<bool> showInWindow(voX3DScene& scene, voX3DView& view, const Vox3dOptions& options,
                          std::string& whyNot)
{
    ScreenRequest request;
    request.program = "vox3d";
    request.width = options.width;
    request.height = options.height;
    const auto window = Window::open(request, whyNot);
    if (!window) return false;
    gl = &window->gl();
    Viewer viewer(scene, view, options, *window);
    if (auto shown = viewer.run(); !shown) return shown.failure();
    return true;
}

} // namespace vo
