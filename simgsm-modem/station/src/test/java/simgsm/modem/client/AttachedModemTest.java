package simgsm.modem.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.CallDecision;
import simgsm.modem.ModemState;
import simgsm.modem.line.ModemLine;
import simgsm.octets.OctetString;
import simgsm.octets.Timestamp;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.MessageSplitter;
import simgsm.sms.SmsAddress;
import simgsm.sms.TpduCodec;
import simgsm.station.StationSnapshot;
import simgsm.station.call.MobileCallTable.MobileCallState;

class AttachedModemTest {
    private final ModemBench bench = new ModemBench();

    @Test
    void aModemIsPreparedStepByStepAndRegistered() {
        bench.ready();
        assertEquals(List.of("StationRegistered"), bench.news());
        assertEquals(List.of("AT", "ATE0", "ATV1", "AT+CMEE=1"), bench.sent.subList(0, 4));
        assertTrue(bench.sent.contains("AT+DDET=1,0,1"));
        StationSnapshot snapshot = bench.modem.snapshot();
        assertTrue(snapshot.registered());
        assertEquals("TestNet", snapshot.networkName());
        assertEquals(Optional.empty(), snapshot.codec());
    }

    @Test
    void aModemThatDoesNotAnswerIsCalledForAttentionAgainAndAgain() {
        bench.answers.put("AT", ModemBench.NO_ANSWER);
        bench.ready();
        assertTrue(bench.sent.size() > 1 && bench.sent.stream().allMatch("AT"::equals), bench.sent.toString());
        bench.answers.remove("AT");
        bench.millis(3000);
        assertTrue(bench.isReady());
    }

    @Test
    void aSimThatIsNotReadyIsAwaited() {
        bench.answers.put("AT+CPIN?", "+CPIN: SIM PIN|OK");
        bench.ready();
        assertFalse(bench.isReady());
        bench.answers.put("AT+CPIN?", "+CPIN: READY|OK");
        bench.millis(1500);
        assertTrue(bench.isReady());
    }

