#include "grsh/commands.h"
#include "grsh/dict.h"
#include "grsh/interrupt.h"
#include "grsh/option_words.h"
#include "image/compare.h"
#include "image/flip.h"
#include "image/image_file.h"
#include "image/median.h"
#include "render/accumulate/assemble.h"

#include <array>
#include <filesystem>
#include <set>

namespace grsh {
namespace {

using image::Colours;
using image::CompareSettings;

void checkInterrupt() {
    if (interrupted()) throw core::Error("RENDER", "INTERRUPTED", "", "interrupted");
}

Tcl_Obj* median(Call& call) {
    const std::string in = call.words.fileName(0, "in"), out = call.words.fileName(1, "out");
    const FileAccess& files = *call.session.files;
    constexpr core::Range range{.least = 1, .most = image::largestMedian};
    const int n = call.words.integer(2, "n", range);
    if (n % 2 == 0) throwBadValue("n", "odd, from 1 to 15", call.words.object(2));
    const InterruptScope scope(call.interp);
    const image::ImageFile file(files.toWrite(out));
    const image::FileName from = files.toRead(in);
    file.checkAgainst(from);
    image::Image image = image::readImage(from);
    image::applyMedian(image, n);
    image.metadata.emplace_back("grsh:median", std::to_string(n));
    checkInterrupt();
    file.write(image);
    return nullptr;
}

// The difference, channel by channel, or grey where there is but one number for each pixel.
image::Film differenceFilm(const Colours& a, const Colours& b, std::span<const float> flip) {
    image::Film film(a.width, a.height, 0, a.height);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x);
            film.at(x, y) = flip.empty() ? glm::abs(a.pixels[i] - b.pixels[i]) : core::Rgbf(flip[i]);
        }
    }
    return film;
}

void checkTolerance(const CompareSettings& settings, double value, const image::Comparison& figures, Call& call) {
    if (!settings.tolerance) return;
    const bool isPsnr = settings.metric == "psnr";
    if (isPsnr ? value >= *settings.tolerance : value <= *settings.tolerance) return;
    const std::string number = core::numberText(value);
    throw core::Error("COMPARE", "TOLERANCE", number,
                      quoted(call.words.text(0)) + " and " + quoted(call.words.text(1)) +
                          " differ: " + std::string(settings.metric) + " is " + number + ", " +
                          (isPsnr ? "less" : "more") + " than the tolerance " + core::numberText(*settings.tolerance) +
                          "; they differ most at pixel " + std::to_string(figures.x) + " " + std::to_string(figures.y));
}

double mean(std::span<const float> numbers) {
    double sum = 0;
    for (const float x : numbers) sum += static_cast<double>(x);
    return sum / static_cast<double>(numbers.size());
}

// The pictures a and b, of the same size.
std::pair<Colours, Colours> readBoth(const image::FileName& fileA, const image::FileName& fileB) {
    const std::string &a = fileA.name, &b = fileB.name;
    std::pair<Colours, Colours> both{image::coloursOf(image::readImage(fileA), a),
                                     image::coloursOf(image::readImage(fileB), b)};
    const auto size = [](const Colours& colours) {
        return std::to_string(colours.width) + " x " + std::to_string(colours.height);
    };
    if (size(both.first) != size(both.second))
        throw core::Error("COMPARE", "SIZE", a,
                          "cannot compare \"" + a + "\" with \"" + b + "\": they have " + size(both.first) + " and " +
                              size(both.second) + " pixels");
    if (both.first.isFilmic != both.second.isFilmic)
        throw core::Error("COMPARE", "CURVE", both.first.isFilmic ? a : b,
                          "cannot compare \"" + a + "\" with \"" + b + "\": only \"" + (both.first.isFilmic ? a : b) +
                              "\" has gone through the filmic curve");
    return both;
}

