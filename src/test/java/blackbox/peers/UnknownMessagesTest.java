package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.Scenario;
import java.io.BufferedReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A phone over one tower receives layer 3 messages that pycrate has made, and RSL messages that no tower receives. */
@Tag("peer")
class UnknownMessagesTest {
    private static final int MESSAGES = Integer.getInteger("unknown.messages", 1_000);
    private static final Pattern RESULT =
            Pattern.compile("sent (\\d+) unknown (\\d+) answered (\\d+) rsl (\\d+) reported (\\d+)");

    @Test
    void eachUnknownMessageIsAnswered() throws Exception {
        Peer.require(Peer.PYTHON.run("-c", "import pycrate_mobile").status() == 0, "pycrate (Python)");
        Process controller = Peer.PYTHON
                .process(Peer.source("unknown_messages.py"), String.valueOf(MESSAGES), "1")
                .start();
        try (Scenario scenario = new Scenario(MESSAGES + " messages made by pycrate");
                BufferedReader printed = controller.inputReader()) {
            String port = printed.readLine().substring("port ".length());
            Path town = Files.write(
                    scenario.folder().resolve("one.town"),
                    List.of("town One", "area urban", "tower west 0 0 arfcn=100 bsic=10 lac=1"));
            String cells = "127.0.0.1:"
                    + scenario.start(
                                    "cells",
                                    "simgsm-cells",
                                    "--headless",
                                    "--town",
                                    town.toString(),
                                    "--port",
                                    "0",
                                    "--center",
                                    "127.0.0.1:" + port)
                            .expect("ready")
                            .field("port");
            scenario.start(
                    "phone", "simgsm-phone", "--headless", "--no-sound", "--number", "5550100", "--center", cells);
            String last = null;
            for (String line = printed.readLine(); line != null; line = printed.readLine()) {
                System.out.println("  " + line);
                last = line;
            }
            assertNotNull(last, "the controller printed nothing");
            Matcher result = RESULT.matcher(last);
            assertTrue(result.matches(), last);
            assertEquals(result.group(2), result.group(3), "answers to unknown layer 3 messages");
            assertEquals(result.group(4), result.group(5), "ERROR REPORTs for RSL messages");
        } finally {
            controller.destroy();
        }
    }
}