    @ParameterizedTest
    @CsvSource({
        "+CPIN: SIM PIN|OK, sim-pin +CPIN: SIM PIN",
        "+CPIN:SIM PUK|OK, sim-puk +CPIN:SIM PUK",
        "+CPIN: NOT INSERTED|OK, no-sim +CPIN: NOT INSERTED",
        "+CME ERROR: 10, no-sim +CME ERROR: 10",
        "+CME ERROR: 11, sim-pin +CME ERROR: 11",
        "+CME ERROR: 12, sim-puk +CME ERROR: 12",
    })
    void aSimThatHindersTheModemIsToldOnce(String answer, String state) {
        bench.answers.put("AT+CPIN?", answer);
        bench.ready();
        assertEquals(List.of(state), bench.states);
        bench.answers.put("AT+CPIN?", "+CPIN: READY|OK");
        bench.millis(1500);
        assertEquals(List.of(state, "ready TestNet"), bench.states);
        assertEquals(ModemState.READY, bench.modem.state().state());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "+CPINR: SIM PIN,3,3|+CPINR: SIM PUK,10,10|OK; OK; 1",
                "+CPINR: SIM PIN,2,3|OK; OK; 1",
                "+CPINR: SIM PIN,1,3|OK; OK; 0",
                "ERROR; +SPIC: 3,10,3,10|OK; 1",
                "ERROR; +SPIC: 1,10,3,10|OK; 0",
                "ERROR; ERROR; 0",
            })
    void aPinIsEnteredOnceAndNeverAsTheLastTry(String named, String counted, int entered) {
        bench.modem.setPin("1234");
        bench.answers.put("AT+CPIN?", "+CPIN: SIM PIN|OK");
        bench.answers.put("AT+CPINR", named);
        bench.answers.put("AT+SPIC", counted);
        bench.answers.put("AT+CPIN=\"1234\"", "+CME ERROR: 16");
        bench.ready();
        bench.millis(5000);
        assertEquals(
                entered, bench.sent.stream().filter("AT+CPIN=\"1234\""::equals).count());
        bench.answers.put("AT+CPIN?", "+CPIN: READY|OK");
        bench.millis(1500);
        assertEquals(List.of("sim-pin +CPIN: SIM PIN", "ready TestNet"), bench.states);
    }

    @Test
    void aBusySimIsAskedAgainWithoutAWord() {
        bench.answers.put("AT+CPIN?", "+CME ERROR: 14");
        bench.ready();
        assertEquals(List.of(), bench.states);
    }

    @Test
    void eachChangeOfTheModemsStateIsToldOnce() {
        bench.modem.lineFailed("no such file");
        bench.modem.lineFailed("no such file");
        bench.answers.put("AT+CREG?", "+CREG: 1,2|OK");
        bench.ready();
        bench.answers.put("AT+CREG?", "+CREG: 1,1|OK");
        bench.millis(1500);
        bench.answers.put("AT+CREG?", "+CREG: 1,0|OK");
        bench.millis(30_000);
        bench.answers.put("AT+CREG?", "+CREG: 1,5|OK");
        bench.millis(30_000);
        bench.answers.put("AT+CREG?", ModemBench.NO_ANSWER);
        bench.millis(36_000);
        bench.answers.put("AT+CREG?", "+CREG: 1,5|OK");
        bench.millis(8000);
        bench.modem.lineDown(bench.nowNanos);
        assertEquals(
                List.of(
                        "silent no such file",
                        "no-network +CREG: 1,2",
                        "ready TestNet",
                        "no-network +CREG: 1,0",
                        "ready TestNet",
                        "silent no answer to AT+CREG?",
                        "ready TestNet",
                        "silent the line is lost"),
                bench.states);
    }

    @Test
    void anAnswerWithoutItsFinalResultIsTakenAfterItsTime() {
        bench.answers.put("AT+CPIN?", "+CPIN: READY");
        bench.ready();
        assertFalse(bench.isReady());
        bench.millis(2000);
        assertTrue(bench.isReady());
    }

    @Test
    void aUsefulCommandWithoutAnswerIsLeftOut() {
        bench.answers.put("AT+COPS?", ModemBench.NO_ANSWER);
        bench.ready();
        bench.millis(5500);
        assertTrue(bench.isReady());
        assertEquals("", bench.modem.snapshot().networkName());
    }

    @Test
    void aModemThatFallsSilentInItsSetUpIsPreparedAnew() {
        bench.answers.put("AT+CREG?", ModemBench.NO_ANSWER);
        bench.modem.lineUp(0);
        bench.millis(1000);
        bench.answers.put("AT", ModemBench.NO_ANSWER);
        bench.millis(10_000);
        bench.answers.remove("AT");
        bench.answers.put("AT+CREG?", "+CREG: 1,5|OK");
        bench.millis(3000);
        assertTrue(bench.isReady());
        assertEquals(2, bench.sent.stream().filter("ATE0"::equals).count());
    }

    @Test
    void aCallRingsIsAnsweredAndEnds() {
        bench.ready().news();
        bench.inCall();
        assertEquals(List.of("ringing 5550100", "Connected", "tone 1"), bench.news());
        assertEquals(MobileCallState.ACTIVE, bench.modem.snapshot().callState());
        assertEquals(Optional.of(new Msisdn("5550100")), bench.modem.snapshot().peer());
        bench.say("+DTMF: 5,160", "+DTMF:*", "+DTMF: 1400");
        assertEquals(List.of("key 5 160.0", "KeyEnded", "key * 0.0", "KeyEnded"), bench.news());
        bench.say("NO CARRIER");
        assertEquals(List.of("released 16"), bench.news());
        assertEquals(MobileCallState.NULL, bench.modem.snapshot().callState());
    }

    @Test
    void keysWaitForTheAnswerThatIsDueAndAreDroppedWithTheCall() {
        bench.ready().inCall();
        bench.news();
        bench.answers.put("AT+CLCC", ModemBench.NO_ANSWER);
        bench.millis(600);
        bench.say("+DTMF: 1");
        assertEquals(List.of(), bench.news());
        bench.say("+CLCC: 1,1,0,0,0,\"5550100\",129", "OK");
        assertEquals(List.of("key 1 0.0", "KeyEnded"), bench.news());
        bench.millis(600);
        bench.say("+DTMF: 2");
        bench.millis(2500);
        assertEquals(List.of("released 41", "StationUnregistered"), bench.news());
    }

    @Test
    void linesThatCouldHaveBeenKeysAreReportedAndOthersAreNot() {
        bench.ready().inCall();
        bench.news();
        bench.say("+DTMF: 55", "#DTMFEV: ", "noise", "OK", "ERROR", "+CIEV: 1,2", "+CDS: 20", "070000");
        assertEquals(List.of("KeyUnreadable", "KeyUnreadable", "KeyUnreadable"), bench.news());
    }

    @Test
    void aCallThatTheListDoesNotHaveAnyMoreHasEnded() {
        bench.ready().inCall();
        bench.news();
        bench.answers.put("AT+CLCC", "OK");
        bench.millis(600);
        assertEquals(List.of("released 16"), bench.news());
    }

    @Test
    void aRingOfACallThatHasEndedIsNoCall() {
        bench.ready().news();
        bench.say("RING");
        bench.millis(2000);
        assertEquals(List.of(), bench.news());
    }

    @Test
    void aCallThatCannotBeTakenAnyMoreHasEnded() {
        bench.ready().news();
        bench.answers.put("AT+CLCC", "+CLCC: 1,1,4,0,0,\"5550100\",129|OK");
        bench.answers.put("ATA", "NO CARRIER");
        bench.say("RING");
        bench.millis(1700);
        assertEquals(List.of("ringing 5550100", "released 16"), bench.news());
    }

    @Test
    void aCallThatNoLongerRingsHasEnded() {
        ModemBench slow = new ModemBench(120_000);
        slow.ready().news();
        slow.answers.put("AT+CLCC", "+CLCC: 1,1,4,0,0,\"5550100\",129|OK");
        slow.say("RING");
        slow.millis(6000);
        slow.say("RING");
        slow.millis(6000);
        assertEquals(List.of("ringing 5550100"), slow.news());
        slow.millis(1500);
        assertEquals(List.of("released 16"), slow.news());
    }

    @Test
    void aCallerWithoutANumberIsUnknown() {
        bench.ready().news();
        bench.answers.put("AT+CLCC", "+CLCC: 1,1,4,0,0|OK");
        bench.say("+CRING: VOICE", "+CLIP: \"\",128");
        bench.millis(100);
        assertEquals(List.of("ringing "), bench.news());
    }

    @Test
    void aCallThatRingsDuringTheSetUpIsNotHungUp() {
        bench.answers.put("AT+CLCC", "+CLCC: 1,1,4,0,0,\"+34600111222\",145|OK");
        bench.ready();
        bench.millis(200);
        assertFalse(bench.sent.contains("ATH"));
        assertEquals(
                List.of("StationRegistered", "ringing 34600111222"),
                bench.news().subList(0, 2));
    }

    @Test
    void aDeniedCallHearsItsToneAndIsHungUp() {
        bench.decision = new CallDecision(false, DtmfKey.TWO);
        bench.ready().news();
        bench.inCall();
        assertTrue(bench.sent.contains("AT+VTS=2"));
        assertEquals(List.of("ringing 5550100", "tone 2", "released 16"), bench.news());
    }

    @Test
    void aToneThatIsRefusedIsReported() {
        bench.answers.put("AT+VTS=3", "ERROR");
        bench.ready().inCall();
        bench.news();
        assertTrue(bench.modem.sendTone(DtmfKey.THREE));
        bench.millis(500);
        assertEquals(List.of("ReplyToneFailed"), bench.news());
        assertTrue(bench.modem.hangUp());
        bench.millis(100);
        assertFalse(bench.modem.sendTone(DtmfKey.THREE));
        assertFalse(bench.modem.hangUp());
    }

    @Test
    void aModemThatHasRefusedToHangUpInItsSetUpIsAskedAgainAndGoesOn() {
        bench.answers.put("ATH", "ERROR");
        bench.answers.put("AT+CHUP", "ERROR");
        bench.ready().news();
        bench.sent.clear();
        bench.answers.put("AT+CLCC", "+CLCC: 1,1,4,0,0,\"5550100\",129|OK");
        bench.say("RING");
        bench.millis(1700);
        assertEquals(List.of("ringing 5550100", "released 16"), bench.news());
        assertEquals(Optional.of("ATH"), bench.lastSent());
        bench.say("+CMTI: \"SM\",3");
        bench.millis(50);
        assertTrue(bench.sent.contains("AT+CMGR=3"), bench.sent.toString());
    }

    @Test
    void aTextOfADamagedNumberIsReportedAllTheSame() {
        bench.answers.put("AT+CMGF=0", "ERROR");
        bench.ready().news();
        bench.answers.put("AT+CMGR=3", "+CMGR: \"REC UNREAD\",\"+12?4\",,\"26/11/22,08:00:00+00\"|** #*0 **|OK");
        bench.say("+CMTI: \"SM\",3");
        bench.millis(50);
        assertEquals(List.of("sms +12?4 ** #*0 **"), bench.news());
    }

    @Test
    void aNoticeToAModemWithoutAMessageFormatIsLeft() {
        bench.answers.put("AT+CMGF=0", "ERROR");
        bench.answers.put("AT+CMGF=1", "ERROR");
        bench.ready().news();
        bench.say("+CMTI: \"SM\",3");
        bench.millis(50);
        assertFalse(bench.sent.contains("AT+CMGR=3"));
    }

    @Test
    void anOrderUnderWayStopsTheMinute() {
        bench.ready().inCall();
        bench.news();
        bench.modem.setOrderUnderWay(true);
        bench.millis(70_000);
        assertEquals(List.of(), bench.news());
        bench.modem.setOrderUnderWay(false);
        bench.millis(59_000);
        assertEquals(List.of(), bench.news());
        bench.millis(1500);
        assertEquals(List.of("CallIdle", "released 16"), bench.news());
    }

    @Test
    void theEndOfTheProgramHangsUp() {
        bench.ready().inCall();
        bench.modem.closing();
        assertEquals(Optional.of("ATH"), bench.lastSent());
    }

    @Test
    void theLossOfTheNetworkIsReportedAndItsReturnToo() {
        bench.ready().news();
        bench.answers.put("AT+CREG?", "+CREG: 1,2|OK");
        bench.say("+CREG: 2");
        bench.millis(50);
        assertEquals(List.of("StationUnregistered"), bench.news());
        bench.answers.put("AT+CREG?", "+CREG: 1,1|OK");
        bench.millis(30_000);
        assertEquals(List.of("StationRegistered"), bench.news());
    }

    @Test
    void aMessageOfManyPartsIsSentPartByPart() {
        bench.answers.put("AT+CMGF=1", "ERROR");
        bench.ready().news();
        prompt();
        int id = bench.modem.reply(new Msisdn("5550100"), "x".repeat(200));
        bench.millis(50);
        bench.say("+CMGS: 1", "OK");
        prompt();
        bench.millis(50);
        bench.say("+CMGS: 2", "OK");
        bench.millis(50);
        assertEquals(List.of("sent " + id + " 2"), bench.news());
    }

    /** Every CMGS is answered by a prompt, and its text by nothing. */
    private void prompt() {
        for (int octets = 10; octets < 180; octets++) {
            bench.answers.put("AT+CMGS=" + octets, "> ");
        }
        bench.answers.replaceAll((command, answer) -> command.matches("00[0-9A-F]+") ? ModemBench.NO_ANSWER : answer);
    }

    @Test
    void aRefusedMessageFailsWithTheNetworksCauseAndOneWithoutServiceWaits() {
        bench.ready().news();
        for (int octets = 10; octets < 30; octets++) {
            bench.answers.put("AT+CMGS=" + octets, "+CMS ERROR: 28");
        }
        int first = bench.modem.reply(new Msisdn("5550100"), "3 Done");
        bench.millis(50);
        assertEquals(List.of("failed " + first + " 28"), bench.news());
        bench.answers.replaceAll((command, answer) -> command.startsWith("AT+CMGS") ? "+CMS ERROR: 331" : answer);
        int second = bench.modem.reply(new Msisdn("5550100"), "3 Done");
        bench.millis(31_000);
        assertEquals(List.of(), bench.news());
        bench.answers.replaceAll((command, answer) -> command.startsWith("AT+CMGS") ? "+CMGS: 7|OK" : answer);
        bench.millis(30_000);
        assertEquals(List.of("sent " + second + " 1"), bench.news());
    }

    @ParameterizedTest
    @ValueSource(ints = {41, 500, 512})
    void aMessageThatIsRefusedWithoutALastingCauseIsTriedThreeTimesWithPauses(int error) {
        bench.ready().news();
        for (int octets = 10; octets < 30; octets++) {
            bench.answers.put("AT+CMGS=" + octets, "+CMS ERROR: " + error);
        }
        int first = bench.modem.reply(new Msisdn("5550100"), "3 Done");
        bench.millis(35_000);
        assertEquals(List.of(), bench.news());
        bench.millis(30_000);
        assertEquals(List.of("failed " + first + " 41"), bench.news());
        assertEquals(
                3,
                bench.sent.stream()
                        .filter(command -> command.startsWith("AT+CMGS"))
                        .count());
    }

    @Test
    void aMessageThatWaitedInTheModemFromBeforeTheStartIsErasedAndNotReported() {
        store(1, "62112212000000", "Hi there");
        store(2, "62111232000000", "** #**20 **");
        bench.ready();
        assertEquals(List.of("StationRegistered", "sms 34600111222 Hi there"), bench.news());
        assertTrue(bench.sent.contains("AT+CMGD=2"));
    }

    /** @param stamp of the service centre, digits swapped */
    private void store(int index, String stamp, String text) {
        DeliverTpdu deliver = new DeliverTpdu(
                false,
                false,
                false,
                SmsAddress.of(new Msisdn("34600111222")),
                0,
                new Timestamp(OctetString.ofHex(stamp)),
                MessageSplitter.split(text, 1).get(0));
        String pdu = "00" + TpduCodec.encode(deliver);
        bench.answers.merge(
                "AT+CMGL=4", "+CMGL: " + index + ",0,,24|" + pdu + "|OK", (one, two) -> one.replace("|OK", "|") + two);
        bench.answers.put("AT+CMGR=" + index, "+CMGR: 1,,24|" + pdu + "|OK");
    }

    @Test
    void aMessageThatFindsNoModemFailsAfter10Minutes() {
        int id = bench.modem.reply(new Msisdn("5550100"), "3 Done");
        bench.millis(600_000);
        bench.ready();
        assertTrue(bench.news().contains("failed " + id + " 38"));
    }

    @Test
    void aMessageThatIsNotStoredIsReadFromItsNotice() {
        bench.ready().news();
        DeliverTpdu deliver = new DeliverTpdu(
                false,
                false,
                false,
                SmsAddress.of(new Msisdn("34600111222")),
                0,
                new Timestamp(OctetString.ofHex("62112261000000")),
                MessageSplitter.split("** #*0 **", 1).get(0));
        bench.say("+CMT: ,24", "00" + TpduCodec.encode(deliver));
        assertEquals(List.of("sms 34600111222 ** #*0 **"), bench.news());
        bench.say("+CMT: ,24", "nonsense");
        bench.millis(50);
        assertEquals(List.of(), bench.news());
    }

    @Test
    void aMessageThatIsReadDifferentlyEachTimeIsLeft() {
        bench.ready().news();
        bench.say("+CMTI: \"SM\",3");
        for (int reading = 0; reading < 6; reading++) {
            bench.answers.put("AT+CMGR=3", "+CMGR: 1,,20|0791" + reading + "|OK");
            bench.millis(10);
        }
        assertFalse(bench.sent.contains("AT+CMGD=3"));
        assertEquals(List.of(), bench.news());
    }

    @Test
    void aSecondCallIsRefusedWhileOneStands() {
        bench.ready().inCall();
        bench.say("+CCWA: \"5550101\",129,1");
        bench.millis(20);
        assertTrue(bench.sent.contains("AT+CHLD=0"));
    }

    @Test
    void aModemThatStartsAgainIsPreparedAnew() {
        bench.ready().news();
        bench.say("RDY");
        assertEquals(List.of("StationUnregistered"), bench.news());
        bench.say("+CFUN: 1", "+CPIN: READY", "Call Ready");
        bench.millis(2000);
        assertEquals(List.of("StationRegistered"), bench.news());
        bench.modem.lineDown(bench.nowNanos);
        assertEquals(List.of("StationUnregistered"), bench.news());
        assertFalse(bench.modem.snapshot().linkUp());
        assertEquals(ModemLine.NO_DEADLINE, bench.modem.nextDeadlineNanos());
    }
}
