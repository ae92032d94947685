package simgsm.phone;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.Bench;
import simgsm.phone.handset.FakeStation;
import simgsm.phone.handset.Handset;
import simgsm.phone.handset.HandsetEvent;
import simgsm.phone.screen.KeyMode;
import simgsm.speech.AudioOutput;
import simgsm.station.context.StationEvent;

/** The console's contract: every command and event, word for word. */
class PhoneConsoleTest {
    private static final Msisdn ROBOT = new Msisdn("5550200");

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final Console console = new Console(new PrintStream(bytes, false, StandardCharsets.UTF_8));
    private final FakeStation station = new FakeStation();
    private final Handset handset;
    private final PhoneEventPrinter printer = new PhoneEventPrinter(console, PhoneTexts.in(Locale.ENGLISH));

    PhoneConsoleTest() {
        handset = Bench.handset(KeyMode.IN_BAND, printer, AudioOutput.SILENT);
        station.reportTo(handset::accept);
        handset.attach(station);
        console.ready(Event.of("ready"));
        bytes.reset();
    }

    private List<String> lines() {
        return bytes.toString(StandardCharsets.UTF_8).lines().toList();
    }

    private List<String> after(String... commands) throws IOException, InterruptedException {
        var input = new BufferedReader(new StringReader(String.join("\n", commands)));
        console.run(input, new PhoneCommands(console, new Direct()));
        return lines();
    }

    /** The test's thread is the owner thread. */
    private final class Direct implements HandsetAccess {
        @Override
        public <T> T ask(Function<Handset, T> act) {
            return act.apply(handset);
        }

        @Override
        public boolean settle(long boundNanos) {
            AtomicBoolean isSettled = new AtomicBoolean();
            handset.whenSettled(() -> {
                isSettled.set(true);
                console.emit(Event.of("settled"));
            });
            return isSettled.get();
        }
    }

    @Test
    void anEndWithoutTheNetworksAnswerIsAFailedRun() throws Exception {
        new PhoneCommands(console, new Direct()).finish();
        assertEquals(ExitStatus.OK, console.exitStatus());
        after("sms 5550200 hi");
        new PhoneCommands(console, new Direct()).finish();
        assertEquals(ExitStatus.FAILED, console.exitStatus());
    }

    @Test
    void aCallAsTheConsoleTellsIt() throws Exception {
        after("dial 5550200");
        handset.accept(new StationEvent.CalledPartyAlerted());
        handset.accept(new StationEvent.Connected(Optional.of(ROBOT)));
        assertEquals(
                List.of(
                        "calling number=5550200",
                        "alerting",
                        "connected number=5550200",
                        "released cause=16 text=\"normal call clearing\""),
                after("hangup"));
    }

    @Test
    void refusedKeysAreAnError() {
        handset.accept(new StationEvent.KeysRefused(Cause.SERVICE_NOT_AVAILABLE));
        assertEquals(
                List.of("error text=\"press: the network refuses the keys , cause 63,"
                        + " service or option not available, unspecified\""),
                lines());
    }

    @Test
    void anIncomingCallIsAnswered() throws Exception {
        station.ring("5550101");
        assertEquals(List.of("ringing from=5550101", "connected number=5550200"), after("answer"));
    }

    @Test
    void aCallerWithoutANumberIsAnEmptyString() {
        handset.accept(new StationEvent.Ringing(Optional.empty()));
        assertEquals(List.of("ringing from=\"\""), lines());
    }

    @Test
    void registrationIsReportedWithTheNetworksCauseIfThereIsOne() {
        handset.accept(new StationEvent.StationRegistered(new Msisdn("5550100")));
        handset.accept(new StationEvent.StationUnregistered(Optional.empty()));
        handset.accept(new StationEvent.StationUnregistered(Optional.of(RejectCause.ILLEGAL_MS)));
        assertEquals(List.of("registered number=5550100", "unregistered", "unregistered cause=3"), lines());
    }

    @Test
    void keysArePressedWithBlanksIgnored() throws Exception {
        after("dial 5550200");
        handset.accept(new StationEvent.Connected(Optional.of(ROBOT)));
        after("press ** #**20 **");
        for (int i = 0; i < 100; i++) {
            handset.fillFrame(new short[160]);
        }
        assertEquals("sent keys=**#**20**", lines().get(2));
    }

    @ParameterizedTest
    @CsvSource({
        "1, connection accepted",
        "2, connection denied",
        "3, executed",
        "4, collision",
        "5, infinite loop",
        "6, executing",
        "7, not a valid command",
        "8, not possible in this status"
    })
    void aToneIsReportedWithItsMeaning(char key, String meaning) {
        printer.accept(new HandsetEvent.ToneHeard(DtmfKey.of(key)));
        String quoted = meaning.contains(" ") ? "\"" + meaning + "\"" : meaning;
        assertEquals(List.of("tone key=" + key + " meaning=" + quoted), lines());
    }

    @Test
    void aToneWithoutAMeaningHasAnEmptyOne() {
        printer.accept(new HandsetEvent.ToneHeard(DtmfKey.NINE));
        assertEquals(List.of("tone key=9 meaning=\"\""), lines());
    }

    @Test
    void meaningsSpeakTheConsolesLanguage() {
        new PhoneEventPrinter(console, PhoneTexts.in(Locale.forLanguageTag("es")))
                .accept(new HandsetEvent.ToneHeard(DtmfKey.FOUR));
        assertEquals(List.of("tone key=4 meaning=choque"), lines());
    }

