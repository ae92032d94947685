package simgsm.audio;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;

class SoundCardLineTest {
    @Test
    void aDeviceThatIsNotThereIsNamedWithThoseThatAre() {
        IOException refused = assertThrows(IOException.class, new SoundCardLine("no such device")::open);
        assertTrue(refused.getMessage().contains("expected a device of ["), refused.getMessage());
        assertTrue(refused.getMessage().endsWith("found no such device"), refused.getMessage());
    }
}
