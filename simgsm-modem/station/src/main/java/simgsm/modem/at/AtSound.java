package simgsm.modem.at;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.function.Consumer;
import simgsm.speech.CallMixer;
import simgsm.speech.PcmFrames;
import simgsm.station.call.AddedSpeech;

/**
 * The sound of a call for a client's program, on a port beside that of the commands, as Huawei's modems have it on a
 * second tty: {@code AT^DDSETEX=2} switches it on until the call ends. Then each frame heard is sent to the client, in
 * silence one each 20 ms, and the client's frames are added to the sent speech, late ones included.
 */
public final class AtSound implements AddedSpeech {
    /** 0.5 s; frames of either side that are late for longer are replaced by silence, which would cut a tone. */
    private static final int MOST_LATE_FRAMES = 25;
    /** 1 s; all that wait are sent at once. */
    private static final int MOST_WAITING = 50;

    private static final Consumer<byte[]> NOBODY = octets -> {};

    private final Queue<short[]> voice = new ArrayDeque<>();
    private final PcmFrames input = new PcmFrames(this::spoken);
    private Consumer<byte[]> client = NOBODY;
    private boolean isOffered;
    private boolean isOn;
    private int framesSinceHeard;
    private int framesSinceSpoken;

    /** A sound without a port. */
    public AtSound() {}

    /** There is a port. */
    public void offer() {
        isOffered = true;
    }

    public void connect(Consumer<byte[]> newClient) {
        client = newClient;
        input.drop();
    }

    public void disconnect() {
        client = NOBODY;
    }

    /** Octets of the client. */
    public void received(byte[] octets) {
        input.accept(octets);
    }

    private void spoken(short[] frame) {
        if (isOn) {
            voice.add(frame);
        }
        if (voice.size() > MOST_WAITING) {
            voice.remove();
        }
    }

    public boolean isOffered() {
        return isOffered;
    }

    /** Switches the sound on or off. */
    public void setOn(boolean on) {
        isOn = on;
        voice.clear();
        framesSinceSpoken = MOST_LATE_FRAMES;
    }

    /** 20 ms of the far end. */
    public void heard(short[] frame) {
        framesSinceHeard = 0;
        if (isOn) {
            client.accept(PcmFrames.octets(frame));
        }
    }

    @Override
    public int framesDue() {
        if (isOn && ++framesSinceHeard > MOST_LATE_FRAMES) {
            client.accept(new byte[PcmFrames.OCTETS]);
        }
        framesSinceSpoken = voice.isEmpty() ? framesSinceSpoken + 1 : 0;
        boolean isLate = voice.isEmpty() && framesSinceSpoken < MOST_LATE_FRAMES;
        return isLate ? 0 : Math.max(1, voice.size());
    }

    @Override
    public short[] addTo(short[] own) {
        short[] frame = voice.poll();
        return frame == null ? own : CallMixer.sum(own, frame);
    }
}
