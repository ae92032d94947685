package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import blackbox.Scenario;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.StringJoiner;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** osmo-bsc and the centre get the same measurement results of 100 calls and decide on the same handovers. */
@Tag("peer")
class HandoverDecisionsTest {
    /** With two seeds 100 in all; more in one run would take longer than a peer may. */
    private static final int SEQUENCES = 50;

    private static final List<String> CELLS = List.of("101:20:8", "102:30:9", "103:40:10", "104:50:11", "105:60:12");
    private static final String NUMBERS = "5550100-5550111,5550200";

    @BeforeAll
    static void requireTheCore() {
        List.of(Peer.OSMO_BSC, Peer.OSMO_BTS, Peer.OSMO_MSC, Peer.OSMO_HLR, Peer.OSMO_MGW, Peer.OSMO_STP)
                .forEach(Peer::require);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void theSameResultsLeadToTheSameReportAndTarget(int seed) throws Exception {
        try (Scenario scenario = new Scenario("handover decisions beside osmo-bsc, seed " + seed)) {
            scenario.center();
            String[] ours = scenario.centerAddress().split(":");
            List<String> centre =
                    decisions(Peer.PYTHON.run(arguments(ours[0], ours[1], seed).toArray(String[]::new)));
            String command = "python3 " + String.join(" ", arguments("127.0.0.1", "3003", seed));
            List<String> osmocom = decisions(Peer.BASH.run(
                    Peer.source("osmocom/core.sh"), town(scenario.folder()).toString(), NUMBERS, command));
            assertEquals(SEQUENCES, osmocom.size(), "decisions of osmo-bsc");
            assertEquals(osmocom, centre);
        }
    }

    private static List<String> arguments(String host, String port, int seed) {
        return Stream.concat(
                        Stream.of(
                                Peer.source("osmocom/handover_decisions.py"),
                                host,
                                port,
                                String.valueOf(seed),
                                String.valueOf(SEQUENCES)),
                        CELLS.stream())
                .toList();
    }

    private static List<String> decisions(Peer.Output output) {
        return output.expectSuccess()
                .lines()
                .filter(line -> line.startsWith("sequence="))
                .toList();
    }

    /** A town with these cells, for osmo-bsc's configuration. */
    private static Path town(Path folder) throws IOException {
        StringJoiner text = new StringJoiner("\n", "town Five cells\nsize 8000 8000\narea urban\n", "\n");
        for (int i = 0; i < CELLS.size(); i++) {
            String[] cell = CELLS.get(i).split(":");
            text.add("tower t" + i + " " + 1_000 * (i + 1) + " 1000 arfcn=" + cell[1] + " bsic=" + cell[2]
                    + " lac=1 site=" + cell[0]);
        }
        return Files.writeString(folder.resolve("five.town"), text.toString());
    }
}
