// How volumes are drawn that stand among others.

#include "draw/hit_plan.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace vo;

enum class Kind { samples, surfaces, projection, tetrahedra };

/// Two wide round a point of the view's axis, that far from the eye.
StyledVolume volumeAt(double depth, Kind kind)
{
    StyledVolume volume;
    volume.dimensions = glm::vec3(2.0f);
    volume.worldFromLocal = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -depth));
    if (kind == Kind::surfaces) volume.surfaces.emplace();
    if (kind == Kind::projection) volume.projection.emplace();
    if (kind == Kind::tetrahedra) {
        StyledTetras tetras;
        tetras.positions = {{-1, -1, -1}, {1, 1, 1}};
        volume.tetras = std::make_shared<StyledTetras>(tetras);
    }
    return volume;
}

struct Planned
{
    std::vector<VolumePlace> places;
    std::vector<std::size_t> walked;
};

StyledScene sceneOf(int panes)
{
    StyledScene scene;
    scene.clipFromEye = glm::perspective(1.5, 1.0, 0.01, 100.0);
    for (int i = 0; i < panes; ++i) {
        StyledSurface& pane = scene.surfaces.emplace_back();
        pane.positions = {{-1, -1, -5}, {1, -1, -5}, {1, 1, -5}, {-1, 1, -5}};
        pane.normals.assign(4, {0, 0, 1});
        pane.triangles = {0, 1, 2, 0, 2, 3};
        pane.transparency = 0.5f;
    }
    return scene;
}

Planned planned(const std::vector<StyledVolume>& volumes, int panes = 0)
{
    const StyledScene scene = sceneOf(panes);
    std::vector<const StyledVolume*> drawn;
    for (const StyledVolume& volume : volumes)
        drawn.push_back(&volume);
    Planned plan{volumePlaces(scene, drawn), {}};
    plan.walked = walkedNearestFirst(scene, drawn, plan.places);
    return plan;
}

using Places = std::vector<VolumePlace>;
using Numbers = std::vector<std::size_t>;
constexpr VolumePlace kAlone = VolumePlace::alone, kAmong = VolumePlace::among,
                      kBetween = VolumePlace::betweenHits, kOf = VolumePlace::ofHits;

TEST(volumePlaces, areThoseOfVolumesAloneWhereNothingMeets)
{
    const Planned plan = planned({volumeAt(5.0, Kind::samples), volumeAt(9.0, Kind::surfaces)});
    EXPECT_EQ(plan.places, (Places{kAlone, kAlone}));
    EXPECT_TRUE(plan.walked.empty());
}

TEST(volumePlaces, areOnRaysWhereSamplesMeetSurfacesAlone)
{
    EXPECT_EQ(planned({volumeAt(5.0, Kind::samples)}, 1).places, Places{kBetween});
    EXPECT_EQ(planned({volumeAt(5.0, Kind::surfaces), volumeAt(6.0, Kind::samples)}).places,
              (Places{kOf, kBetween}));
    EXPECT_EQ(planned({volumeAt(5.0, Kind::surfaces), volumeAt(6.0, Kind::surfaces)}).places,
              (Places{kBetween, kOf}));
}

TEST(volumePlaces, areOnRaysWhereProjectionsStandAmongOtherThings)
{
    EXPECT_EQ(planned({volumeAt(20.0, Kind::samples), volumeAt(5.0, Kind::projection)}, 1).places,
              (Places{kBetween, kOf}));
    EXPECT_EQ(planned({volumeAt(5.0, Kind::projection), volumeAt(5.0, Kind::projection)}).places,
              (Places{kOf, kOf}));
}

TEST(volumePlaces, areAmongOthersWhereSamplesMeet)
{
    EXPECT_EQ(planned({volumeAt(5.0, Kind::samples), volumeAt(6.0, Kind::samples)}).places,
              (Places{kAmong, kAmong}));
    EXPECT_EQ(
        planned({volumeAt(5.0, Kind::samples), volumeAt(5.0, Kind::projection), volumeAt(6.0, Kind::samples)})
            .places,
        (Places{kAmong, kAmong, kAmong}));
    EXPECT_EQ(planned({volumeAt(5.0, Kind::tetrahedra)}, 1).places, Places{kAmong});
}

TEST(volumePlaces, areAmongOthersWhereTooManyHaveHits)
{
    std::vector<StyledVolume> volumes(8, volumeAt(5.0, Kind::surfaces));
    EXPECT_EQ(planned(volumes).places.back(), kOf);
    volumes.push_back(volumes[0]);
    EXPECT_EQ(planned(volumes).places, Places(9, kAmong));
}

TEST(walkedNearestFirst, goesByDepth)
{
    const Planned plan = planned({volumeAt(12.0, Kind::samples), volumeAt(5.0, Kind::surfaces),
                                  volumeAt(5.5, Kind::surfaces), volumeAt(9.0, Kind::surfaces)});
    EXPECT_EQ(plan.places, (Places{kBetween, kBetween, kOf, kBetween}));
    EXPECT_EQ(plan.walked, (Numbers{1, 3, 0}));
}

TEST(volumePlaces, raysDoNotStopAtVeryMany)
{
    const std::vector<StyledVolume> volume{volumeAt(5.0, Kind::samples)};
    EXPECT_EQ(planned(volume, 60).places, Places{kBetween});
    EXPECT_EQ(planned(volume, 68).places, Places{kAmong});
    const std::vector<StyledVolume> projection{volumeAt(5.0, Kind::projection)};
    EXPECT_EQ(planned(projection, 15).places, Places{kOf});
    EXPECT_EQ(planned(projection, 17).places, Places{kAmong});
}

TEST(facesHaveHits, unlessThereAreManyOrNone)
{
    EXPECT_FALSE(facesHaveHits(sceneOf(0)));
    EXPECT_TRUE(facesHaveHits(sceneOf(1)));
    EXPECT_TRUE(facesHaveHits(sceneOf(7)));
    EXPECT_FALSE(facesHaveHits(sceneOf(9)));
}

} // namespace
