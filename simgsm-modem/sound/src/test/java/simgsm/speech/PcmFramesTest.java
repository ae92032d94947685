package simgsm.speech;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class PcmFramesTest {
    private final List<short[]> frames = new ArrayList<>();
    private final PcmFrames line = new PcmFrames(frames::add);

    private static short[] frame(int first) {
        short[] frame = new short[160];
        for (int i = 0; i < frame.length; i++) {
            frame[i] = (short) (first - 300 * i);
        }
        return frame;
    }

    @Test
    void octetsInAnyPiecesAreFrames() {
        byte[] octets = PcmFrames.octets(frame(20_000));
        assertEquals(PcmFrames.OCTETS, octets.length);
        assertEquals(20_000, (octets[0] & 0xff) + 256 * octets[1], "little-endian");
        for (int at = 0; at < octets.length; at += 7) {
            line.accept(Arrays.copyOfRange(octets, at, Math.min(octets.length, at + 7)));
        }

        assertEquals(1, frames.size());
        assertArrayEquals(frame(20_000), frames.get(0));
    }

    @Test
    void aPartialFrameIsDroppedAtTheBeginningOfAConnection() {
        line.accept(new byte[PcmFrames.OCTETS - 1]);
        line.drop();
        line.accept(PcmFrames.octets(frame(5)));

        assertEquals(1, frames.size());
        assertArrayEquals(frame(5), frames.get(0));
    }
}
