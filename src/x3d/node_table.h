#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "x3d/field_type.h"

namespace vo {

/// Which document's nodes, fields and defaults hold: the proposal of 2005 (in scenes before X3D 3.3), or
/// ISO's.
enum class Edition : unsigned { proposal2005 = 1, x3d33 = 2, x3d40 = 4 };

using Editions = unsigned;
constexpr Editions kAllEditions = 7;

constexpr bool has(Editions editions, Edition edition)
{
    return (editions & static_cast<Editions>(edition)) != 0;
}

/// "X3D 4.0", for a message.
const char* editionText(Edition edition);
/// The edition of a scene's version: below 3.3 the proposal's, from 4.0 on 4.0's.
Edition editionOfVersion(int major, int minor);

/// That edition, or the one of `editions` that is nearest to it.
Edition nearestEdition(Editions editions, Edition to);

enum class Access { initializeOnly, inputOnly, outputOnly, inputOutput };

constexpr bool isInput(Access access)
{
    return access == Access::inputOnly || access == Access::inputOutput;
}
constexpr bool isOutput(Access access)
{
    return access == Access::outputOnly || access == Access::inputOutput;
}
/// Whether a field of this access has a value that a file may give.
constexpr bool isKept(Access access)
{
    return access == Access::initializeOnly || access == Access::inputOutput;
}

/// The numbers that each component of a value may be.
struct Range
{
    double low = 0, high = 0;
    /// Whether the limits themselves belong to it.
    bool hasLow = true, hasHigh = true;
    /// Whether -1 passes too.
    bool orMinusOne = false;
    /// As it is declared: "(0,inf)".
    std::string text;

    bool contains(double number) const;
};

class NodeType;

/// A field of a node, in some editions.
struct FieldRow
{
    std::string name;
    /// The place of its value in the node. Rows with one slot are one field, which differs between editions.
    std::size_t slot = 0;
    FieldType type = FieldType::sfBool;
    Access access = Access::inputOutput;
    Editions editions = kAllEditions;
    FieldValue defaultValue;
    Range range;
    /// Of fields that are compared with voxels: beyond it numbers are allowed, and find none.
    std::optional<Range> voxelRange;
    /// Strings that are allowed; any where there are none.
    std::vector<std::string> choices;
    /// Nodes that are allowed.
    std::vector<const NodeType*> accepted;
    std::string_view acceptedNames;
};

class NodeType
{
public:
    /// The name in an edition; any of its names where it is not in that one.
    const std::string& name(Edition edition) const;
    /// The editions that have it under this name; 0 where it is no name of it.
    Editions editionsOfName(std::string_view name) const;
    bool isAbstract() const { return isAbstract_; }
    const std::string& component() const { return component_; }
    int level(Edition edition) const { return edition == Edition::proposal2005 ? level2005_ : levelIso_; }
    /// The field of the parent that it goes to where a file does not say.
    const std::string& container() const { return container_; }
    bool isA(const NodeType& base) const;

    std::span<const FieldRow> rows() const { return rows_; }
    std::size_t slotCount() const { return slotCount_; }
    /// The field of this name in this edition, else in another, else NULL.
    const FieldRow* row(std::string_view name, Edition edition) const;
    /// The field in this edition, else in another.
    const FieldRow& row(std::size_t slot, Edition edition) const;
    /// The editions in which the slot has this name.
    Editions editionsOfRow(std::string_view name) const;

private:
    friend class NodeTableReader;
    struct Name
    {
        std::string text;
        Editions editions;
    };
    std::vector<Name> names_;
    bool isAbstract_ = false;
    std::string component_, container_;
    int level2005_ = 0, levelIso_ = 0;
    std::vector<const NodeType*> bases_; // of all depths
    std::vector<FieldRow> rows_;
    std::size_t slotCount_ = 0;
};

/// All nodes, those that are abstract among them.
std::span<const std::unique_ptr<NodeType>> nodeTypes();
/// The node of a name, in any edition, that is not abstract; else NULL.
const NodeType* findNodeType(std::string_view name);
/// The node or abstract type of a name that must exist.
const NodeType& knownNodeType(std::string_view name);

} // namespace vo
