#include "x3d/read_encodings.h"

#include <algorithm>
#include <cctype>

#include "x3d/number_text.h"
#include "x3d/printable_word.h"
#include "x3d/text_lines.h"
#include "x3d/value_text.h"

namespace vo {
namespace {

/// Words, signs and strings of ClassicVRML.
class ClassicLexer
{
public:
    enum class Kind { end, word, sign, string, broken };
    struct Token
    {
        Kind kind = Kind::end;
        std::string_view text; // of a string: between the quotes, as written
        int line = 1;

        bool is(std::string_view other) const { return kind != Kind::string && text == other; }
    };

    explicit ClassicLexer(std::string_view text) : text_(text) { advance(); }

    const Token& peek() const { return next_; }
    Token take()
    {
        const Token taken = next_;
        advance();
        return taken;
    }
    bool skip(std::string_view sign)
    {
        if (!next_.is(sign)) return false;
        advance();
        return true;
    }

private:
    static bool isBlank(char c) { return c == ' ' || c == ',' || (c >= '\t' && c <= '\r'); }
    static bool isSign(char c) { return c == '{' || c == '}' || c == '[' || c == ']'; }

    void step()
    {
        line_ += endsLine(text_, at_);
        ++at_;
    }

    void skipBlanks()
    {
        while (at_ < text_.size()) {
            if (text_[at_] == '#')
                at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
            else if (isBlank(text_[at_]))
                step();
            else
                return;
        }
    }

    void advance()
    {
        skipBlanks();
        next_ = {Kind::end, {}, line_};
        if (at_ == text_.size()) return;
        if (text_[at_] == '"') return advanceString();
        const std::size_t from = at_;
        if (isSign(text_[at_]))
            ++at_;
        else
            while (at_ < text_.size() && !isBlank(text_[at_]) && !isSign(text_[at_]) && text_[at_] != '"' &&
                   text_[at_] != '#')
                ++at_;
        next_.kind = at_ == from + 1 && isSign(text_[from]) ? Kind::sign : Kind::word;
        next_.text = text_.substr(from, at_ - from);
    }

    void advanceString()
    {
        const std::size_t from = ++at_;
        while (at_ < text_.size() && text_[at_] != '"') {
            if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
            step();
        }
        next_.kind = at_ < text_.size() ? Kind::string : Kind::broken;
        next_.text = text_.substr(from, at_ - from);
        if (at_ < text_.size()) ++at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    Token next_;
};

std::string unescaped(std::string_view written)
{
    std::string out;
    for (std::size_t i = 0; i < written.size(); ++i) {
        const bool isEscape =
            written[i] == '\\' && i + 1 < written.size() && (written[i + 1] == '"' || written[i + 1] == '\\');
        out += written[isEscape ? ++i : i];
    }
    return out;
}

class ClassicReader
{
    using Lexer = ClassicLexer;

public:
    ClassicReader(std::string_view text, SceneBuilder& builder) : text_(text), lexer_(text), builder_(builder)
    {
    }

    void read()
    {
        if (!readFirstLine()) return;
        bool hasProfile = false;
        while (!builder_.gaveUp() && lexer_.peek().kind != Lexer::Kind::end) {
            const Lexer::Token& next = lexer_.peek();
            if (next.is("PROFILE")) {
                const int line = lexer_.take().line;
                const std::string_view profile = word("the name of a profile");
                if (builder_.gaveUp()) return;
                if (hasProfile) builder_.warn(line, "PROFILE is given twice; this one is kept");
                builder_.setProfile(profile, line);
                hasProfile = true;
            } else if (next.is("COMPONENT")) {
                readComponent();
            } else if (next.is("META")) {
                lexer_.take();
                const std::string name = string("a name in quotes for META"),
                                  content = string("a text in quotes for META");
                if (builder_.gaveUp()) return;
                builder_.header.metas.push_back({name, content});
            } else {
                readStatement();
            }
        }
        if (!hasProfile && !builder_.gaveUp())
            builder_.warn(1, "expected a PROFILE, found none, taken as Full");
    }

private:
    bool readFirstLine()
    {
        const std::string_view line = text_.substr(0, std::min(text_.find_first_of("\r\n"), text_.size()));
        if (line.starts_with("#VRML")) {
            builder_.giveUp(1,
                            "expected \"#X3D V3.0 utf8\" or a later version, found VRML, which is not read");
            return false;
        }
        if (!line.starts_with("#X3D V")) {
            builder_.giveUp(1, "expected \"#X3D V3.0 utf8\" or a later version, found " + quotedWord(line));
            return false;
        }
        const std::string_view rest = line.substr(6);
        const auto blank = std::min(rest.find(' '), rest.size());
        builder_.setVersion(rest.substr(0, blank), 1);
        if (!rest.substr(blank).starts_with(" utf8"))
            builder_.warn(1, "expected \"utf8\" behind the version, found " + quotedWord(rest.substr(blank)));
        return true;
    }

