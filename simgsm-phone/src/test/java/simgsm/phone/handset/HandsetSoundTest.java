package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.KeyMode;
import simgsm.speech.AudioInput;
import simgsm.speech.AudioOutput;
import simgsm.station.context.StationEvent;

/** The sound devices of the phone. */
class HandsetSoundTest {
    private static final class Plug implements AudioOutput {
        private boolean in;

        @Override
        public void play(short[] samples) {}

        @Override
        public boolean isAudible() {
            return in;
        }

        @Override
        public void close() {}
    }

    @Test
    void aSoundDeviceThatComesOrGoesIsShownAtTheNextLook() {
        Plug plug = new Plug();
        Handset handset = Bench.handset(KeyMode.IN_BAND, event -> {}, plug);
        handset.attach(new FakeStation());
        assertFalse(handset.snapshot().audible());
        plug.in = true;
        handset.checkSoundDevice();
        assertTrue(handset.snapshot().audible());
        plug.in = false;
        handset.checkSoundDevice();
        assertFalse(handset.snapshot().audible());
    }

    /** Each frame has the next value in all samples. */
    private static final class Counting implements AudioInput {
        @Override
        public void begin() {}

        private short count;

        @Override
        public void read(short[] frame) {
            Arrays.fill(frame, ++count);
        }

        @Override
        public void close() {}
    }

    @Test
    void theMicrophoneIsSentInACallOnlyAndRestsDuringAKeyAndItsPause() {
        Bench bench = new Bench();
        bench.handset.setMicrophone(new Counting());
        short[] frame = new short[160];
        bench.handset.fillFrame(frame);
        assertEquals(0, frame[0]);
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550200"))));
        bench.handset.fillFrame(frame);
        assertEquals(1, frame[159]);
        bench.handset.press(List.of(DtmfKey.of('5')));
        short[] tone = new short[160];
        int frames = 0;
        do {
            bench.handset.fillFrame(tone);
            frames++;
        } while (frames < 20 && tone[0] != 1 + frames);
        assertEquals(100 / 20 + 1, frames, "frames until the microphone is back");
        assertEquals(7, tone[159]);
    }
}
