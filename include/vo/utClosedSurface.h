#ifndef VO_UT_CLOSED_SURFACE_H
#define VO_UT_CLOSED_SURFACE_H

#include <vo/utGeometry.h>

/** What a closed surface of triangles bounds, as tetrahedra: an organ, a bone, a part to be moved by itself (guide, pages
    14 to 16). Of the library vout, by CGAL's mesh generator: a vout that has it comes under the GNU General Public
    License, version 3 or later (docs/vout.md). In one built without, the constructors are UNSUPPORTED and make no
    surface.

    The surface may have several parts, and cavities: what lies inside of an odd number of parts is filled. Triangles may
    be any way round, in all parts, but neighbours alike. Vertices of equal coordinates count as one. BAD_VALUE, with
    numbers of what was found: a surface that is open, that crosses or touches itself, or whose neighbours go round
    opposite ways; triangles without area; coordinates that are not finite.

    No tetrahedron has an angle between two of its faces below getSmallestAngle(). */
class VOUT_API voutClosedSurface : public voutGeometry
{
public:
    /** Of countV vertices, three coordinates each, and countI / 3 triangles, three vertex numbers each; both are
        copied. */
    voutClosedSurface(const float *vertices, int countV, const int *triangles, int countI);
    /** Of a file in OFF, PLY, STL or OBJ, by the ending of its name. Polygons are convex; neighbours that go round
        opposite ways are turned. */
    explicit voutClosedSurface(const char *fileName);
    virtual ~voutClosedSurface();

    /** About how long edges of tetrahedra are; the number of tetrahedra is 8 to 20 times the volume through the length's
        cube. At first a twentieth of the diagonal of the surface's bounds. */
    void setEdgeLength(float length);
    float getEdgeLength() const;
    /** How far faces of tetrahedra may be off the surface, from a thousandth of the edge length on. At first, and where it
        was not set, a twentieth of the edge length. */
    void setFacetDistance(float distance);
    float getFacetDistance() const;
    /** Where the normals of neighbouring triangles differ by more than this angle in degrees (40 at first; 1 to 180), their
        edge is sharp, and made of edges of tetrahedra. */
    void setSharpAngle(float degrees);
    float getSharpAngle() const;

    /** The volume that the surface bounds; 0 where there is none. */
    double getVolume() const;
    /** The box round it; where there is no surface: BAD_VALUE, and nothing is written. */
    void getBounds(float lower[3], float upper[3]) const;
    /** 5, in degrees. */
    static float getSmallestAngle();

    /** V3F records. Equal calls give equal sets. Takes about a second for 100,000 tetrahedra. UNSUPPORTED, with the
        reason, where no tetrahedra of this quality were found, as in a wedge that is sharper itself, or where
        details finer than the edge length would be lost. */
    virtual voIndexedTetraSet *tessellate();
    /** The same, and the rest of a box round the surface, from one mesh: where the two sets meet they have the same
        triangles, so that both together fill the box. The surface has to stay clear of the box's faces by the facet
        distance. Both sets are new, the caller's to delete. Returns 0; or else 1, and both are NULL. */
    int tessellateInBox(const float lower[3], const float upper[3], voIndexedTetraSet *&inside,
                        voIndexedTetraSet *&rest);

private:
    struct Private;
    Private *d;
};

#endif
