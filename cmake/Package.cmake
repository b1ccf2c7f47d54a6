# Install rules and the package descriptions (find_package(Volumizer), pkg-config volumizer).
