#pragma once

#include <array>
#include <string_view>

namespace vo {

/// The nodes of X3D that are known, in the notation of the standard, one line each for a node and for a
/// field:
///
///     abstract NAME [: BASE ...]
///     node NAME[@WHEN] ... : BASE ... | COMPONENT LEVEL[/LEVEL] | CONTAINER
///       [@WHEN] TYPE ACCESS NAME[=KEY] [DEFAULT] [RANGE] [~RANGE] [{STRING ...}] [<NODE ...>]
///
/// WHEN limits a name or a row to editions: 2005 (the proposal, in scenes before X3D 3.3), 3.3, 4.0, iso (the
/// last two), 3 (the first two); without it all have it. A name of which the editions differ is written once
/// for each. LEVEL is that of 2005 and, after the stroke, that of ISO. CONTAINER is the field of the parent
/// that a node goes to where a file does not say. ACCESS is [] initializeOnly, [in], [out], [in,out]. Rows
/// with one KEY (their name, if none is given; the row of that name comes first) are one field that was
/// renamed. DEFAULT is numbers, TRUE, FALSE, quoted strings without blanks, NULL or [] (nothing in it). RANGE
/// holds for each component: brackets belong to it, parentheses do not; "|-1" lets -1 pass too; pi and inf
/// are numbers. ~RANGE is that of voxels, which the field is compared with: beyond it numbers are allowed,
/// and find none. {} lists the strings that are allowed, <> the nodes. A row stands for that of a base with
/// the same key in the editions that it names.
std::array<std::string_view, 10> nodeDeclarations();

} // namespace vo
