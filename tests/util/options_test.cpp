#include "volume_view/options.h"

#include <gtest/gtest.h>

namespace {

using vo::Options;
using vo::OptionSet;
using vo::parseOptions;
using vo::Result;

Result<Options> parse(std::vector<const char*> words, OptionSet set = OptionSet::All)
{
    return parseOptions(words, set);
}

/// The failure's text, empty when there is none.
std::string failureOf(std::vector<const char*> words, OptionSet set = OptionSet::All)
{
    const auto options = parse(std::move(words), set);
    return options ? "" : options.failure().text;
}

TEST(Options, nothingGivesTheDefaults)
{
    const auto options = parse({});
    ASSERT_TRUE(options);
    EXPECT_TRUE(options->files.empty());
    EXPECT_EQ(options->textureDimensions, 3);
    EXPECT_FALSE(options->color);
    EXPECT_FALSE(options->dataRange);
    EXPECT_FALSE(options->lut);
    EXPECT_EQ(options->width, 512);
    EXPECT_EQ(options->height, 512);
    EXPECT_FALSE(options->bricks);
    EXPECT_EQ(options->overlap, 1);
    EXPECT_EQ(options->sampling, 1);
    EXPECT_EQ(options->perspective, 0);
}

TEST(Options, optionsStandAnywhereAroundTheFile)
{
    for (const auto& words : {std::vector<const char*>{"-2D", "-size", "3", "4", "a.tif"},
                              {"a.tif", "-2D", "-size", "3", "4"},
                              {"-2D", "a.tif", "-size", "3", "4"}}) {
        const auto options = parse(words);
        ASSERT_TRUE(options);
        EXPECT_EQ(options->files, std::vector<std::string>{"a.tif"});
        EXPECT_EQ(options->textureDimensions, 2);
        EXPECT_EQ(options->width, 3);
        EXPECT_EQ(options->height, 4);
    }
}

TEST(Options, everyOptionReachesItsSetting)
{
    const auto options = parse({"-3D",
                                "-color",
                                "-dataRange",
                                "-5",
                                "4095.5",
                                "-lut",
                                "135",
                                "155",
                                "-lutFile",
                                "t.lut",
                                "-tessellationSize",
                                "8",
                                "-output",
                                "o.png",
                                "-view",
                                "1",
                                "2",
                                "-scale",
                                "1",
                                "2",
                                "3",
                                "-bricks",
                                "2",
                                "3",
                                "4",
                                "-overlap",
                                "2",
                                "-space",
                                "view",
                                "-sampling",
                                "0.5",
                                "-perspective",
                                "30",
                                "-frames",
                                "20",
                                "-mip",
                                "-core",
                                "-wireframe"});
    ASSERT_TRUE(options) << options.failure().text;
    EXPECT_EQ(options->color, true);
    EXPECT_EQ(options->dataRange->low, -5);
    EXPECT_EQ(options->dataRange->high, 4095.5);
    EXPECT_EQ(options->lut->center, 135);
    EXPECT_EQ(options->lut->width, 155);
    EXPECT_EQ(options->lutFile, "t.lut");
    EXPECT_EQ(options->tessellationSize, 8);
    EXPECT_EQ(options->output, "o.png");
    EXPECT_EQ(options->latitude, 1);
    EXPECT_EQ(options->longitude, 2);
    EXPECT_EQ(options->scale, (std::array<double, 3>{1, 2, 3}));
    EXPECT_EQ(options->bricks, (std::array<int, 3>{2, 3, 4}));
    EXPECT_EQ(options->overlap, 2);
    EXPECT_TRUE(options->viewSpace);
    EXPECT_EQ(options->sampling, 0.5);
    EXPECT_EQ(options->perspective, 30);
    EXPECT_EQ(options->frames, 20);
    EXPECT_TRUE(options->mip && options->core && options->wireframe);
    EXPECT_TRUE(options->files.empty());
}

TEST(Options, argumentsAreTakenByCount)
{
    const auto options = parse({"-view", "-3", "20", "-output", "-2D"});
    ASSERT_TRUE(options) << options.failure().text;
    EXPECT_EQ(options->latitude, -3);
    EXPECT_EQ(options->longitude, 20);
    EXPECT_EQ(options->output, "-2D");
    EXPECT_EQ(options->textureDimensions, 3);
}

TEST(Options, ambiguityGoesToTheFirstInLexicographicOrder)
{
    const auto options = parse({"-lu", "1", "2", "-s", "3", "-o", "o.png"});
    ASSERT_TRUE(options) << options.failure().text;
    EXPECT_EQ(options->lut->center, 1) << "-lut before -lutFile";
    EXPECT_EQ(options->sampling, 3) << "-sampling before -scale, -size, -space";
    EXPECT_EQ(options->output, "o.png") << "-output before -overlap";
}

TEST(Options, guidesOptionsComeBeforeOurs)
{
    const auto options = parse({"-co", "-m"});
    ASSERT_TRUE(options);
    EXPECT_EQ(options->color, false) << "-m is -monochrome, not -mip";
    EXPECT_FALSE(options->core) << "-co is -color, not -core";
    EXPECT_FALSE(options->mip);
}

TEST(Options, abbreviationsThatFitOneOptionFindIt)
{
    const auto options = parse({"-tess", "8", "-lutF", "f", "-d", "0", "9", "-cor", "-mi", "-v", "7", "9"});
    ASSERT_TRUE(options) << options.failure().text;
    EXPECT_EQ(options->tessellationSize, 8);
    EXPECT_EQ(options->lutFile, "f");
    EXPECT_EQ(options->dataRange->high, 9);
    EXPECT_TRUE(options->core);
    EXPECT_TRUE(options->mip);
    EXPECT_EQ(options->latitude, 7) << "-v is a view";
}

TEST(Options, exactNameWinsOverLongerOnes)
{
    const auto options = parse({"-lut", "1", "2"});
    ASSERT_TRUE(options);
    EXPECT_TRUE(options->lut);
    EXPECT_EQ(options->lutFile, "");
}

TEST(Options, twoDashesMeanTheSame)
{
    EXPECT_TRUE(parse({"--help"})->help);
    EXPECT_TRUE(parse({"-help"})->help);
    EXPECT_TRUE(parse({"-h"})->help);
    EXPECT_TRUE(parse({"--version"})->version);
}

TEST(Options, twoDashesAloneEndTheOptions)
{
    const auto options = parse({"--", "-2D"});
    ASSERT_TRUE(options);
    EXPECT_EQ(options->files, std::vector<std::string>{"-2D"});
}

TEST(Options, lastOneOfTwoCounts)
{
    const auto options = parse({"-color", "-monochrome", "-view", "1", "2", "-view", "3", "4"});
    ASSERT_TRUE(options);
    EXPECT_EQ(options->color, false);
    EXPECT_EQ(options->latitude, 3);
}

TEST(Options, unknownOptionIsNamed)
{
    for (const char* word : {"-colour", "-x", "-", "---", "-LUT", "-2d"})
        EXPECT_NE(failureOf({"a.tif", word}).find(std::string("'") + word + "'"), std::string::npos) << word;
}

TEST(Options, missingArgumentIsNamed)
{
    EXPECT_EQ(failureOf({"-size", "512"}), "option -size: expected W H, found '512'");
    EXPECT_EQ(failureOf({"-output"}), "option -output: expected FILE.png, found nothing");
}

TEST(Options, lettersInNumbersAreRefused)
{
    EXPECT_EQ(failureOf({"-size", "5x", "512"}),
              "option -size: expected a width in pixels from 1 to 16384, found '5x'");
    for (const char* word : {"", "abc", "1e", "nan", "inf", "1,5", " 1", "1 ", "0x10", "1e999"}) {
        EXPECT_NE(failureOf({"-view", "0", word}), "") << word;
        EXPECT_NE(failureOf({"-sampling", word}), "") << word;
        EXPECT_NE(failureOf({"-frames", word}), "") << word;
    }
}

TEST(Options, valuesOutOfRangeAreRefused)
{
    const std::vector<std::vector<const char*>> lines{
        {"-size", "0", "5"},          {"-size", "5", "-1"},
        {"-size", "2147483648", "5"}, {"-size", "16385", "5"},
        {"-scale", "1", "0", "1"},    {"-scale", "-1", "1", "1"},
        {"-bricks", "0", "1", "1"},   {"-bricks", "1", "1", "99999"},
        {"-overlap", "-1"},           {"-sampling", "0"},
        {"-sampling", "-1"},          {"-perspective", "0"},
        {"-perspective", "180"},      {"-frames", "0"},
        {"-frames", "2.5"},           {"-dataRange", "5", "5"},
        {"-dataRange", "9", "1"},     {"-lut", "5", "0"},
        {"-lut", "5", "-1"},          {"-space", "world"},
        {"-tessellationSize", "0"}};
    for (const auto& words : lines) {
        const std::string text = failureOf(words);
        EXPECT_NE(text.find(words[0]), std::string::npos) << words[0] << ' ' << words[1] << ": " << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
    }
}

TEST(Options, boundsAndWhatWasTypedAreTold)
{
    EXPECT_EQ(failureOf({"-scale", "1e-30", "1", "1"}),
              "option -scale: expected a number from 1e-06 to 1e+09, found '1e-30'");
    EXPECT_EQ(failureOf({"-sampling", "1e999"}),
              "option -sampling: expected a number from 1e-06 to 1e+09, found '1e999'");
    EXPECT_EQ(failureOf({"-dataRange", "5", "5.0"}),
              "option -dataRange: expected LOW below HIGH, found '5 5.0'");
    EXPECT_EQ(failureOf({"-size", "16384", "8192"}),
              "option -size: expected at most 67108864 pixels in all, found '16384 8192'");
}

TEST(Options, picturesAreNamedPng)
{
    for (const char* word : {"", ".png", "a.jpg", "png", "a.png.gz"})
        EXPECT_EQ(failureOf({"-output", word}),
                  std::string("option -output: expected a file name that ends in .png, found '") + word +
                      "'");
    EXPECT_TRUE(parse({"-output", "A.PNG"}));
}

TEST(Options, simpleSetTakesFewOptions)
{
    EXPECT_TRUE(parse({"-output", "o.png", "-size", "3", "3", "-view", "0", "0"}, OptionSet::Simple));
    EXPECT_EQ(parse({"-s", "3", "3"}, OptionSet::Simple)->width, 3) << "no -sampling there";
    EXPECT_NE(failureOf({"-color"}, OptionSet::Simple), "");
}

TEST(Options, helpNamesEveryOption)
{
    const std::string text = vo::optionsHelp(OptionSet::All);
    for (const char* name :
         {"-2D", "-lutFile FILE", "-tessellationSize N", "-output FILE.png", "-frames N", "-core"})
        EXPECT_NE(text.find(name), std::string::npos) << name;
    EXPECT_EQ(vo::optionsHelp(OptionSet::Simple).find("-lutFile"), std::string::npos);
}

} // namespace
