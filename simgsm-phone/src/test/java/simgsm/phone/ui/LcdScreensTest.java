package simgsm.phone.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.ResourceBundle;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.Bench;
import simgsm.phone.screen.KeyMode;
import simgsm.phone.screen.PhoneKey;
import simgsm.sim.SimPhoneBook;
import simgsm.speech.SpeechCodec;
import simgsm.ss.ServiceStatus;
import simgsm.ss.SsCode;
import simgsm.ss.SsOperation;
import simgsm.station.context.StationEvent;
import simgsm.ui.Theme;
import simgsm.words.SpokenLanguage;

/** Every screen of the display is painted, in both languages, and no two look alike. */
class LcdScreensTest {
    @BeforeEach
    void light() {
        Theme.zoomTo(1);
        Theme.install(Appearance.LIGHT);
    }

    static Map<String, Bench> screens() {
        Map<String, Bench> screens = new LinkedHashMap<>();
        screens.put("rest", new Bench());
        screens.put("typed", with(bench -> bench.tap(PhoneKey.FIVE, PhoneKey.STAR)));
        screens.put("long number", with(bench -> {
            for (int i = 0; i < 60; i++) {
                bench.tap(PhoneKey.NINE);
            }
        }));
        screens.put("calling", with(bench -> bench.handset.dial(new Msisdn("5550200"))));
        screens.put("ringing", with(bench -> bench.station.ring("5550101")));
        screens.put("connected", Bench.connected());
        screens.put("connected, full rate comes", fullRate());
        screens.put("connected, keys signalled", Bench.connected(KeyMode.SIGNALLED));
        screens.put("keys refused", refused());
        screens.put("menu", with(bench -> bench.tap(PhoneKey.MENU)));
        screens.put("menu, second", with(bench -> bench.tap(PhoneKey.MENU, PhoneKey.DOWN)));
        screens.put("empty inbox", with(bench -> bench.tap(PhoneKey.DOWN)));
        screens.put("empty outbox", with(bench -> bench.tap(PhoneKey.UP)));
        screens.put("inbox", with(bench -> {
            messages(bench);
            bench.tap(PhoneKey.DOWN);
        }));
        screens.put("message", with(bench -> {
            messages(bench);
            bench.tap(PhoneKey.DOWN, PhoneKey.OK);
        }));
        screens.put("message, scrolled", with(bench -> {
            messages(bench);
            bench.tap(PhoneKey.DOWN, PhoneKey.OK, PhoneKey.DOWN);
        }));
        screens.put("writing", with(bench -> bench.tap(PhoneKey.MESSAGE)));
        screens.put("writing, pending", with(bench -> bench.tap(PhoneKey.MESSAGE, PhoneKey.TWO)));
        screens.put("recipient", with(bench -> bench.tap(PhoneKey.MESSAGE, PhoneKey.TWO, PhoneKey.OK)));
        screens.put("note", with(bench -> bench.tap(PhoneKey.STAR, PhoneKey.CALL)));
        screens.put("sent", sent());
        screens.put("delivered", with(bench -> {
            messages(bench);
            bench.tap(PhoneKey.MESSAGE, PhoneKey.TWO, PhoneKey.OK, PhoneKey.FIVE, PhoneKey.OK);
        }));
        screens.put("failed", failed());
        screens.put(
                "broadcast", with(bench -> bench.handset.accept(new StationEvent.BroadcastReceived(50, 1, "storm"))));
        screens.put("order without a call", with(bench -> bench.key("**#**20**")));
        screens.put("service code", with(bench -> bench.key("*#100#")));
        screens.put("service asked for", with(bench -> bench.handset.codes().send("*100#")));
        screens.put(
                "service's text",
                with(bench -> bench.handset.accept(
                        new StationEvent.UssdReceived("Stopped at 0.200 -1.450 m, heading 90.0.", false))));
        screens.put(
                "service's question",
                with(bench -> bench.handset.accept(
                        new StationEvent.UssdReceived("1 Own number\n2 Status of a robot\n0 End", true))));
        screens.put("number and its name", with(bench -> {
            contacts(bench);
            bench.key("5550200");
            bench.tap(PhoneKey.LEFT, PhoneKey.LEFT);
        }));
        screens.put("names", with(bench -> {
            contacts(bench);
            bench.tap(PhoneKey.SOFT_RIGHT);
        }));
        screens.put("what to do with a name", with(bench -> {
            contacts(bench);
            bench.tap(PhoneKey.SOFT_RIGHT, PhoneKey.OK);
        }));
        screens.put("new name", with(bench -> {
            bench.tap(PhoneKey.SOFT_RIGHT, PhoneKey.OK, PhoneKey.SEVEN, PhoneKey.SEVEN);
        }));
        screens.put("new name's number", with(bench -> {
            bench.tap(PhoneKey.SOFT_RIGHT, PhoneKey.OK);
            bench.type("Robot");
            bench.tap(PhoneKey.OK);
            bench.key("5550200");
        }));
        screens.put("caller with a name", with(bench -> {
            contacts(bench);
            bench.station.ring("5550200");
        }));
        screens.put("silenced", with(bench -> {
            contacts(bench);
            bench.station.ring("5550200");
            bench.tap(PhoneKey.SOFT_RIGHT);
        }));
        screens.put("connected with a name, another waits", with(bench -> {
            contacts(bench);
            bench.station.ring("5550200");
            bench.tap(PhoneKey.CALL);
            bench.handset.accept(new StationEvent.CallWaits(Optional.of(new Msisdn("5550101"))));
        }));
        screens.put("connected, another is held", with(bench -> {
            held(bench);
            bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550101"))));
        }));
        screens.put("connected, a tone has come, another is held", with(bench -> {
            held(bench);
            bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550101"))));
            bench.handset.press(DtmfKey.sequence("** #**20 **"));
            bench.farEndPlays('3');
        }));
        screens.put("held", with(LcdScreensTest::held));
        screens.put("what to do in a call", with(bench -> {
            held(bench);
            bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550101"))));
            bench.tap(PhoneKey.SOFT_LEFT);
        }));
        screens.put("how a forwarding stands", with(bench -> {
            contacts(bench);
            bench.handset.codes().send("*#21#");
            bench.handset.accept(new StationEvent.ServiceAnswered(
                    SsOperation.INTERROGATE_SS,
                    new ServiceStatus(SsCode.FORWARDING_UNCONDITIONAL, 7, Optional.of("+5550101"))));
        }));
        screens.put("missed", with(LcdScreensTest::missed));
        screens.put("missed calls", with(bench -> {
            missed(bench);
            bench.tap(PhoneKey.SOFT_LEFT);
        }));
        screens.put("a call's details", with(bench -> {
            missed(bench);
            bench.tap(PhoneKey.SOFT_LEFT, PhoneKey.OK);
        }));
        screens.put("what to do with a call", with(bench -> {
            missed(bench);
            bench.tap(PhoneKey.SOFT_LEFT, PhoneKey.SOFT_LEFT);
        }));
        screens.put("unread and missed", with(bench -> {
            messages(bench);
            missed(bench);
        }));
        for (int item = 1; item <= 6; item++) {
            String digit = String.valueOf(item);
            screens.put("menu " + item, with(bench -> {
                bench.tap(PhoneKey.MENU);
                bench.key(digit);
            }));
        }
        for (int item = 1; item <= 7; item++) {
            String digits = "5" + item;
            screens.put("setting " + item, with(bench -> {
                bench.tap(PhoneKey.MENU);
                bench.key(digits);
            }));
        }
        screens.put("forwarding", with(bench -> {
            bench.tap(PhoneKey.MENU);
            bench.key("43");
        }));
        screens.put("forwarding of busy calls", with(bench -> {
            bench.tap(PhoneKey.MENU);
            bench.key("432");
        }));
        screens.put("forwarding to", with(bench -> {
            bench.tap(PhoneKey.MENU);
            bench.key("4321555");
        }));
        screens.put("what to do with a text", with(bench -> {
            bench.tap(PhoneKey.MESSAGE);
            bench.type("Hola");
            bench.tap(PhoneKey.SOFT_LEFT);
        }));
        screens.put("what to do with a message", with(bench -> {
            messages(bench);
            bench.tap(PhoneKey.DOWN, PhoneKey.SOFT_LEFT);
        }));
        screens.put("question", with(bench -> {
            messages(bench);
            bench.tap(PhoneKey.DOWN, PhoneKey.SOFT_LEFT, PhoneKey.SIX);
        }));
        screens.put("outbox", with(bench -> {
            bench.handset.sendMessage(new Msisdn("5550200"), "** #**20 **");
            bench.handset.accept(new StationEvent.MessageSent(0, new Msisdn("5550200"), 1));
            bench.handset.accept(new StationEvent.MessageDelivered(0, new Msisdn("5550200")));
            bench.handset.sendMessage(new Msisdn("5550101"), "on its way");
            bench.tap(PhoneKey.UP);
        }));
        screens.put("message of the outbox", with(bench -> {
            bench.handset.sendMessage(new Msisdn("5550200"), "** #**20 **");
            bench.handset.accept(new StationEvent.MessageSent(0, new Msisdn("5550200"), 1));
            bench.tap(PhoneKey.UP, PhoneKey.OK);
        }));
        screens.put("long text, cursor within", with(bench -> {
            bench.tap(PhoneKey.MESSAGE);
            bench.type("The robot stands before the door of the laboratory and waits for its next order");
            bench.tap(PhoneKey.LEFT, PhoneKey.LEFT, PhoneKey.LEFT, PhoneKey.LEFT, PhoneKey.LEFT, PhoneKey.LEFT);
        }));
        screens.put("a robot's words", said("Hecho: #**20. Parado en 1.200 0.500 m, rumbo 90.0."));
        screens.put("off", with(bench -> bench.handset.powerOff()));
        return screens;
    }

