package simgsm.modem;

import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import java.util.random.RandomGenerator;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.station.MobileStation;
import simgsm.station.Sim;
import simgsm.station.StationIdentity;
import simgsm.station.StationListener;
import simgsm.station.StationOptions;

/**
 * M2 as a deterministic core: it owns a station and speaks for it. It alerts and connects every call at once, clears it with
 * cause 16 after 60 s without a key while no order is under way, and with cause 41 after 2 s without a speech frame. It
 * measures all of this in speech: by the frames that it hears, and silence by those that it sends.
 */
public final class Modem {
    static final int TONE_MILLIS = 150;
    static final int PAUSE_MILLIS = 70;
    /** 60 s of speech. */
    static final int IDLE_SAMPLES = 60 * 8000;
    /** 2 s in frames of our own. */
    static final int SILENT_FRAMES = 100;

    private enum Phase {
        NONE,
        ACCEPTED,
        DENIED
    }

    private final MobileStation station;
    private final ModemListener listener;
    private final Replies replies;
    private final DtmfGenerator generator = new DtmfGenerator(this::toneLeft);
    private final DtmfReceiver receiver = new DtmfReceiver(this::keyDecided);
    /** Tones whose last sample is in the frame that goes out now: they have left once the next frame is asked for. */
    private final Queue<DtmfKey> leaving = new ArrayDeque<>();

    private Phase phase = Phase.NONE;
    private boolean connected;
    private DtmfKey greeting;
    private boolean orderUnderWay;
    private int idleSamples;
    private int framesSinceHeard;

    public Modem(StationIdentity identity, Sim sim, StationOptions options, ModemListener listener) {
        this(identity, sim, options, listener, RandomGenerator.getDefault());
    }

    /** @param random as for {@link MobileStation} */
    public Modem(
            StationIdentity identity, Sim sim, StationOptions options, ModemListener listener, RandomGenerator random) {
        this.listener = listener;
        station = new MobileStation(identity, sim, options, this::speak, new Ears(), random);
        replies = new Replies(station, listener);
    }

    /** For the thread that gives it time and a socket. */
    public MobileStation station() {
        return station;
    }

    /**
     * Queues a reply tone of 150 ms, 70 ms from its neighbours.
     *
     * @return false if it was dropped, for want of an accepted call that is up
     */
    public boolean sendTone(DtmfKey key) {
        boolean heard = phase == Phase.ACCEPTED && connected;
        if (heard) {
            queue(key);
        }
        return heard;
    }

    /** @return the message reference of the first part */
    public int sendSms(Msisdn to, String text) {
        return station.sendMessage(to, text);
    }

    /**
     * As {@link #sendSms}, but a message that finds no service, or a network that is congested, is tried again for ten
     * minutes before it fails; of more than twenty that wait the oldest fails.
     */
    public int reply(Msisdn to, String text) {
        return replies.send(to, text);
    }

    /** While an order is under way the count of 60 s stands still; it starts again at every reply tone. */
    public void setOrderUnderWay(boolean underWay) {
        orderUnderWay = underWay;
    }

    /** Ends the call with cause 16. @return false if there is none */
    public boolean hangUp() {
        return station.clear(Cause.NORMAL_CALL_CLEARING);
    }

    private void queue(DtmfKey key) {
        idleSamples = 0;
        generator.enqueue(key, TONE_MILLIS, PAUSE_MILLIS);
    }

    private void toneLeft(DtmfKey key) {
        leaving.add(key);
    }

    private void keyDecided(DtmfDigit digit) {
        idleSamples = 0;
        listener.key(digit);
    }

    /** The station asks for the next frame, every 20 ms: the modem's clock. */
    private void speak(short[] frame) {
        tellTonesSent();
        if (phase != Phase.NONE && ++framesSinceHeard > SILENT_FRAMES) {
            station.clear(Cause.TEMPORARY_FAILURE);
        }
        generator.read(frame);
    }

    private void tellTonesSent() {
        for (DtmfKey key = leaving.poll(); key != null; key = leaving.poll()) {
            idleSamples = 0;
            listener.toneSent(key);
            if (phase == Phase.DENIED) {
                station.clear(Cause.NORMAL_CALL_CLEARING);
            }
        }
    }

    private void hear(short[] samples) {
        framesSinceHeard = 0;
        if (phase != Phase.ACCEPTED) {
            return;
        }
        listener.heard(samples);
        receiver.accept(samples);
        listener.speechTime(samples.length);
        idleSamples += orderUnderWay ? 0 : samples.length;
        if (idleSamples >= IDLE_SAMPLES) {
            station.clear(Cause.NORMAL_CALL_CLEARING);
        }
    }

    private void begin(CallDecision decision) {
        phase = decision.accepted() ? Phase.ACCEPTED : Phase.DENIED;
        greeting = decision.tone();
        connected = false;
        orderUnderWay = false;
        idleSamples = 0;
        framesSinceHeard = 0;
        receiver.reset();
        station.answer();
    }

    private void end(Cause cause) {
        if (phase == Phase.NONE) {
            return;
        }
        tellTonesSent();
        phase = Phase.NONE;
        connected = false;
        generator.drop();
        listener.callEnded(cause);
    }

    /** What the station tells. */
    private final class Ears implements StationListener {
        @Override
        public void registered(Msisdn number) {
            listener.registered(number);
            replies.registered();
        }

        @Override
        public void unregistered(Optional<RejectCause> cause) {
            listener.unregistered(cause);
        }

        @Override
        public void ringing(Optional<Msisdn> from) {
            begin(listener.call(from));
        }

        @Override
        public void connected(Optional<Msisdn> peer) {
            connected = true;
            queue(greeting);
            if (phase == Phase.ACCEPTED) {
                listener.connected(peer);
            }
        }

        @Override
        public void released(Cause cause) {
            end(cause);
        }

        @Override
        public void speechReceived(short[] samples) {
            hear(samples);
        }

        @Override
        public void messageReceived(String from, String text) {
            listener.sms(from, text);
        }

        @Override
        public void messageSent(int id, Msisdn to, int parts) {
            replies.sent(id, to, parts);
        }

        @Override
        public void messageFailed(int id, Msisdn to, RpCause cause) {
            replies.failed(id, to, cause);
        }

        @Override
        public void reminded() {
            replies.reminded();
        }
    }
}
