#include "mesh.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

namespace {

using vo::Failure;

/// The numbers of a line, and whatever is wrong with it.
class Line
{
public:
    explicit Line(const std::string& text) : words_(text) {}

    bool isEmpty() { return !(words_ >> kind_); }
    const std::string& kind() const { return kind_; }
    const std::string& problem() const { return problem_; }

    template <class Number>
    Number number(Number low, Number high, const char* what)
    {
        std::string word;
        words_ >> word;
        Number value{};
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
        const bool fits =
            code == std::errc() && end == word.data() + word.size() && value >= low && value <= high;
        if (!fits && problem_.empty())
            problem_ = std::string("expected ") + what + ", found " +
                       (word.empty() ? "the end of the line" : "'" + word + "'");
        return value;
    }
    void expectEnd()
    {
        if (std::string word; problem_.empty() && words_ >> word)
            problem_ = "expected the end of the line, found '" + word + "'";
    }
    void expectKind()
    {
        if (problem_.empty()) problem_ = "expected v or t, found '" + kind_ + "'";
    }

private:
    std::istringstream words_;
    std::string kind_, problem_;
};

void readVertex(Line& line, Mesh& mesh)
{
    Mesh::Vertex vertex{};
    for (float& coordinate : vertex.position)
        coordinate = line.number(-1e15f, 1e15f, "a coordinate");
    for (float& component : vertex.color)
        component = line.number(0.0f, 1.0f, "a colour from 0 to 1");
    mesh.vertices.push_back(vertex);
}

void readTetra(Line& line, Mesh& mesh)
{
    for (int corner = 0; corner < 4; ++corner)
        mesh.tetras.push_back(
            line.number(0, int(mesh.vertices.size()) - 1, "the number of a vertex that stands above"));
}

} // namespace

vo::Result<Mesh> readMesh(const std::string& path)
{
    std::ifstream file(path);
    if (!file) return Failure{path + ": cannot open it"};
    Mesh mesh;
    std::string text;
    for (int number = 1; std::getline(file, text); ++number) {
        Line line(text.substr(0, text.find('#')));
        if (line.isEmpty()) continue;
        if (line.kind() == "v") {
            readVertex(line, mesh);
        } else if (line.kind() == "t") {
            readTetra(line, mesh);
        } else {
            line.expectKind();
        }
        line.expectEnd();
        if (!line.problem().empty())
            return Failure{path + ": line " + std::to_string(number) + ": " + line.problem()};
        if (mesh.vertices.size() > 10'000'000 || mesh.tetras.size() > 40'000'000)
            return Failure{path + ": line " + std::to_string(number) +
                           ": expected at most 10 million vertices and as many tetrahedra"};
    }
    if (file.bad()) return Failure{path + ": cannot be read"};
    if (mesh.tetras.empty()) return Failure{path + ": expected a tetrahedron (t A B C D), found none"};
    return mesh;
}
