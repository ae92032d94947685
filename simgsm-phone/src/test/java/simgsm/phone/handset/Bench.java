package simgsm.phone.handset;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.DtmfReceiver;
import simgsm.speech.AudioOutput;
import simgsm.station.StationListener;

/** A handset on a bench: a fake station, a hand-moved clock, the events as lines, the sent tones heard by a receiver. */
public final class Bench {
    public static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");

    public final FakeStation station = new FakeStation();
    public final List<String> events = new ArrayList<>();
    public final Handset handset;
    public final StationListener ears;
    public long nowNanos;

    private final StringBuilder heardByFarEnd = new StringBuilder();
    private final List<Double> tonesMillis = new ArrayList<>();
    private final DtmfReceiver farEnd = new DtmfReceiver(new FarEnd());
    private final short[] frame = new short[160];

    public Bench() {
        this(KeyMode.IN_BAND);
    }

    public Bench(KeyMode keyMode) {
        this(keyMode, AudioOutput.SILENT);
    }

    public Bench(KeyMode keyMode, AudioOutput output) {
        handset = new Handset(new Msisdn("5550100"), keyMode, new Lines(), output, () -> NOON);
        ears = handset.ears();
        station.tell(ears);
        handset.attach(station);
    }

    /** A bench whose handset is in a call with 5550200. */
    public static Bench connected() {
        return connected(KeyMode.IN_BAND);
    }

    public static Bench connected(KeyMode keyMode) {
        Bench bench = new Bench(keyMode);
        bench.handset.dial(new Msisdn("5550200"));
        bench.ears.alerting();
        bench.ears.connected(Optional.of(new Msisdn("5550200")));
        bench.events.clear();
        return bench;
    }

    /** Speech time goes on in a call. */
    public void speechMillis(int millis) {
        for (int i = 0; i < millis / 20; i++) {
            handset.mouth().read(frame);
            farEnd.accept(frame);
            nowNanos += 20_000_000;
        }
    }

    /** Time goes on without a call. */
    public void millis(int millis) {
        for (int i = 0; i < millis / 20; i++) {
            nowNanos += 20_000_000;
            handset.timePassed(nowNanos);
        }
    }

    public void down(PhoneKey key) {
        handset.keyDown(key, nowNanos);
    }

    public void up(PhoneKey key) {
        handset.keyUp(key, nowNanos);
    }

    /** Presses keys one after the other, shortly. */
    public void tap(PhoneKey... keys) {
        for (PhoneKey key : keys) {
            down(key);
            up(key);
        }
    }

    /** The keys that came out at the far end so far. */
    public String heardByFarEnd() {
        farEnd.finish();
        return heardByFarEnd.toString();
    }

    /** How long they sounded. */
    public List<Double> tonesMillis() {
        farEnd.finish();
        return tonesMillis;
    }

    /** The far end's phone plays a key of 150 ms, as a robot does. */
    public void farEndPlays(char key) {
        DtmfGenerator generator = new DtmfGenerator();
        generator.enqueue(DtmfKey.of(key), 150, 70);
        while (!generator.isIdle()) {
            short[] sound = new short[160];
            generator.read(sound);
            ears.speechReceived(sound);
        }
    }

    public HandsetSnapshot snapshot() {
        return handset.snapshot();
    }

    private final class FarEnd implements DtmfListener {
        @Override
        public void keyDecided(simgsm.dtmf.DtmfDigit digit) {
            heardByFarEnd.append(digit.key().symbol());
        }

        @Override
        public void keyEnded(simgsm.dtmf.DtmfDigit digit) {
            tonesMillis.add(digit.durationMillis());
        }
    }

    private final class Lines implements HandsetListener {
        @Override
        public void calling(Msisdn number) {
            events.add("calling " + number);
        }

        @Override
        public void alerting() {
            events.add("alerting");
        }

        @Override
        public void ringing(Optional<Msisdn> from) {
            events.add("ringing " + from.map(Msisdn::digits).orElse("?"));
        }

        @Override
        public void connected(Optional<Msisdn> peer) {
            events.add("connected " + peer.map(Msisdn::digits).orElse("?"));
        }

        @Override
        public void sent(String keys) {
            events.add("sent " + keys);
        }

        @Override
        public void keysRefused(String keys, Cause cause) {
            events.add("refused " + keys + " " + cause.code());
        }

        @Override
        public void toneHeard(DtmfKey key) {
            events.add("tone " + key.symbol());
        }

        @Override
        public void released(Cause cause) {
            events.add("released " + cause.code());
        }

        @Override
        public void messageSent(Msisdn to, int parts, int id) {
            events.add("sms-sent " + to + " " + parts + " " + id);
        }

        @Override
        public void messageFailed(Msisdn to, RpCause cause) {
            events.add("sms-failed " + to + " " + cause.code());
        }

        @Override
        public void messageDelivered(Msisdn to, int id) {
            events.add("sms-delivered " + to + " " + id);
        }

        @Override
        public void messageReceived(String from, String text) {
            events.add("sms " + from + " " + text);
        }

        @Override
        public void broadcastReceived(int channel, int pages, String text) {
            events.add("broadcast " + channel + " " + text);
        }
    }
}