    private static Bench sent() {
        return with(bench -> bench.tap(PhoneKey.MESSAGE, PhoneKey.TWO, PhoneKey.OK, PhoneKey.FIVE, PhoneKey.OK));
    }

    private static Bench failed() {
        Bench bench = sent();
        bench.handset.accept(new StationEvent.MessageFailed(0, new Msisdn("5"), RpCause.DESTINATION_OUT_OF_ORDER));
        return bench;
    }

    private static Bench fullRate() {
        Bench bench = Bench.connected();
        bench.station.heardCodec = Optional.of(SpeechCodec.Kind.GSM_FULL_RATE);
        bench.handset.accept(new StationEvent.StationChanged());
        return bench;
    }

    private static Bench refused() {
        Bench bench = Bench.connected(KeyMode.SIGNALLED);
        bench.handset.accept(new StationEvent.KeysRefused(Cause.SERVICE_NOT_AVAILABLE));
        return bench;
    }

    private static void contacts(Bench bench) {
        bench.phoneBook.write(1, new SimPhoneBook.Entry("5550200", "Robot"));
        bench.phoneBook.write(2, new SimPhoneBook.Entry("+5550101", "Ada"));
        bench.phoneBook.write(3, new SimPhoneBook.Entry("5550300", "Laboratory of Robots"));
        bench.handset.accept(new StationEvent.StationChanged());
    }

