package simgsm.audio;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import simgsm.speech.AudioOutput;

class SoundCardTest {
    @Test
    void theSilentTwinIsNeverAudible() {
        AudioOutput.SILENT.play(new short[160]);
        assertFalse(AudioOutput.SILENT.isAudible());
    }

    @Test
    void withOrWithoutADeviceNothingBlocksAndNothingThrows() {
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            AudioOutput output = SoundCard.open();
            for (int i = 0; i < 1000; i++) {
                output.play(new short[160]);
            }
            output.close();
            output.play(new short[160]);
            assertFalse(output.isAudible());
        });
    }
}
