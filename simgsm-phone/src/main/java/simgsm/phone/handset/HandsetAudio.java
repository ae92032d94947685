package simgsm.phone.handset;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.phone.screen.RingTone;
import simgsm.phone.screen.UserSettings;
import simgsm.speech.AudioInput;
import simgsm.speech.AudioOutput;
import simgsm.station.context.StationEvent;
import simgsm.tone.ToneSet;
import simgsm.words.PromptListener;

/**
 * All sound of the handset: keys sent in a call, the far end's keys and speech, and, without a call, key tones and
 * supervisory tones. The clock is the station's speech frames during a call, else {@link #timePassed}.
 */
final class HandsetAudio {
    private static final int SAMPLES_PER_FRAME = 160;
    private static final long FRAME_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
    /** Later frames are skipped. */
    private static final long MAX_CATCH_UP_NANOS = TimeUnit.MILLISECONDS.toNanos(200);
    /** Frames played after the end of a sound, until the scope shows silence. */
    private static final int TAIL_FRAMES = 8;

    private final EarpieceOutput earpiece;
    private final Supplier<KeySender> senders;
    private KeySender sender;
    private final KeySender keyTones = new KeySender(keys -> {});
    private final DtmfReceiver receiver;
    private final PromptListener words;
    private final SupervisoryTones supervisory;
    private final SoundPlayer player = new SoundPlayer();
    private AudioInput microphone = AudioInput.SILENT;
    private final short[] heardFrame = new short[SAMPLES_PER_FRAME];
    /** Speech that is not sent: of {@link #keyTones}, and of the microphone while keys or a sound are sent. */
    private final short[] unsentFrame = new short[SAMPLES_PER_FRAME];

    private RingTone ringTone = RingTone.WARBLE;
    private boolean connected;
    private boolean networkPlaysTones;
    private Runnable timeWanted = () -> {};
    private int localFramesLeft;
    private boolean localTimeKnown;
    private long nextLocalFrameNanos;

    /**
     * Silent at first.
     *
     * @param senders supplies each call's sender of keys
     * @param tones supervisory tones, European or American
     * @param keyHeard receives each key of the far end at its decision
     * @param wordsHeard receives each sentence of a robot's prompts
     */
    HandsetAudio(
            AudioOutput output,
            Supplier<KeySender> senders,
            ToneSet tones,
            Consumer<DtmfKey> keyHeard,
            Consumer<String> wordsHeard) {
        earpiece = new EarpieceOutput(output);
        supervisory = new SupervisoryTones(tones);
        this.senders = senders;
        sender = senders.get();
        receiver = new DtmfReceiver(digit -> keyHeard.accept(digit.key()));
        words = new PromptListener(sentence -> wordsHeard.accept(sentence.text()));
    }

    /** @param volume 0 to {@link UserSettings#MOST_VOLUME} */
    void setSound(RingTone newRingTone, int volume) {
        ringTone = newRingTone;
        earpiece.setVolume(volume);
    }

    /** A microphone that rests while keys or a sound are sent. */
    void setMicrophone(AudioInput newMicrophone) {
        microphone = newMicrophone;
    }

    void accept(StationEvent.OfCall event) {
        if (event instanceof StationEvent.Calling) {
            callBegan();
        } else if (event instanceof StationEvent.Ringing) {
            callBegan();
            supervisory.ringing(ringTone);
            beginLocally();
        } else if (event instanceof StationEvent.CalledPartyAlerted) {
            ringBack();
        } else if (event instanceof StationEvent.Connected) {
            connected();
        } else if (event instanceof StationEvent.CallWaits) {
            supervisory.callWaits();
        } else if (event instanceof StationEvent.WaitingCallEnded) {
            stopTones();
        } else if (event instanceof StationEvent.Released released) {
            connected = false;
            dropKeys();
            earpiece.callEnded();
            supervisory.ended(released.cause());
            beginLocally();
        } else if (event instanceof StationEvent.CallHeld) {
            connected = false;
            dropKeys();
            earpiece.callEnded();
            stopTones();
        } else if (event instanceof StationEvent.CallRetrieved) {
            connected();
        } else if (event instanceof StationEvent.NetworkPlaysTones tones) {
            setNetworkPlaysTones(tones.playing());
        }
    }

    private void callBegan() {
        sender.drop();
        sender = senders.get();
        stopTones();
    }

    private void ringBack() {
        if (!networkPlaysTones) {
            supervisory.ringBack();
            beginLocally();
        }
    }

