package simgsm.modem.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.dtmf.DtmfKey;
import simgsm.timer.Timers;

class CommandDialogueTest implements CommandDialogue.Listener {
    private final Timers timers = new Timers();
    private final StringBuilder sent = new StringBuilder();
    private final List<String> heard = new ArrayList<>();
    private final CommandDialogue dialogue = new CommandDialogue(timers, sent::append, this);

    @Override
    public void unsolicited(String line) {
        heard.add("code " + line);
    }

    @Override
    public void body(String line) {
        heard.add("body " + line);
    }

    @Override
    public void unreadable(String line) {
        heard.add("unreadable " + line);
    }

    @Override
    public void stalled(ModemCommand command) {
        heard.add("stalled " + command.text());
    }

    private void received(String octets) {
        dialogue.received(octets.getBytes(StandardCharsets.ISO_8859_1));
    }

    private void ask(ModemCommand command) {
        dialogue.send(command, answer -> heard.add(command.text() + " -> " + answer.ending() + " " + answer.text()));
    }

    @Test
    void oneCommandIsSentAtATimeAndAnUrgentOneBeforeThoseThatWait() {
        ask(ModemCommand.of("AT+A"));
        ask(ModemCommand.of("AT+B"));
        dialogue.sendFirst(ModemCommand.of("AT+C"), answer -> heard.add("first"));
        assertEquals("AT+A\r", sent.toString());
        received("OK\r\nOK\r\n\r\n+CME ERROR: 30\r\n");
        assertEquals("AT+A\rAT+C\rAT+B\r", sent.toString());
        assertEquals(List.of("AT+A -> OK OK", "first", "AT+B -> REFUSED +CME ERROR: 30"), heard);
        assertTrue(dialogue.isIdle());
    }

    @Test
    void echoAndHalfLinesAreNoAnswersAndCodesAreDistinguished() {
        ask(ModemCommand.query("AT+CLCC", "+CLCC:"));
        received("AT+CLCC\r\r\n+CL");
        received("CC: 1,1,0\r\n\r\nRI");
        received("NG\r\n+CMTI: \"SM\",4\r\nwhat\u0000\r\nOK\r");
        assertEquals(
                List.of(
                        "code RING",
                        "code +CMTI: \"SM\",4",
                        "unreadable what" + LineFramer.NOISE,
                        "AT+CLCC -> OK +CLCC: 1,1,0 OK"),
                heard);
    }

    @Test
    void aModemMayNameTheCommandInItsAnswer() {
        ask(ModemCommand.of("AT+CVHU=0"));
        received("+CVHU: (0-1)\r\n+CVH: 5\r\nOK\r\n");
        assertEquals(List.of("unreadable +CVH: 5", "AT+CVHU=0 -> OK OK"), heard);
    }

    @Test
    void aBodyIsNoCodeAndNoAnswer() {
        ask(ModemCommand.of("AT"));
        received("+CDS: 5\r\nRING\r\nOK\r\n");
        assertEquals(List.of("code +CDS: 5", "body RING", "AT -> OK OK"), heard);
    }

    @Test
    void theListingOfAMessageHasItsBody() {
        ask(ModemCommand.listing("AT+CMGR=1", "+CMGR:"));
        received("0791\r\n+CMGR: 1,,20\r\n0791\r\n+DTMF: 5\r\nOK\r\n");
        assertEquals(List.of("unreadable 0791", "code +DTMF: 5", "AT+CMGR=1 -> OK +CMGR: 1,,20 0791 OK"), heard);
    }

    @Test
    void aPromptIsAnsweredByTheTextAndItsEchoDropped() {
        ask(ModemCommand.prompting("AT+CMGS=5", "00AABB", "+CMGS:"));
        received("AT+CMGS=5\r\r\n> ");
        assertEquals("AT+CMGS=5\r00AABB\u001a", sent.toString());
        received("00AABB\u001a\r\n+CMGS: 12\r\n\r\nOK\r\n");
        assertEquals(List.of("AT+CMGS=5 -> OK +CMGS: 12 OK"), heard);
    }

    @Test
    void aCommandWithoutAnAnswerEndsTheDialogueAndLeavesThePrompt() {
        ask(ModemCommand.prompting("AT+CMGS=5", "00AABB", "+CMGS:"));
        ask(ModemCommand.of("AT+B"));
        timers.advance(61_000_000_000L);
        assertEquals(
                List.of("AT+B -> LOST connection lost", "stalled AT+CMGS=5", "AT+CMGS=5 -> TIMED_OUT no answer"),
                heard);
        assertEquals("AT+CMGS=5\r\u001b", sent.toString());
        received("OK\r\nERROR\r\n");
        assertEquals(3, heard.size(), "late results belong to nothing");
    }

    @Test
    void theEndOfACallIsAResultOnlyOfCommandsAboutCalls() {
        ask(ModemCommand.ofCall("ATA"));
        received("NO CARRIER\r\n");
        ask(ModemCommand.free("AT+CGMI"));
        received("NO CARRIER\r\nACME \u00a9\r\nOK\r\n");
        assertEquals(List.of("ATA -> REFUSED NO CARRIER", "code NO CARRIER", "AT+CGMI -> OK ACME \u00a9 OK"), heard);
    }

    @Test
    void aLineThatIsTooLongIsCut() {
        received("x".repeat(5000) + "\r\n");
        assertEquals(
                "unreadable ".length() + LineFramer.MAX_CHARACTERS, heard.get(0).length());
    }

    @ParameterizedTest
    @CsvSource({
        "+DTMF: 5, 5, -1",
        "+DTMF:#, #, -1",
        "'+DTMF: 5,160', 5, 160",
        "+RXDTMF: *, *, -1",
        "'#DTMFEV: 9,1', 9, -1",
        "+QTONEDET: 42, *, -1",
        "+UUDTMFD: d, D, -1"
    })
    void reportsOfKeysAreRead(String line, char key, int millis) {
        DtmfDialect.Report report =
                DtmfDialect.ofReport(line).orElseThrow().read(line).orElseThrow();
        assertEquals(Optional.of(DtmfKey.of(key)), report.key());
        assertEquals(millis < 0 ? OptionalInt.empty() : OptionalInt.of(millis), report.millis());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "+DTMF: ",
                "+DTMF: 55",
                "+DTMF: 5,",
                "+DTMF: 5x",
                "+QTONEDET: 5",
                "+QTONEDET: 99",
                "+UUDTMFD: 5 5"
            })
    void damagedReportsAreNot(String line) {
        assertEquals(Optional.empty(), DtmfDialect.ofReport(line).orElseThrow().read(line));
    }

    @Test
    void theModemsOwnDialectIsEnabledFirst() {
        assertEquals(
                "AT#DTMF=1",
                SetupStep.KEYS.alternatives("Telit Cinterion").get(0).text());
        assertEquals("AT+DDET=1,0,1", SetupStep.KEYS.alternatives("ACME").get(0).text());
        assertEquals(6, SetupStep.KEYS.alternatives("Quectel").size());
    }

    @Test
    void codesAreWholeWords() {
        assertEquals(Optional.of(UnsolicitedCode.RING), UnsolicitedCode.of("RING"));
        assertEquals(Optional.empty(), UnsolicitedCode.of("RINGING"));
        assertEquals(Optional.of(UnsolicitedCode.NEWS), UnsolicitedCode.of("^RSSI: 20"));
        assertEquals(Optional.of(UnsolicitedCode.CALL_ENDED), UnsolicitedCode.of("VOICE CALL: END: 000012"));
    }
}
