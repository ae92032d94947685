package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

/** Captures of the centre: whole, in order, and refused where they cannot be written. */
public class CaptureTest {
    private static final int RSL = 0x00;
    private static final int SPEECH = 0xe1;
    private static final int MGCP = 0xfc;
    /** RTP header and 20 ms of A-law. */
    private static final int A_LAW_PACKET = 172;

    private static final String OTHER = "5550101";

    @Test
    void theCaptureOfADayHoldsWholeFramesInOrder() throws Exception {
        try (Scenario scenario = new Scenario("a day in the life, captured")) {
            Path file = scenario.folder().resolve("day.pcap");
            day(scenario, file);
            CaptureFile capture = CaptureFile.read(file);
            capture.requireOrder();
            capture.requireWholeFrames();
            assertTrue(capture.frames(RSL) > 100, capture.frames(RSL) + " messages");
            assertEquals(0, capture.frames(SPEECH), "speech goes by UDP");
            assertTrue(capture.frames(MGCP) >= 4, "speech is announced");
            assertTrue(capture.datagrams().size() > 50, capture.datagrams().size() + " frames of speech");
            capture.datagrams().forEach(datagram -> assertEquals(A_LAW_PACKET, datagram.data().length));
        }
    }

    /** Attach, calls, keys, messages, a broadcast and detach, captured to a file. */
    public static void day(Scenario scenario, Path file) throws Exception {
        RunningProgram center = scenario.center("--capture", file.toString());
        RunningProgram phone = scenario.phone(Scenario.PHONE, "--dtmf", "signalled");
        RunningProgram other = scenario.phone(OTHER);
        scenario.tell("a call with signalled keys");
        phone.say("dial " + OTHER);
        other.expect("ringing", "from", Scenario.PHONE);
        other.say("answer");
        phone.expect("connected");
        other.expect("connected");
        phone.say("press 5#");
        phone.expect("sent", "keys", "5#");
        phone.say("hangup");
        other.expect("released");
        scenario.tell("a call that is not taken");
        other.say("dial " + Scenario.PHONE);
        phone.expect("ringing", "from", OTHER);
        phone.say("hangup");
        other.expect("released", "cause", "21");
        scenario.tell("a message, one of several parts, one in another alphabet");
        for (String text : List.of("hello", "many words ".repeat(30).strip(), "\u263a")) {
            phone.say("sms " + OTHER + " " + text);
            other.expect("sms", "from", Scenario.PHONE, "text", text);
            phone.expect("sms-delivered", "to", OTHER);
        }
        scenario.tell("a broadcast of two pages");
        center.say("broadcast 50 " + "The weather stays fine. ".repeat(6).strip());
        phone.expect("broadcast", "channel", "50", "pages", "2");
        other.expect("broadcast", "channel", "50", "pages", "2");
        scenario.tell("all programs end");
        assertEquals(0, phone.quit());
        assertEquals(0, other.quit());
        center.expect("detached", "number", Scenario.PHONE);
        center.expect("detached", "number", OTHER);
        assertEquals(0, center.quit());
    }

    @Test
    void aPlaceThatCannotBeWrittenIsSaidAtTheStart() throws Exception {
        try (Scenario scenario = new Scenario("a capture that has no place")) {
            Path file = scenario.folder().resolve("no-such-folder").resolve("a.pcap");
            FinishedProgram center = center(scenario, "--capture", file.toString());
            assertEquals(74, center.status());
            assertTrue(
                    center.error().startsWith("simgsm-center: cannot capture to " + file + ": no such folder"),
                    center.error());
        }
    }

    @Test
    void aLimitWithoutACaptureIsAUsageError() throws Exception {
        try (Scenario scenario = new Scenario("a limit for nothing")) {
            FinishedProgram center = center(scenario, "--capture-limit", "10");
            assertEquals(2, center.status());
            assertTrue(center.error().contains("--capture-limit needs --capture"), center.error());
        }
    }

    @Test
    void aFullDiskEndsTheCaptureAndNotTheCentre() throws Exception {
        Assumptions.assumeTrue(Files.exists(Path.of("/dev/full")), "no disk that is always full");
        try (Scenario scenario = new Scenario("a capture on a full disk")) {
            FinishedProgram center = center(scenario, "--capture", "/dev/full");
            assertEquals(74, center.status());
            assertTrue(center.error().contains("cannot capture to /dev/full: "), center.error());
        }
    }

    private static FinishedProgram center(Scenario scenario, String... options) throws Exception {
        List<String> arguments = new ArrayList<>(List.of(
                "--headless",
                "--port",
                "0",
                "--data",
                scenario.folder().resolve("data").toString()));
        arguments.addAll(List.of(options));
        return FinishedProgram.run("simgsm-center", arguments, java.util.Map.of());
    }
}
