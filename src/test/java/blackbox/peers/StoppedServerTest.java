package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.RunningProgram;
import blackbox.Scenario;
import java.io.IOException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Clients from elsewhere begin while the server is stopped for 1.5 s, as on a busy machine, and are served afterwards. */
@Tag("peer")
class StoppedServerTest {
    private static void stop(RunningProgram server) throws IOException, InterruptedException {
        new ProcessBuilder("kill", "-STOP", String.valueOf(server.pid()))
                .start()
                .waitFor();
        new ProcessBuilder("sh", "-c", "sleep 1.5; kill -CONT " + server.pid()).start();
    }

    @Test
    void smpplibBindsAndSubmits() throws Exception {
        Peer.require(Peer.PYTHON.run("-c", "import smpplib").status() == 0, "smpplib (Python)");
        try (Scenario scenario = new Scenario("smpplib meets a stopped centre")) {
            RunningProgram center = scenario.center("--smpp", "0");
            scenario.robot("empty.map", "--speed", "20");
            stop(center);
            String printed = Peer.PYTHON
                    .run(
                            Peer.source("smpplib_order.py"),
                            String.valueOf(scenario.smppPort()),
                            "5550300",
                            Scenario.ROBOT,
                            "** #**20 **")
                    .expectSuccess();
            assertTrue(printed.contains("reply 3 Done: #**20."), printed);
        }
    }

    @Test
    void socatSendsAnAtCommand() throws Exception {
        Peer.SOCAT.require();
        try (Scenario scenario = new Scenario("socat meets a stopped SimRobot")) {
            RunningProgram robot =
                    scenario.start("robot", "simrobot", "--headless", "--center", "127.0.0.1:1", "--at", "0");
            String port = robot.expect("ready").field("at");
            stop(robot);
            String printed = Peer.BASH
                    .run("-c", "printf 'AT\\r' | socat -t 20 - TCP:127.0.0.1:" + port)
                    .expectSuccess();
            assertTrue(printed.contains("OK"), printed);
        }
    }
}
