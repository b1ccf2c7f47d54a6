#include "cast/polygon_setup.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

/// Polygons thinner than this are as good as a line: values change along it alone.
constexpr double kThin = 1.0 / 64.0; // pixels

glm::dvec2 windowPlace(const WindowVertex& vertex)
{
    return {vertex.x, vertex.y};
}

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// Finds the linear function of the window that has given values in three places.
class LinearFit
{
public:
    LinearFit(const glm::dvec2& origin, const glm::dvec2& first, const glm::dvec2& second,
              const glm::dvec2& start)
        : a_(first - origin), b_(second - origin), toStart_(start - origin), det_(cross(a_, b_)),
          length2_(glm::dot(a_, a_)), thin_(det_ * det_ <= kThin * kThin * length2_)
    {
    }

    WindowGradient operator()(double atOrigin, double atFirst, double atSecond) const
    {
        const double toFirst = atFirst - atOrigin, toSecond = atSecond - atOrigin;
        glm::dvec2 slope(0.0);
        if (!thin_)
            slope = glm::dvec2(toFirst * b_.y - toSecond * a_.y, toSecond * a_.x - toFirst * b_.x) / det_;
        else if (length2_ > 0.0)
            slope = toFirst / length2_ * a_;
        return {static_cast<float>(atOrigin + glm::dot(slope, toStart_)), static_cast<float>(slope.x),
                static_cast<float>(slope.y)};
    }

private:
    glm::dvec2 a_, b_, toStart_;
    double det_, length2_;
    bool thin_;
};

std::int32_t snapped(double pixels)
{
    return static_cast<std::int32_t>(std::lrint(pixels * kSubpixels));
}

} // namespace

PolygonSetup::PolygonSetup(const CastRequest& request, std::span<const FillBrick> bricks,
                           std::span<const float> records)
    : request_(request), bricks_(bricks), records_(records), projection_(request)
{
}

PolygonVertex PolygonSetup::vertexOf(std::uint32_t number) const
{
    const RecordLayout& layout = request_.layout;
    const float* record =
        records_.data() + static_cast<std::size_t>(number) * static_cast<std::size_t>(layout.values);
    const float* position = record + layout.position();
    const float* voxel = layout.texCoord >= 0 ? record + layout.texCoord : position;
    PolygonVertex vertex;
    vertex.position = {position[0], position[1], position[2]};
    for (std::size_t i = 0; i < 3; ++i)
        vertex.values[i] = voxel[i];
    if (layout.color < 0) return vertex;
    vertex.values[6] = 1.0;
    for (int i = 0; i < layout.colorChannels; ++i)
        vertex.values[static_cast<std::size_t>(3 + i)] = record[layout.color + i];
    return vertex;
}

void PolygonSetup::readPolygon(std::span<const std::uint32_t> fan)
{
    polygon_.clear();
    polygon_.push_back(vertexOf(fan[2]));
    polygon_.push_back(vertexOf(fan[0]));
    for (std::size_t i = 1; i < fan.size(); i += 3)
        polygon_.push_back(vertexOf(fan[i]));
    if (!request_.shading.flat || request_.layout.color < 0) return;
    for (PolygonVertex& vertex : polygon_)
        std::copy_n(polygon_.front().values.begin() + 3, 4, vertex.values.begin() + 3);
}

/// Far apart, so that no value within the polygon is far outside the three.
PolygonSetup::Basis PolygonSetup::findBasis() const
{
    const auto farthest = [&](auto distance) {
        std::size_t best = 0;
        double largest = -1.0;
        for (std::size_t i = 0; i < seen_.size(); ++i)
            if (const double d = distance(windowPlace(seen_[i])); d > largest) {
                largest = d;
                best = i;
            }
        return best;
    };
    const auto from = [](const glm::dvec2& a) {
        return [a](const glm::dvec2& p) { return glm::dot(p - a, p - a); };
    };
    Basis basis{};
    basis.origin = farthest(from(windowPlace(seen_.front())));
    const glm::dvec2 origin = windowPlace(seen_[basis.origin]);
    basis.first = farthest(from(origin));
    const glm::dvec2 along = windowPlace(seen_[basis.first]) - origin;
    basis.second = farthest([&](const glm::dvec2& p) { return std::abs(cross(along, p - origin)); });
    return basis;
}

void PolygonSetup::setGradients(const FillBrick& brick, FillPolygon& polygon) const
{
    const Basis basis = findBasis();
    const WindowVertex &a = seen_[basis.origin], &b = seen_[basis.first], &c = seen_[basis.second];
    const LinearFit fit(windowPlace(a), windowPlace(b), windowPlace(c),
                        {polygon.box.x0 + 0.5, polygon.box.y0 + 0.5});
    const bool perspective = projection_.perspective();
    const auto fitScaled = [&](auto valueOf) {
        const auto scaled = [&](const WindowVertex& v) {
            return perspective ? valueOf(v) * v.inverseW : valueOf(v);
        };
        return fit(scaled(a), scaled(b), scaled(c));
    };
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const auto place = [&](const WindowVertex& v) {
            return kPlaceParts * (v.values[i] * brick.scale[axis] + brick.shift[axis]);
        };
        const auto inside = [&](double p) {
            return static_cast<float>(
                std::clamp(p, kPlaceParts * brick.lower[axis], kPlaceParts * brick.upper[axis]));
        };
        polygon.place[i] = fitScaled(place);
        const auto [low, high] = std::ranges::minmax(seen_, {}, place);
        polygon.lower[i] = inside(place(low));
        polygon.upper[i] = inside(place(high));
    }
    if (perspective) {
        polygon.inverseW = fit(a.inverseW, b.inverseW, c.inverseW);
        polygon.smallestInverseW =
            static_cast<float>(std::ranges::min(seen_, {}, &WindowVertex::inverseW).inverseW);
    }
    if (!request_.depth.depths.empty()) polygon.depth = fit(a.depth, b.depth, c.depth);
    for (std::size_t i = 3; request_.layout.color >= 0 && i < PolygonVertex::kValues; ++i)
        polygon.color[i - 3] = fitScaled([i](const WindowVertex& v) { return v.values[i]; });
}

void PolygonSetup::append(int brick, std::span<const std::uint32_t> fan, FillList& list)
{
    readPolygon(fan);
    projection_.project(polygon_, seen_);
    if (seen_.size() < 3) return;
    snapped_.clear();
    for (const WindowVertex& vertex : seen_)
        snapped_.push_back({snapped(vertex.x), snapped(vertex.y)});

    FillPolygon polygon;
    polygon.sampler = bricks_[static_cast<std::size_t>(brick)].sampler;
    polygon.firstRow = list.rows.size();
    int layers = 0;
    polygon.box = appendRowSpans(snapped_, request_.width, request_.height, list.rows, layers);
    if (layers == 0) return;
    setGradients(bricks_[static_cast<std::size_t>(brick)], polygon);
    for (int layer = 0; layer < layers; ++layer) {
        list.polygons.push_back(polygon);
        polygon.firstRow += static_cast<std::size_t>(polygon.box.y1 - polygon.box.y0);
    }
}

} // namespace vo