    @Test
    void everyCauseIsReportedByNumberAndName() {
        printer.accept(new StationEvent.Released(Cause.USER_BUSY));
        printer.accept(new StationEvent.Released(Cause.TEMPORARY_FAILURE));
        assertEquals(
                List.of("released cause=17 text=\"user busy\"", "released cause=41 text=\"temporary failure\""),
                lines());
    }

    @Test
    void shortMessagesAreReportedFieldByField() {
        printer.accept(new StationEvent.MessageSent(7, ROBOT, 2));
        printer.accept(new StationEvent.MessageFailed(7, ROBOT, RpCause.UNASSIGNED_NUMBER));
        printer.accept(new StationEvent.MessageDelivered(256 + 7, ROBOT));
        printer.accept(new StationEvent.ShortMessageReceived("5550200", "3 Done: #**20."));
        printer.accept(new StationEvent.BroadcastReceived(50, 1, "hello"));
        assertEquals(
                List.of(
                        "sms-sent to=5550200 parts=2 id=7",
                        "sms-failed to=5550200 cause=1 text=\"unassigned number\"",
                        "sms-delivered to=5550200 id=7",
                        "sms from=5550200 text=\"3 Done: #**20.\"",
                        "broadcast channel=50 pages=1 text=hello"),
                lines());
    }

    @Test
    void aTextStandsBareOrAsAJsonString() throws Exception {
        after("sms 5550200 ** #**20 **", "sms 5550200 \"two\\nlines \\u00e9\"");
        assertEquals(List.of("sms 5550200 ** #**20 **", "sms 5550200 two\nlines \u00e9"), station.asked);
    }

    @Test
    void theInboxIsListedAndClosed() throws Exception {
        handset.accept(new StationEvent.ShortMessageReceived("5550200", "3 Done"));
        bytes.reset();
        assertEquals(
                List.of(
                        "message from=5550200 text=\"3 Done\" read=false",
                        "end of=inbox count=1",
                        "message from=5550200 text=\"3 Done\" read=true",
                        "end of=inbox count=1"),
                after("inbox", "inbox"));
    }

    @Test
    void anEmptyInboxIsClosedAtOnce() throws Exception {
        assertEquals(List.of("end of=inbox count=0"), after("inbox"));
    }

    @Test
    void memoryAndChannelsAreTheStations() throws Exception {
        assertEquals(List.of(), after("memory full", "memory free", "channels 50, 919-921", "channels none"));
        assertEquals(List.of("memory full", "memory free", "channels 50,919-921", "channels none"), station.asked);
    }

    @Test
    void aMessageThatIsGivenUpIsReportedWithItsStatus() throws Exception {
        after("sms 5550200 hello");
        handset.accept(new StationEvent.MessageSent(0, ROBOT, 1));
        handset.accept(new StationEvent.MessageUndelivered(0, ROBOT, 0x46));
        assertEquals(
                List.of(
                        "sms-sent to=5550200 parts=1 id=0",
                        "sms-undelivered to=5550200 id=0 status=70 text=\"validity period expired\""),
                lines());
    }

    @Test
    void powerGoesOffAndOn() throws Exception {
        after("power off");
        assertEquals(false, station.snapshot().powered());
        after("power on");
        assertEquals(true, station.snapshot().powered());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "dial | expected dial NUMBER",
                "dial 5550200 5550201 | expected dial NUMBER",
                "dial abc | dial: expected a telephone number of 1 to 15 digits, found abc",
                "dial 1234567890123456 | dial: expected a telephone number of 1 to 15 digits, found 1234567890123456",
                "answer now | expected nothing after it",
                "answer | no call rings",
                "hangup | there is no call",
                "press 5 | there is no call",
                "press | expected press KEYS",
                "press 12x | press: expected one of 0123456789*#ABCD, found x",
                "sms | expected sms NUMBER TEXT",
                "sms 5550200 | found no text",
                "sms robot hello | sms: expected a telephone number of 1 to 15 digits, found robot",
                "sms 5550200 \"open | a closing",
                "sms 5550200 \"a\" b | nothing may follow",
                "sms 5550200 \"\" | the message has no text",
                "inbox all | expected nothing after it",
                "power | expected power on or power off",
                "power up | expected on or off, found up",
                "memory | expected memory full or memory free",
                "memory half | memory: expected full or free, found half",
                "channels | channels: expected all, none, or channels",
                "channels 50,x | 50,919,4370-4399, found x",
                "jump | unknown command jump, expected dial",
            })
    void aMalformedLineIsAnErrorThatSaysWhatWasExpected(String command, String expected) throws Exception {
        List<String> lines = after(command);
        assertEquals(1, lines.size());
        assertTrue(lines.get(0).startsWith("error text="), lines.get(0));
        assertTrue(lines.get(0).contains(expected), lines.get(0));
        assertEquals(0, console.exitStatus());
    }

    @Test
    void diallingInACallIsAnErrorAndTheProgramGoesOn() throws Exception {
        assertEquals(
                List.of(
                        "calling number=5550200",
                        "error text=\"dial: a call is under way; hang up first\"",
                        "end of=inbox count=0"),
                after("dial 5550200", "dial 5550201", "inbox"));
    }

    @Test
    void blankLinesAreNothing() throws Exception {
        assertEquals(List.of(), after("", "   "));
    }

    @Test
    void theEndWaitsForQueuedKeys() throws Exception {
        after("dial 5550200");
        handset.accept(new StationEvent.Connected(Optional.of(ROBOT)));
        after("press 1");
        new PhoneCommands(console, new Direct()).finish();
        for (int i = 0; i < 5; i++) {
            handset.fillFrame(new short[160]);
        }
        assertEquals(List.of("sent keys=1", "settled"), lines().subList(2, 4));
    }
}
