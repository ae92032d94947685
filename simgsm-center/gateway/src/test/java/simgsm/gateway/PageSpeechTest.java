package simgsm.gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class PageSpeechTest {
    private final PageSpeech speech = new PageSpeech();

    private static short[] frame(int value) {
        short[] samples = new short[160];
        Arrays.fill(samples, (short) value);
        return samples;
    }

    private int read() {
        short[] samples = new short[160];
        speech.read(samples);
        return samples[0];
    }

    private void accept(int... values) {
        Arrays.stream(values).mapToObj(PageSpeechTest::frame).forEach(speech::accept);
    }

    @Test
    void framesLeaveInOrderBehindTheCushion() {
        accept(100);
        assertEquals(0, read());
        accept(200);
        assertEquals(100, read());
        accept(300);
        assertEquals(200, read());
        assertEquals(300, read());
    }

    @Test
    void aLateFrameIsReplacedByTheOneBeforeItForAtMost100Millis() {
        accept(100, 200);
        assertEquals(100, read());
        for (int i = 0; i <= PageSpeech.MOST_SUBSTITUTES; i++) {
            assertEquals(200, read());
        }
        assertEquals(0, read());
        accept(300);
        assertEquals(0, read(), "the cushion fills again");
    }

    @Test
    void ofALongPauseWhatIsBeyondTheCushionIsLeftOut() {
        accept(100, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 200);
        int[] left = new int[8];
        Arrays.setAll(left, i -> read());
        assertEquals("[100, 0, 0, 0, 0, 0, 0, 200]", Arrays.toString(left));
    }

    @Test
    void beyond300MillisTheOldestFrameIsDropped() {
        for (int i = 1; i <= PageSpeech.MOST_FRAMES + 2; i++) {
            accept(100 * i);
        }
        assertEquals(300, read());
    }

    @Test
    void aNewCallBeginsWithoutWhatWaited() {
        accept(100, 200);
        speech.clear();
        assertEquals(0, read());
    }
}
