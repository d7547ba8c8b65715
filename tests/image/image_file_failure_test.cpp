// A picture file is complete, or it is not there; and what cannot work is refused before the render.
#include "image/image_file.h"

#include "core/error.h"
#include "image/png_reader.h"
#include "image/temporary_folder.h"

#include <gmock/gmock.h>

#include <random>

namespace image {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

// The message with which a path is refused, or nothing.
std::string refusal(const std::string& path) {
    try {
        const ImageFile file(path);
    } catch (const core::Error& error) {
        EXPECT_EQ(error.topic, "FILE");
        EXPECT_EQ(error.word, path);
        EXPECT_THAT(error.what(), HasSubstr("cannot write \"" + path + "\": "));
        return error.what();
    }
    return "";
}

// Noise, which does not compress: 3 bytes a pixel in the file.
Film noise(int width, int height) {
    Film film(width, height, 0, height);
    std::mt19937 random(1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < 3; ++channel) film.at(x, y)[channel] = float(random() % 1000) / 1000.f;
    return film;
}

TEST(ImageFileRefusal, OfAnotherEnding) {
    const TemporaryFolder folder;
    for (const char* name : {"a.jpg", "a", "a.png.gz", "png", ".png", "a.png ", "a.exr.gz", "exr", "a.pfm2", ""})
        EXPECT_THAT(refusal(folder / name), HasSubstr("must be .png, .exr or .pfm")) << name;
    EXPECT_THAT(refusal(""), HasSubstr("must be .png, .exr or .pfm"));
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(ImageFileRefusal, OfAFolderThatIsNotThere) {
    const TemporaryFolder folder;
    EXPECT_THAT(refusal(folder / "missing/a.png"), HasSubstr("No such file or directory"));
    writeText(folder / "file", "");
    EXPECT_THAT(refusal(folder / "file/a.png"), HasSubstr("Not a directory"));
    EXPECT_THAT(folder.names(), ElementsAre("file"));
}

TEST(ImageFileRefusal, OfAFolderThatTakesNoFiles) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "closed");
    fs::permissions(folder / "closed", fs::perms(0555));
    const Unprivileged nobody;
    EXPECT_THAT(refusal(folder / "closed/a.png"), HasSubstr("Permission denied"));
}

TEST(ImageFileRefusal, OfWhatIsNoFile) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "folder.png");
    ASSERT_EQ(mkfifo((folder / "pipe.png").c_str(), 0600), 0);
    EXPECT_THAT(refusal(folder / "folder.png"), HasSubstr("it is not a file"));
    EXPECT_THAT(refusal(folder / "pipe.png"), HasSubstr("it is not a file"));
    fs::create_symlink("folder.png", folder / "link.png");
    EXPECT_THAT(refusal(folder / "link.png"), HasSubstr("it is not a file"));
}

TEST(ImageFileRefusal, OfANameThatIsTooLong) {
    const TemporaryFolder folder;
    EXPECT_THAT(refusal(folder / (std::string(300, 'x') + ".png")), HasSubstr("File name too long"));
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(ImageFileRefusal, OfALinkThatLeadsInACircle) {
    const TemporaryFolder folder;
    fs::create_symlink("b.png", folder / "a.png");
    fs::create_symlink("a.png", folder / "b.png");
    EXPECT_NE(refusal(folder / "a.png"), "");
    EXPECT_TRUE(fs::is_symlink(folder / "a.png"));
}

TEST(ImageFile, LeavesNothingWhereNothingIsWritten) {
    const TemporaryFolder folder;
    { const ImageFile file(folder / "a.png"); }
    EXPECT_THAT(folder.names(), IsEmpty());
    writeText(folder / "b.png", "as it was");
    { const ImageFile file(folder / "b.png"); }
    EXPECT_EQ(bytesOf(folder / "b.png"), "as it was");
}

// Small enough to be written when the file is closed, and large enough to fill it before.
TEST(ImageFile, IsAbsentWhenTheDiskIsFull) {
    for (const int size : {20, 400}) {
        const TemporaryFolder folder;
        writeText(folder / "old.png", "as it was");
        for (const char* name : {"new.png", "old.png"}) {
            const ImageFile file(folder / name);
            const Film film = noise(size, size);
            std::string message;
            {
                const FullDisk disk(1000);
                try {
                    file.write(film, 0, {});
                } catch (const core::Error& error) {
                    message = error.what();
                    EXPECT_EQ(error.topic, "FILE");
                    EXPECT_EQ(error.word, folder / name);
                }
            }
            EXPECT_THAT(message, HasSubstr("cannot write \"" + (folder / name) + "\": ")) << size;
            EXPECT_THAT(message, HasSubstr("File too large")) << size << ": why is what one wants to know";
        }
        EXPECT_THAT(folder.names(), ElementsAre("old.png")) << size;
        EXPECT_EQ(bytesOf(folder / "old.png"), "as it was") << size;
    }
}

// The folder may go, or change, while a picture is rendered for hours.
TEST(ImageFile, IsAbsentWhenItsFolderHasGone) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    const ImageFile file(folder / "sub/a.png");
    fs::remove(folder / "sub");
    EXPECT_THROW(file.write(Film(1, 1, 0, 1), 0, {}), core::Error);
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(ImageFile, LeavesNothingWhenAFolderHasTakenItsPlace) {
    const TemporaryFolder folder;
    const ImageFile file(folder / "a.png");
    fs::create_directory(folder / "a.png");
    EXPECT_THROW(file.write(Film(1, 1, 0, 1), 0, {}), core::Error);
    EXPECT_THAT(folder.names(), ElementsAre("a.png"));
}

TEST(ImageFile, ReplacesWhatWasThere) {
    const TemporaryFolder folder;
    writeText(folder / "a.png", std::string(100'000, 'x'));
    ImageFile(folder / "a.png").write(Film(2, 3, 0, 3), 0, {});
    EXPECT_EQ(Png(folder / "a.png").height, 3);
    EXPECT_THAT(folder.names(), ElementsAre("a.png"));
}

TEST(ImageFile, IsWrittenWhereALinkLeads) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    writeText(folder / "sub/real.png", "as it was");
    fs::create_symlink("sub/real.png", folder / "link.png");
    fs::create_symlink("link.png", folder / "second.png");
    ImageFile(folder / "second.png").write(Film(2, 3, 0, 3), 0, {});
    EXPECT_TRUE(fs::is_symlink(folder / "second.png"));
    EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
    EXPECT_FALSE(fs::is_symlink(folder / "sub/real.png"));
    EXPECT_EQ(Png(folder / "sub/real.png").height, 3);
    EXPECT_THAT(folder.names(), UnorderedElementsAre("sub", "link.png", "second.png"));
}

TEST(ImageFile, IsMadeWhereALinkLeadsToNothingYet) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    fs::create_symlink("sub/new.png", folder / "link.png");
    ImageFile(folder / "link.png").write(Film(2, 3, 0, 3), 0, {});
    EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
    EXPECT_EQ(Png(folder / "sub/new.png").height, 3);
}

TEST(ImageFile, HasThePermissionsOfAnyNewFile) {
    for (const mode_t mask : {0022, 0077, 0002}) {
        const TemporaryFolder folder;
        const Umask set(mask);
        ImageFile(folder / "a.png").write(Film(1, 1, 0, 1), 0, {});
        writeText(folder / "usual", "");
        EXPECT_EQ(fs::status(folder / "a.png").permissions(), fs::perms(0666 & ~mask));
        EXPECT_EQ(fs::status(folder / "a.png").permissions(), fs::status(folder / "usual").permissions());
    }
}

}  // namespace
}  // namespace image
