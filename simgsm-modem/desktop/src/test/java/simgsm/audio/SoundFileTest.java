package simgsm.audio;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sounds that the phone's console plays. */
class SoundFileTest {
    private static final AudioFormat FORMAT = new AudioFormat(8000, 16, 1, true, false);

    @TempDir
    Path folder;

    @Test
    void aFileWithoutASampleIsAnErrorBecauseItsEndWouldNeverCome() throws Exception {
        IOException refused = assertThrows(IOException.class, () -> SoundFile.read(written()));
        assertEquals("expected sound, found no sample", refused.getMessage());
        assertArrayEquals(new short[] {0x0201}, SoundFile.read(written((byte) 1, (byte) 2)));
    }

    private Path written(byte... octets) throws IOException {
        Path file = folder.resolve(octets.length + ".wav");
        try (AudioInputStream sound =
                new AudioInputStream(new ByteArrayInputStream(octets), FORMAT, octets.length / 2)) {
            AudioSystem.write(sound, AudioFileFormat.Type.WAVE, file.toFile());
        }
        return file;
    }
}