    private void connected() {
        connected = true;
        microphone.begin();
        networkPlaysTones = false;
        receiver.reset();
        words.reset();
        keyTones.drop();
        stopTones();
        localFramesLeft = 0;
    }

    private void setNetworkPlaysTones(boolean playing) {
        if (playing != networkPlaysTones) {
            networkPlaysTones = playing;
            stopTones();
            earpiece.callEnded();
            beginLocally();
        }
    }

    boolean networkPlaysTones() {
        return networkPlaysTones;
    }

    /** Queues keys for the far end; they are sent once a call is connected. */
    void press(List<DtmfKey> keys, int toneMillis, Runnable whenSent) {
        sender.press(keys, toneMillis, whenSent);
    }

    /** Starts a key's tone, which lasts until {@link #keyUp}; it is sent to the far end during a call, otherwise only played locally. */
    void keyDown(DtmfKey key) {
        if (connected) {
            sender.down(key);
        } else {
            keyTones.down(key);
            beginLocally();
        }
    }

    void keyUp() {
        sender.up();
        keyTones.up();
    }

    /**
     * Adds a sound to the speech sent, from the next frame of a connected call. @param whenPlayed runs at its end
     */
    void play(short[] samples, Runnable whenPlayed) {
        player.play(samples, whenPlayed);
    }

    /** Drops unsent keys and a sound being played. @return the keys */
    String dropKeys() {
        player.stop();
        return sender.drop();
    }

    boolean keysAreSent() {
        return sender.isIdle() && player.isIdle();
    }

    /** Ends the supervisory tone. */
    void stopTones() {
        supervisory.stop();
    }

    /** Fills the next 20 ms for the far end. @return true if a view has to show a change */
    boolean fillFrame(short[] speech) {
        if (!connected) {
            Arrays.fill(speech, (short) 0);
            return networkPlaysTones && playLocalFrame();
        }
        boolean isQuiet = keysAreSent();
        DtmfKey before = sender.sounding();
        sender.read(speech, heardFrame);
        player.addTo(speech, heardFrame);
        // a microphone in the earpiece would howl
        microphone.read(isQuiet ? speech : unsentFrame);
        earpiece.play(heardFrame);
        return earpiece.pollChanged() || before != sender.sounding();
    }

    /** Plays 20 ms from the far end or the network. Keys are detected in the far end's speech only. */
    void hear(short[] frame) {
        if (connected) {
            receiver.accept(frame);
            words.accept(frame);
        }
        if (connected && !supervisory.isIdle()) {
            short[] mixed = frame.clone();
            supervisory.addTo(mixed);
            earpiece.receive(mixed);
        } else if (connected || networkPlaysTones) {
            earpiece.receive(frame);
        }
    }

    /** The key that sounds now. */
    Optional<DtmfKey> sounding() {
        return Optional.ofNullable((connected ? sender : keyTones).sounding());
    }

    EarpieceOutput earpiece() {
        return earpiece;
    }

    void whenTimeIsWanted(Runnable action) {
        timeWanted = action;
    }

    private void beginLocally() {
        boolean idle = localFramesLeft == 0;
        localFramesLeft = TAIL_FRAMES;
        if (idle) {
            localTimeKnown = false;
            timeWanted.run();
        }
    }

    boolean wantsTime() {
        return localFramesLeft > 0 && !networkPlaysTones;
    }

    /** @return true if a view has to show a change */
    boolean timePassed(long nowNanos) {
        if (!localTimeKnown || nowNanos - nextLocalFrameNanos > MAX_CATCH_UP_NANOS) {
            nextLocalFrameNanos = nowNanos;
            localTimeKnown = true;
        }
        boolean changed = false;
        while (wantsTime() && nextLocalFrameNanos <= nowNanos) {
            changed |= playLocalFrame();
            nextLocalFrameNanos += FRAME_NANOS;
        }
        return changed;
    }

    private boolean playLocalFrame() {
        DtmfKey before = keyTones.sounding();
        keyTones.read(unsentFrame, heardFrame);
        supervisory.addTo(heardFrame);
        earpiece.play(heardFrame);
        boolean silent = keyTones.isIdle() && supervisory.isIdle();
        localFramesLeft = silent ? Math.max(0, localFramesLeft - 1) : TAIL_FRAMES;
        if (localFramesLeft == 0 && !networkPlaysTones) {
            earpiece.rest();
        }
        return earpiece.pollChanged() || before != keyTones.sounding();
    }
}
