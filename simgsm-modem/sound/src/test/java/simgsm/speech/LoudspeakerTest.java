package simgsm.speech;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What is heard of calls, and of which. */
class LoudspeakerTest {
    private final List<Integer> played = new ArrayList<>();
    private boolean closed;
    private final AudioOutput output = new AudioOutput() {
        @Override
        public void play(short[] samples) {
            played.add((int) samples[0]);
        }

        @Override
        public boolean isAudible() {
            return true;
        }

        @Override
        public void close() {
            closed = true;
        }
    };

    private static short[] frame(int value) {
        short[] frame = new short[160];
        Arrays.fill(frame, (short) value);
        return frame;
    }

    @Test
    void bothDirectionsAreHeardAtOnce() {
        CallTap call = new Loudspeaker(output).tap("anna");
        call.callBegan();
        call.sent(frame(1));
        call.received(frame(20));
        call.sent(frame(2));
        call.sent(frame(3));
        assertEquals(List.of(1, 22, 3), played);
    }

    @Test
    void theSumOfTwoLoudVoicesIsClippedAndDoesNotWrap() {
        CallMix mix = new CallMix();
        mix.received(frame(30_000));
        assertEquals(Short.MAX_VALUE, mix.sent(frame(30_000))[0]);
        mix.received(frame(-30_000));
        assertEquals(Short.MIN_VALUE, mix.sent(frame(-30_000))[0]);
    }

    @Test
    void ofABurstTheNewestIsHeard() {
        CallMix mix = new CallMix();
        for (int i = 1; i <= 10; i++) {
            mix.received(frame(i));
        }
        assertEquals(8, mix.sent(frame(0))[0]);
        mix.clear();
        assertEquals(0, mix.sent(frame(0))[0]);
    }

    @Test
    void withoutAChoiceTheCallThatBeganFirstIsHeard() {
        Loudspeaker speaker = new Loudspeaker(output);
        CallTap anna = speaker.tap("anna");
        CallTap bert = speaker.tap("bert");
        anna.callBegan();
        bert.callBegan();
        anna.sent(frame(1));
        bert.sent(frame(2));
        anna.callEnded();
        bert.sent(frame(3));
        assertEquals(List.of(1, 3), played);
    }

    @Test
    void theChosenStationIsHeardAndNoOther() {
        Loudspeaker speaker = new Loudspeaker(output);
        CallTap anna = speaker.tap("anna");
        CallTap bert = speaker.tap("bert");
        speaker.choose("bert");
        anna.callBegan();
        bert.callBegan();
        anna.sent(frame(1));
        bert.sent(frame(2));
        speaker.choose("anna");
        anna.sent(frame(3));
        bert.sent(frame(4));
        assertEquals(List.of(2, 3), played);
    }

    @Test
    void whoIsSilentAnywayIsNotListenedTo() {
        Loudspeaker speaker = new Loudspeaker(AudioOutput.SILENT);
        assertSame(CallTap.NONE, speaker.tap("anna"));
        assertFalse(speaker.isAudible());
    }

    @Test
    void theOutputIsClosedWithTheLoudspeaker() {
        Loudspeaker speaker = new Loudspeaker(output);
        assertTrue(speaker.isAudible());
        speaker.close();
        assertTrue(closed);
    }

    @Test
    void aLazyOutputIsOpenedByTheFirstSound() {
        List<String> opened = new ArrayList<>();
        LazyOutput late = new LazyOutput(() -> {
            opened.add("opened");
            return output;
        });
        assertFalse(late.isAudible());
        assertTrue(opened.isEmpty());
        late.play(frame(7));
        late.play(frame(8));
        assertEquals(List.of("opened"), opened);
        assertEquals(List.of(7, 8), played);
        assertTrue(late.isAudible());
        late.close();
        assertTrue(closed);
    }

    @Test
    void aLazyOutputThatIsClosedFirstOpensNothing() {
        LazyOutput late = new LazyOutput(() -> {
            throw new AssertionError("opened");
        });
        late.close();
        late.play(frame(1));
        assertFalse(late.isAudible());
    }
}
