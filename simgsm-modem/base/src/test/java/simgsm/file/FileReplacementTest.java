package simgsm.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileReplacementTest {
    private static final byte[] OLD = "old".getBytes(StandardCharsets.UTF_8);
    private static final byte[] NEW = "new".getBytes(StandardCharsets.UTF_8);

    @TempDir
    Path folder;

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted().toList();
        }
    }

    @Test
    void aFileIsMadeAndReplacedAndNothingElseIsLeft() throws IOException {
        Path file = folder.resolve("a.txt");
        FileReplacement.write(file, OLD);
        FileReplacement.write(file, NEW);
        assertArrayEquals(NEW, Files.readAllBytes(file));
        assertEquals(List.of(file), files());
    }

    @Test
    void aFileThatIsWrittenDurablyIsReplacedAndNothingElseIsLeft() throws IOException {
        Path file = folder.resolve("a.txt");
        FileReplacement.writeDurably(file, OLD);
        FileReplacement.writeDurably(file, NEW);
        assertArrayEquals(NEW, Files.readAllBytes(file));
        assertEquals(List.of(file), files());
    }

    /** As an editor does that has the file open: it must see the old content to its end. */
    @Test
    void aReaderOfTheOldContentReadsItToItsEnd() throws IOException {
        Path file = folder.resolve("a.txt");
        Files.write(file, OLD);
        try (var reader = Files.newInputStream(file)) {
            FileReplacement.write(file, NEW);
            assertArrayEquals(OLD, reader.readAllBytes());
        }
    }

    @Test
    void aSymbolicLinkStaysAndItsFileIsReplaced() throws IOException {
        Path file = Files.write(folder.resolve("a.txt"), OLD);
        Path link = folder.resolve("link.txt");
        try {
            Files.createSymbolicLink(link, file);
        } catch (UnsupportedOperationException | IOException e) {
            Assumptions.abort("no symbolic links here");
        }
        FileReplacement.write(link, NEW);
        assertTrue(Files.isSymbolicLink(link));
        assertArrayEquals(NEW, Files.readAllBytes(file));
    }

    @Test
    void aDeviceStaysWhatItIs() throws IOException {
        Path device = Path.of("/dev/full");
        Assumptions.assumeTrue(Files.exists(device), "no disk that is always full");
        assertThrows(IOException.class, () -> FileReplacement.write(device, NEW));
        assertFalse(Files.isRegularFile(device));
    }

    @Test
    void whatCannotBeWrittenIsNamedWithItsReasonAndLeavesNothing() throws IOException {
        Path nowhere = folder.resolve("none").resolve("a.txt");
        assertEquals(
                nowhere + ": the folder does not exist",
                assertThrows(IOException.class, () -> FileReplacement.write(nowhere, NEW))
                        .getMessage());
        assertEquals(
                folder + ": expected a file, found a folder",
                assertThrows(IOException.class, () -> FileReplacement.write(folder, NEW))
                        .getMessage());
        assertEquals(List.of(), files());
    }
}
