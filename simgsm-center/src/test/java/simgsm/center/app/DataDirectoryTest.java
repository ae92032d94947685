package simgsm.center.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DataDirectoryTest {
    @TempDir
    Path temporary;

    private static Properties system(String os) {
        Properties system = new Properties();
        system.setProperty("user.home", "/home/ada");
        system.setProperty("os.name", os);
        return system;
    }

    @Test
    void theDirectoryIsMadeAndCanBeTakenAgainOnceGivenBack() throws IOException {
        Path directory = temporary.resolve("a").resolve("b");
        DataDirectory.take(directory).close();
        DataDirectory.take(directory).close();
        assertTrue(Files.isDirectory(directory));
    }

    @Test
    void theErrorOfASecondHolderNamesTheDirectory() throws IOException {
        try (DataDirectory held = DataDirectory.take(temporary)) {
            IOException failure = assertThrows(IOException.class, () -> DataDirectory.take(temporary));
            assertTrue(failure.getMessage().contains(held.path().toString()), failure.getMessage());
        }
    }

    @Test
    void aPathThatIsAFileIsNamedWithTheReason() throws IOException {
        Path file = Files.createFile(temporary.resolve("file"));
        IOException failure = assertThrows(IOException.class, () -> DataDirectory.take(file));
        assertEquals("cannot make the data directory " + file + ": there is a file of that name", failure.getMessage());
    }

    @Test
    void aLockFileThatCannotBeOpenedIsNamedWithTheReason() throws IOException {
        Path file = Files.createDirectory(temporary.resolve("lock"));
        IOException failure = assertThrows(IOException.class, () -> DataDirectory.take(temporary));
        assertEquals(
                "cannot lock the data directory: " + file + ": expected a file, found a folder", failure.getMessage());
    }

    @Test
    void theUsualPlaceFollowsThePlatform() {
        assertEquals(
                Path.of("/data/simgsm"), DataDirectory.defaultPath(Map.of("XDG_DATA_HOME", "/data"), system("Linux")));
        assertEquals(
                Path.of("/home/ada/.local/share/simgsm"),
                DataDirectory.defaultPath(Map.of("XDG_DATA_HOME", "relative"), system("Linux")));
        assertEquals(
                Path.of("/home/ada/Library/Application Support/simgsm"),
                DataDirectory.defaultPath(Map.of(), system("Mac OS X")));
        assertEquals(
                Path.of("/home/ada/AppData/Local/simgsm"), DataDirectory.defaultPath(Map.of(), system("Windows 11")));
    }
}