Tcl_Obj* compareCommand(Call& call) {
    const FileAccess& files = *call.session.files;
    const std::string names[] = {call.words.fileName(0, "a"), call.words.fileName(1, "b")};
    CompareSettings settings;
    readOptions(call.words, 2, "no such option", settings);
    const InterruptScope scope(call.interp);
    const image::FileName inputs[] = {files.toRead(names[0]), files.toRead(names[1])};
    std::optional<image::ImageFile> file;
    if (!settings.difference.empty()) {
        file.emplace(files.toWrite(settings.difference));
        for (const image::FileName& input : inputs) file->checkIsNot(input);
    }
    const auto [a, b] = readBoth(inputs[0], inputs[1]);

    const image::Comparison figures = image::compare(a, b);
    std::vector<float> flip;
    if (settings.metric == "flip") flip = image::flip(shown(b), shown(a), a.width, a.height);
    const double value = settings.metric == "mse"      ? figures.mse
                         : settings.metric == "relmse" ? figures.relmse
                         : settings.metric == "psnr"   ? figures.psnr
                                                       : mean(flip);
    checkInterrupt();
    if (file) file->write(differenceFilm(a, b, flip), 0, {{"Software", "grsh " GRSH_VERSION}});
    checkTolerance(settings, value, figures, call);
    return dictOf({{"metric", textObject(settings.metric)},
                   {"value", Tcl_NewDoubleObj(value)},
                   {"mse", Tcl_NewDoubleObj(figures.mse)},
                   {"relmse", Tcl_NewDoubleObj(figures.relmse)},
                   {"psnr", Tcl_NewDoubleObj(figures.psnr)},
                   {"largest", Tcl_NewDoubleObj(figures.largest)},
                   {"x", Tcl_NewIntObj(figures.x)},
                   {"y", Tcl_NewIntObj(figures.y)},
                   {"width", Tcl_NewIntObj(a.width)},
                   {"height", Tcl_NewIntObj(a.height)}});
}

Tcl_Obj* assembleCommand(Call& call) {
    const InterruptScope scope(call.interp);
    const FileAccess& files = *call.session.files;
    const image::ImageFile file(files.toWrite(call.words.fileName(0, "out")));
    std::vector<image::FileName> inputs;
    std::set<std::filesystem::path> paths;
    for (std::size_t i = 1; i < call.words.size(); ++i) {
        const image::FileName& input = inputs.emplace_back(files.toRead(call.words.fileName(i, "strip")));
        file.checkAgainst(input);
        std::error_code failed;
        const std::filesystem::path path = std::filesystem::weakly_canonical(input.path, failed);
        if (!failed && !paths.insert(path).second)
            throw core::Error("STRIP", "TWICE", input.name, "\"" + input.name + "\" is given twice");
    }
    std::vector<render::Strip> strips;
    for (const image::FileName& input : inputs) {
        strips.push_back({input.name, image::readImage(input)});
        checkInterrupt();
    }
    file.write(render::assemble(std::move(strips)));
    return nullptr;
}

constexpr std::array<Command, 3> rows{{
    {"gr_median", "", "in out n", 3, 3, median,
     "filters noise out of a picture file: each channel's median in the n x n window round each pixel",
     "n is odd, from 1 to 15; the edges of the picture cut the window off\n"
     "out is another file than in, with the same ending"},
    {"gr_compare", "", "a b ?option value ...?", 2, anyNumberOfWords, compareCommand,
     "compares the picture file a with the reference b and returns figures; fails beyond a tolerance"},
    {"gr_assemble", "", "out strip ?strip ...?", 2, anyNumberOfWords, assembleCommand,
     "puts strips, rendered with startline, startcolumn and the like, together: the bytes of the render in one piece",
     "strips are .png or .exr files in any order, and out has the same ending"},
}};

}  // namespace

std::span<const Command> imageCommands() {
    return rows;
}

std::vector<OptionHelp> compareOptionsHelp() {
    return optionsHelp(CompareSettings::options());
}

}  // namespace grsh