    private static void held(Bench bench) {
        contacts(bench);
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550200"))));
        bench.handset.accept(new StationEvent.CallHeld(Optional.of(new Msisdn("5550200"))));
    }

    private static void missed(Bench bench) {
        contacts(bench);
        for (String caller : new String[] {"5550200", "5550300", "5559999"}) {
            bench.station.ring(caller);
            bench.station.release(Cause.NORMAL_CALL_CLEARING);
        }
        bench.tap(PhoneKey.END);
    }

    private static void messages(Bench bench) {
        for (int i = 0; i < 5; i++) {
            bench.handset.accept(new StationEvent.ShortMessageReceived(
                    "5550200", "3 Done: #**20. Stopped at 1.200 0.500 m, heading 90.0. ".repeat(4) + i));
        }
    }

    private interface Deed {
        void on(Bench bench);
    }

    private static Bench with(Deed deed) {
        Bench bench = new Bench();
        deed.on(bench);
        return bench;
    }

    private static BufferedImage picture(Bench bench, String language) {
        return new PanelBench(bench, Locale.forLanguageTag(language)).paint(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyScreenLooksDifferent(String language) {
        Map<Integer, String> seen = new LinkedHashMap<>();
        screens().forEach((name, bench) -> {
            BufferedImage image = picture(bench, language);
            int hash = Arrays.hashCode(((DataBufferInt) image.getRaster().getDataBuffer()).getData());
            String before = seen.put(hash, name);
            assertEquals(null, before, name + " looks like " + before);
        });
        assertEquals(screens().size(), seen.size());
    }

    @Test
    void theToneThatComesBackIsShown() {
        Bench bench = Bench.connected();
        BufferedImage before = picture(bench, "en");
        bench.farEndPlays('3');
        assertTrue(differences(before, picture(bench, "en")) > 200);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyScreenIsSpokenAndNoTwoAlikeButTheLongerMessage(String language) {
        Map<String, String> seen = new LinkedHashMap<>();
        screens().forEach((name, bench) -> {
            String spoken = new PanelBench(bench, Locale.forLanguageTag(language))
                    .find("lcd")
                    .getAccessibleContext()
                    .getAccessibleName();
            seen.put(spoken, name);
        });
        // A message scrolled is the same message; codec, key mode and a silenced ring are not spoken.
        assertEquals(screens().size() - 4, seen.size());
    }

    /** Nothing is written in a smaller size. How many lines a sentence takes depends on the system's fonts. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Hecho: #**20. Parado.|1|1",
                "Hecho: #**20. Parado en 1.200 0.500 m, rumbo 90.0.|2|3",
                "La orden no vale: se espera * o # en la tecla 12. Rango 1..99 cm.|2|3",
                "Choque tras 123 de 9999 cm. Choque en -12.345 -12.345 m, rumbo 271.4. Queda poca carga.|3|3"
            })
    void theWordsOfARobotTakeUpToThreeLinesOfOneSize(String reply, int least, int most) {
        LcdPen pen = new LcdPen(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics(), 1);
        double lines = 1 + LcdKeys.lift(pen, said(reply).snapshot().call()) / 12.5;
        assertTrue(lines >= least && lines <= most, lines + " lines");
    }

    private static Bench said(String reply) {
        Bench bench = Bench.connected();
        bench.handset.press(DtmfKey.sequence("** #**20 **"));
        bench.speechMillis(2_000);
        bench.farEndPlays('3');
        bench.farEndSays(SpokenLanguage.SPANISH, reply);
        return bench;
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyHintFitsTheDisplay(String language) {
        ResourceBundle bundle = ResourceBundle.getBundle(
                "simgsm.phone.messages", TextBundle.bundleLocale(Locale.forLanguageTag(language)));
        LcdPen pen = new LcdPen(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics(), 1);
        for (String key : bundle.keySet()) {
            if (key.startsWith("lcd.hint.") || key.startsWith("lcd.delivery.")) {
                double width =
                        pen.width(pen.sans(11, false), bundle.getString(key).replaceAll("\\{.*\\|1<", ""));
                assertTrue(width <= LcdPen.WIDTH - 2 * LcdPen.MARGIN, key + " is " + width + " wide");
            }
        }
    }

    /** Beside the number of a menu's row, or the widest value of a setting. */
    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyLabelFitsItsPlace(String language) {
        ResourceBundle bundle = ResourceBundle.getBundle(
                "simgsm.phone.messages", TextBundle.bundleLocale(Locale.forLanguageTag(language)));
        LcdPen pen = new LcdPen(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics(), 1);
        Map<String, String> settings = Map.of(
                "setting.language", "language.",
                "setting.ring", "ring.",
                "setting.theme", "theme.",
                "setting.codec", "codec.",
                "setting.keys", "keys.",
                "setting.length", "length.");
        double row = LcdPen.WIDTH - 2 * LcdPen.MARGIN - 4 - 18 - 6;
        for (String key : bundle.keySet()) {
            double label = pen.width(pen.sans(13.5, true), bundle.getString(key));
            if (key.startsWith("soft.")) {
                double width = pen.width(pen.sans(12.5, true), bundle.getString(key));
                assertTrue(width <= LcdPen.WIDTH / 2 - LcdPen.MARGIN - 2, key + " is " + width + " wide");
            } else if (settings.containsKey(key)) {
                String family = settings.get(key);
                double note = bundle.keySet().stream()
                        .filter(value -> value.startsWith(family))
                        .mapToDouble(value -> pen.width(pen.sans(12, false), bundle.getString(value)))
                        .max()
                        .orElseThrow();
                assertTrue(label + 6 + note <= row, key + " with its widest value is " + (label + 6 + note) + " wide");
            } else if (key.matches("(menu|option|service|forward|calls)\\..*")
                    && !bundle.getString(key).contains("{")) {
                assertTrue(label <= row, key + " is " + label + " wide");
            }
        }
    }

    @Test
    void theTwoLanguagesDiffer() {
        assertNotEquals(0, differences(picture(new Bench(), "en"), picture(new Bench(), "es")));
    }

    private static int differences(BufferedImage one, BufferedImage other) {
        int count = 0;
        for (int y = 0; y < one.getHeight(); y++) {
            for (int x = 0; x < one.getWidth(); x++) {
                count += one.getRGB(x, y) == other.getRGB(x, y) ? 0 : 1;
            }
        }
        return count;
    }

    @ParameterizedTest
    @CsvSource({
        "5550200, typed",
        "+5550200, typed",
        "*100#, code",
        "**21*5550101#, code",
        "**#, order",
        "**#**20**, order"
    })
    void theHintSaysWhatTheTypedKeysAreFor(String typed, String hint) {
        assertEquals(hint, LcdHome.hint(typed));
    }
}
