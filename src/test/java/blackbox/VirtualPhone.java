package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.Handset;
import simgsm.phone.handset.HandsetEvent;
import simgsm.phone.screen.KeyMode;
import simgsm.phone.screen.UserSettings;
import simgsm.sim.SimPhoneBook;
import simgsm.speech.AudioOutput;
import simgsm.speech.SpeechCodec;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;
import simgsm.tone.ToneSet;

/** A phone of a {@link VirtualSuite}: the real handset on the real station. */
public final class VirtualPhone {
    /** Key and time are all that a person adds to a tone: 100 ms and as much again. */
    private static final double SECONDS_PER_KEY = 0.2;

    public final List<String> tones = new ArrayList<>();
    public final List<Integer> releaseCauses = new ArrayList<>();
    public final List<String> messages = new ArrayList<>();
    /** Of the messages that the network has taken. */
    int sentCount;

    private final VirtualSuite suite;
    private final Handset handset;
    private final MobileStation station;
    VirtualLink link;

    VirtualPhone(VirtualSuite suite, StationIdentity identity, Sim sim) {
        this.suite = suite;
        handset = new Handset(
                identity.number(),
                UserSettings.delivered(SpeechCodec.Kind.A_LAW, KeyMode.IN_BAND),
                ToneSet.EUROPEAN,
                new SimPhoneBook(),
                this::note,
                AudioOutput.SILENT,
                () -> Instant.EPOCH);
        station = new MobileStation(identity, sim, StationOptions.STANDARD, handset::fillFrame, handset::accept);
        handset.attach(station);
    }

    public MobileStation station() {
        return station;
    }

    /** The handset as its window sees it. */
    public Handset handset() {
        return handset;
    }

    public void dial(String number) {
        assertEquals(Optional.empty(), handset.dial(new Msisdn(number)));
        suite.settle();
    }

    /** Presses the keys; when this returns the last has been heard. Blanks are for the reader. */
    public void press(String keys) {
        List<DtmfKey> pressed = DtmfKey.sequence(keys.replace(" ", ""));
        assertEquals(Optional.empty(), handset.press(pressed));
        suite.seconds(pressed.size() * SECONDS_PER_KEY);
    }

    /** Begins to press the keys; time passes outside. */
    public void begin(String keys) {
        assertEquals(Optional.empty(), handset.press(DtmfKey.sequence(keys.replace(" ", ""))));
        suite.settle();
    }

    public void hangUp() {
        assertEquals(Optional.empty(), handset.hangUp());
        suite.settle();
    }

    public void message(String to, String text) {
        assertEquals(Optional.empty(), handset.sendMessage(new Msisdn(to), text));
        suite.settle();
    }

    /** The digits that the phone has heard, as one word. */
    String tones() {
        return String.join("", tones);
    }

    private void note(StationEvent event) {
        if (event instanceof HandsetEvent.ToneHeard heard) {
            tones.add("" + heard.key().symbol());
        } else if (event instanceof StationEvent.Released released) {
            releaseCauses.add(released.cause().code());
        } else if (event instanceof StationEvent.MessageSent) {
            sentCount++;
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            messages.add(message.text());
        }
    }
}
