package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.CenterFromOutsideTest;
import blackbox.Scenario;
import java.nio.file.Files;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The parser of Prometheus's Python client reads the centre's metrics. */
@Tag("peer")
class PrometheusTest {
    @BeforeAll
    static void requireParser() {
        Peer.PYTHON.require();
        Peer.require(
                Files.isDirectory(Peer.LIBRARIES.resolve("python").resolve("prometheus_client")), "prometheus_client");
    }

    @Test
    void everyMetricIsReadWithItsTypeAndHelp() throws Exception {
        try (Scenario scenario = new Scenario("metrics, read by Prometheus's parser")) {
            scenario.center("--http", "0");
            scenario.robot("empty.map");
            CenterFromOutsideTest.traffic(scenario.phone(Scenario.PHONE));
            List<String> samples = Peer.PYTHON
                    .run(Peer.source("metrics.py"), scenario.centerUrl() + "metrics")
                    .expectSuccess()
                    .lines()
                    .toList();
            for (String sample : List.of(
                    "gauge\tsimgsm_subscribers_attached\t\t2",
                    "counter\tsimgsm_calls_released_total\tcause=16\t1",
                    "counter\tsimgsm_messages_total\tstate=accepted\t3",
                    "gauge\tsimgsm_messages_waiting\t\t1")) {
                assertTrue(samples.contains(sample), sample + " in " + samples);
            }
        }
    }
}
