package simgsm.tools.audio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;

/** Reads all samples of a sound file. */
public final class WholeSpeechFile {
    private WholeSpeechFile() {}

    public static short[] read(Path path) throws IOException {
        try (SpeechFile file = SpeechFile.open(path)) {
            short[] all = new short[1 << 14];
            int length = 0;
            for (int n; (n = file.read(all, length, all.length)) >= 0; length += n) {
                if (length + n == all.length) {
                    all = Arrays.copyOf(all, 2 * all.length);
                }
            }
            return Arrays.copyOf(all, length);
        }
    }
}
