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
class CallMonitorTest {
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
        CallAudioListener call = new CallMonitor(output).listener("anna");
        call.callBegan();
        call.sent(frame(1));
        call.received(frame(20));
        call.sent(frame(2));
        call.sent(frame(3));
        assertEquals(List.of(1, 22, 3), played);
    }

    @Test
    void theSumOfTwoLoudVoicesIsClippedAndDoesNotWrap() {
        CallMixer mix = new CallMixer();
        mix.received(frame(30_000));
        assertEquals(Short.MAX_VALUE, mix.sent(frame(30_000))[0]);
        mix.received(frame(-30_000));
        assertEquals(Short.MIN_VALUE, mix.sent(frame(-30_000))[0]);
    }

    @Test
    void ofABurstTheNewestIsHeard() {
        CallMixer mix = new CallMixer();
        for (int i = 1; i <= 10; i++) {
            mix.received(frame(i));
        }
        assertEquals(8, mix.sent(frame(0))[0]);
        mix.clear();
        assertEquals(0, mix.sent(frame(0))[0]);
    }

    @Test
    void withoutAChoiceTheCallThatBeganFirstIsHeard() {
        CallMonitor speaker = new CallMonitor(output);
        CallAudioListener anna = speaker.listener("anna");
        CallAudioListener bert = speaker.listener("bert");
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
        CallMonitor speaker = new CallMonitor(output);
        CallAudioListener anna = speaker.listener("anna");
        CallAudioListener bert = speaker.listener("bert");
        speaker.select("bert");
        anna.callBegan();
        bert.callBegan();
        anna.sent(frame(1));
        bert.sent(frame(2));
        speaker.select("anna");
        anna.sent(frame(3));
        bert.sent(frame(4));
        assertEquals(List.of(2, 3), played);
    }

    @Test
    void whoIsSilentAnywayIsNotListenedTo() {
        CallMonitor speaker = new CallMonitor(AudioOutput.SILENT);
        assertSame(CallAudioListener.NONE, speaker.listener("anna"));
        assertFalse(speaker.isAudible());
    }

    @Test
    void theOutputIsClosedWithTheLoudspeaker() {
        CallMonitor speaker = new CallMonitor(output);
        assertTrue(speaker.isAudible());
        speaker.close();
        assertTrue(closed);
    }

    @Test
    void aLazyOutputIsOpenedByTheFirstSound() {
        List<String> opened = new ArrayList<>();
        OnDemandAudioOutput late = new OnDemandAudioOutput(() -> {
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
        OnDemandAudioOutput late = new OnDemandAudioOutput(() -> {
            throw new AssertionError("opened");
        });
        late.close();
        late.play(frame(1));
        assertFalse(late.isAudible());
    }
}
