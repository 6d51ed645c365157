// Dresses the body that a garment file names, prints how that ended, and writes the cloth as OBJ: its positions and
// triangles, as the library gives them. Usage: dress GARMENT.json OUT.obj
#include <cstdio>
#include <exception>
#include <fstream>

#include <selvedge/selvedge.h>

int main(int argc, char** argv) {
    if (argc != 3) return std::fprintf(stderr, "usage: dress GARMENT.json OUT.obj\n"), 2;
    try {
        const selvedge::Result result = selvedge::dress(selvedge::load_pattern(argv[1]));
        for (const selvedge::DrapeFault& fault : result.faults()) std::printf("%s\n", fault.sentence.c_str());
        std::ofstream file(argv[2]);
        file.precision(9);  // digits that bring a float back
        for (const auto& [x, y, z] : result.mesh().positions) file << "v " << x << ' ' << y << ' ' << z << '\n';
        for (const auto& [a, b, c] : result.mesh().triangles)
            file << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
        return file.flush() && result.verdict() == selvedge::Verdict::Dressed ? 0 : 1;
    } catch (const std::exception& error) {  // InputError: what() names file, place and problem
        return std::fprintf(stderr, "dress: %s\n", error.what()), 2;
    }
}
