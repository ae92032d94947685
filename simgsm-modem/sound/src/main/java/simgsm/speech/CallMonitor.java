package simgsm.speech;

import java.util.ArrayList;
import java.util.List;

/**
 * Plays the calls of several stations on one output, one call at a time: the selected station's, or, without a
 * selection, the one that began first.
 */
public final class CallMonitor {
    private final AudioOutput output;
    /** Active calls, oldest first; used on the stations' thread only. */
    private final List<Listener> calls = new ArrayList<>();

    private volatile String selected = "";

    /** A monitor on this output, which it closes. */
    public CallMonitor(AudioOutput output) {
        this.output = output;
    }

    /** The listener for one station; all stations of a monitor run on one thread. */
    public CallAudioListener listener(String station) {
        return output == AudioOutput.SILENT ? CallAudioListener.NONE : new Listener(station);
    }

    /** Selects a station, in a call or not; null for none. Any thread may call it. */
    public void select(String station) {
        selected = station == null ? "" : station;
    }

    /** True if a device is open. */
    public boolean isAudible() {
        return output.isAudible();
    }

    /** Closes the output. */
    public void close() {
        output.close();
    }

    private final class Listener implements CallAudioListener {
        private final String station;
        private final CallMixer mix = new CallMixer();

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
            if (selected.isEmpty() ? calls.get(0) == this : selected.equals(station)) {
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
