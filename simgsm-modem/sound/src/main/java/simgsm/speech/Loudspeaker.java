package simgsm.speech;

import java.util.ArrayList;
import java.util.List;

/**
 * Lets the calls of several stations be heard on one output, one call at a time: the chosen station's, or while none is
 * chosen the one that began first.
 */
public final class Loudspeaker {
    private final AudioOutput output;
    /** Calls under way, oldest first; of the stations' thread. */
    private final List<Listener> calls = new ArrayList<>();

    private volatile String chosen = "";

    public Loudspeaker(AudioOutput output) {
        this.output = output;
    }

    /** Listens in on the calls of one station; the stations that share a loudspeaker share their thread, too. */
    public CallTap tap(String station) {
        return output == AudioOutput.SILENT ? CallTap.NONE : new Listener(station);
    }

    /** From now on this station is the one to be heard, whether it is in a call or not; any thread may choose. */
    public void choose(String station) {
        chosen = station == null ? "" : station;
    }

    /** Whether there is a device. */
    public boolean isAudible() {
        return output.isAudible();
    }

    public void close() {
        output.close();
    }

    private final class Listener implements CallTap {
        private final String station;
        private final CallMix mix = new CallMix();

        Listener(String station) {
            this.station = station;
        }

        @Override
        public void callBegan() {
            calls.add(this);
        }

        @Override
        public void sent(short[] frame) {
            short[] mixed = mix.sent(frame);
            if (chosen.isEmpty() ? calls.get(0) == this : chosen.equals(station)) {
                output.play(mixed);
            }
        }

        @Override
        public void received(short[] frame) {
            mix.received(frame);
        }

        @Override
        public void callEnded() {
            calls.remove(this);
            mix.clear();
        }
    }
}
