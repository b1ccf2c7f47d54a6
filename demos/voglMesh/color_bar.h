#pragma once

// Before any header of <vo/...>.
#include "gl.h"

#include <string>
#include <vector>

/** Draws a table as a bar at the right edge of the picture, its lowest entry at the bottom, with the numbers
   that its ends and quarters stand for. `rgba`: four parts an entry; alpha is not shown. */
void drawColorBar(const std::vector<float>& rgba, double low, double high);

/** A number as the bar writes it: at most seven characters. */
std::string barNumber(double value, double range);
