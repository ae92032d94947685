package simgsm.file;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PrivateFilesTest {
    @TempDir
    Path folder;

    @BeforeAll
    static void filesHaveOwners() {
        Assumptions.assumeTrue(
                FileSystems.getDefault().supportedFileAttributeViews().contains("posix"));
    }

    private static String mode(Path file) throws IOException {
        return PosixFilePermissions.toString(Files.getPosixFilePermissions(file));
    }

    @Test
    void aNewFileAndAllNewFoldersAreTheOwners() throws IOException {
        Path made = PrivateFiles.makeFolder(folder.resolve("a").resolve("b"));
        PrivateFiles.open(made.resolve("f"), StandardOpenOption.CREATE, StandardOpenOption.APPEND)
                .close();

        assertEquals("rwx------", mode(folder.resolve("a")));
        assertEquals("rwx------", mode(made));
        assertEquals("rw-------", mode(made.resolve("f")));
    }

    @Test
    void aFileThatEveryUserMayReadBecomesTheOwnersAndAFolderStays() throws IOException {
        Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
        Path file = Files.writeString(folder.resolve("f"), "old");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r--r--"));

        PrivateFiles.makeFolder(folder);
        PrivateFiles.open(file, StandardOpenOption.WRITE).close();

        assertEquals("rwxr-xr-x", mode(folder));
        assertEquals("rw-------", mode(file));
        assertEquals("old", Files.readString(file));
    }

    @Test
    void aReplacedFileIsTheOwnersIfThatIsAsked() throws IOException {
        Path file = Files.writeString(folder.resolve("f"), "old");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r--r--"));

        FileReplacement.writePrivately(file, new byte[] {'n'});

        assertEquals("rw-------", mode(file));
        assertEquals("n", Files.readString(file));
    }
}
