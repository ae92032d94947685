package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import simgsm.phone.screen.KeyMode;
import simgsm.speech.AudioOutput;

/** The view shows whether there is a sound device. */
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
}
