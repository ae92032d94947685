package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import org.junit.jupiter.api.Test;

/** The load tool puts real stations on a real centre and says in one line what it measured. */
class LoadTest {
    @Test
    void everyPhoneAttachesTalksAndWrites() throws Exception {
        try (Scenario scenario = new Scenario("20 phones, 5 calls, 40 messages")) {
            RunningProgram center = scenario.center();
            FinishedProgram load = load(scenario.centerAddress(), "20", "5", "40", "1");
            assertEquals(0, load.status(), load.error());
            assertEquals(1, load.output().lines().count(), load.output());
            ConsoleEvent line = ConsoleEvent.parse(load.output().strip());
            assertEquals("load", line.name());
            assertEquals("20", line.field("phones"));
            assertEquals("5", line.field("calls"));
            assertEquals("40", line.field("sms"));
            assertEquals("0", line.field("smslost"));
            assertEquals("0", line.field("lost"));
            assertTrue(Long.parseLong(line.field("frames")) > 0, load.output());
            for (String figure :
                    new String[] {"attachrate", "callrate", "p50ms", "p99ms", "smsrate", "smsp50ms", "smsp99ms"}) {
                assertTrue(Double.parseDouble(line.field(figure)) > 0, figure + " in " + load.output());
            }
            scenario.tell("the phones have left again");
            center.say("calls");
            center.expect("end", "of", "calls", "count", "0");
            assertEquals(0, center.quit());
        }
    }

    @Test
    void whatWasNotAskedForIsADash() throws Exception {
        try (Scenario scenario = new Scenario("phones that only attach")) {
            scenario.center();
            FinishedProgram load = load(scenario.centerAddress(), "2", "0", "0", "1");
            assertEquals(0, load.status(), load.error());
            ConsoleEvent line = ConsoleEvent.parse(load.output().strip());
            assertEquals("-", line.field("callrate"));
            assertEquals("-", line.field("p99ms"));
            assertEquals("-", line.field("smsp99ms"));
        }
    }

    @Test
    void withoutACentreItSaysSoAndEndsWith69() throws Exception {
        FinishedProgram load = load("127.0.0.1:" + portOfNobody(), "2", "1", "0", "1");
        assertEquals(69, load.status());
        assertEquals("", load.output());
        assertTrue(load.error().startsWith("simgsm-modem: no centre at 127.0.0.1:"), load.error());
    }

    @Test
    void moreCallsThanPairsOfPhonesAreAUsageError() throws Exception {
        FinishedProgram load = load("127.0.0.1:1", "5", "3", "0", "1");
        assertEquals(2, load.status());
        assertEquals(
                "simgsm-modem: --calls: expected 0 to 2, since a call takes two of 5 phones, found 3; see --help\n",
                load.error());
    }

    private static FinishedProgram load(String center, String phones, String calls, String messages, String seconds)
            throws IOException, InterruptedException {
        return FinishedProgram.run(
                "simgsm-modem",
                "load",
                "--center",
                center,
                "--phones",
                phones,
                "--calls",
                calls,
                "--sms",
                messages,
                "--seconds",
                seconds);
    }

    private static int portOfNobody() throws IOException {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return socket.getLocalPort();
        }
    }
}