    void readComponent()
    {
        const int line = lexer_.take().line;
        const std::string_view text = word("a name, a colon and a level for COMPONENT");
        if (builder_.gaveUp()) return;
        const auto colon = std::min(text.rfind(':'), text.size());
        int level = 1;
        if (colon == text.size() || !parseNumber(text.substr(colon + 1), level))
            builder_.wrong(line,
                           "COMPONENT: expected a name, a colon and a level, found " + quotedWord(text));
        else
            builder_.addComponent(text.substr(0, colon), level, line);
    }

    /// The next word; "" after giving up where none stands there.
    std::string_view word(const char* what)
    {
        if (lexer_.peek().kind == Lexer::Kind::word) return lexer_.take().text;
        expected(what);
        return {};
    }

    std::string string(const char* what)
    {
        if (lexer_.peek().kind == Lexer::Kind::string) return unescaped(lexer_.take().text);
        expected(what);
        return {};
    }

    void expected(const std::string& what)
    {
        const Lexer::Token& next = lexer_.peek();
        const std::string found = next.kind == Lexer::Kind::end      ? "the end of the file"
                                  : next.kind == Lexer::Kind::broken ? "a string without an end"
                                                                     : quotedWord(next.text);
        builder_.giveUp(next.line, "expected " + what + ", found " + found);
    }

    /// A node, a route or what is skipped. Nodes go to `field` of the node that is open, or to the roots.
    void readStatement(std::string_view field = {})
    {
        const Lexer::Token& next = lexer_.peek();
        if (next.kind != Lexer::Kind::word) return expected("a node");
        if (next.is("ROUTE")) return readRoute();
        for (const char* const word : {"PROTO", "EXTERNPROTO", "IMPORT", "EXPORT", "UNIT"})
            if (next.is(word)) return skipStatement();
        if (next.is("NULL")) {
            lexer_.take();
            return;
        }
        readNode(field);
    }

    void readNode(std::string_view field)
    {
        std::string_view name;
        const int line = lexer_.peek().line;
        if (lexer_.skip("USE")) {
            const std::string_view used = word("a name behind USE");
            if (builder_.gaveUp()) return;
            if (Node* const node = builder_.use(used, line)) builder_.attach(*node, field, line);
            return;
        }
        if (lexer_.skip("DEF")) name = word("a name behind DEF");
        if (builder_.gaveUp()) return;
        const Lexer::Token typeName = lexer_.take();
        if (typeName.kind != Lexer::Kind::word || !lexer_.peek().is("{"))
            return expected("{ behind the name of a node");
        const NodeType* const type = builder_.typeOf(typeName.text, line);
        if (!type) {
            if (!name.empty()) builder_.skipName(name);
            return skipBraces();
        }
        lexer_.take();
        Node* const node = builder_.begin(*type, typeName.text, name, line);
        if (!node) return;
        while (!builder_.gaveUp() && !lexer_.peek().is("}"))
            readField();
        lexer_.take();
        builder_.end();
        if (!builder_.gaveUp()) builder_.attach(*node, field, line);
    }

    void readField()
    {
        const Lexer::Token& next = lexer_.peek();
        if (next.kind != Lexer::Kind::word || isNumber(next)) return expected("the name of a field, or }");
        if (next.is("ROUTE")) return readRoute();
        if (next.is("PROTO") || next.is("EXTERNPROTO")) return skipStatement();
        const Lexer::Token name = lexer_.take();
        if (lexer_.peek().is("{")) return expected("the value of a field");
        const FieldRow* const row = builder_.rowToSet(name.text, name.line);
        if (!row) return skipValue();
        if (shapeOf(row->type).storage == Storage::nodes) return readNodes(*row, name.text);
        FieldValue value = emptyValue(row->type);
        if (readValue(*row, value)) builder_.set(*row, std::move(value), name.line);
    }

    void readNodes(const FieldRow&, std::string_view field)
    {
        if (!lexer_.skip("[")) return readStatement(field);
        while (!builder_.gaveUp() && !lexer_.peek().is("]"))
            readStatement(field);
        lexer_.take();
    }

    /// Sizes of lists and pictures are what stands there, not what a number says.
    bool readValue(const FieldRow& row, FieldValue& value)
    {
        const FieldShape& shape = shapeOf(row.type);
        const bool isPicture = row.type == FieldType::sfImage;
        if (shape.isMany && !isPicture && lexer_.skip("[")) {
            while (!lexer_.peek().is("]"))
                if (!readElement(row, value)) return false;
            lexer_.take();
        } else if (isPicture) {
            while (isNumber(lexer_.peek()))
                if (!readElement(row, value)) return false;
        } else {
            for (int i = 0; i < shape.components; ++i)
                if (!readElement(row, value)) return false;
        }
        if (fits(row.type, value)) return true;
        expected("a multiple of " + std::to_string(shape.components) + " numbers for " + row.name);
        return false;
    }

    static bool isNumber(const Lexer::Token& token)
    {
        return token.kind == Lexer::Kind::word &&
               (std::isdigit(static_cast<unsigned char>(token.text[0])) || token.text[0] == '-' ||
                token.text[0] == '+' || token.text[0] == '.');
    }

