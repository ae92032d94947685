package simgsm.modem;

import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.random.RandomGenerator;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.DtmfReceiver;
import simgsm.station.MobileStation;
import simgsm.station.StationSnapshot;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;

/**
 * M2 as a deterministic core: a station that alerts every call at once, connects it after the time of {@link
 * ModemOptions}, clears it with cause 16 after 60 s without a key while no order is being executed, and with cause 41
 * after 2 s without a speech frame. During a call, time is counted in speech: keys by received frames, silence by
 * sent frames.
 */
public final class Modem implements AnsweringModem {
    static final int TONE_MILLIS = 150;
    /** Log odds that are enough near lost speech, which disturbs a key's tones; lower ones are also wrong keys'. */
    static final double OUTAGE_LIMIT = 1.5;

    static final int PAUSE_MILLIS = 70;
    /** Longest time without a key. */
    public static final int IDLE_SECONDS = 60;

    /** {@link #IDLE_SECONDS} in samples. */
    static final int IDLE_SAMPLES = IDLE_SECONDS * 8000;
    /** 2 s, in frames sent. */
    static final int SILENT_FRAMES = 100;

    private enum Phase {
        NONE,
        RINGING,
        ACCEPTED,
        DENIED
    }

    private final MobileStation station;
    private final Function<Optional<Msisdn>, CallDecision> admission;
    private final Consumer<StationEvent> listener;
    private final long answerAfterNanos;
    private final Replies replies;
    private final DtmfGenerator generator = new DtmfGenerator(this::toneGenerated);
    private final DtmfReceiver receiver;
    private final CallWords words;
    private final OutageWatch outages = new OutageWatch();
    /** Tones with their last sample in the frame filled last; sent once the next frame is requested. */
    private final Queue<DtmfKey> generated = new ArrayDeque<>();

    private Consumer<StationEvent> observer = event -> {};
    private Phase phase = Phase.NONE;
    private boolean connected;
    private Optional<Msisdn> caller = Optional.empty();
    private DtmfKey greeting;
    private boolean orderActive;
    private int idleSamples;
    private int framesSinceHeard;

    /** As below, with its own random numbers. */
    public Modem(
            StationIdentity identity,
            Sim sim,
            ModemOptions options,
            Function<Optional<Msisdn>, CallDecision> admission,
            Consumer<StationEvent> listener) {
        this(identity, sim, options, admission, listener, RandomGenerator.getDefault());
    }

    /**
     * A modem without a link.
     *
     * @param admission rules on a call when it is answered, by the caller's number, empty if the network does not
     *     send it
     * @param listener receives the station's events and {@link ModemEvent}s on the owner thread, and may call the
     *     modem; for a denied call only ringing and release
     * @param random as for {@link MobileStation}
     */
    public Modem(
            StationIdentity identity,
            Sim sim,
            ModemOptions options,
            Function<Optional<Msisdn>, CallDecision> admission,
            Consumer<StationEvent> listener,
            RandomGenerator random) {
        this.admission = admission;
        this.listener = listener;
        answerAfterNanos = TimeUnit.MILLISECONDS.toNanos(options.answerAfterMillis());
        words = new CallWords(options.prompts(), options.voices(), listener::accept);
        receiver = new DtmfReceiver(new DtmfListener() {
            @Override
            public void keyDecided(DtmfDigit digit) {
                idleSamples = 0;
                if (words.key(digit.key())) {
                    return;
                }
                if (outages.keyDecided(digit)) {
                    listener.accept(new ModemEvent.KeyUnreadable());
                }
                listener.accept(new ModemEvent.KeyDecided(digit));
            }

            @Override
            public void keyEnded(DtmfDigit digit) {
                listener.accept(new ModemEvent.KeyEnded());
            }
        });
        station = new MobileStation(identity, sim, options.station(), this::fillFrame, this::accept, random);
        replies = new Replies(station, listener);
    }

    /** The station, for the thread that gives it time and a socket. */
    public MobileStation station() {
        return station;
    }

    @Override
    public StationSnapshot snapshot() {
        return station.snapshot();
    }

    /** Queues a reply tone of 150 ms, followed by a pause of 70 ms. */
    @Override
    public boolean sendTone(DtmfKey key) {
        boolean heard = phase == Phase.ACCEPTED && connected;
        if (heard) {
            queue(key);
        }
        return heard;
    }

    @Override
    public boolean say(String reply) {
        return phase == Phase.ACCEPTED && connected && words.say(reply);
    }

    @Override
    public boolean listensToVoice() {
        return words.listensToVoice();
    }

    @Override
    public void listen() {
        if (phase == Phase.ACCEPTED && connected) {
            words.listen(caller);
        }
    }

