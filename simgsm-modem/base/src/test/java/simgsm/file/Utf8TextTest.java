package simgsm.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class Utf8TextTest {
    @Test
    void aByteOrderMarkIsNoPartOfTheText() throws Exception {
        assertEquals("ñandú\n", Utf8Text.of("\uFEFFñandú\n".getBytes(StandardCharsets.UTF_8)));
        assertEquals("", Utf8Text.of("\uFEFF".getBytes(StandardCharsets.UTF_8)));
        assertEquals("a\uFEFF", Utf8Text.of("a\uFEFF".getBytes(StandardCharsets.UTF_8)), "only at the beginning");
    }

    @Test
    void anOctetThatIsNotUtf8IsNamedWithItsPlace() {
        assertEquals("octet 3: expected UTF-8, found F1", message("ma\u00F1ana\n"));
        assertEquals("line 2, octet 3: expected UTF-8, found F1", message("one\nma\u00F1ana\n"));
        assertEquals("octet 2: expected UTF-8, found C3", message("a\u00C3"), "an unfinished character");
    }

    private static String message(String latin1) {
        byte[] octets = latin1.getBytes(StandardCharsets.ISO_8859_1);
        return assertThrows(CharacterCodingException.class, () -> Utf8Text.of(octets))
                .getMessage();
    }

    @Test
    void anErrorNamesTheFile(@TempDir Path folder) throws Exception {
        Path file = Files.write(folder.resolve("l.txt"), new byte[] {'a', (byte) 0xf1});
        assertEquals(file + ": octet 2: expected UTF-8, found F1", described(file));
        assertEquals(folder + ": expected a file, found a folder", described(folder));
        Path missing = folder.resolve("nowhere.txt");
        assertEquals(missing + ": no such file", described(missing));
        Path beyond = folder.resolve("nowhere").resolve("x.txt");
        assertEquals(beyond + ": no such folder " + beyond.getParent(), described(beyond));
    }

    private static String described(Path file) {
        return FileErrors.describe(assertThrows(IOException.class, () -> Utf8Text.read(file)));
    }

    @Test
    void anErrorWithoutAFileGetsItsName() {
        Path file = Path.of("out.wav");
        IOException full = new IOException("No space left on device");
        IOException named = assertThrows(
                IOException.class,
                () -> FileErrors.naming(file, () -> {
                    throw full;
                }));
        assertEquals("out.wav: No space left on device", FileErrors.describe(named));
    }
}
