package simgsm.audio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import javax.sound.sampled.LineUnavailableException;
import org.junit.jupiter.api.Test;

class SoundCardLineTest {
    @Test
    void withoutAnOutputTheInputIsNotOpenedAndTheOutputNamed() {
        IOException refused = assertThrows(
                IOException.class,
                () -> SoundCardLine.open(
                        format -> {
                            throw new AssertionError("the input is opened");
                        },
                        format -> {
                            throw new LineUnavailableException("none here");
                        }));
        assertEquals("no sound output of 16 bit, mono: none here", refused.getMessage());
    }

    @Test
    void aDeviceThatIsNotThereIsNamedWithThoseThatAre() {
        IOException refused = assertThrows(IOException.class, new SoundCardLine("no such device")::open);
        assertTrue(refused.getMessage().contains("expected a device of ["), refused.getMessage());
        assertTrue(refused.getMessage().endsWith("found no such device"), refused.getMessage());
    }
}
