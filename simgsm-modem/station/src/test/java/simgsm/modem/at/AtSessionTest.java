package simgsm.modem.at;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.timer.Timers;

/** The dialogue over a table of its own; the client's state is a list of what was done. */
class AtSessionTest {
    private static final String CTRL_Z = "\u001a";
    private static final String ESCAPE = "\u001b";

    private final Timers timers = new Timers();
    private final List<String> done = new ArrayList<>();
    private final StringBuilder output = new StringBuilder();
    private AtRequest pending;
    private final AtSession<List<String>> session = new AtSession<>(
            table(), done, timers, octets -> output.append(new String(octets, StandardCharsets.ISO_8859_1)));

    private AtCommandTable<List<String>> table() {
        AtCommandTable<List<String>> table = new AtCommandTable<>();
        table.add("E", "0|1", "echo")
                .execute((client, request) -> session.format().setEchoed(request.basicNumber(1) == 1));
        table.add("V", "0|1", "words")
                .execute((client, request) -> session.format().setInWords(request.basicNumber(1) == 1));
        table.add("Q", "0|1", "quiet")
                .execute((client, request) -> session.format().setQuiet(request.basicNumber(1) == 1));
        table.add("Z", "", "reset").execute((client, request) -> session.resetFormat());
        table.add("&V", "", "settings")
                .execute((client, request) -> request.line(session.format().describe()));
        table.add("+CMEE", "<mode>", "errors")
                .set((client, request) -> session.format()
                        .setErrorMode(request.parameters().atMost(1).number(0, 0, 2)))
                .read((client, request) -> request.answer(session.format().errorMode()))
                .test("(0-2)");
        table.add("+DO", "<what>", "notes what it is given")
                .set((client, request) -> client.add(request.parameters().text(0)));
        table.add("+WAIT", "", "ends later").executeFor((client, request) -> {
            pending = request;
            return AtResult.PENDING;
        });
        table.add("+EARLY", "", "ends before it returns").executeFor((client, request) -> {
            request.finish(AtResult.PENDING);
            request.finish(AtResult.BUSY);
            request.finish(AtResult.OK);
            return AtResult.PENDING;
        });
        table.add("+FAIL", "", "fails").execute((client, request) -> {
            throw new AtException(CmeError.NOT_FOUND);
        });
        table.add("+SMSFAIL", "", "fails").execute((client, request) -> {
            throw AtException.ofMessage(CmsError.MEMORY_FULL);
        });
        table.add("+TEXT", "<lines>", "takes a text")
                .setFor((client, request) ->
                        request.prompt(request.parameters().number(0, 0, 1) == 1, text -> taken(request, text)))
                .testWith((client, request) -> request.answer(AtRequest.quoted("now"), client.size()));
        return table;
    }

    private AtResult taken(AtRequest request, byte[] octets) throws AtException {
        String text = new String(octets, StandardCharsets.ISO_8859_1);
        if (text.equals("refused")) {
            throw AtException.ofMessage(CmsError.INVALID_TEXT_PARAMETER);
        }
        done.add(text);
        if (text.equals("early")) {
            request.finish(AtResult.NO_CARRIER);
            return AtResult.PENDING;
        }
        pending = request;
        return text.equals("later") ? AtResult.PENDING : AtResult.OK;
    }

    /** What comes back, with returns and line feeds as signs. */
    private String say(String octets) {
        session.received(octets.getBytes(StandardCharsets.ISO_8859_1));
        return heard();
    }

    private String heard() {
        String text = output.toString().replace("\r\n", "|").replace("\r", "!");
        output.setLength(0);
        return text;
    }

