package simgsm.modem.client;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.DtmfReceiver;
import simgsm.modem.CallWords;
import simgsm.modem.ModemEvent;
import simgsm.modem.line.ModemLine;
import simgsm.speech.CallAudioListener;
import simgsm.speech.PcmFrames;
import simgsm.speech.SpeechCodec;
import simgsm.station.context.StationEvent;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * The sound of an attached modem's calls on its second line: 8 kHz, 16 bit, little-endian, both ways. The modem is
 * the clock: for each frame of 20 ms received one is sent. A pause of 0.5 s, or the line's end, is a lost sound.
 */
final class AttachedSound implements ModemLine.Party {
    /** Time from the call's beginning to its first frame. */
    static final long FIRST_FRAME_NANOS = TimeUnit.SECONDS.toNanos(2);

    static final long PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(500);
    static final int TONE_MILLIS = 150;
    private static final int PAUSE_MILLIS = 70;

    /** Receives the sound of a call. */
    interface Listener {
        /** {@link StationEvent.SpeechReceived}, its keys, {@link ModemEvent.SpeechProcessed}, and the events of words. */
        void heard(StationEvent event);

        void toneSent(DtmfKey key);

        /** The sound of the call was lost, or is back; keys may be lost. @param why empty if it is back */
        void soundChanged(String why);
    }

    private final Timers timers;
    private final CallAudioListener recorder;
    private final Consumer<byte[]> output;
    private final Consumer<String> onLine;
    private final PcmFrames input = new PcmFrames(this::accept);
    /** Tones with their last sample in the newest frame; sent once the next is due. */
    private final Queue<DtmfKey> finished = new ArrayDeque<>();

    private final DtmfGenerator generator = new DtmfGenerator(finished::add);
    private final DtmfReceiver receiver = new DtmfReceiver(new DtmfListener() {
        @Override
        public void keyDecided(DtmfDigit digit) {
            if (words.key(digit.key())) {
                return;
            }
            listener.heard(new ModemEvent.KeyDecided(digit));
        }

        @Override
        public void keyEnded(DtmfDigit digit) {
            listener.heard(new ModemEvent.KeyEnded());
        }
    });
    private final CallWords words;
    private Listener listener;
    private Timer guard;
    private boolean isOpen;
    private boolean isInCall;
    private volatile boolean isLive;
    /** Why there is no line; null before the first try. */
    private String obstacle;

    /**
     * A sound whose line is closed.
     *
     * @param onLine receives the obstacle when it changes: empty for an open line
     */
    AttachedSound(Timers timers, SoundPort port, Consumer<String> onLine) {
        this.timers = timers;
        recorder = port.recorder();
        output = port.output();
        words = new CallWords(port.prompts(), port.voices(), event -> listener.heard(event));
        this.onLine = onLine;
    }

    void setListener(Listener newListener) {
        listener = newListener;
    }

    // ---- the line --------------------------------------------------------------------------------------------------

    @Override
    public void lineUp(long nowNanos) {
        timers.advance(nowNanos);
        isOpen = true;
        input.drop();
        tell("");
    }

    @Override
    public void lineDown(long nowNanos) {
        timers.advance(nowNanos);
        if (isOpen) {
            lineFailed("the line of the sound is lost");
            isOpen = false;
            lost();
        }
    }

    @Override
    public void lineFailed(String reason) {
        tell(reason);
    }

    private void tell(String now) {
        if (!now.equals(obstacle)) {
            obstacle = now;
            onLine.accept(now);
        }
    }

    @Override
    public void received(byte[] octets, long nowNanos) {
        timers.cancel(guard);
        timers.advance(nowNanos);
        if (isLive) {
            restartGuard(PAUSE_NANOS);
        }
        input.accept(octets);
    }

    // ---- the call --------------------------------------------------------------------------------------------------

    boolean isOpen() {
        return isOpen;
    }

    /** Replies in words, and orders by voice, while the sound is live. */
    CallWords words() {
        return isLive ? words : CallWords.NONE;
    }

    /** True if an order by voice could be heard now; callable on any thread. */
    boolean listensToVoice() {
        return isLive && words.listensToVoice();
    }

    /** True if keys are heard, and tones sent, in the sound of the call. */
    boolean isLive() {
        return isLive;
    }

    /** A call is active; its sound is expected. */
    void begin() {
        receiver.reset();
        generator.drop();
        finished.clear();
        isInCall = true;
        isLive = isOpen;
        recorder.callBegan();
        if (isLive) {
            restartGuard(FIRST_FRAME_NANOS);
        }
    }

    void end() {
        timers.cancel(guard);
        if (isInCall) {
            isInCall = false;
            isLive = false;
            words.end();
            recorder.callEnded();
        }
    }

    /** Counts time without sound, which the receiver hears as silence. */
    void skip(int samples) {
        if (isOpen) {
            receiver.accept(new short[samples]);
        }
    }

    void play(DtmfKey key) {
        words.stop();
        generator.enqueue(key, TONE_MILLIS, PAUSE_MILLIS);
    }

    private void restartGuard(long nanos) {
        timers.cancel(guard);
        guard = timers.start(nanos, this::lost);
    }

    private void lost() {
        timers.cancel(guard);
        if (isLive) {
            isLive = false;
            generator.drop();
            words.end();
            listener.soundChanged(isOpen ? "the modem sends no sound" : obstacle);
        }
    }

    private void accept(short[] heard) {
        if (!isInCall) {
            return;
        }
        if (!isLive) {
            isLive = true;
            listener.soundChanged("");
            restartGuard(PAUSE_NANOS);
        }
        recorder.received(heard);
        listener.heard(new StationEvent.SpeechReceived(heard));
        receiver.accept(heard);
        listener.heard(new ModemEvent.SpeechProcessed(heard.length));
        words.hear(heard);
        if (isLive) {
            send();
        }
    }

    private void send() {
        for (DtmfKey key = finished.poll(); key != null; key = finished.poll()) {
            listener.toneSent(key);
        }
        short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
        boolean isTone = generator.read(frame);
        words.read(frame, isTone);
        recorder.sent(frame);
        output.accept(PcmFrames.octets(frame));
    }
}
