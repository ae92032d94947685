package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.Words;
import simgsm.sim.SimPhoneBook;
import simgsm.ss.SsError;
import simgsm.station.context.StationEvent;
import simgsm.station.context.UssdEnding;

/** What just happened, as the user is to read it. */
class HandsetLogTest {
    private static List<String> logged(Bench bench) {
        return bench.snapshot().log().stream()
                .map(entry -> shown(entry.words()))
                .toList();
    }

    private static String shown(Words words) {
        return words.arguments().stream()
                .map(argument -> argument instanceof Words inner ? shown(inner) : argument.toString())
                .collect(
                        Collectors.joining(" ", words.key() + (words.arguments().isEmpty() ? "" : " "), ""));
    }

    @Test
    void aCallWithAnOrderIsReportedFromItsBeginningToItsEnd() {
        Bench bench = new Bench();
        bench.phoneBook.write(1, new SimPhoneBook.Entry("5550200", "Robot"));
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.CalledPartyAlerted());
        bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550200"))));
        bench.farEndPlays('1');
        bench.handset.press(DtmfKey.sequence("**#**20**"));
        bench.speechMillis(2200);
        bench.farEndPlays('6');
        bench.farEndPlays('9');
        bench.handset.accept(new StationEvent.Released(Cause.NORMAL_CALL_CLEARING));
        assertEquals(
                List.of(
                        "log.calling Robot",
                        "log.alerting",
                        "log.connected Robot",
                        "log.tone 1 tone.1",
                        "log.keys **#**20**",
                        "log.tone 6 tone.6",
                        "log.tone.plain 9",
                        "log.released NORMAL_CALL_CLEARING normal call clearing"),
                logged(bench));
    }

    @Test
    void keysThatArePressedOneByOneAreOneEvent() {
        Bench bench = Bench.connected();
        for (PhoneKey key : new PhoneKey[] {PhoneKey.STAR, PhoneKey.STAR, PhoneKey.FIVE}) {
            bench.down(key);
            bench.speechMillis(100);
            bench.up(key);
            bench.speechMillis(100);
        }
        bench.farEndPlays('7');
        bench.down(PhoneKey.ONE);
        bench.speechMillis(100);
        bench.up(PhoneKey.ONE);
        bench.speechMillis(100);
        List<String> log = logged(bench);
        assertEquals(
                List.of("log.keys **5", "log.tone 7 tone.7", "log.keys 1"), log.subList(log.size() - 3, log.size()));
    }

    /** An endless row of keys, as a script or a stuck key makes it, must not become one endless line. */
    @Test
    void anEventHasAtMostSixtyFourKeysAndFurtherKeysBeginTheNext() {
        Bench bench = Bench.connected();
        int before = logged(bench).size();
        bench.handset.press(DtmfKey.sequence("1".repeat(2 * HandsetLog.MOST_KEYS + 1)));
        bench.speechMillis(200 * (2 * HandsetLog.MOST_KEYS + 1));
        List<String> log = logged(bench);
        String full = "log.keys " + "1".repeat(HandsetLog.MOST_KEYS);
        assertEquals(List.of(full, full, "log.keys 1"), log.subList(before, log.size()));
    }

    @Test
    void messagesAndCodesAreShown() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.ShortMessageReceived("5550200", "3 Done"));
        bench.handset.accept(new StationEvent.UssdReceived("your number: 5550100", false));
        assertEquals(List.of("log.sms 5550200 3 Done", "log.ussd your number: 5550100"), logged(bench));
    }

    @Test
    void aCodeWithoutAnAnswerIsReportedWithItsReasonUnlessTheUserEndedIt() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.UssdEnded(UssdEnding.CANCELLED, Optional.empty()));
        bench.handset.accept(new StationEvent.UssdEnded(UssdEnding.COMPLETED, Optional.empty()));
        bench.handset.accept(
                new StationEvent.UssdEnded(UssdEnding.REFUSED, Optional.of(SsError.UNEXPECTED_DATA_VALUE)));
        bench.handset.accept(new StationEvent.UssdEnded(UssdEnding.REFUSED, Optional.of(SsError.ILLEGAL_SS_OPERATION)));
        bench.handset.accept(new StationEvent.UssdEnded(UssdEnding.NO_SERVICE, Optional.empty()));
        bench.handset.accept(new StationEvent.UssdEnded(UssdEnding.NO_ANSWER, Optional.empty()));
        assertEquals(
                List.of(
                        "log.ussd-failed Note[kind=USSD_UNKNOWN, detail=]",
                        "log.ussd-failed Note[kind=USSD_REFUSED, detail=16]",
                        "log.ussd-failed Note[kind=USSD_NO_SERVICE, detail=]",
                        "log.ussd-failed Note[kind=USSD_NO_ANSWER, detail=]"),
                logged(bench));
    }

    @Test
    void theListStaysTheSameUntilTheNextEvent() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.ShortMessageReceived("5550200", "3 Done"));
        List<HandsetLog.Entry> before = bench.snapshot().log();
        bench.handset.accept(new StationEvent.StationChanged());
        assertSame(before, bench.snapshot().log());
    }

    @Test
    void theOldestEventsMakeRoomForNewOnes() {
        Bench bench = new Bench();
        for (int i = 0; i <= HandsetLog.CAPACITY; i++) {
            bench.handset.accept(new StationEvent.ShortMessageReceived("5550200", String.valueOf(i)));
        }
        List<String> log = logged(bench);
        assertEquals(HandsetLog.CAPACITY, log.size());
        assertEquals("log.sms 5550200 1", log.get(0));
    }
}