    /** Without echo from here on. */
    private void silent() {
        assertEquals("ATE0!|OK|", say("ATE0\r"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '>', quoteCharacter = '~', textBlock = """
            AT              > |OK|
            at              > |OK|
            A               > |ERROR|
            HELLO           > |ERROR|
            HAT             > |ERROR|
            +++AT           > |OK|
            ATX             > |ERROR|
            ATE2            > |ERROR|
            AT+NONE         > |ERROR|
            AT+CMEE         > |ERROR|
            AT+CMEE?        > |+CMEE: 0||OK|
            AT+CMEE=?       > |+CMEE: (0-2)||OK|
            AT+WAIT=?       > |OK|
            AT+TEXT=?       > |+TEXT: "now",0||OK|
            AT+CMEE=3       > |ERROR|
            AT+FAIL         > |ERROR|
            AT+CMEE=1;+FAIL > |+CME ERROR: 22|
            AT+CMEE=2;+FAIL > |+CME ERROR: not found|
            AT+SMSFAIL      > |+CMS ERROR: 322|
            AT+EARLY        > |BUSY|
            AT&V            > |E0 V1 Q0 +CMEE: 0||OK|
            ATV0+FAIL       > 4!
            ATV0            > 0!
            ATQ1            > ~~
            ATV0&V          > E0 V0 Q0 +CMEE: 0|0!
            """)
    void aLineHasOneResult(String line, String answer) {
        silent();
        assertEquals(answer, say(line + "\r"));
    }

    @Test
    void commandsAfterAFaultAreNotPerformed() {
        silent();
        assertEquals("|ERROR|", say("AT+DO=1;+FAIL;+DO=2\r"));
        assertEquals(List.of("1"), done);
    }

    @Test
    void charactersAreEchoedUntilTheyAreNot() {
        assertEquals("AT!|OK|", say("AT\r\n"));
        assertEquals("ATE0!|OK|", say("ATE0\r\n"));
        assertEquals("|OK|", say("AT\r\n"));
        assertEquals("|OK|", say("ATZ\r"));
        assertEquals("AT!|OK|", say("AT\r"));
    }

    @Test
    void aLineIsEditedAndRepeated() {
        silent();
        assertEquals("|OK|", say("AT+DO=12\b\u007f34\r"));
        assertEquals("|OK|", say("A/"));
        assertEquals("", say("AT+DO=5" + ESCAPE));
        assertEquals("", say("\r"));
        assertEquals(List.of("34", "34"), done);
    }

    @Test
    void aLineThatIsTooLongIsAnErrorAndTheNextIsNot() {
        silent();
        assertEquals("|OK|", say("AT+DO=7\r"));
        assertEquals("|ERROR|", say("AT+DO=" + "1".repeat(AtSession.MAX_LINE) + "\r"));
        assertEquals("|ERROR|", say("A/"), "not the line before it");
        assertEquals("|OK|", say("AT\r"));
        assertEquals(List.of("7"), done);
    }

    @Test
    void whatFollowsAPendingCommandWaitsForItsResult() {
        silent();
        assertEquals("", say("AT+WAIT;+DO=1\rAT+DO=2\r"));
        assertEquals(List.of(), done);
        assertFalse(pending.isOver());
        pending.finish(AtResult.OK);
        assertTrue(pending.isOver());
        assertEquals("|OK||OK|", heard());
        assertEquals(List.of("1", "2"), done);
        pending.finish(AtResult.ERROR);
        assertEquals("", heard());
    }

    @Test
    void aClientThatSendsTooMuchIsHeldBack() {
        say("AT+WAIT\r");
        assertTrue(session.wantsInput());
        say("x".repeat(16_384));
        assertFalse(session.wantsInput());
    }

    @Test
    void aPendingCommandEndsWithItsClient() {
        say("AT+WAIT\r");
        session.close();
        assertTrue(pending.isOver());
        pending.finish(AtResult.OK);
        session.report("+NEWS");
        assertEquals("", heard());
    }

    @Test
    void aTextEndsWithCtrlZ() {
        silent();
        assertEquals("|> ", say("AT+TEXT=0\r"));
        assertEquals(
                "abc\bd" + CTRL_Z + "|OK|",
                sayEchoed("abc\bd" + CTRL_Z),
                "oFono 1.31 takes its Ctrl-Z for the echo's end");
        assertEquals(List.of("abd"), done);
    }

    private String sayEchoed(String octets) {
        session.format().setEchoed(true);
        String answer = say(octets);
        session.format().setEchoed(false);
        return answer;
    }

    /** TS 27.005, 3.5.1, has one prompt, behind the command; Adafruit_FONA reads the answer behind a text of lines. */
    @Test
    void aTextOfLinesIsPromptedLineByLineWithEchoAndOnceWithoutIt() {
        silent();
        assertEquals("AT+TEXT=1!|> one|> two" + CTRL_Z + "|OK|", sayEchoed("AT+TEXT=1\rone\rtwo" + CTRL_Z));
        assertEquals("|> |OK|", say("AT+TEXT=1\rone\rtwo" + CTRL_Z));
        assertEquals("|> |OK|", say("AT+TEXT=0\rone\rtwo" + CTRL_Z));
        assertEquals(List.of("one\ntwo", "one\ntwo", "onetwo"), done);
    }

    @Test
    void escapeEndsATextWithoutTakingIt() {
        silent();
        assertEquals("|> |OK|", say("AT+TEXT=0\rabc" + ESCAPE));
        assertEquals(List.of(), done);
        assertEquals(0, timers.size());
    }

    @Test
    void aTextMayBeRefusedOrEndEarlyOrLater() {
        silent();
        assertEquals("|> |+CMS ERROR: 305|", say("AT+TEXT=0\rrefused" + CTRL_Z));
        assertEquals("|> |NO CARRIER|", say("AT+TEXT=0\rearly" + CTRL_Z));
        assertEquals("|> ", say("AT+TEXT=0\rlater" + CTRL_Z));
        pending.finish(AtResult.OK);
        assertEquals("|OK|", heard());
    }

    @Test
    void aTextIsCutAtItsLimit() {
        silent();
        say("AT+TEXT=0\r" + "x".repeat(AtSession.MAX_TEXT + 10) + CTRL_Z);
        assertEquals(AtSession.MAX_TEXT, done.get(0).length());
    }

    @Test
    void aPromptEndsSixtySecondsAfterTheLastCharacter() {
        silent();
        say("AT+TEXT=0\r");
        timers.advance(AtSession.PROMPT_NANOS - 1);
        say("a");
        timers.advance(2 * AtSession.PROMPT_NANOS - 2);
        assertEquals("", heard());
        timers.advance(2 * AtSession.PROMPT_NANOS - 1);
        assertEquals("|ERROR|", heard());
        assertEquals("|OK|", say("AT\r"));
    }

    @Test
    void aCodeBehindAnAnnouncementWaits500MillisecondsForTheNextCommand() {
        silent();
        session.announce("+CMTI: 1");
        session.announce("+CMTI: 2");
        session.report(AtResult.RING);
        assertEquals("|+CMTI: 1|", heard());
        assertEquals("", say("AT+WAIT\r"));
        timers.advance(HeldCodes.ANNOUNCED_NANOS);
        assertEquals("", heard());
        pending.finish(AtResult.OK);
        assertEquals("|OK||+CMTI: 2|", heard());
        assertEquals("|OK|", say("AT\r"));
        timers.advance(2 * HeldCodes.ANNOUNCED_NANOS - 1);
        assertEquals("|OK|", say("AT\r"));
        timers.advance(3 * HeldCodes.ANNOUNCED_NANOS - 2);
        assertEquals("", heard());
        timers.advance(3 * HeldCodes.ANNOUNCED_NANOS - 1);
        assertEquals("|RING|", heard());
    }

    @Test
    void aCodeBehindAnAnnouncementWaitsTwoSecondsAtMost() {
        silent();
        session.announce("+CMTI: 1");
        session.report(AtResult.RING);
        heard();
        for (long nanos = 0; nanos < HeldCodes.MOST_ANNOUNCED_NANOS; nanos += HeldCodes.ANNOUNCED_NANOS / 2) {
            timers.advance(nanos);
            assertEquals("|OK|", say("AT\r"));
        }
        timers.advance(HeldCodes.MOST_ANNOUNCED_NANOS);
        assertEquals("|RING|", heard());
    }

    @Test
    void aCodeBehindAnAnnouncementThatNoCommandFollowsWaits500Milliseconds() {
        silent();
        session.announce("+CMTI: 1");
        session.report(AtResult.RING);
        timers.advance(HeldCodes.ANNOUNCED_NANOS - 1);
        assertEquals("|+CMTI: 1|", heard());
        timers.advance(HeldCodes.ANNOUNCED_NANOS);
        assertEquals("|RING|", heard());
        session.announce("+CMTI: 2");
        session.report(AtResult.RING);
        assertEquals("|+CMTI: 2|", heard());
        say("A");
        timers.advance(2 * HeldCodes.ANNOUNCED_NANOS);
        assertEquals("", heard());
        assertEquals("|OK||RING|", say("T\r"));
    }

    @Test
    void codesThatBelongTogetherLeaveInOneWrite() {
        List<String> writes = new ArrayList<>();
        AtSession<List<String>> other = new AtSession<>(
                table(), done, timers, octets -> writes.add(new String(octets, StandardCharsets.ISO_8859_1)));
        other.reportTogether(() -> {
            other.report(AtResult.RING);
            other.report("+CLIP: 1");
        });
        assertEquals(List.of("\r\nRING\r\n\r\n+CLIP: 1\r\n"), writes);
    }

    @Test
    void newsWaitForTheResultOfACommand() {
        silent();
        session.report("+NEWS: 1");
        assertEquals("|+NEWS: 1|", heard());
        say("AT+WAIT\r");
        session.report(AtResult.RING);
        assertEquals("", heard());
        pending.finish(AtResult.OK);
        assertEquals("|OK||RING|", heard());
    }

    @Test
    void newsWaitTwoSecondsForAnIncompleteLineOrItsEnd() {
        silent();
        say("AT");
        session.report("+NEWS: 1");
        timers.advance(AtSession.INCOMPLETE_LINE_NANOS - 1);
        assertEquals("", heard());
        timers.advance(AtSession.INCOMPLETE_LINE_NANOS);
        assertEquals("|+NEWS: 1|", heard());
        session.report("+NEWS: 2");
        assertEquals("|OK||+NEWS: 2|", say("\r"));
        say("A");
        session.report("+NEWS: 3");
        assertEquals("|+NEWS: 3|", say("\b"));
    }

    @Test
    void ofTooManyNewsTheOldestAreDropped() {
        silent();
        say("AT+WAIT\r");
        for (int i = 0; i <= HeldCodes.MAX_HELD; i++) {
            session.report("+NEWS: " + i);
        }
        pending.finish(AtResult.OK);
        String heard = heard();
        assertTrue(heard.startsWith("|OK||+NEWS: 1|"), heard);
        assertTrue(heard.endsWith("|+NEWS: " + HeldCodes.MAX_HELD + "|"), heard);
    }

    @Test
    void aQuietClientHearsNoCodesButLines() {
        say("ATE0Q1\r");
        heard();
        session.report(AtResult.RING);
        session.report("+NEWS");
        assertEquals("|+NEWS|", heard());
    }

    @Test
    void aCommandStandsOnceInTheTable() {
        AtCommandTable<List<String>> table = table();
        assertThrows(IllegalArgumentException.class, () -> table.add("E", "", "again"));
        assertEquals(
                List.of("E", "V", "Q", "Z"),
                table.rows().stream().map(AtCommandTable.Row::name).limit(4).toList());
    }

    @Test
    void theTableIsItsOwnManual() {
        AtCommandTable<List<String>> table = new AtCommandTable<>();
        AtCommandTable.Row<List<String>> row = table.add("+XY", "0|1", "does x");
        row.execute((client, request) -> {}).read((client, request) -> {}).set((client, request) -> {});
        row.test("(0,1)");
        table.add("E", "<n>", "echo").execute((client, request) -> {});
        assertEquals("+XY", row.name());
        assertEquals("""
                - `AT+XY AT+XY? AT+XY=? AT+XY=0|1`: does x
                - `ATE<n>`: echo
                """, table.toMarkdown());
        assertEquals(Optional.empty(), table.handler(new AtCommand("E", AtCommand.Form.TEST, "")));
    }
}
