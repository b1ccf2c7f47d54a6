#pragma once

#include "volume_io/result.h"

#include <string>
#include <vector>

/// Names of the pictures of a turn (-frames), and which of them are one file.
namespace vo {

/// Whether a name has one %d or %03d for the number of a picture.
bool isNumbered(const std::string& name);

/// A failure where a name has no such number. `option` begins the message.
Result<void> checkNumbered(const char* option, const std::string& name);

/// A failure where a name of a turn has a % that is no such number.
Result<void> checkFrameName(const char* option, const std::string& name);

/// The name of picture `frame`, from 0, of a turn of `frames`: with its number in place of %d. Without a turn
/// (`frames` 0) the name itself.
std::string frameName(const std::string& name, int frames, int frame);

/// The names that an option gives to all its pictures.
struct NamedPictures
{
    const char* option;
    std::vector<std::string> names;
};

/// A failure where two of the names lead to one file, however they are spelled: through other folders or
/// through links.
Result<void> checkNamesDiffer(const std::vector<NamedPictures>& pictures);

} // namespace vo
