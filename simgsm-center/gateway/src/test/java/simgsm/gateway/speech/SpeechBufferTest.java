package simgsm.gateway.speech;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.dtmf.ToneShape;

class SpeechBufferTest {
    private final SpeechBuffer speech = new SpeechBuffer();

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
        Arrays.stream(values).mapToObj(SpeechBufferTest::frame).forEach(speech::accept);
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
        for (int i = 0; i <= SpeechBuffer.MOST_SUBSTITUTES; i++) {
            assertEquals(200, read());
        }
        assertEquals(0, read());
        accept(300);
        assertEquals(0, read(), "the cushion fills again");
    }

    @Test
    void ofALongPauseWhatIsBeyondTheCushionIsLeftOut() {
        accept(100, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 200);
        int[] left = new int[6];
        Arrays.setAll(left, i -> read());
        assertEquals("[100, 0, 0, 0, 0, 200]", Arrays.toString(left));
    }

    @Test
    void beyond5SecondsTheOldestFrameIsDroppedAndCounted() {
        for (int i = 1; i <= SpeechBuffer.MOST_FRAMES + 2; i++) {
            accept(100 * i);
        }
        assertEquals(300, read());
        assertEquals(2, speech.framesDropped());
        assertEquals(400, read());
        assertEquals(0, speech.framesDropped());
    }

    /** The page sends 100 ms of each key and 80 ms of silence, and stops for up to 600 ms at random; what waited comes at once then. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void keysOfAPageThatStallsAreReceivedOnceEach(long seed) {
        Random random = new Random(seed);
        String keys = random.ints(100, 0, 12)
                .mapToObj(i -> "0123456789*#".substring(i, i + 1))
                .collect(Collectors.joining());
        DtmfGenerator page = new DtmfGenerator(new ToneShape(100, 80, -10, -10, 2), sent -> {});
        DtmfKey.sequence(keys).forEach(page::enqueue);
        StringBuilder received = new StringBuilder();
        DtmfReceiver receiver =
                new DtmfReceiver(digit -> received.append(digit.key().symbol()));
        int stalled = 0;
        int owed = 0;
        for (int tick = 0; tick < 1_200; tick++) {
            owed++;
            stalled = stalled > 0 ? stalled - 1 : random.nextInt(40) == 0 ? random.nextInt(30) : 0;
            for (; stalled == 0 && owed > 0; owed--) {
                short[] frame = new short[160];
                page.read(frame);
                speech.accept(frame);
            }
            short[] frame = new short[160];
            speech.read(frame);
            receiver.accept(frame);
        }
        assertEquals(keys, received.toString());
    }

    @Test
    void aNewCallBeginsWithoutWhatWaited() {
        accept(100, 200);
        speech.clear();
        assertEquals(0, read());
    }
}
