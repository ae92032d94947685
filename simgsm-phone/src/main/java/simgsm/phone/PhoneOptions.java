package simgsm.phone;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.console.Arguments;
import simgsm.console.TextBundle;
import simgsm.console.UsageException;
import simgsm.phone.screen.KeyMode;
import simgsm.phone.screen.UserSettings;
import simgsm.sim.InsertedCard;
import simgsm.sim.SimSlot;
import simgsm.sms.ChannelList;
import simgsm.speech.SpeechCodec;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;
import simgsm.tone.ToneSet;

/**
 * The phone's options, from the command line.
 *
 * @param user initial settings of the user
 * @param sim authenticates the phone in a closed network
 * @param tones the call progress tones: busy and others
 * @param recording file of the calls' recording, if any
 * @param data folder of stored names, calls, messages and settings, if any
 * @param given keys of the user's settings that are on the command line
 * @param ignoresSetup a fault: offered calls are left unanswered
 * @param channels displayed cell broadcast channels
 */
record PhoneOptions(
        StationIdentity identity,
        Sim sim,
        UserSettings user,
        ToneSet tones,
        Optional<Path> recording,
        Optional<Path> data,
        Set<String> given,
        boolean ignoresSetup,
        ChannelList channels) {
    private static final String DEFAULT_NUMBER = "5550100";
    private static final String UNIT_NAME = "SimGSM phone";

    /** @throws IOException naming the SIM file if it cannot be read */
    static PhoneOptions of(Arguments arguments) throws UsageException, IOException {
        SimSlot slot = SimSlot.of(arguments.path("sim"));
        Optional<Msisdn> given = arguments.value("number", slot.isEmpty() ? PhoneOptions::ownNumber : Msisdn::parse);
        Optional<InsertedCard> card = Arguments.checked(() -> slot.card(given));
        Msisdn number = card.map(InsertedCard::number).or(() -> given).orElse(new Msisdn(DEFAULT_NUMBER));
        Imei imei = imei(arguments, number);
        return new PhoneOptions(
                card.map(inserted -> StationIdentity.ofCard(inserted.card(), imei, UNIT_NAME))
                        .orElseGet(() -> StationIdentity.ofOpenNumber(number, imei, UNIT_NAME)),
                card.map(Sim::of).orElse(Sim.WITHOUT_KEY),
                UserSettings.delivered(
                                arguments
                                        .value("codec", SpeechCodec.Kind::named)
                                        .orElse(SpeechCodec.Kind.A_LAW),
                                keyMode(arguments))
                        .withLanguage(
                                TextBundle.bundleLocale(arguments.language())
                                                .getLanguage()
                                                .equals("es")
                                        ? "es"
                                        : "en"),
                arguments.value("tones", ToneSet::of).orElse(ToneSet.EUROPEAN),
                arguments.path("record-audio"),
                arguments.path("data"),
                given(arguments),
                arguments.has("ignore-setup"),
                arguments.value("channels", ChannelList::parse).orElse(ChannelList.ALL));
    }

    private static Set<String> given(Arguments arguments) {
        Set<String> given = new HashSet<>();
        if (arguments.has("codec")) {
            given.add(UserSettings.CODEC);
        }
        if (arguments.has("dtmf")) {
            given.add(UserSettings.KEYS);
        }
        return given;
    }

    private static Imei imei(Arguments arguments, Msisdn number) throws UsageException {
        Random random = new Random();
        if (arguments.has("seed")) {
            // The number is part of the seed: otherwise two phones with one seed would have the same IMEI.
            random = new Random(arguments.integer("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE) * 31
                    + number.digits().hashCode());
        }
        return arguments.value("imei", Imei::new).orElse(Imei.random(random));
    }

    /** The identity in the open network is derived from the number, which must have this form. */
    private static Msisdn ownNumber(String text) {
        if (!text.matches("\\+?[1-9][0-9]{0,9}")) {
            throw new IllegalArgumentException("expected 1 to 10 digits and no leading zero, found " + text);
        }
        return Msisdn.parse(text).plain();
    }

    private static KeyMode keyMode(Arguments arguments) throws UsageException {
        return arguments.choice("dtmf", "inband", "signalled").equals("inband") ? KeyMode.IN_BAND : KeyMode.SIGNALLED;
    }
}
