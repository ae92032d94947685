package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class QuickStartTest {
    private static final String USE = "-XX:SharedArchiveFile=";
    private static final String MAKE = "-XX:ArchiveClassesAtExit=";

    @TempDir
    private Path folder;

    @BeforeEach
    void jars() throws IOException {
        Files.writeString(folder.resolve("simgsm-phone.jar"), "jar");
        Files.writeString(folder.resolve("simgsm-base.jar"), "jar");
    }

    @Test
    void theFirstRunMakesTheArchiveThatLaterOnesUse() throws IOException {
        Path archive = archive(MAKE);
        Files.writeString(archive, "archive");
        assertEquals(archive, archive(USE));
        assertTrue(Files.exists(archive));
    }

    @Test
    void aProgramWithoutAWindowUsesTheArchiveAndMakesNone() throws IOException {
        ProgramFolder programs = new ProgramFolder(folder, false);
        assertEquals(QuickStart.options(), QuickStart.options(programs, "simgsm-phone.jar", false));
        Files.writeString(archive(MAKE), "archive");
        assertEquals(
                QuickStart.options(programs, "simgsm-phone.jar", true),
                QuickStart.options(programs, "simgsm-phone.jar", false));
        assertTrue(QuickStart.options(programs, "simgsm-phone.jar", false).contains(USE + archive(USE)));
    }

    @Test
    void anArchiveIsNotUsedOnceAnyJarHasChanged() throws IOException {
        Path archive = archive(MAKE);
        Files.writeString(archive, "archive");
        Files.writeString(folder.resolve("simgsm-base.jar"), "another jar");
        assertNotEquals(archive, archive(MAKE));
        assertFalse(Files.exists(archive), "the stale archive stays");
    }

    @Test
    void anArchiveWhoseWritingWasEndedIsMadeAnew() throws IOException {
        Path archive = archive(MAKE);
        Files.write(archive, new byte[64]);
        assertEquals(archive, archive(MAKE));
    }

    @Test
    void theArchivesOfOtherProgramsStay() throws IOException {
        Path other = Files.writeString(folder.resolve("simrobot-01234567.jsa"), "archive");
        archive(MAKE);
        assertTrue(Files.exists(other));
    }

    @Test
    void aFolderThatCannotBeReadGivesNoArchive() {
        List<String> options =
                QuickStart.options(new ProgramFolder(folder.resolve("none"), false), "simgsm-phone.jar", true);
        assertEquals(QuickStart.options(), options);
    }

    @Test
    void aRunThatMakesAnArchiveDiffersFromOneThatUsesIt() throws IOException {
        ProgramFolder programs = new ProgramFolder(folder, false);
        assertTrue(QuickStart.writesAtEnd(QuickStart.options(programs, "simgsm-phone.jar", true)));
        Files.writeString(archive(MAKE), "archive");
        assertFalse(QuickStart.writesAtEnd(QuickStart.options(programs, "simgsm-phone.jar", true)));
    }

    @Test
    void anImageUsesTheCacheThatItHasAndMakesNone() throws IOException {
        ProgramFolder image = new ProgramFolder(folder, true);
        assertEquals(QuickStart.options(), QuickStart.options(image, "simgsm-phone.jar", true));
        Path cache = QuickStart.cacheOf(folder, "simgsm-phone");
        Files.createDirectories(cache.getParent());
        Files.writeString(cache, "cache");
        assertTrue(QuickStart.options(image, "simgsm-phone.jar", true).contains("-XX:AOTCache=" + cache));
        assertEquals(QuickStart.options(), QuickStart.options(image, "simrobot.jar", true));
    }

    private Path archive(String option) {
        return QuickStart.options(new ProgramFolder(folder, false), "simgsm-phone.jar", true).stream()
                .filter(word -> word.startsWith(option))
                .map(word -> Path.of(word.substring(option.length())))
                .findFirst()
                .orElseThrow();
    }
}