    bool readElement(const FieldRow& row, FieldValue& value)
    {
        const Lexer::Token& next = lexer_.peek();
        const bool isWord = next.kind == Lexer::Kind::word;
        bool isRead = false;
        const char* what = "a number";
        if (auto* const strings = std::get_if<std::vector<std::string>>(&value)) {
            what = "a string in quotes";
            isRead = next.kind == Lexer::Kind::string;
            if (isRead) strings->push_back(unescaped(next.text));
        } else if (auto* const floats = std::get_if<std::vector<float>>(&value)) {
            isRead = isWord && parseNumber(next.text, floats->emplace_back());
        } else if (auto* const doubles = std::get_if<std::vector<double>>(&value)) {
            isRead = isWord && parseNumber(next.text, doubles->emplace_back());
        } else {
            auto& integers = std::get<std::vector<std::int32_t>>(value);
            if (row.type == FieldType::sfBool || row.type == FieldType::mfBool) {
                what = "TRUE or FALSE";
                isRead = next.is("TRUE") || next.is("FALSE");
                integers.push_back(next.is("TRUE"));
            } else {
                what = "a whole number of 32 bits";
                isRead = isWord && parseInteger(next.text, holdsPixels(row.name), integers.emplace_back());
            }
        }
        if (!isRead)
            expected(std::string(what) + " for " + row.name);
        else
            lexer_.take();
        return isRead;
    }

    void readRoute()
    {
        const int line = lexer_.take().line;
        const char* const form = "ROUTE node.field TO node.field";
        const std::string_view from = word(form);
        if (builder_.gaveUp()) return;
        if (!lexer_.skip("TO")) return expected(form);
        const std::string_view to = word(form);
        if (builder_.gaveUp()) return;
        const auto fromDot = from.find('.'), toDot = to.find('.');
        if (fromDot == from.npos || toDot == to.npos)
            return builder_.wrong(line, "ROUTE: expected node.field TO node.field, found \"" +
                                            printableWord(from) + " TO " + printableWord(to) + "\"");
        builder_.route(from.substr(0, fromDot), from.substr(fromDot + 1), to.substr(0, toDot),
                       to.substr(toDot + 1), line);
    }

    /// What is not read: prototypes and the like.
    void skipStatement()
    {
        const Lexer::Token what = lexer_.take();
        const std::string skipped = printableWord(what.text) + " is not supported, skipped";
        const bool isPrototype = what.is("PROTO") || what.is("EXTERNPROTO");
        if (!isPrototype) builder_.warn(what.line, skipped);
        if (isPrototype) {
            const std::string_view name = word("the name of a prototype");
            if (builder_.gaveUp()) return;
            builder_.warn(what.line, skipped + " with all nodes " + quotedWord(name));
            skipBraces();
            if (what.is("PROTO"))
                skipBraces();
            else
                skipValue();
            return;
        }
        // IMPORT a.b AS c; EXPORT a AS b; UNIT length name 1.0
        word("a name");
        if (what.is("UNIT")) {
            word("a name");
            word("a number");
        } else if (lexer_.skip("AS")) {
            builder_.skipName(word("a name behind AS"));
        }
    }

    /// From an opening brace or bracket to the one that closes it.
    void skipBraces()
    {
        if (!lexer_.peek().is("{") && !lexer_.peek().is("[")) return expected("{ or [");
        const std::string from = std::to_string(lexer_.peek().line);
        int depth = 0;
        do {
            const Lexer::Token token = lexer_.take();
            if (token.kind == Lexer::Kind::end || token.kind == Lexer::Kind::broken)
                return expected("} or ] of what is skipped from line " + from + " on");
            if (token.kind == Lexer::Kind::word && token.text == "DEF") builder_.skipName(lexer_.peek().text);
            if (token.kind != Lexer::Kind::sign) continue;
            depth += token.text == "{" || token.text == "[" ? 1 : -1;
        } while (depth > 0);
    }

    /// A value of a type that is not known.
    void skipValue()
    {
        const Lexer::Token& next = lexer_.peek();
        if (next.is("[")) return skipBraces();
        if (next.kind == Lexer::Kind::string || next.is("TRUE") || next.is("FALSE") || next.is("NULL")) {
            lexer_.take();
            return;
        }
        if (isNumber(next)) {
            while (isNumber(lexer_.peek()))
                lexer_.take();
            return;
        }
        if (next.kind != Lexer::Kind::word) return expected("the value of a field");
        if (lexer_.skip("USE") || lexer_.skip("IS")) {
            lexer_.take();
            return;
        }
        if (lexer_.skip("DEF")) builder_.skipName(lexer_.take().text);
        lexer_.take();
        skipBraces();
    }

    std::string_view text_;
    ClassicLexer lexer_;
    SceneBuilder& builder_;
};

} // namespace

void readClassic(std::string_view text, SceneBuilder& builder)
{
    ClassicReader(text, builder).read();
}

} // namespace vo
