package simgsm.center.records;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.call.CallProgress;

class DetailRecordsTest {
    private static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");

    @TempDir
    Path folder;

    private final List<String> lines = new ArrayList<>();
    private Instant now = NOON;
    private Duration setAhead = Duration.ZERO;
    private final DetailRecords records = new DetailRecords(
            () -> now.plus(setAhead), () -> Duration.between(NOON, now).toNanos(), detail -> lines.add(detail.line()));

    private void call(long id, CallProgress state, Optional<Cause> cause) {
        records.accept(new ExchangeEvent.CallChanged(id, new Msisdn("5550100"), new Msisdn("5550200"), state, cause));
    }

    private static DetailRecord message(String from, Instant ended) {
        return new DetailRecord(
                DetailRecord.Type.MESSAGE,
                7,
                from,
                "5550200",
                "app",
                NOON,
                Optional.empty(),
                ended,
                Duration.ZERO,
                "delivered",
                Optional.empty());
    }

    @Test
    void anAnsweredCallHasItsTimesAndTheSecondsSinceTheAnswer() {
        call(1, CallProgress.INITIATED, Optional.empty());
        now = NOON.plusMillis(1500);
        call(1, CallProgress.ACTIVE, Optional.empty());
        now = NOON.plusMillis(63_750);
        call(1, CallProgress.RELEASED, Optional.of(Cause.NORMAL_CALL_CLEARING));

        assertEquals(
                List.of("call,1,5550100,5550200,,2026-11-21T12:00:00Z,2026-11-21T12:00:01.500Z,"
                        + "2026-11-21T12:01:03.750Z,62.250,answered,16"),
                lines);
    }

    @Test
    void theSecondsOfACallInWhichTheClockIsSetAreThoseThatHavePassed() {
        call(1, CallProgress.INITIATED, Optional.empty());
        call(1, CallProgress.ACTIVE, Optional.empty());
        now = NOON.plusSeconds(5);
        setAhead = Duration.ofHours(-3);
        call(1, CallProgress.RELEASED, Optional.of(Cause.NORMAL_CALL_CLEARING));

        assertEquals(
                List.of("call,1,5550100,5550200,,2026-11-21T12:00:00Z,2026-11-21T12:00:00Z,2026-11-21T09:00:05Z,"
                        + "5.000,answered,16"),
                lines);
    }

    @Test
    void twoCallsOfOnePairAtOnceAreTwoRecords() {
        call(1, CallProgress.INITIATED, Optional.empty());
        call(2, CallProgress.INITIATED, Optional.empty());
        now = NOON.plusSeconds(1);
        call(2, CallProgress.RELEASED, Optional.of(Cause.USER_BUSY));
        call(1, CallProgress.RELEASED, Optional.of(Cause.CALL_REJECTED));

        assertEquals(
                List.of(
                        "call,2,5550100,5550200,,2026-11-21T12:00:00Z,,2026-11-21T12:00:01Z,0.000,refused,17",
                        "call,1,5550100,5550200,,2026-11-21T12:00:00Z,,2026-11-21T12:00:01Z,0.000,refused,21"),
                lines);
    }

    @Test
    void aNameWithACommaIsQuotedAndAFormulaIsMadeText() {
        assertTrue(message("Smith, \"Ada\"", NOON).line().startsWith("message,7,\"Smith, \"\"Ada\"\"\",5550200,app,"));
        assertTrue(message("=1+1", NOON).line().startsWith("message,7,'=1+1,"));
        assertTrue(message("+1+1", NOON).line().startsWith("message,7,'+1+1,"));
        assertTrue(message("\t=1", NOON).line().startsWith("message,7,'\\t=1,"));
        assertTrue(message("\r=1", NOON).line().startsWith("message,7,'\\r=1,"));
    }

    @Test
    void aNameWithEndsOfLinesStaysInOneLine() {
        String line = message("a\r\nmessage,8\u2028\u001b[31m", NOON).line();

        assertTrue(line.startsWith("message,7,\"a\\r\\nmessage,8\\u2028\\u001b[31m\",5550200,app,"), line);
    }

    @Test
    void eachDayHasItsFileAndAFileIsContinued() throws IOException {
        try (RecordFiles files = RecordFiles.in(folder)) {
            files.add(message("1", NOON));
            files.add(message("2", NOON.plusSeconds(86_400)));
        }
        try (RecordFiles files = RecordFiles.in(folder)) {
            files.add(message("3", NOON));
        }

        List<String> first = Files.readAllLines(RecordFiles.file(folder, LocalDate.of(2026, 11, 21)));
        assertEquals(3, first.size());
        assertEquals(DetailRecord.HEADER, first.get(0));
        assertTrue(first.get(1).startsWith("message,7,1,") && first.get(2).startsWith("message,7,3,"));
        assertEquals(
                2,
                Files.readAllLines(RecordFiles.file(folder, LocalDate.of(2026, 11, 22)))
                        .size());
    }

    @Test
    void aFileThatCannotBeWrittenCostsItsOwnRecordOnly() throws IOException {
        Files.createDirectory(RecordFiles.file(folder, LocalDate.of(2026, 11, 20)));
        try (RecordFiles files = RecordFiles.in(folder)) {
            files.add(message("1", NOON));
            files.add(message("2", NOON.minusSeconds(86_400)));
            files.add(message("3", NOON));
        }

        List<String> lines = Files.readAllLines(RecordFiles.file(folder, LocalDate.of(2026, 11, 21)));
        assertEquals(3, lines.size());
        assertTrue(lines.get(1).startsWith("message,7,1,") && lines.get(2).startsWith("message,7,3,"));
    }

    @Test
    void aTornLastLineIsEndedBeforeTheNextRecord() throws IOException {
        Path file = RecordFiles.file(folder, LocalDate.of(2026, 11, 21));
        Files.writeString(file, DetailRecord.HEADER + "\r\nmessage,7,to");
        try (RecordFiles files = RecordFiles.in(folder)) {
            files.add(message("1", NOON));
        }

        assertTrue(Files.readAllLines(file).get(2).startsWith("message,7,1,"));
    }

    @Test
    void aFolderThatCannotBeMadeIsNamed() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "");

        String text =
                assertThrows(IOException.class, () -> RecordFiles.in(file)).getMessage();

        assertTrue(text.contains(file.toString()), text);
    }
}