    /** As in the interface; the oldest of more than 20 waiting messages fails. */
    @Override
    public int reply(Msisdn to, String text) {
        return replies.send(to, text);
    }

    @Override
    public boolean isAskedByNetwork() {
        return station.isAskedByNetwork();
    }

    @Override
    public boolean replyUssd(String text) {
        return isAskedByNetwork() && station.sendUssd(text);
    }

    /** Every reply tone restarts the count. */
    @Override
    public void setOrderUnderWay(boolean active) {
        orderActive = active;
    }

    /** Answers the ringing call before its time is over. @return false if none rings */
    public boolean answer() {
        if (phase != Phase.RINGING) {
            return false;
        }
        CallDecision decision = admission.apply(caller);
        phase = decision.accepted() ? Phase.ACCEPTED : Phase.DENIED;
        greeting = decision.tone();
        return station.answer();
    }

    @Override
    public boolean hangUp() {
        return station.clear(Cause.NORMAL_CALL_CLEARING);
    }

    private void queue(DtmfKey key) {
        idleSamples = 0;
        words.stop();
        generator.enqueue(key, TONE_MILLIS, PAUSE_MILLIS);
    }

    private void toneGenerated(DtmfKey key) {
        generated.add(key);
    }

    /** Requested by the station every 20 ms: the modem's clock. */
    private void fillFrame(short[] frame) {
        reportTonesSent();
        if (phase != Phase.NONE && ++framesSinceHeard > SILENT_FRAMES) {
            station.clear(Cause.TEMPORARY_FAILURE);
        }
        boolean isTone = generator.read(frame);
        words.read(frame, isTone);
    }

    private void reportTonesSent() {
        for (DtmfKey key = generated.poll(); key != null; key = generated.poll()) {
            idleSamples = 0;
            listener.accept(new ModemEvent.ReplyToneSent(key));
            if (phase == Phase.DENIED) {
                station.clear(Cause.NORMAL_CALL_CLEARING);
            }
        }
    }

    /** Adds a receiver of all events of the station, called after the modem has acted on them. */
    public void observe(Consumer<StationEvent> newObserver) {
        observer = newObserver;
    }

    private void accept(StationEvent event) {
        act(event);
        observer.accept(event);
    }

    /** A call that did not ring here was dialled through the station; it is not the robot's. */
    private void act(StationEvent event) {
        if (event instanceof StationEvent.SpeechReceived speech) {
            hear(speech);
        } else if (event instanceof StationEvent.SpeechLost lost) {
            outages.lost(lost.frames());
        } else if (event instanceof StationEvent.Ringing ringing) {
            ring(ringing);
        } else if (event instanceof StationEvent.AnswerDue) {
            answer();
        } else if (event instanceof StationEvent.Connected) {
            connected(event);
        } else if (event instanceof StationEvent.Released) {
            end(event);
        } else {
            replies.accept(event);
        }
    }

    private void connected(StationEvent event) {
        if (phase != Phase.NONE) {
            connected = true;
            queue(greeting);
        }
        if (phase == Phase.ACCEPTED) {
            listener.accept(event);
        }
    }

    private void hear(StationEvent.SpeechReceived speech) {
        framesSinceHeard = 0;
        if (phase != Phase.ACCEPTED) {
            return;
        }
        listener.accept(speech);
        outages.heard(speech.samples().length);
        receiver.setLimit(outages.isNear() ? OUTAGE_LIMIT : DtmfReceiver.LIMIT);
        receiver.accept(speech.samples());
        int count = speech.samples().length;
        listener.accept(new ModemEvent.SpeechProcessed(count));
        words.hear(speech.samples());
        if (words.isListening()) {
            idleSamples = 0;
        } else if (!orderActive) {
            idleSamples += count;
        }
        if (idleSamples >= IDLE_SAMPLES) {
            idleSamples = 0;
            listener.accept(new ModemEvent.CallIdle(IDLE_SECONDS));
            station.clear(Cause.NORMAL_CALL_CLEARING);
        }
    }

    private void ring(StationEvent.Ringing ringing) {
        phase = Phase.RINGING;
        caller = ringing.from();
        connected = false;
        orderActive = false;
        idleSamples = 0;
        framesSinceHeard = 0;
        outages.reset();
        receiver.reset();
        listener.accept(ringing);
        if (answerAfterNanos == 0) {
            answer();
        } else {
            station.remindToAnswer(answerAfterNanos);
        }
    }

    private void end(StationEvent released) {
        if (phase == Phase.NONE) {
            return;
        }
        reportTonesSent();
        phase = Phase.NONE;
        connected = false;
        generator.drop();
        words.end();
        listener.accept(released);
    }
}
