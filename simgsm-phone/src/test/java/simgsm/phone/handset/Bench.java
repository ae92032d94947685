package simgsm.phone.handset;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.DtmfReceiver;
import simgsm.phone.screen.KeyMode;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.Screen;
import simgsm.phone.screen.UserSettings;
import simgsm.sim.SimPhoneBook;
import simgsm.speech.AudioOutput;
import simgsm.speech.SpeechCodec;
import simgsm.station.context.StationEvent;
import simgsm.tone.ToneSet;
import simgsm.words.PromptListener;
import simgsm.words.Prompts;
import simgsm.words.SpokenLanguage;
import simgsm.words.SpokenReply;

/** A handset on a bench: a fake station, a hand-moved clock, the events as lines, the sent tones heard by a receiver. */
public final class Bench {
    public static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");

    public final SimPhoneBook phoneBook = new SimPhoneBook();
    public final FakeStation station = new FakeStation();
    public final List<String> events = new ArrayList<>();
    public final Handset handset;
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
        handset = new Handset(
                new Msisdn("5550100"),
                UserSettings.delivered(SpeechCodec.Kind.A_LAW, keyMode),
                ToneSet.EUROPEAN,
                phoneBook,
                this::note,
                output,
                () -> NOON);
        station.reportTo(handset::accept);
        handset.attach(station);
    }

    /** A handset with European tones and an empty phone book. */
    public static Handset handset(KeyMode keyMode, Consumer<StationEvent> listener, AudioOutput output) {
        return new Handset(
                new Msisdn("5550100"),
                UserSettings.delivered(SpeechCodec.Kind.A_LAW, keyMode),
                ToneSet.EUROPEAN,
                new SimPhoneBook(),
                listener,
                output,
                () -> NOON);
    }

    public HandsetKeys keys() {
        return new HandsetKeys(handset);
    }

    /** A bench whose handset is in a call with 5550200. */
    public static Bench connected() {
        return connected(KeyMode.IN_BAND);
    }

    public static Bench connected(KeyMode keyMode) {
        Bench bench = new Bench(keyMode);
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.CalledPartyAlerted());
        bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550200"))));
        bench.events.clear();
        return bench;
    }

    /** Speech time goes on in a call. */
    public void speechMillis(int millis) {
        for (int i = 0; i < millis / 20; i++) {
            handset.fillFrame(frame);
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
        keys().keyDown(key, nowNanos);
    }

    public void up(PhoneKey key) {
        keys().keyUp(key, nowNanos);
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
            handset.accept(new StationEvent.SpeechReceived(sound));
        }
    }

    /** A robot's modem reads a reply with its prompts, and is silent for 400 ms. */
    public void farEndSays(SpokenLanguage language, String reply) {
        PromptListener.load();
        Prompts prompts = Prompts.of(language);
        short[] said = prompts.samples(new SpokenReply(prompts).read(reply));
        for (int at = 0; at < said.length + 20 * 160; at += 160) {
            int from = Math.min(at, said.length);
            handset.accept(new StationEvent.SpeechReceived(
                    Arrays.copyOf(Arrays.copyOfRange(said, from, Math.min(from + 160, said.length)), 160)));
        }
    }

    /** The list or menu on the display. */
    public Screen.Listing list() {
        return (Screen.Listing) snapshot().screen();
    }

    /** Keys of the twelve, one after the other, each with a pause in which its letter stands. */
    public void key(String keys) {
        keys.chars().forEach(symbol -> {
            tap(PhoneKey.ofSymbol((char) symbol).orElseThrow());
            nowNanos += 2_000_000_000L;
        });
    }

    /** Characters of a computer's keyboard. */
    public void type(String text) {
        text.chars().forEach(sign -> {
            keys().charDown((char) sign, nowNanos);
            keys().charUp((char) sign, nowNanos);
        });
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

    private void note(StationEvent event) {
        if (event instanceof StationEvent.Calling calling) {
            events.add("calling " + calling.number());
        } else if (event instanceof StationEvent.CalledPartyAlerted) {
            events.add("alerting");
        } else if (event instanceof StationEvent.Ringing ringing) {
            events.add("ringing " + digits(ringing.from()));
        } else if (event instanceof StationEvent.Connected connected) {
            events.add("connected " + digits(connected.peer()));
        } else if (event instanceof StationEvent.Released released) {
            events.add("released " + released.cause().code());
        } else if (event instanceof StationEvent.OfMessage message) {
            note(message);
        } else if (event instanceof HandsetEvent.KeysSent sent) {
            events.add("sent " + sent.keys());
        } else if (event instanceof HandsetEvent.KeysNotSent refused) {
            events.add("refused " + refused.keys() + " " + refused.cause().code());
        } else if (event instanceof HandsetEvent.ToneHeard heard) {
            events.add("tone " + heard.key().symbol());
        }
    }

    private void note(StationEvent.OfMessage event) {
        if (event instanceof StationEvent.MessageSent sent) {
            events.add("sms-sent " + sent.to() + " " + sent.parts() + " " + sent.id());
        } else if (event instanceof StationEvent.MessageFailed failed) {
            events.add("sms-failed " + failed.to() + " " + failed.cause().code());
        } else if (event instanceof StationEvent.MessageDelivered delivered) {
            events.add("sms-delivered " + delivered.to() + " " + delivered.id());
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            events.add("sms " + message.from() + " " + message.text());
        } else if (event instanceof StationEvent.BroadcastReceived broadcast) {
            events.add("broadcast " + broadcast.channel() + " " + broadcast.text());
        }
    }

    private static String digits(Optional<Msisdn> number) {
        return number.map(Msisdn::digits).orElse("?");
    }
}
