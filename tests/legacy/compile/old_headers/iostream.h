// The stream header of 1998: its names are global.
#include <iostream>
using std::cerr;
using std::cout;
using std::endl;
