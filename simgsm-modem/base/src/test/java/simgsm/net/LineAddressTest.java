package simgsm.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LineAddressTest {
    @Test
    void hostAndPortAreOneOverTcp() {
        assertEquals(new LineAddress.Tcp("robot.example", 8101), LineAddress.parse("robot.example:8101"));
        assertEquals(new LineAddress.Tcp("::1", 8101), LineAddress.parse("::1:8101"));
    }

    @Test
    void aFileThatIsThereIsASerialLine(@TempDir Path folder) throws Exception {
        Path device = Files.createFile(folder.resolve("ttyUSB0"));
        assertEquals(new LineAddress.Device(device), LineAddress.parse(device.toString()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "nonsense", "host:", ":8101", "host:0", "host:65536", "/dev/no-such-line", "/"})
    void anythingElseIsRefusedInWords(String text) {
        IllegalArgumentException refusal = assertThrows(IllegalArgumentException.class, () -> LineAddress.parse(text));
        assertTrue(refusal.getMessage().startsWith("expected HOST:PORT or a serial line's device file, found "));
    }
}
