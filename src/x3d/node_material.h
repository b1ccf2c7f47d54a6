#pragma once

#include "x3d/node_values.h"

namespace vo {

/// The fields of a Material for what is `lit` by it, a surface or a style.
template <typename Lit>
void readMaterial(const Node& material, Lit& lit)
{
    lit.ambientIntensity = floatOf(material, "ambientIntensity", lit.ambientIntensity);
    lit.shininess = floatOf(material, "shininess", lit.shininess);
    lit.transparency = floatOf(material, "transparency", lit.transparency);
    lit.diffuse = vec3Of(material, "diffuseColor", lit.diffuse);
    lit.emissive = vec3Of(material, "emissiveColor", lit.emissive);
    lit.specular = vec3Of(material, "specularColor", lit.specular);
}

} // namespace vo
